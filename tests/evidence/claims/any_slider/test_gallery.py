"""The gallery: its supports, and their limit curves by another route."""

import numpy as np
import pytest

import planar_pushing as pp
from planar_pushing.evidence.claims.any_slider.gallery import _forces
from planar_pushing.evidence.claims.any_slider.supports import GALLERY, L_SHAPE, SYMMETRIC, stacked


def test_centres_of_pressure_are_on_the_rod():
    centers = {name: each.center_of_pressure for name, each in GALLERY.items()}
    assert centers.pop("pressure map") == pytest.approx((1 / 6, 1 / 4))
    for center in centers.values():
        assert center == pytest.approx((0.0, 0.0), abs=1e-15)


@pytest.mark.parametrize("name", GALLERY)
def test_symmetric_supports_have_symmetric_friction(name):
    """The power of friction in a motion and in its mirror image."""
    friction = pp.SupportFriction(support=GALLERY[name])
    twist = np.array([0.3, 0.5, 0.7])
    power = pp.potential(friction, [twist, twist * (1, -1, -1)])
    assert (abs(power[0] - power[1]) < 1e-14) == (name in SYMMETRIC)


def test_forces_on_the_curve_are_those_of_the_motion_there():
    """The power of the force in its own motion is that of friction."""
    turns, rods = np.array([-30.0, 30.0]), np.array([0.5, 2.0])
    found = _forces(stacked([L_SHAPE, GALLERY["square"]]), rods, turns)
    for (i, j, k), size in np.ndenumerate(found):
        support = (L_SHAPE, GALLERY["square"])[i]
        length = support.extent * rods[j]
        slider = pp.Slider(rod_length=length, rod_angle=np.pi / 2)
        scene = pp.Scene(
            slider=slider, contact=pp.PerfectlyRough(),
            effects=(pp.SupportFriction(support=support),),
        )  # fmt: skip
        (stick,) = [
            each for each in pp.solve(scene, pp.motion_angle(scene, np.pi / 2 + np.deg2rad(turns[k])))
            if each.mode is pp.ContactMode.STICK
        ]  # fmt: skip
        assert np.hypot(*stick.force) == pytest.approx(size, rel=1e-10)
