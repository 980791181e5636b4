"""Random and adversarial inputs: no NaN, no warning, no exception but our own, no wrong mode.

`snakemake sweep` runs the same checks on a million inputs.
"""

import json
import warnings
from collections import Counter
from dataclasses import replace

import numpy as np
import pytest

from planar_pushing.evidence.hard_cases.sweep import decisions, kernels
from planar_pushing.evidence.hard_cases.sweep.counts import (
    FULL,
    KERNELS,
    Budget,
    sweep,
)
from planar_pushing.evidence.writing import json_text
from planar_pushing.mechanics.candidates import candidates
from planar_pushing.mechanics.plane import direction

SEED = 7
FEW = Budget(kernels=20_000, scenes=40, pushers=200, scalar=80, decided=150)


@pytest.fixture(scope="module")
def counts():
    return sweep(FEW, SEED)


def test_nothing_fails(counts):
    assert {kind: each["failures"] for kind, each in counts.items()} == dict.fromkeys(counts, 0)


def test_every_kind_has_its_inputs(counts):
    inputs = {kind: each["inputs"] for kind, each in counts.items()}
    assert set(KERNELS) < set(inputs)
    assert inputs["ring_profile"] == FEW.kernels
    assert inputs["contact modes, vectorised"] == FEW.scenes * FEW.pushers
    assert inputs["contact modes, certified"] == FEW.decided


def test_most_decisions_do_not_hang_on_rounding(counts):
    certified = counts["contact modes, certified"]
    assert certified["tie"] + certified["undecided"] < 0.2 * certified["inputs"]


def test_the_full_sweep_has_a_million_inputs():
    assert FULL.kernels == FULL.scenes * FULL.pushers == 1_000_000


def test_a_wrong_kernel_is_told(monkeypatch):
    right = kernels.ring_profile

    def wrong(k):
        force, torque = right(k)
        return force, np.where(np.abs(k) > 1, torque * (1 + 1e-12), torque)

    monkeypatch.setattr(kernels, "ring_profile", wrong)
    assert KERNELS["ring_profile"][0](np.random.default_rng(SEED), 20_000).any()


def test_a_wrong_mode_is_told():
    rng = np.random.default_rng(SEED)
    here, pusher = decisions.scene(rng, 1), direction(np.linspace(0.1, 3.0, 50))
    found = candidates(here, pusher)
    assert not decisions._count(here, found, pusher).any()
    nothing = tuple(replace(each, consistent=each.consistent & False) for each in found)
    closed = here.contact.force_angles.closed
    assert decisions._count(here, nothing, pusher).all() == closed
    slower = [replace(each, twist=each.twist * 0.5) for each in found]
    told = [decisions._breaks_its_conditions(here, each, pusher).any() for each in slower[1:]]
    assert any(told)


def test_a_missing_solution_is_wrong(monkeypatch):
    class Nothing:
        modes = ()

    monkeypatch.setattr(decisions, "solve", lambda *_: Nothing())
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        found = Counter(decisions.decided(np.random.default_rng([SEED, i])) for i in range(10))
    assert found[decisions.Decision.WRONG] >= 5


def test_counts_are_plain_values(counts):
    assert json.loads(json_text(counts)) == counts
