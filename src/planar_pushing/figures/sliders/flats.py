"""Limit curves with flats: pieces whose forces all turn the slider about one support point."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import numpy.typing as npt
from matplotlib.axes import Axes

from planar_pushing.figures.parts.curves import BUTT
from planar_pushing.figures.style import DARK, FORCE, GREY
from planar_pushing.mechanics.plane import Array

#: Width of a flat, points.
FLAT = 2.4


def limit_line(ax: Axes, forces: Array, pivots: npt.NDArray[np.int16]) -> None:
    """Draw a limit curve, forces of shape (n, 2), about its origin; its flats are thick."""
    reach = 1.12 * float(np.abs(forces).max())
    for x, y in ((reach, 0.0), (0.0, reach)):
        ax.plot([-x, x], [-y, y], color=GREY, linewidth=0.4, zorder=1)
    ax.plot(*forces.T, color=DARK, **BUTT)
    for _, part in flats(pivots):
        ax.plot(*forces[part].T, color=FORCE, linewidth=FLAT, **BUTT)


def flats(pivots: npt.NDArray[np.int16]) -> Iterator[tuple[int, slice]]:
    """Number of the support point and place of every flat of a curve."""
    starts = np.flatnonzero(np.diff(pivots, prepend=-2))
    for start, stop in zip(starts, [*starts[1:], len(pivots)], strict=True):
        if pivots[start] >= 0:
            yield int(pivots[start]), slice(int(start), int(stop))
