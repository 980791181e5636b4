"""Moments of the pressure of a support at centers of rotation."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from planar_pushing.core.pieces import HEAD
from planar_pushing.mechanics.kernels import run
from planar_pushing.mechanics.pressure.pieces import Array
from planar_pushing.mechanics.pressure.table import Table


class Moments(NamedTuple):
    """Moments of a pressure, as in `core.pieces.Moments`, of the shape of the centers.

    Attributes
    ----------
    distance : ndarray
        D, the mean distance to the center of rotation.
    unit_x, unit_y : ndarray
        G, the mean unit vector away from it.
    torque : ndarray
        T, about the center of pressure.
    xx, xy, yy : ndarray
        Second derivatives of D.
    atom : ndarray
        Number of the atom at the center of rotation, or -1.
    """

    distance: Array
    unit_x: Array
    unit_y: Array
    torque: Array
    xx: Array
    xy: Array
    yy: Array
    atom: Array


def moments(table: Table, x: npt.ArrayLike, y: npt.ArrayLike, number: int = 0) -> Moments:
    """Moments of one pressure of a table at centers of rotation.

    Parameters
    ----------
    table : Table
    x, y : array_like
        In the body frame, in the unit of the table, up to 1e9 extents away.
    number : int, optional
        Number of the support.
    """
    columns = np.broadcast_arrays(float(HEAD * number), x, y)
    rows = np.stack([column.ravel() for column in columns], axis=1)
    results = run("moments", table.data, rows, len(Moments._fields))
    return Moments(*(each.reshape(columns[0].shape)[()] for each in results.T))
