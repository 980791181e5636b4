"""A line of force through the contact of a slider with any support, in its body frame."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from flint import arb, fmpq

from planar_pushing.certified.balls import Exact, sign
from planar_pushing.certified.supports.pressure.moments import Vector
from planar_pushing.certified.supports.pressure.pieces import Pieces, Place


@dataclass(frozen=True, slots=True)
class Push:
    """A line of force of direction t at the contact P = (-l, 0).

    Attributes
    ----------
    support : Pieces
    length : fmpq
        Length of the rod, in the unit of the support's lengths.
    x, y : arb
        Unit vector t.
    exact : tuple, optional
        A positive multiple of t in the cyclotomic field.
    """

    support: Pieces
    length: fmpq
    x: arb
    y: arb
    exact: tuple[Exact, Exact] | None = None

    @property
    def contact(self) -> Place:
        """The contact P."""
        return -self.length, fmpq(0)

    def arm(self, place: Vector) -> arb:
        """Moment of a unit force about a place, with reversed sign: the sign of a rotation about it."""
        return self.x * place[1] - self.y * (place[0] + self.length)

    def reach(self, place: Vector) -> arb:
        """Distance of a place from the contact along the force."""
        return self.x * (place[0] + self.length) + self.y * place[1]

    def side(self, place: Place) -> int:
        """Sign of `arm` at an exact place."""
        x, y = place[0] + self.length, place[1]
        return sign(self.x * y - self.y * x, self._known(lambda t_x, t_y: t_x * y - t_y * x))

    def along(self, run: Place) -> int:
        """Sign of the component of an exact vector along the force."""
        x, y = run
        return sign(self.x * x + self.y * y, self._known(lambda t_x, t_y: t_x * x + t_y * y))

    def _known(self, value: Callable[[Exact, Exact], Exact]) -> Callable[[], Exact] | None:
        known = self.exact
        return None if known is None else lambda: value(*known)


def ball(place: Place) -> Vector:
    """An exact place as balls."""
    return arb(place[0]), arb(place[1])
