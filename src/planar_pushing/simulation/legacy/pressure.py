"""The common record of all pressure distributions."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]
#: Kinds of rows of a record, in order.
ATOMS, SEGMENTS, RINGS, DISCS, PLATES, EDGES = range(6)


class Pressure(NamedTuple):
    """Unit pressure in the compiled core: pieces in the body frame whose shares add up to 1.

    Lengths are in units of the slider's radius. All pieces are rows of one array, because each array
    argument costs a function time. Shorter rows are padded with zeros.

    Parameters
    ----------
    center_x, center_y : float
        Center of pressure.
    extent : float
        Largest distance of the support from the center of pressure.
    spread : tuple of float
        Means of x x, x y and y y relative to the center of pressure.
    starts : tuple of int
        First row of each kind of piece, `ATOMS` to `EDGES`, and the number of rows.
    series : int
        Number of the first plate's multipoles.
    rows : array, shape (n, COLUMNS)
        Atoms are points: x, y, share, and the square of the distance below which a center of rotation is
        on the point. No two are at the same place.
        Segments are uniform lines: x and y of the midpoint, unit tangent, half length, share.
        Rings and discs are uniform: x and y of the center, radius, share. A hole has a negative share.
        Plates are areas with uniform pressure between edges: x and y of the center of pressure, largest
        distance of an edge from it, share, and the rows in which its edges begin and end.
        Edges of the plates: x and y of the midpoint from the plate's center, unit tangent, half length, and
        the pressure on the left of the tangent minus that on the right, per unit share.
    multipoles : array, shape (m, ROWS, 2)
        Moments of the plates, in the form that `multipole.far` reads.
    """

    center_x: float
    center_y: float
    extent: float
    spread: tuple[float, float, float]
    starts: tuple[int, int, int, int, int, int]
    series: int
    rows: Array
    multipoles: Array
