"""Slips of any support with friction and inertia, born in pairs, against those of the ring's route."""

import numpy as np
import pytest

import planar_pushing as pp
from planar_pushing.mechanics.effects.base import COLUMNS, made
from planar_pushing.mechanics.plane import rod, toward
from planar_pushing.mechanics.reduced.base import MOTION, slips

#: The normal motion of the contact falls to this over the size of the force, and rises again (PHYSICS.md).
LEAST = -0.0400296
RING = pp.Composite([(1.0, pp.Ring(1.0))])


def found(support, part):
    """Slips under the right edge of mu = 1.4, at a part of the least normal motion."""
    slider = pp.Slider(rod_length=2.0, rod_angle=np.pi / 4, radius=1.0)
    effects = (pp.SupportFriction(support=support), pp.Inertia())
    scene = pp.Scene(slider=slider, contact=pp.Coulomb(1.4), effects=effects)
    row = np.zeros(COLUMNS)
    row[:7] = scene.weight, *scene.inertia, *scene.placement
    own, motions = rod(2.0, np.pi / 4), np.empty((8, MOTION))
    edge = toward(own, np.arctan2(1.0, 1.4))
    count = slips(made(scene.kinds, row), own, edge, part * LEAST, np.inf, motions)
    return motions[:count]


@pytest.mark.parametrize("part", [0.5, 0.9, 0.99, 0.999, 1 - 1e-4, 1 - 1e-5])
def test_both_slips_of_a_pair_are_found_near_its_birth(part):
    """Two nodes of the search are further apart than the slips are."""
    general, ring = found(RING, part), found(pp.Ring(), part)
    assert len(ring) == len(general) == 2
    near = 1e-11 / np.sqrt(1 - part)
    assert general[:, :5] == pytest.approx(ring[:, :5], rel=near)
    assert np.hypot(*general[0, 3:5]) < 1.40897 < np.hypot(*general[1, 3:5])


def test_before_its_birth_there_is_no_pair():
    assert len(found(RING, 1 + 1e-5)) == len(found(pp.Ring(), 1 + 1e-5)) == 0
