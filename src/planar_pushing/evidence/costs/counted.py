"""Counts of how often each effect is evaluated, at a motion or a line of force each.

Compiled code cannot be watched: counting needs a process with ``NUMBA_DISABLE_JIT=1``, in which every
function of the mechanics is the Python function that it is in the source.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from threading import Lock
from typing import Any
from unittest.mock import patch

import numba

from planar_pushing.mechanics.effects import inertia
from planar_pushing.mechanics.numerics.root import EQUATIONS
from planar_pushing.mechanics.reduced import isotropic, turning
from planar_pushing.mechanics.supports import ring
from planar_pushing.terms.errors import PlanarPushingError
from planar_pushing.terms.options import EffectKind

Function = Callable[..., Any]
#: Where an effect is evaluated: friction in the one function behind the ring's wrench and its inverse,
#: inertia at a motion, under a line of force, and where its terms stand in an equation with friction.
PLACES: tuple[tuple[EffectKind, dict[Any, Any], Any], ...] = (
    (EffectKind.SUPPORT_FRICTION, vars(ring), "curves"),
    (EffectKind.INERTIA, vars(inertia), "response"),
    (EffectKind.INERTIA, vars(inertia), "spin_ratio"),
    (EffectKind.INERTIA, vars(inertia), "leverages"),
    (EffectKind.INERTIA, vars(turning), "_node"),
    (EffectKind.INERTIA, EQUATIONS, isotropic.CurveImbalance),
)


@contextmanager
def counting() -> Iterator[Counter[str]]:
    """Tally of the evaluations of each effect while the context is open.

    Raises
    ------
    PlanarPushingError
        Where the mechanics are compiled.
    """
    if not numba.config.DISABLE_JIT:
        raise PlanarPushingError(
            "compiled code cannot be counted; set NUMBA_DISABLE_JIT=1 before the process starts"
        )
    tally, lock = Counter[str](), Lock()
    with ExitStack() as stack:
        for effect, place, key in PLACES:
            watched = _watched(place[key], effect, tally, lock)
            stack.enter_context(patch.dict(place, {key: watched}))
        yield tally


def _watched(function: Function, effect: EffectKind, tally: Counter[str], lock: Lock) -> Function:
    def watched(*given: Any) -> Any:
        with lock:
            tally[str(effect)] += 1
        return function(*given)

    return watched
