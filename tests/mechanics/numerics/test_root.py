"""Roots: when an iteration has settled, and scenes in which a step is small by chance."""

import numpy as np
import pytest
from planar_pushing.mechanics.numerics.root import is_last

import planar_pushing as pp


@pytest.mark.parametrize(
    ("size", "before", "last"),
    [
        (1e-9, 1e-4, True),  # converges quadratically: the next one is 1e-19
        (1e-9, 1e-6, False),  # the next one is 1e-15
        (5.2e-7, 0.084, False),  # by chance: the next one was 1e-12
        (1e-14, 1e-14, True),
        (1e-3, 0.9, False),
    ],
)
def test_an_iteration_settles(size, before, last):
    assert is_last(size, before) == last


def test_a_slip_after_a_step_that_is_small_by_chance():
    """Friction and inertia, l = 10: the ratio of the force's parts is that of the speeds to rounding."""
    scene = pp.Scene(
        slider=pp.Slider(rod_length=10.0, rod_angle=np.pi / 4), contact=pp.Coulomb(0.1),
        effects=(pp.RingFriction(), pp.Inertia()),
    )  # fmt: skip
    (slip,) = pp.solve(scene, np.deg2rad(29.0), 1.0)
    force = sum(pp.wrench(each, slip.twist, scene.slider) for each in scene.effects)
    assert force[0] / force[1] == pytest.approx(0.1, rel=1e-14)
    assert slip.twist[0] / slip.twist[1] == pytest.approx(0.1, rel=1e-14)
