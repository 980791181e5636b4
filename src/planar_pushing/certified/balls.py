"""Balls: precision, certified signs, angles in exact degrees, storage in doubles.

A ball is an `arb`, a midpoint with a rigorous radius. If a ball contains zero, its sign is decided by
exact arithmetic in a cyclotomic field, or not at all.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache, wraps
from typing import Any, ParamSpec, TypeVar

from flint import arb, ctx, fmpq, fmpq_poly, fmpz_poly

#: Working precision in bits. Results retain at least 84 of them, a relative radius below 1e-25.
PRECISION = 192

#: The exact numbers form the field of the roots of unity at multiples of half a degree.
_TURN = 720
_MODULUS = fmpq_poly(fmpz_poly.cyclotomic(_TURN))

P = ParamSpec("P")
T = TypeVar("T")
Exact = Any  # fmpq_poly modulo the cyclotomic polynomial, or a rational


class Undecided(ArithmeticError):
    """A sign or an accuracy that is not decided by the precision or by exact arithmetic."""


class Exhausted(Undecided):
    """A search that used up its budget: more digits do not help."""


def precise(function: Callable[P, T]) -> Callable[P, T]:
    """Evaluate a function at the working precision, whatever the precision of the caller."""

    @wraps(function)
    def wrapped(*args: P.args, **kwargs: P.kwargs) -> T:
        if ctx.prec == PRECISION:
            return function(*args, **kwargs)
        with ctx.workprec(PRECISION):
            return function(*args, **kwargs)

    return wrapped


def rational(number: float | fmpq) -> fmpq:
    """Return the exact value of a finite double."""
    return number if isinstance(number, fmpq) else fmpq(*float(number).as_integer_ratio())


def sign(ball: arb, exact: Callable[[], Exact] | None = None) -> int:
    """Sign of a number, -1, 0 or 1.

    Parameters
    ----------
    ball : arb
        Encloses the number.
    exact : callable, optional
        Returns an exact number of the same sign; called only if the ball contains zero.

    Raises
    ------
    Undecided
        If the ball contains zero and the number is not known to be zero.
    """
    if ball > 0:
        return 1
    if ball < 0:
        return -1
    if ball.is_zero() or (exact is not None and _vanishes(exact())):
        return 0
    raise Undecided(f"the sign of {ball} is undecided")


def settle(ball: arb, exact: Callable[[], Exact] | None = None) -> arb:
    """Return the ball, or an exact zero if the number is known to vanish."""
    return ball if not ball.contains(0) or sign(ball, exact) else arb(0)


def norm(x: arb, y: arb) -> arb:
    """Length of a vector; also near zero, where a product of balls could make a square negative."""
    square = x * x + y * y
    if square > 0 or square.is_zero():
        return square.sqrt()
    low, high = (
        a * a + b * b for a, b in ((_least(x), _least(y)), (abs(x).upper(), abs(y).upper()))
    )
    return low.sqrt().lower().union(high.sqrt())


def _least(x: arb) -> arb:
    return arb(x.abs_lower())


def unit(x: arb) -> arb:
    """A number that is known to lie in [-1, 1]."""
    return x if abs(x) <= 1 or not x.is_finite() else x.intersection(arb(0, 1))


def _vanishes(number: Exact) -> bool:
    return not fmpq_poly([number]) if isinstance(number, fmpq) else not number % _MODULUS


@lru_cache(maxsize=4096)
def exact_cosine(degrees: fmpq) -> fmpq_poly:
    """Cosine of a multiple of half a degree, as an element of the cyclotomic field."""
    if not has_exact_direction(degrees):
        raise Undecided(f"{degrees} degrees: exact arithmetic requires multiples of half a degree")
    power = int((degrees * 2).p) % _TURN
    coefficients = [0] * (_TURN + 1)
    coefficients[power] += 1
    coefficients[_TURN - power] += 1
    return fmpq_poly(coefficients, 2) % _MODULUS


def has_exact_direction(degrees: fmpq) -> bool:
    """Whether the cyclotomic field contains the cosine and the sine of the angle."""
    return bool((degrees * 2).q == 1)


def exact_direction(degrees: fmpq) -> tuple[fmpq_poly, fmpq_poly]:
    """Cosine and sine as elements of the cyclotomic field."""
    return exact_cosine(degrees), exact_sine(degrees)


def exact_sine(degrees: fmpq) -> fmpq_poly:
    """Sine of a multiple of half a degree, as an element of the cyclotomic field."""
    return exact_cosine(90 - degrees)


def cosine_sine(degrees: fmpq) -> tuple[arb, arb]:
    """Cosine and sine of an angle in exact degrees; exact if they are rational."""
    sine, cosine = arb.sin_cos_pi_fmpq(degrees / 180)
    return cosine, sine


def in_degrees(radians: arb) -> arb:
    """Convert radians to degrees."""
    return radians * 180 / arb.pi()


def fold(degrees: fmpq) -> fmpq:
    """Return the angle in [0, 90] degrees with the same absolute value of the sine."""
    half_turns = (degrees / 180).floor()
    rest = degrees - 180 * half_turns
    return min(rest, 180 - rest)
