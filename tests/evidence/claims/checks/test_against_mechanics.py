"""Numbers of the findings against the mechanics, which share no code with the checks."""

import numpy as np
import pytest

import planar_pushing as pp
from evidence.claims.ledgers import judged
from mechanics.builders import BOTH, PSI, make_scene
from planar_pushing.mechanics.plane import direction

VALUES = {each.claim.id: each.evidence.value for each in judged()}


@pytest.mark.parametrize(
    ("name", "length"),
    [("off-ellipse-half-rod", 0.5), ("off-ellipse-short-rod", 1), ("off-ellipse-long-rod", 5)],
)
def test_distance_from_the_ellipse(name, length):
    curve = pp.limit_curve(make_scene(length), np.linspace(PSI, PSI + np.pi / 2, 20001))
    x, y = (curve.force @ direction(PSI + turn) for turn in (0.0, np.pi / 2))
    shortfall = 1 - np.hypot(x / np.abs(x).max(), y / np.abs(y).max())
    assert shortfall.max() == pytest.approx(float(VALUES[name]), rel=1e-6)
    assert shortfall.min() > -1e-15


def test_pulling_threshold_of_friction():
    threshold = float(VALUES["friction-threshold"])
    assert not pp.can_pull(make_scene(2.0, threshold - 1e-12))
    assert pp.can_pull(make_scene(2.0, threshold + 1e-12))


def test_the_dip_of_the_normal_motion():
    least = float(VALUES["normal-motion-dips"])
    scene = make_scene(2.0, 1.4, BOTH)
    for part, slips in ((0.9999, 2), (1.0001, 0)):
        pusher = np.array([10.0, part * least])
        found = pp.solve(scene, np.arctan2(*pusher[::-1]), np.hypot(*pusher))
        assert sum(s.mode is pp.ContactMode.SLIP_LEFT for s in found) == slips


def test_directions_without_solution():
    law = pp.InfiniteFriction(at_zero_normal="none")
    for degrees, solutions in ((148.61, 1), (148.62, 0), (179.9, 0)):
        assert len(pp.solve(make_scene(2.0, law), np.deg2rad(degrees))) == solutions
