"""The pieces of which every pressure distribution consists, and their second moments."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]
#: Kinds of pieces, in order, and the edges of plates.
ATOMS, SEGMENTS, RINGS, DISCS, PLATES, EDGES = range(6)


class Pieces(NamedTuple):
    """Pieces of a support in the body frame, in the user's unit of length; the last column is the share.

    Parameters
    ----------
    atoms : array, shape (n, 3)
        x, y, share.
    segments : array, shape (n, 5)
        x and y of both ends, share.
    rings, discs : array, shape (n, 4)
        x and y of the center, radius, share.
    plates : tuple of arrays, shape (m, 5)
        Edges of each plate: x and y of both ends, and the pressure on the left minus that on the right.
    """

    atoms: Array = np.empty((0, 3))
    segments: Array = np.empty((0, 5))
    rings: Array = np.empty((0, 4))
    discs: Array = np.empty((0, 4))
    plates: tuple[Array, ...] = ()


#: For each kind of piece, the columns in which its two ends, or its one position, begin.
ENDS = ((ATOMS, 0, 0), (SEGMENTS, 0, 2), (RINGS, 0, 0), (DISCS, 0, 0), (EDGES, 0, 2))
#: For round pieces, the mean square of a coordinate from their center divided by the squared radius.
ROUND = {RINGS: 1 / 2, DISCS: 1 / 4}


def spreads(rows: list[Array], owners: list[Any], centers: Array) -> Array:
    """Means of x x, x y and y y from the centers of pressure, shape (supports, 3)."""
    totals = np.zeros((len(centers), 3))
    for kind, first, last in ENDS:
        pieces = rows[kind]
        if not len(pieces):
            continue
        around = centers[owners[kind]]
        start, end = pieces[:, first : first + 2] - around, pieces[:, last : last + 2] - around
        means, share = _along(start, end), pieces[:, -1]
        if kind in ROUND:
            means[:, [0, 2]] += ROUND[kind] * pieces[:, 2:3] ** 2
        if kind == EDGES:
            # Moments of the triangle from the center to the edge, weighted by its share of the pressure.
            share = share * (start[:, 0] * end[:, 1] - start[:, 1] * end[:, 0]) / 4
        np.add.at(totals, owners[kind], share[:, None] * means)
    return totals


def _along(start: Array, end: Array) -> Array:
    """Means of x x, x y and y y over uniform lines."""
    (a, b), (c, d) = start.T, end.T
    xx, yy = (a * a + a * c + c * c) / 3, (b * b + b * d + d * d) / 3
    means = np.empty((len(start), 3))
    means[:, 0], means[:, 1], means[:, 2] = xx, (2 * a * b + a * d + b * c + 2 * c * d) / 6, yy
    return means
