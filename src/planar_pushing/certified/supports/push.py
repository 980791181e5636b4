"""A line of force through the contact of a slider with any support, in its body frame."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import TypeVar

from flint import arb, ctx, fmpq

from planar_pushing.certified.balls import (
    Exact,
    Undecided,
    cosine_sine,
    exact_direction,
    has_exact_direction,
    rational,
    sign,
)
from planar_pushing.certified.supports.pressure.mirror import is_mirrored
from planar_pushing.certified.supports.pressure.moments import Vector
from planar_pushing.certified.supports.pressure.pieces import Pieces, Place

#: Precisions in bits that are tried in turn.
PRECISIONS = (320, 640, 1280)

Found = TypeVar("Found")


@dataclass(frozen=True, slots=True)
class Push:
    """A line of force of direction t at the contact P = (-l, 0).

    Attributes
    ----------
    support : Pieces
    length : fmpq
        Of the rod, in the unit of the support's lengths.
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
        """P."""
        return -self.length, fmpq(0)

    def arm(self, place: Vector) -> arb:
        """Moment of a unit force about a place, with its sign changed: the sign of a rotation there."""
        return self.x * place[1] - self.y * (place[0] + self.length)

    def reach(self, place: Vector) -> arb:
        """Distance of a place from the contact along the force."""
        return self.x * (place[0] + self.length) + self.y * place[1]

    def side(self, place: Place) -> int:
        """Sign of `arm` at an exact place."""
        x, y = place[0] + self.length, place[1]
        return sign(self.x * y - self.y * x, self._known(lambda t_x, t_y: t_x * y - t_y * x))

    def along(self, run: Place) -> int:
        """Sign of an exact vector's part along the force."""
        x, y = run
        return sign(self.x * x + self.y * y, self._known(lambda t_x, t_y: t_x * x + t_y * y))

    def touches(self, center: Place, radius: fmpq) -> bool:
        """Whether the line touches a circle."""
        x, y = center[0] + self.length, center[1]
        ball = (self.x * y - self.y * x) ** 2 - radius**2

        def exact(t_x: Exact, t_y: Exact) -> Exact:
            return (t_x * y - t_y * x) ** 2 - radius**2 * (t_x**2 + t_y**2)

        return sign(ball, self._known(exact)) == 0

    def _known(self, value: Callable[[Exact, Exact], Exact]) -> Callable[[], Exact] | None:
        known = self.exact
        return None if known is None else lambda: value(*known)


def ball(place: Place) -> Vector:
    """An exact place as balls."""
    return arb(place[0]), arb(place[1])


def is_even(push: Push) -> bool:
    """Whether force and motion of the contact are parallel by symmetry.

    Mirrored in the rod, a force or a motion across it and all that follows change their signs.
    """
    return push.along((fmpq(1), fmpq(0))) == 0 and is_mirrored(push.support)


def at_angle(support: Pieces, length: fmpq, rod_angle: fmpq, force_angle: fmpq) -> Push:
    """The line of a force at an angle from the fence; angles in degrees."""
    turn = force_angle - rod_angle
    exact = exact_direction(turn) if has_exact_direction(turn) else None
    return Push(support, length, *cosine_sine(turn), exact)


def on_edge(support: Pieces, length: fmpq, rod_angle: fmpq, friction: float, side: int) -> Push:
    """The line of a force on an edge of the friction cone, 1 for the right and -1 for the left one."""
    if math.isinf(friction):
        return at_angle(support, length, rod_angle, fmpq(90 - 90 * side))
    mu, (c, s) = side * rational(friction), cosine_sine(rod_angle)
    size = arb(1 + mu * mu).sqrt()
    exact = None
    if has_exact_direction(rod_angle):
        e_c, e_s = exact_direction(rod_angle)
        exact = mu * e_c + e_s, e_c - mu * e_s
    return Push(support, length, (mu * c + s) / size, (c - mu * s) / size, exact)


def decided(decide: Callable[[Push], Found], push: Callable[[], Push]) -> Found:
    """Decide on a push at the first precision that suffices; the push is made anew at each precision.

    Raises
    ------
    Undecided
        Where a sign stays open at the last precision.
    """
    for precision in PRECISIONS[:-1]:
        try:
            with ctx.workprec(precision):
                return decide(push())
        except Undecided:
            continue
    with ctx.workprec(PRECISIONS[-1]):
        return decide(push())
