"""Points that carry weight: the feet of a table, a tripod."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from planar_pushing.mechanics.compiled import inlined
from planar_pushing.mechanics.supports.base import Position, positions, weights
from planar_pushing.mechanics.supports.pressure.assembly import assembled, center, extent
from planar_pushing.mechanics.supports.pressure.record import Pieces, Pressure
from planar_pushing.mechanics.supports.pressure.sums import NOTHING, added, point
from planar_pushing.terms.errors import InvalidValue

#: A centre of rotation this close to an atom, over the size of the numbers it was computed from, is on it.
ROUNDING = 1e-15


@dataclass(frozen=True, slots=True)
class Points:
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

    def record(self, radius: float) -> Pressure:
        return assembled(self.pieces(), radius)


@inlined
def of_atoms(atoms, x, y, p_x, p_y, extent):
    """Sum over the atoms, its torque about p, and which is at (x, y), or -1; that one gives no force."""
    total, hit = NOTHING, -1
    for i in range(len(atoms)):
        q_x, q_y, share = atoms[i, 0], atoms[i, 1], atoms[i, 2]
        r_x, r_y = x - q_x, y - q_y
        if abs(r_x) + abs(r_y) <= ROUNDING * (extent + abs(q_x) + abs(q_y)):
            hit = i
        else:
            total = added(total, share, point(r_x, r_y), q_x - p_x, q_y - p_y)
    return total, hit
