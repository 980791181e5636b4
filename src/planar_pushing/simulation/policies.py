"""Policies over time for choosing among several consistent contact modes."""

from __future__ import annotations

from typing import Any

import numpy as np

from planar_pushing.simulation.timed import timed
from planar_pushing.terms.errors import InvalidValue, require_option
from planar_pushing.terms.options import Policy

#: Start times, the first of which is 0, and the policies from then on.
Policies = tuple[tuple[float, Policy], ...]
ALLOWED = f"{', '.join(Policy)}, or a sequence of (start_time, policy)"
REMEDY = "name one of these policies"


def required_policies(given: Any) -> Policies:
    """Validate policies over time; a single policy applies from time 0."""
    if isinstance(given, (list, tuple)):
        return timed("on_ambiguity", given, _policy, ALLOWED, REMEDY)
    if not isinstance(given, str) or given not in list(Policy):
        raise InvalidValue("on_ambiguity", given, ALLOWED, REMEDY)
    return ((0.0, Policy(given)),)


def _policy(given: Any) -> Policy:
    return require_option("on_ambiguity", given, Policy, REMEDY)


def starts_of(policies: Policies) -> list[float]:
    """Start times of the policies."""
    return [start for start, _ in policies]


def marked(fences: Any, policies: Policies) -> Any:
    """Store the policy in each piece of the fences, and return the pieces."""
    numbers = np.array([list(Policy).index(policy) for _, policy in policies])
    held = np.searchsorted(starts_of(policies), fences["start"], side="right") - 1
    fences["policy"] = numbers[held]
    return fences
