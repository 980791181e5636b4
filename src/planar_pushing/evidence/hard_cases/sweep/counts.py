"""A sweep of random and adversarial inputs over kernels and contact modes, and its counts."""

from __future__ import annotations

import warnings
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from planar_pushing.evidence.hard_cases.sweep import conditions, decisions, kernels
from planar_pushing.evidence.hard_cases.sweep.adversarial import Generator
from planar_pushing.evidence.hard_cases.sweep.decisions import Decision

#: Checks of the functions of arrays.
KERNELS: dict[str, Callable[[Generator, int], kernels.Wrong]] = {
    "ring_profile": kernels.ring_profiles,
    "ring_spin_ratio": kernels.inverses,
    "motion_angle, friction": kernels.motion_angles,
    "motion_angle, inertia": kernels.motion_angles_of_inertia,
    "motion_angle, both": kernels.motion_angles_of_both,
    "motion cone edges": kernels.cone_edges,
    "limit_curve": kernels.limit_curves,
}
#: Scenes of one set of effects and one law that are solved at once.
BLOCK = 500
Counts = dict[str, dict[str, int]]


@dataclass(frozen=True, slots=True, kw_only=True)
class Budget:
    """How many inputs: of each kernel, scenes in arrays, scenes one at a time, and certified ones."""

    kernels: int
    scenes: int
    scalar: int
    decided: int


FULL = Budget(kernels=1_000_000, scenes=1_000_000, scalar=5000, decided=10_000)


def sweep(budget: Budget, seed: int = 1995) -> Counts:
    """Check invariants and decisions on the inputs that a seed gives; a warning is an error.

    Returns
    -------
    dict
        For each kind the number of inputs and of failures, and what was refused or left open.
    """
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        counts = {name: _kernel(name, budget, seed) for name in KERNELS}
        counts["contact modes, vectorised"] = _vectorised(budget, seed)
        counts["contact modes, solve"] = _scalar(budget, seed)
        counts["contact modes, certified"] = _decided(budget, seed)
    return counts


def _kernel(name: str, budget: Budget, seed: int) -> dict[str, int]:
    wrong = KERNELS[name](np.random.default_rng(seed), budget.kernels)
    return {"inputs": wrong.size, "failures": int(wrong.sum())}


def _vectorised(budget: Budget, seed: int) -> dict[str, int]:
    blocks = range(budget.scenes // BLOCK)
    rngs = (np.random.default_rng([seed, i]) for i in blocks)
    wrong = [conditions.checked(rng, i, BLOCK) for i, rng in zip(blocks, rngs, strict=True)]
    return {"inputs": BLOCK * len(wrong), "failures": sum(int(each.sum()) for each in wrong)}


def _scalar(budget: Budget, seed: int) -> dict[str, int]:
    found = [decisions.scalar(np.random.default_rng([seed, i])) for i in range(budget.scalar)]
    refused, wrong = (sum(part) for part in zip(*found, strict=True))
    return {"inputs": budget.scalar, "failures": wrong, "refused": refused}


def _decided(budget: Budget, seed: int) -> dict[str, int]:
    found = Counter(
        decisions.decided(np.random.default_rng([seed, i])) for i in range(budget.decided)
    )
    ties = {each.name.lower(): found[each] for each in (Decision.TIE, Decision.UNDECIDED)}
    return {"inputs": budget.decided, "failures": found[Decision.WRONG], **ties}
