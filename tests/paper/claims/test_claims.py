"""The checks of the ledger that ask a mechanics, on the library; the ledger asks the oracle."""

import numpy as np
import pytest
from claims.library import Library
from evidence.claims.ledgers import entries, found, judge
from flint import arb
from mechanics.builders import BOTH, make_scene

import planar_pushing as pp
from pulling_by_pushing.evidence.proofs.registry import CHECKS
from pulling_by_pushing.evidence.proofs.verdicts import Verdict

#: A number that the library does not answer.
UNASKED = {"normal_motion_dip"}
#: A check with an edge that lies exactly along the fence.
EXACT = {"slow-pulls-fast-does-not"}


def is_exact(entry):
    """Whether no tolerance decides: an equality, or an accuracy of a few roundings."""
    return entry.equals is not None or entry.check in EXACT or (entry.within or 1) < 1e-12


ASKED = {
    key: entry
    for key, entry in entries().items()
    if (CHECKS[entry.check].asks if entry.check else entry.argument not in UNASKED)
}


@pytest.mark.parametrize("key", ASKED, ids=" ".join)
def test_the_library_agrees(key):
    verdict = judge(*key, mechanics=Library()).verdict
    undecided = {Verdict.UNDECIDED} if is_exact(ASKED[key]) else set()
    assert verdict in {Verdict.PROVED, Verdict.ENCLOSED} | undecided


class Tilted(Library):
    """Every cone is off by a billionth of a degree."""

    def motion_cone(self, scene):
        return tuple(edge + arb(1e-9) for edge in super().motion_cone(scene))


class Turned(Library):
    def motion(self, scene, force_angle, power):
        u_x, u_y, omega = super().motion(scene, force_angle, power)
        return u_x, u_y * (1 + arb(1e-5)), omega


class Weak(Library):
    def wrench(self, scene, motion, without=-1):
        force_x, force_y, torque = super().wrench(scene, motion, without)
        return force_x, force_y, torque * (1 - arb(1e-6))


class Narrow(Library):
    def friction_cone(self, scene):
        right, left = super().friction_cone(scene)
        return right + arb(1e-6), left


class Loose(Library):
    def bound_of_the_cases(self, scene):
        right, left = super().bound_of_the_cases(scene)
        return right, left + arb(1e-6)


class Forgetful(Library):
    """The last mode is missing."""

    def modes(self, scene, pusher_angle, magnitude):
        return super().modes(scene, pusher_angle, magnitude)[:-1]


class Inventive(Library):
    def modes(self, scene, pusher_angle, magnitude):
        return [*super().modes(scene, pusher_angle, magnitude), ("slip-left", arb(0))]


@pytest.mark.parametrize(
    ("wrong", "claims"),
    [
        (Tilted, {"velocity-cone-of-figure-6", "cones-of-figure-7", "exact-cone-of-figure-12"}),
        (Turned, {"shape-of-an-l", "speed-decides-pulling", "cones-beyond-the-pure-ones"}),
        (Weak, {"integration-constants", "center-beyond-bound", "pivots-of-a-tripod"}),
        (Narrow, {"friction-cone"}),
        (Loose, {"bound-of-figure-12"}),
        (
            Forgetful,
            {"case-analysis", "pulling-is-ambiguous", "two-definitions", "perfectly-rough"},
        ),
        (Inventive, {"case-analysis", "normal-motion-dips", "two-definitions", "perfectly-rough"}),
    ],
)
def test_a_wrong_library_is_refuted(wrong, claims):
    keys = [key for key in ASKED if key[0] in claims]
    verdicts = {key: judge(*key, mechanics=wrong()).verdict for key in keys}
    assert {key[0] for key in keys if verdicts[key] is Verdict.REFUTED} == claims


@pytest.mark.parametrize(("part", "slips"), [(0.9999, 2), (1.0001, 0)])
def test_the_dip_of_the_normal_motion(part, slips):
    least = float(found("normal-motion-dips", "least").value)
    pusher = np.array([10.0, part * least])
    solutions = pp.solve(make_scene(2.0, 1.4, BOTH), np.arctan2(*pusher[::-1]), np.hypot(*pusher))
    assert sum(each.mode is pp.ContactMode.SLIP_LEFT for each in solutions) == slips
