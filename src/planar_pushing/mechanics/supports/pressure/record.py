"""The one record of a pressure distribution, whatever its pieces."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]


#: Kinds of rows of a record, in their order.
ATOMS, SEGMENTS, RINGS, DISCS, PLATES, EDGES = range(6)
#: Columns of a row.
COLUMNS = 6


class Pressure(NamedTuple):
    """Unit pressure in the compiled core: pieces whose shares add to 1, in the body frame.

    Lengths are in units of the slider's radius. All pieces are rows of one array, since each array that a
    function takes costs it time. Rows that are shorter than others end in zeros.

    Parameters
    ----------
    center_x, center_y : float
        Center of pressure.
    extent : float
        Largest distance of the support from the center of pressure.
    spread : tuple of float
        Means of x x, x y and y y from the center of pressure.
    starts : tuple of int
        Rows in which the pieces of each kind begin: `ATOMS` to `EDGES`.
    series : int
        Number of the first plate's multipoles.
    rows : array, shape (n, COLUMNS)
        Atoms are points: x, y, share, and the square of the distance below which a center of rotation is
        on the point. No two are at the same place.
        Segments are even lines: x and y of the middle, unit tangent, half the length, share.
        Rings and discs are even: x and y of the center, radius, share. A hole has a negative share.
        Plates are areas whose pressure is even between edges: x and y of the center of pressure, largest
        distance of an edge from it, share, and the rows in which its edges begin and end.
        Edges of the plates: x and y of the middle from the plate's center, unit tangent, half the length,
        and the pressure on the left of the tangent less that on the right, per unit share.
    multipoles : array, shape (m, ROWS, 2)
        Moments of the plates as `far` of `multipole` reads them.
    """

    center_x: float
    center_y: float
    extent: float
    spread: tuple[float, float, float]
    starts: tuple[int, int, int, int, int, int]
    series: int
    rows: Array
    multipoles: Array


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
        Edges of each plate: x and y of both ends, and the pressure on the left less that on the right.
    """

    atoms: Array = np.empty((0, 3))
    segments: Array = np.empty((0, 5))
    rings: Array = np.empty((0, 4))
    discs: Array = np.empty((0, 4))
    plates: tuple[Array, ...] = ()
