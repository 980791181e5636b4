"""The random supports: of every kind, the same in every run, and not such that nothing could fail."""

import numpy as np
import pytest

import planar_pushing as pp
from planar_pushing.evidence.claims.registry import CHECKS
from planar_pushing.evidence.claims.samples import random_pushes
from planar_pushing.evidence.claims.samples.supports import random_scenes, random_supports
from planar_pushing.evidence.claims.verdicts import Verdict

MEMBERS = random_supports(40)
FEW = {"supports": 40, "contacts": 5}


def test_every_kind_is_drawn_and_every_run_has_the_same():
    kinds = {type(each) for each in MEMBERS.ravel()}
    assert kinds == {pp.Points, pp.Segment, pp.Polygon, pp.Composite}
    assert len(set(MEMBERS.ravel())) == 40
    random_supports.cache_clear()
    assert all(one == other for one, other in zip(random_supports(40), MEMBERS, strict=True))


def test_other_pushes_slip():
    scenes = random_scenes(MEMBERS, 5)
    normal, along = (pp.solve(scenes, np.deg2rad(angle)) for angle in (90.0, 179.0))
    assert normal.solutions.shape == (40, 5)
    assert (normal.mode[..., 0] == pp.ContactMode.STICK).all()
    assert 20 < (along.mode[..., 0] != pp.ContactMode.STICK).sum() < 180


def test_a_failure_is_named():
    holds = np.ones((2, 3), dtype=bool)
    holds[1, 2] = False
    found = random_pushes.everywhere(holds)
    assert found.verdict is Verdict.REFUTED
    assert found.points == 6
    assert found.reason == "fails at 1 points, first support 1, contact 2"


NAMES = [
    *("normal-push-on-random-supports", "slip-outside-cone-on-random-supports"),
    *("cones-of-random-supports", "pulls-of-random-supports", "centers-of-random-supports"),
]


@pytest.mark.parametrize("name", NAMES)
def test_a_sample_is_called_one(name):
    found = CHECKS[name].run(**FEW)
    assert found.verdict is Verdict.SAMPLED
    assert found.points == 200


@pytest.mark.parametrize(
    ("name", "route", "wrong"),
    [
        (NAMES[0], "solve", lambda scenes, angle: pp.solve(scenes, np.deg2rad(175.0))),
        (NAMES[1], "solve", lambda scenes, angle: pp.solve(scenes, np.pi - angle)),
        (NAMES[2], "can_pull", lambda scenes: ~pp.can_pull(scenes)),
        (NAMES[3], "solve", lambda scenes, angle: pp.solve(scenes, -np.pi / 2)),
        (NAMES[4], "motion_centers", lambda scenes, force, origin: np.full((40, 5, 2), 1e3)),
    ],
)
def test_a_library_that_is_wrong_is_noticed(monkeypatch, name, route, wrong):
    monkeypatch.setattr(random_pushes, route, wrong)
    assert CHECKS[name].run(**FEW).verdict is Verdict.REFUTED
