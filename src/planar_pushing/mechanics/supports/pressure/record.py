"""The one record of a pressure distribution, whatever its pieces."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]


class Pressure(NamedTuple):
    """Unit pressure in the compiled core: pieces whose shares add to 1, in the body frame.

    Lengths are in units of the slider's radius. Arrays are C-contiguous; float64 but for `first`.

    Parameters
    ----------
    center_x, center_y : float
        Centre of pressure.
    extent : float
        Largest distance of the support from the centre of pressure.
    atoms : array, shape (n, 3)
        Points: x, y, share. No two are at the same place.
    segments : array, shape (n, 6)
        Even lines: x and y of the middle, unit tangent, half the length, share.
    rings, discs : array, shape (n, 4)
        Even circles and discs: x and y of the centre, radius, share. A hole has a negative share.
    plates : array, shape (n, 4)
        Areas whose pressure is even between edges: x and y of the centre of pressure, largest distance
        of an edge from it, share.
    first : array of int64, shape (n + 1,)
        Where the edges of each plate begin, and the number of all edges.
    edges : array, shape (m, 6)
        Edges of the plates: x and y of the middle from the plate's centre, unit tangent, half the
        length, and the pressure on the left of the tangent less that on the right, per unit share.
    multipoles : array, shape (n, TERMS, 2)
        Moments of the plates as `far` of `multipole` reads them.
    """

    center_x: float
    center_y: float
    extent: float
    atoms: Array
    segments: Array
    rings: Array
    discs: Array
    plates: Array
    first: npt.NDArray[np.int64]
    edges: Array
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
        x and y of the centre, radius, share.
    plates : tuple of arrays, shape (m, 5)
        Edges of each plate: x and y of both ends, and the pressure on the left less that on the right.
    """

    atoms: Array = np.empty((0, 3))
    segments: Array = np.empty((0, 5))
    rings: Array = np.empty((0, 4))
    discs: Array = np.empty((0, 4))
    plates: tuple[Array, ...] = ()
