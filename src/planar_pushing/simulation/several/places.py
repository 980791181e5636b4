"""The place of a finger's contact along the outline of an object, of which it can touch two pieces."""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.mechanics.outline import Outline
from planar_pushing.mechanics.outline.chains import BEFORE, BETA0, BETA1, LENGTH, RHO, START, TURN
from planar_pushing.mechanics.outline.places import nearest_place
from planar_pushing.simulation.several.movers import Touch
from planar_pushing.simulation.several.run import Row
from planar_pushing.terms.numbers import Array


class FingerPlace:
    """The place of a finger, which is the first mover of a run, as it goes along the outline.

    Attributes
    ----------
    along : float
        Arc length from the contact at time 0; of two places the mean, which in an inner corner is that of
        the corner, as of a point.
    normal : float
        Rotation of the normal since time 0, radians; of two places the mean.

    Parameters
    ----------
    outline : Outline
        In the body frame.
    """

    def __init__(self, outline: Outline) -> None:
        self.outline = outline
        self.along = self.normal = 0.0
        self._reference: float | None = None

    def measure_from(self, point: tuple[float, float]) -> None:
        """Measure arc lengths from a point of the outline; by default it is the first contact."""
        self._reference = float(self._arcs([point])[1][0])

    def follow(self, row: Row) -> int:
        """Go on to the places of an instant; return the piece of the outline."""
        touches = _touches_of_finger(row)
        pieces, arcs, perimeter = self._arcs([touch.point for touch in touches])
        if self._reference is None:
            self._reference = float(arcs[0])
        turns = np.array([math.atan2(-touch.normal[0], touch.normal[1]) for touch in touches])
        self.along = _mean_near(self.along, arcs - self._reference, perimeter)
        self.normal = _mean_near(self.normal, row.pose.angle + turns, TURN)
        if len(touches) == 1:
            return int(pieces[0])
        return self._piece_at(int(pieces[0]), self.along + self._reference, perimeter)

    def _arcs(
        self, points: list[tuple[float, float]]
    ) -> tuple[npt.NDArray[np.int64], Array, float]:
        """Pieces at points of the outline, their arc lengths, and the perimeter of their chain."""
        pieces, places = self.outline.pieces, nearest_place(self.outline, np.array(points))
        chain = pieces[self._chain_of(int(places.piece[0]))]
        perimeter = float((chain[:, START] + chain[:, LENGTH]).max())
        return places.piece, pieces[places.piece, START] + places.position, perimeter

    def _chain_of(self, piece: int) -> npt.NDArray[np.int64]:
        """The numbers of the pieces of a chain, of which one is given."""
        pieces = self.outline.pieces
        chains = np.cumsum(pieces[:, BEFORE] >= np.arange(len(pieces)))
        return np.flatnonzero(chains == chains[piece])

    def _piece_at(self, piece: int, arc: float, perimeter: float) -> int:
        """The piece of a chain at an arc length; near an inner corner, the corner."""
        numbers = self._chain_of(piece)
        chain = self.outline.pieces[numbers]
        away = np.abs(chain[:, START] - arc) % perimeter
        is_corner = (chain[:, RHO] == 0.0) & (chain[:, BETA1] < chain[:, BETA0])
        is_corner &= np.minimum(away, perimeter - away) <= self.outline.tolerance
        if is_corner.any():
            return int(numbers[is_corner.argmax()])
        return int(numbers[np.searchsorted(chain[:, START], arc % perimeter, side="right") - 1])


def _touches_of_finger(row: Row) -> list[Touch]:
    """The places of the finger that do not separate; all of them if each does."""
    touches = [
        (touch, mode)
        for touch, mode in zip(row.touches, row.modes, strict=True)
        if touch.mover == 0
    ]
    closed = [touch for touch, mode in touches if mode != ContactMode.SEPARATE]
    return closed or [touch for touch, _ in touches]


def _mean_near(last: float, values: Array, period: float) -> float:
    """The mean of values up to multiples of a period, near to one another and to the last mean."""
    values = values + period * np.round((values[0] - values) / period)
    mean = float(values.mean())
    return mean + period * round((last - mean) / period)
