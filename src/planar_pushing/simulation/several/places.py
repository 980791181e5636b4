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
        Arc length from the contact at time 0; of two places the inner corner between them, as of a point,
        or the mean if there is not one.
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
        arcs = _near(arcs - self._reference, self.along, perimeter)
        self.along = float(arcs.mean())
        self.normal = float(_near(row.pose.angle + turns, self.normal, TURN).mean())
        if len(touches) == 1:
            return int(pieces[0])
        numbers = self._chain_of(int(pieces[0]))
        chain = self.outline.pieces[numbers]
        away = (chain[:, START] - self._reference - self.along) % perimeter
        away -= perimeter * (away > perimeter / 2.0)
        is_between = (chain[:, RHO] == 0.0) & (chain[:, BETA1] < chain[:, BETA0])
        is_between &= np.abs(away) < float(np.ptp(arcs)) / 2.0
        if is_between.sum() == 1:
            corner = int(is_between.argmax())
            self.along += float(away[corner])
            return int(numbers[corner])
        arc = (self.along + self._reference) % perimeter
        return int(numbers[np.searchsorted(chain[:, START], arc, side="right") - 1])

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


def _touches_of_finger(row: Row) -> list[Touch]:
    """The places of the finger that do not separate; all of them if each does."""
    touches = [
        (touch, mode)
        for touch, mode in zip(row.touches, row.modes, strict=True)
        if touch.mover == 0
    ]
    closed = [touch for touch, mode in touches if mode != ContactMode.SEPARATE]
    return closed or [touch for touch, _ in touches]


def _near(values: Array, last: float, period: float) -> Array:
    """Values but for multiples of a period, near to one another, with their mean near to the last one."""
    values = values + period * np.round((values[0] - values) / period)
    return np.asarray(values + period * round((last - float(values.mean())) / period))
