"""Decisions at the first precision that suffices."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TypeVar

from flint import ctx

from planar_pushing.certified.balls import Exhausted, Undecided

#: Precisions in bits that are tried in turn: for a decision, and for stored numbers.
COARSE, FINE = (128, 256, 512), (320, 640, 1280)

Found = TypeVar("Found")


def decided(decide: Callable[[], Found], precisions: Sequence[int] = COARSE) -> Found:
    """Decide at the first precision that suffices; everything is computed from scratch at each.

    Raises
    ------
    Undecided
        If a sign remains undecided at the last precision.
    """
    for precision in precisions[:-1]:
        try:
            with ctx.workprec(precision):
                return decide()
        except Exhausted:
            raise
        except Undecided:
            continue
    with ctx.workprec(precisions[-1]):
        return decide()
