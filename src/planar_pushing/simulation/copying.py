"""Copies of rows of numbers."""

from __future__ import annotations

from planar_pushing.mechanics.compiled import compiled


@compiled
def copy(target, source):
    """Write one row into another.

    An assignment to a slice would make an array in between, lest the two overlap, and compile numba's
    formatting of text for its message about shapes, which takes seconds.
    """
    for k in range(len(target)):
        target[k] = source[k]
