"""A load along the fence, with the pusher at rest: the contact sticks whichever way it drags the slider."""

from __future__ import annotations

import numpy as np
import pytest

import planar_pushing as pp

SEPARATE, STICK, *_ = pp.ContactMode
RADIUS = 0.8


@pytest.mark.parametrize("force", [2.0, -2.0])
@pytest.mark.parametrize("law", [pp.InfiniteFriction(), pp.PerfectlyRough()])
def test_a_load_without_a_normal_part_is_held_at_the_contact(law, force):
    """The slider turns about the contact, at a distance of 1 from its center, or moves without rotation."""
    effects = (pp.Inertia(gyration_radius=RADIUS), pp.Load(force=(force, 0.0)))
    slider = pp.Slider(rod_length=1.0, rod_angle=np.pi / 2)
    scene = pp.Scene(slider=slider, contact=law, effects=effects)
    apart, held = pp.solve(scene, np.pi / 2, 0.0)
    assert (apart.mode, held.mode) == (SEPARATE, STICK)
    assert apart.twist == pytest.approx([force, 0.0, 0.0])
    spin = -force / (1.0 + RADIUS**2)
    assert held.twist == pytest.approx([-spin, 0.0, spin])
    assert held.force == pytest.approx([-spin - force, 0.0])
