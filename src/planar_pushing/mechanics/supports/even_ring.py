"""An even ring, anywhere on the slider."""

from __future__ import annotations

from dataclasses import dataclass
from math import sqrt

import numpy as np

from planar_pushing.mechanics.compiled import compiled, inlined
from planar_pushing.mechanics.pictures import Pictured
from planar_pushing.mechanics.supports.base import Position
from planar_pushing.mechanics.supports.pressure.record import DISCS, RINGS, Pieces
from planar_pushing.mechanics.supports.pressure.sums import added, turned
from planar_pushing.mechanics.supports.ring import ring_wrench
from planar_pushing.terms.errors import require_positive


@dataclass(frozen=True, slots=True)
class Ring(Pictured):
    """Support on a ring about the slider's center, its pressure even: the paper's.

    Parameters
    ----------
    radius : float, optional
        Greater than 0; without one the ring has the slider's radius.

    Raises
    ------
    InvalidValue
        Where the radius is not positive.
    """

    radius: float | None = None

    def __post_init__(self) -> None:
        if self.radius is not None:
            radius = require_positive(
                "radius", self.radius, "use Points for a support on one point"
            )
            object.__setattr__(self, "radius", radius)

    @property
    def center_of_pressure(self) -> Position:
        return 0.0, 0.0

    @property
    def extent(self) -> float:
        """The radius, and 1 where the slider gives it, which is then the unit of length."""
        return 1.0 if self.radius is None else self.radius

    def pieces(self) -> Pieces:
        return Pieces(rings=np.array([[0.0, 0.0, self.extent, 1.0]]))


@inlined
def of_rings(total, pressure, x, y):
    """Totals, their torque about p, with the rings."""
    rows, p_x, p_y = pressure.rows, pressure.center_x, pressure.center_y
    for i in range(pressure.starts[RINGS], pressure.starts[DISCS]):
        q_x, q_y, radius, share = rows[i, 0], rows[i, 1], rows[i, 2], rows[i, 3]
        total = added(total, share, ring(x - q_x, y - q_y, radius), q_x - p_x, q_y - p_y)
    return total


@compiled
def ring(x, y, radius):
    """The piece of an even ring: Eqs. (2)-(3) at the spin ratio R / c."""
    c = sqrt(x * x + y * y) / radius
    force, torque, slope = ring_wrench(c, 1.0)
    along = slope if c < 1.0 else slope / (c * c * c)
    across = force / c if c > 0.0 else 0.5
    distance = radius * (torque + c * force)
    return turned(x, y, distance, force, radius * torque, along / radius, across / radius)
