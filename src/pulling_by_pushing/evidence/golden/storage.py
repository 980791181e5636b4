"""Certified numbers as stored: the midpoint as a double, and the radius as an exponent of two in a byte."""

from __future__ import annotations

import math
from typing import Any

from flint import arb, ctx

from pulling_by_pushing.evidence.golden.enclosures import EXACT
from pulling_by_pushing.oracle.balls import FINE, Number, Undecided

#: The smallest and the largest exponent of a radius.
LEAST, MOST = -127, 127
#: Largest radius of an enclosure itself, relative to the number, or to 1 for numbers smaller than 1.
WIDEST = 2.0**-60


def store(value: Any) -> tuple[Any, int]:
    """Midpoint and exponent of a number; a ball has no roundings, and anything else is exact.

    Raises
    ------
    Undecided
        If the enclosure is too wide to be useful.
    """
    if isinstance(value, arb):
        value = Number(value, arb(0))
    if not isinstance(value, Number):
        return value, EXACT
    ball, rounding = value
    if ball.is_nan() or rounding.is_nan():
        raise Undecided("no enclosure, or no condition, of a number")
    middle = float(ball.mid())
    if not math.isfinite(middle):
        return middle, EXACT if rounding.is_zero() else _exponent(rounding, math.floor)
    with ctx.workprec(FINE):
        radius = (ball - middle).abs_upper()
        if ball.rad() > WIDEST * max(abs(middle), 1.0):
            raise Undecided(f"{ball} is too wide to store")
        if middle and ball.contains(0) and radius < 2.0**LEAST:
            middle, radius = 0.0, ball.abs_upper()  # a number that vanishes by symmetry
        radius = arb(radius) + value.allowed
    return middle, EXACT if radius.is_zero() else _exponent(radius, math.ceil)


def _exponent(size: arb, to_integer: Any) -> int:
    if not size.is_finite():
        return MOST
    with ctx.workprec(FINE):
        logarithm = arb(size.abs_upper()).log() / arb(2).log()
        return int(min(max(to_integer(float(logarithm.upper())), LEAST), MOST))
