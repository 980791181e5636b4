"""Random and adversarial inputs: no NaN, no warning, no refusal of the domain, no wrong mode.

`snakemake sweep` runs the same checks on a million inputs.
"""

import json
import warnings
from collections import Counter
from dataclasses import replace

import numpy as np
import pytest

from planar_pushing.evidence.hard_cases.scenes import make_scene
from planar_pushing.evidence.hard_cases.sweep import conditions, decisions, kernels
from planar_pushing.evidence.hard_cases.sweep.counts import (
    BLOCK,
    FULL,
    KERNELS,
    Budget,
    sweep,
)
from planar_pushing.evidence.writing import json_text
from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.mechanics.plane import direction
from planar_pushing.mechanics.solve import solve
from planar_pushing.terms.options import EffectSet

SEED = 7
FEW = Budget(kernels=20_000, scenes=24_000, scalar=80, decided=150)


@pytest.fixture(scope="module")
def counts():
    return sweep(FEW, SEED)


def test_nothing_fails(counts):
    assert {kind: each["failures"] for kind, each in counts.items()} == dict.fromkeys(counts, 0)


def test_every_kind_has_its_inputs(counts):
    inputs = {kind: each["inputs"] for kind, each in counts.items()}
    assert set(KERNELS) < set(inputs)
    assert {inputs[kind] for kind in KERNELS} == {FEW.kernels}
    assert inputs["contact modes, vectorised"] == FEW.scenes
    assert inputs["contact modes, certified"] == FEW.decided


def test_every_set_of_effects_meets_every_law():
    assert FEW.scenes // BLOCK >= len(conditions.KINDS) == 12


def test_most_decisions_do_not_hang_on_rounding(counts):
    certified = counts["contact modes, certified"]
    assert certified["tie"] + certified["undecided"] < 0.2 * certified["inputs"]


def test_some_single_scenes_are_outside_the_domain(counts):
    single = counts["contact modes, solve"]
    assert 0 < single["refused"] < single["inputs"] / 2


def test_the_full_sweep_has_a_million_inputs():
    assert FULL.kernels == FULL.scenes == 1_000_000


def test_a_wrong_kernel_is_told(monkeypatch):
    right = kernels.ring_profile

    def wrong(k):
        force, torque = right(k)
        return force, np.where(np.abs(k) > 1, torque * (1 + 1e-12), torque)

    monkeypatch.setattr(kernels, "ring_profile", wrong)
    assert KERNELS["ring_profile"](np.random.default_rng(SEED), 20_000).any()


def test_wrong_motion_angles_are_told(monkeypatch):
    right = kernels.motion_angle
    monkeypatch.setattr(kernels, "motion_angle", lambda *given: right(*given) + 1e-9)
    for name in (
        "motion_angle, friction",
        "motion_angle, both",
        "motion cone edges",
        "limit_curve",
    ):
        told = KERNELS[name](np.random.default_rng(SEED), 5000)
        assert told.any() == (name != "limit_curve"), name


@pytest.fixture(scope="module", params=["infinite", "coulomb"])
def solved(request):
    rng = np.random.default_rng(SEED)
    given = conditions.pushes(rng, EffectSet.BOTH, request.param, 4000)
    return given, solve(*given)


def told(solved, which, **changes):
    """Share of the solutions in a mode that are told once they are changed."""
    given, found = solved
    each = conditions.gathered(given, replace(found, **changes))
    was = conditions.gathered(given, found).mode
    return conditions.broken(given, each)[was == which].mean()


MOVING = (ContactMode.STICK, ContactMode.SLIP_RIGHT, ContactMode.SLIP_LEFT)
OFF = 1 + 1e-10


@pytest.mark.parametrize("mode", MOVING)
def test_a_changed_solution_is_told(solved, mode):
    """But for slips next to the fence, whose digits may have underflowed."""
    _, found = solved
    assert told(solved, mode) == 0
    assert told(solved, mode, force=found.force * OFF) > 0.6
    assert told(solved, mode, twist=found.twist * OFF) > 0.6
    assert told(solved, mode, contact_motion=found.contact_motion * OFF) > 0.6
    turned = found.force + 1e-10 * found.force[..., ::-1] * [-1, 1]
    assert told(solved, mode, force=turned) > 0.6


@pytest.mark.parametrize("mode", MOVING)
def test_a_wrong_mode_is_told(solved, mode):
    """But for sticks at an edge of the cone, and for slips whose digits may have underflowed."""
    _, found = solved
    for other in {*ContactMode} - {mode}:
        changed = np.where(found.mode == mode, np.int8(other), found.mode)
        assert told(solved, mode, mode=changed) > 0.6, other


def test_a_force_outside_the_cone_is_told():
    rng = np.random.default_rng(SEED)
    given = conditions.pushes(rng, EffectSet.SUPPORT_FRICTION, "rough", 4000)
    infinite = conditions.scenes(rng, EffectSet.SUPPORT_FRICTION, "infinite", 4000).contact
    found = solve(*given)
    strict = given._replace(scene=replace(given.scene, contact=infinite))
    each = conditions.gathered(given, found)
    pulls = (each.mode == ContactMode.STICK) & (each.force[:, 1] < -1e-9 * np.abs(each.force[:, 0]))
    assert pulls.sum() > 500
    assert not conditions.against_its_mode(given, each).any()
    assert conditions.against_its_mode(strict, conditions.gathered(strict, found))[pulls].all()


def test_a_missing_solution_is_counted(solved):
    given, found = solved
    pushing = (direction(given.angle)[:, 1] > 0) & (given.magnitude > 0)
    assert not conditions.miscounted(given, found).any()
    nothing = replace(found, mode=found.mode * 0 - 1, solutions=found.solutions * 0)
    assert conditions.miscounted(given, nothing).all()
    twice = replace(found, solutions=found.solutions + 2)
    single = given._replace(scene=replace(given.scene, effects=given.scene.effects[:1]))
    assert (conditions.miscounted(single, twice) == pushing).all()


@pytest.mark.parametrize(
    ("psi", "mu", "angle"),
    [(1e-300, 9.451541293189834e-06, 1.5707934173394442),
     (3.1415926535897927, 6.0677535364992974e-05, 1.570798797174742),
     (1e-12, 6.077309117895397e-06, 1.5707990692290912)],
)  # fmt: skip
def test_a_line_of_force_that_almost_touches_the_ring(psi, mu, angle):
    """The slope of the torque is infinite there, and a root is found in short steps."""
    scene = make_scene(1.0, psi, share=0.0, mu=mu)
    given = conditions.Pushes(scene, np.array([angle]), np.ones(1))
    found = solve(*given)
    assert found.mode.tolist() == [[ContactMode.STICK, -1, -1, -1]]
    assert not conditions.wrong(given, found).any()


def test_a_missing_decision_is_wrong(monkeypatch):
    class Nothing:
        modes = ()

    monkeypatch.setattr(decisions, "solve", lambda *_: Nothing())
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        found = Counter(decisions.decided(np.random.default_rng([SEED, i])) for i in range(10))
    assert found[decisions.Decision.WRONG] >= 5


def test_a_scene_outside_the_domain_that_is_not_refused_is_wrong(monkeypatch):
    monkeypatch.setattr(decisions, "ROUGHEST", 1e-3)
    found = [decisions.scalar(np.random.default_rng([SEED, i])) for i in range(80)]
    assert sum(wrong for _, wrong in found) > 20


def test_counts_are_plain_values(counts):
    assert json.loads(json_text(counts)) == counts
