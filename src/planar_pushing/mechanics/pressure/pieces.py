"""The pieces of which every pressure distribution consists."""

from __future__ import annotations

from typing import NamedTuple

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
