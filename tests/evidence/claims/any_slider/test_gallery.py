"""The gallery: its supports, and their limit curves by another route."""

import numpy as np
import pytest

import planar_pushing as pp
from planar_pushing.evidence.claims.any_slider.gallery import curve_of_l_leans
from planar_pushing.evidence.claims.any_slider.supports import GALLERY, L_SHAPE, SYMMETRIC
from planar_pushing.evidence.claims.proofs.verdicts import Verdict


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


def sticking_force(length, turn):
    """Force of the L in the motion that its limit curve gives, at an angle from the rod."""
    scene = pp.Scene(
        slider=pp.Slider(rod_length=L_SHAPE.extent * length, rod_angle=np.pi / 2),
        contact=pp.PerfectlyRough(), effects=(pp.SupportFriction(support=L_SHAPE),),
    )  # fmt: skip
    motion = pp.motion_angle(scene, np.pi / 2 + np.deg2rad(turn))
    (stick,) = (each for each in pp.solve(scene, motion) if each.mode is pp.ContactMode.STICK)
    return np.hypot(*stick.force)


@pytest.mark.parametrize("length", [0.5, 2.0])
def test_the_curve_of_the_l_holds_the_forces_of_its_motions(length):
    leans = sticking_force(length, -30.0) - sticking_force(length, 30.0)
    assert abs(leans) > 1e-3
    for wrong, verdict in ((0.0, Verdict.VERIFIED), (1e-8, Verdict.REFUTED)):
        given = {"rod_length": length, "turn": 30.0, "difference": leans + wrong, "within": 1e-9}
        assert curve_of_l_leans(**given).verdict is verdict
