"""Points that carry weight: the feet of a table, a tripod."""

from __future__ import annotations

from dataclasses import dataclass
from math import sqrt
from typing import Any

import numpy as np

from planar_pushing.mechanics.compiled import summing
from planar_pushing.mechanics.pictures import Pictured
from planar_pushing.mechanics.supports.base import Position, positions, weights
from planar_pushing.mechanics.supports.pressure.assembly import center, extent
from planar_pushing.mechanics.supports.pressure.record import ATOMS, SEGMENTS, Pieces
from planar_pushing.mechanics.supports.pressure.sums import NOTHING
from planar_pushing.terms.errors import InvalidValue


@dataclass(frozen=True, slots=True)
class Points(Pictured):
    """Support on points.

    Parameters
    ----------
    positions : sequence of pairs
        Points in the body frame. Points at the same place act as one.
    weights : sequence of float
        What each carries, > 0, in any unit.

    Raises
    ------
    InvalidValue
        Where there is no point, a number is not finite, or a weight is missing or not positive.
    """

    positions: Any
    weights: Any

    def __post_init__(self) -> None:
        remedy = "give x and y of each point in the body frame"
        places = positions("positions", self.positions, remedy)
        if not places:
            raise InvalidValue("positions", self.positions, "at least one point", remedy)
        loads = weights("weights", self.weights, len(places), "give one weight for each point")
        object.__setattr__(self, "positions", places)
        object.__setattr__(self, "weights", loads)

    @property
    def center_of_pressure(self) -> Position:
        return center(self.pieces())

    @property
    def extent(self) -> float:
        return extent(self.pieces())

    def pieces(self) -> Pieces:
        loads = np.array(self.weights)
        return Pieces(atoms=np.column_stack([self.positions, loads / loads.sum()]))


@summing
def of_atoms(pressure, x, y, blur):
    """Sum over the atoms, its torque about p, and which is at (x, y), or -1; that one gives no force.

    `blur` is the square of the distance within which an atom is there.
    """
    rows, first, hit = pressure.rows, pressure.starts[ATOMS], -1
    distance, unit_x, unit_y, torque, xx, xy, yy = NOTHING
    for i in range(first, pressure.starts[SEGMENTS]):
        q_x, q_y, share = rows[i, 0], rows[i, 1], rows[i, 2]
        r_x, r_y = q_x - x, q_y - y
        square = r_x * r_x + r_y * r_y
        apart = square > max(rows[i, 3], blur)
        hit = max(hit, -1 if apart else i - first)
        # The square root and the division do not wait for one another.
        away, bend = sqrt(square), (1.0 if apart else 0.0) / (square if apart else 1.0)
        f_x, f_y = share * (away * bend) * r_x, share * (away * bend) * r_y
        distance += share * away
        unit_x += f_x
        unit_y += f_y
        torque += (q_x - pressure.center_x) * f_x + (q_y - pressure.center_y) * f_y
        xx += bend * f_y * r_y
        xy -= bend * f_x * r_y
        yy += bend * f_x * r_x
    return (distance, unit_x, unit_y, torque, xx, xy, yy), hit
