"""The random supports: of every kind, the same in every run, and not such that nothing could fail."""

import numpy as np

import planar_pushing as pp
from planar_pushing.evidence.claims.any_slider.supports import (
    everywhere,
    random_scenes,
    random_supports,
)
from planar_pushing.evidence.claims.proofs.verdicts import Verdict

MEMBERS = random_supports(40)


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
    found = everywhere(holds, ["one", "other"], "method")
    assert found.verdict is Verdict.REFUTED
    assert found.points == 6
    assert found.reason == "fails at 1 points, first other, 2"
