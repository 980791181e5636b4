"""The methods that work-precision diagrams compare."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from planar_pushing.mechanics.plane import Array

#: Elements in a batch of a method that costs nanoseconds each.
BATCH = 4096
#: Settings of a method without any.
CLOSED = (0.0,)
#: Maps arguments of shape (n,) and, last, a setting to results and, last, to counts of evaluations.
Run = Callable[..., tuple[Array, ...]]


@dataclass(frozen=True, slots=True, kw_only=True)
class Method:
    """A way to compute a wrench or the edge of a motion cone; `budget` is what a timed call of it takes."""

    name: str
    settings: tuple[float, ...]
    run: Run
    budget: int
