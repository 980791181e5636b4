"""Copies of rows of numbers."""

from __future__ import annotations

from planar_pushing.mechanics.compiled import compiled


@compiled
def copy(target, source):
    """Write one row into another; an assignment would make an array in between, lest the two overlap."""
    for k in range(len(target)):
        target[k] = source[k]
