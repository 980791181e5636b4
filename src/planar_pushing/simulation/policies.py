"""Policies over time: which contact mode is taken where several are consistent, and from when on."""

from __future__ import annotations

from typing import Any

import numpy as np

from planar_pushing.simulation.timed import timed
from planar_pushing.terms.errors import InvalidValue, require_option
from planar_pushing.terms.options import Policy

#: Start times, the first of which is 0, and the policies that hold from then on.
Policies = tuple[tuple[float, Policy], ...]
ALLOWED = f"{', '.join(Policy)}, or a sequence of (start_time, policy)"
REMEDY = "name one of these policies"


def required_policies(given: Any) -> Policies:
    """Policies over time, of which a policy alone holds from 0 on, or `InvalidValue`."""
    if isinstance(given, (list, tuple)):
        return timed("on_ambiguity", given, _policy, ALLOWED, REMEDY)
    if not isinstance(given, str) or given not in list(Policy):
        raise InvalidValue("on_ambiguity", given, ALLOWED, REMEDY)
    return ((0.0, Policy(given)),)


def _policy(given: Any) -> Policy:
    return require_option("on_ambiguity", given, Policy, REMEDY)


def starts_of(policies: Policies) -> list[float]:
    """Times at which a policy begins to hold."""
    return [start for start, _ in policies]


def marked(fences: Any, policies: Policies) -> Any:
    """Write the policy of each piece of fences into it, and return the pieces."""
    numbers = np.array([list(Policy).index(policy) for _, policy in policies])
    held = np.searchsorted(starts_of(policies), fences["start"], side="right") - 1
    fences["policy"] = numbers[held]
    return fences
