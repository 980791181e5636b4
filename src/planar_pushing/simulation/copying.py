"""Copying of rows of numbers."""

from __future__ import annotations

from planar_pushing.simulation.legacy.compiled import compiled


@compiled
def copy(target, source):
    """Copy one row into another.

    An assignment to a slice would create a temporary array in case the two overlap. It would also compile
    numba's text formatting for an error message about shapes, which takes seconds.
    """
    for k in range(len(target)):
        target[k] = source[k]
