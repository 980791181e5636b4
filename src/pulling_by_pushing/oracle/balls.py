"""Balls: precision, certified signs, exact directions, and numbers with the roundings that they allow.

A ball is an `arb`, a midpoint with a rigorous radius. If a ball contains zero, its sign is decided by
exact arithmetic in a cyclotomic field, or not at all.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache, wraps
from typing import Any, NamedTuple, ParamSpec, TypeVar

from flint import arb, ctx, fmpq, fmpq_poly, fmpz_poly

#: Working precision in bits, and the one at which an undecided answer is tried again.
PRECISION, FINE = 160, 480
#: Rounding of a double.
UNIT = arb(2) ** -53
#: Roundings that a number may be off: about four times 7.3, the worst ratio of the library's error to one
#: rounding of each term and input, over all golden data and two kinds of processors.
ROUNDINGS = 32
#: The exact numbers form the field of the roots of unity at multiples of half a degree.
_TURN = 720
_MODULUS = fmpq_poly(fmpz_poly.cyclotomic(_TURN))

P = ParamSpec("P")
T = TypeVar("T")
F = TypeVar("F", bound=Callable[..., Any])
Exact = Any  # fmpq_poly modulo the cyclotomic polynomial, or a rational
Vector = tuple[arb, arb]
Position = tuple[fmpq, fmpq]


ZERO = fmpq(0)


class Undecided(ArithmeticError):
    """A sign or a root that neither the precision nor exact arithmetic decides."""


def precise(function: Callable[P, T]) -> Callable[P, T]:
    """Evaluate a function at the working precision, and at a finer one if that is not enough."""

    @wraps(function)
    def evaluate(*args: P.args, **kwargs: P.kwargs) -> T:
        try:
            with ctx.workprec(PRECISION):
                return function(*args, **kwargs)
        except Undecided:
            with ctx.workprec(FINE):
                return function(*args, **kwargs)

    return evaluate


def remember(size: int) -> Callable[[F], F]:
    """Keep the results of a function of positional arguments, for each precision of its own."""

    def decorate(function: F) -> F:
        @lru_cache(size)
        def compute(_bits: int, *args: Any) -> Any:
            return function(*args)

        @wraps(function)
        def evaluate(*args: Any) -> Any:
            return compute(ctx.prec, *args)

        return evaluate  # type: ignore[return-value]

    return decorate


def rational(number: float | fmpq) -> fmpq:
    """The exact value of a finite double."""
    return number if isinstance(number, fmpq) else fmpq(*float(number).as_integer_ratio())


def rational_pair(numbers: Sequence[float]) -> Position:
    """Two doubles as exact numbers."""
    return rational(numbers[0]), rational(numbers[1])


def sign(ball: arb, exact: Callable[[], Exact] | None = None) -> int:
    """Sign of a number, -1, 0 or 1; `exact` returns a multiple of it, in case the ball contains zero.

    Raises
    ------
    Undecided
        If the ball contains zero and the number is not known to be zero.
    """
    if ball > 0:
        return 1
    if ball < 0:
        return -1
    if ball.is_zero() or (exact is not None and is_zero(exact())):
        return 0
    raise Undecided(f"the sign of {ball.str(6)} is undecided")


def is_zero(number: Exact) -> bool:
    """Whether an exact number vanishes."""
    return not number % _MODULUS if isinstance(number, fmpq_poly) else number == 0


def norm(x: arb, y: arb) -> arb:
    """Length of a vector; also near zero, where a product of balls could make a square negative."""
    square = x * x + y * y
    if square > 0 or square.is_zero():
        return square.sqrt()
    low, high = (
        arb(x.abs_lower()) ** 2 + arb(y.abs_lower()) ** 2,
        x.abs_upper() ** 2 + y.abs_upper() ** 2,
    )
    return low.sqrt().lower().union(arb(high).sqrt().upper())


def cross(a: Sequence[Any], b: Sequence[Any]) -> Any:
    """Cross product of two vectors of numbers of any kind."""
    return a[0] * b[1] - a[1] * b[0]


def dot(a: Iterable[Any], b: Iterable[Any]) -> Any:
    """Scalar product of two vectors of numbers of any kind."""
    return sum((x * y for x, y in zip(a, b, strict=True)), fmpq(0))


def cosine_sine(degrees: fmpq) -> Vector:
    """Cosine and sine of an angle in exact degrees; exact if they are rational."""
    sine, cosine = arb.sin_cos_pi_fmpq(degrees / 180)
    return cosine, sine


def in_degrees(radians: arb) -> arb:
    """Convert an angle from radians."""
    return radians * 180 / arb.pi()


@lru_cache(maxsize=4096)
def _exact_cosine(degrees: fmpq) -> fmpq_poly:
    power = int((degrees * 2).p) % _TURN
    coefficients = [0] * (_TURN + 1)
    coefficients[power] += 1
    coefficients[_TURN - power] += 1
    return fmpq_poly(coefficients, 2) % _MODULUS


@dataclass(frozen=True, slots=False, eq=False)
class Direction:
    """A unit vector, at an exact angle or along a rational vector, in the frame of the fence or of a rod.

    Attributes
    ----------
    degrees : fmpq or None
    vector : tuple of fmpq or None
    radians : fmpq
        The angle if neither `degrees` nor `vector` is stated; nothing is known exactly then.
    rod : fmpq
        The direction is in the frame of a rod at this angle in degrees; 0 for the frame of the fence.
    """

    degrees: fmpq | None = None
    vector: Position | None = None
    radians: fmpq = ZERO
    rod: fmpq = ZERO

    @cached_property
    def exact(self) -> tuple[Exact, Exact] | None:
        """A positive multiple of the vector in the cyclotomic field, or None."""
        if self.degrees is not None:
            angle = self.degrees - self.rod
            return (_exact_cosine(angle), _exact_cosine(90 - angle)) if _is_exact(angle) else None
        if self.vector is None:
            return None
        if not self.rod:
            return self.vector
        if not _is_exact(self.rod):
            return None
        (x, y), c, s = self.vector, _exact_cosine(self.rod), _exact_cosine(90 - self.rod)
        return x * c + y * s, y * c - x * s

    @property
    def ball(self) -> Vector:
        """The unit vector; components that vanish are exact."""
        return _ball(self)

    @property
    def angle(self) -> arb:
        """The angle in degrees, in the frame of the fence."""
        if self.degrees is not None:
            return arb(self.degrees)
        if self.vector is None:
            return in_degrees(arb(self.radians))
        return in_degrees(arb.atan2(arb(self.vector[1]), arb(self.vector[0])))

    @cached_property
    def roundings(self) -> arb:
        """Roundings of the vector: one, and those of the angles in radians."""
        turn = abs(self.angle) + abs(self.rod)
        return 1 + (turn * arb.pi() / 180).mid()

    @property
    def in_fence_frame(self) -> tuple[Exact, Exact] | None:
        """The exact vector in the frame of the fence, or None."""
        return _about(self, ZERO).exact

    def to_fence(self, vector: tuple[Exact, Exact]) -> tuple[Exact, Exact] | None:
        """An exact vector of the rod's frame in the frame of the fence, or None."""
        rod = at_degrees(self.rod).exact
        if rod is None:
            return None
        (x, y), (c, s) = vector, rod
        return x * c - y * s, x * s + y * c

    def about(self, rod: fmpq) -> Direction:
        """The same direction, with components in the frame of a rod at an angle in degrees."""
        return _about(self, rod)

    def sign(self, function: Callable[[Exact, Exact], Exact]) -> int:
        """Sign of a linear function of the vector with exact coefficients."""
        exact = self.exact
        return sign(function(*self.ball), None if exact is None else lambda: function(*exact))

    def across(self, point: Position) -> int:
        """Sign of the cross product with an exact vector: its side of the line along the direction."""
        return self.sign(lambda x, y: x * point[1] - y * point[0])

    def along(self, point: Position) -> int:
        """Sign of the scalar product with an exact vector."""
        return self.sign(lambda x, y: x * point[0] + y * point[1])


def _is_exact(degrees: fmpq) -> bool:
    return bool((degrees * 2).q == 1)


@lru_cache(maxsize=1 << 14)
def _about(direction: Direction, rod: fmpq) -> Direction:
    return replace(direction, rod=rod)


@remember(1 << 14)
def _ball(direction: Direction) -> Vector:
    if direction.degrees is not None:
        return cosine_sine(direction.degrees - direction.rod)
    c, s = cosine_sine(direction.rod)
    if direction.vector is None:
        sine, cosine = arb(direction.radians).sin_cos()
        return cosine * c + sine * s, sine * c - cosine * s
    x, y = direction.vector
    size = arb(x * x + y * y).sqrt()
    ball = (x * c + y * s) / size, (y * c - x * s) / size
    if direction.exact is None:
        return ball
    exact = direction.exact
    return _without_zero(ball[0], exact[0]), _without_zero(ball[1], exact[1])


def _without_zero(ball: arb, exact: Exact) -> arb:
    """The ball, or an exact zero if the number vanishes."""
    return arb(0) if ball.contains(0) and is_zero(exact) else ball


@lru_cache(maxsize=1 << 13)
def at_degrees(angle: fmpq | float) -> Direction:
    """The direction at an angle in degrees; the same object for the same angle."""
    return Direction(degrees=rational(angle))


def at_radians(angle: fmpq | float) -> Direction:
    """The direction at an angle in radians."""
    return Direction(radians=rational(angle))


@lru_cache(maxsize=1024)
def cone_edge(friction_coefficient: float, side: int) -> Direction:
    """Edge of the friction cone: side 1 is the right edge, -1 the left one."""
    if math.isinf(friction_coefficient):
        return at_degrees(fmpq(90 - 90 * side))
    return Direction(vector=(side * rational(friction_coefficient), fmpq(1)))


class Number(NamedTuple):
    """A number and its rounding: what one rounding of each term and of each input changes, over `UNIT`."""

    ball: arb
    rounding: arb

    @property
    def allowance(self) -> arb:
        """Largest difference that roundings explain."""
        return ROUNDINGS * UNIT * self.rounding


def terms(ball: arb, *parts: Any) -> Number:
    """A number that is computed directly, from terms of the given magnitudes; without them from itself."""
    return Number(ball, sum((abs(part) for part in parts), arb(abs(ball))))


def settle(number: Number, exact: Callable[[], Exact] | None = None) -> int:
    """Sign of a number that decides a flag or a membership.

    Raises
    ------
    Undecided
        If roundings could change the sign of a number that is not exactly zero.
    """
    result = sign(number.ball, exact)
    if result and not abs(number.ball) > number.allowance:
        raise Undecided(f"rounding decides the sign of {number.ball.str(6)}")
    return result
