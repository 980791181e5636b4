"""Counts of how often each effect is evaluated at a motion.

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
from planar_pushing.mechanics.supports import ring
from planar_pushing.terms.errors import PlanarPushingError
from planar_pushing.terms.options import EffectKind

Function = Callable[..., Any]
#: Where an effect is evaluated: friction in the ring's closed form, for its wrench and for its inverse.
PLACES: tuple[tuple[EffectKind, Any, str], ...] = (
    (EffectKind.SUPPORT_FRICTION, ring, "curves"),
    (EffectKind.INERTIA, inertia, "resistance"),
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
        for effect, module, name in PLACES:
            watched = _watched(getattr(module, name), effect, tally, lock)
            stack.enter_context(patch.object(module, name, watched))
        yield tally


def _watched(function: Function, effect: EffectKind, tally: Counter[str], lock: Lock) -> Function:
    def watched(*given: Any) -> Any:
        with lock:
            tally[str(effect)] += 1
        return function(*given)

    return watched
