"""Decisions at the first precision that suffices."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar

from flint import ctx

from planar_pushing.certified.balls import Undecided

#: Precisions in bits that are tried in turn.
PRECISIONS = (128, 256, 512)

Found = TypeVar("Found")


def decided(decide: Callable[[], Found]) -> Found:
    """Decide at the first precision that suffices; everything is made anew at each.

    Raises
    ------
    Undecided
        Where a sign stays open at the last precision.
    """
    for precision in PRECISIONS[:-1]:
        try:
            with ctx.workprec(precision):
                return decide()
        except Undecided:
            continue
    with ctx.workprec(PRECISIONS[-1]):
        return decide()
