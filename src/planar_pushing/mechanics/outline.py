"""The outline of an object: its corners in order, and its sides."""

from __future__ import annotations

from typing import Any

import numpy as np

from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.supports.polygon import counterclockwise, simple_ring

Corners = tuple[tuple[float, float], ...]


def require_outline(value: Any, name: str = "outline") -> Corners:
    """Corners of a simple polygon, counterclockwise, without those inside a straight side.

    Raises
    ------
    InvalidValue
        If the outline is not a simple polygon.
    """
    corners = counterclockwise(simple_ring(name, value))
    before, behind = corners - np.roll(corners, 1, axis=0), np.roll(corners, -1, axis=0) - corners
    cross = before[:, 0] * behind[:, 1] - before[:, 1] * behind[:, 0]
    turns = np.abs(cross) > 1e-12 * np.hypot(*before.T) * np.hypot(*behind.T)
    return tuple((float(a), float(b)) for a, b in corners[turns])


def size(corners: Array) -> float:
    """Largest extent of an outline along x or y."""
    return float(np.ptp(corners, axis=0).max())
