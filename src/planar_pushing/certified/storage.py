"""Balls as stored: the midpoint as a double, and the radius as an exponent of two in a byte."""

from __future__ import annotations

import math
from typing import Any

from flint import arb, ctx

from planar_pushing.certified.balls import PRECISION, Undecided

#: Exponent of a number that is known exactly, and the smallest of all others.
EXACT, LEAST = -128, -127
#: Largest radius that is stored, relative to the number, or to 1 for numbers smaller than 1.
WIDEST = 2.0**-48


def stored(value: Any) -> tuple[Any, int]:
    """Midpoint and exponent of a ball; a plain number is exact.

    Raises
    ------
    Undecided
        If the ball is too wide to be useful.
    """
    if not isinstance(value, arb):
        return value, EXACT
    middle = float(value.mid())
    if not value.is_finite():
        return middle, EXACT
    with ctx.workprec(4 * PRECISION):
        radius = float((value - middle).abs_upper())
    if radius > WIDEST * max(abs(middle), 1.0):
        raise Undecided(f"{value} is too wide to store")
    if middle and value.contains(0) and radius < 2.0**LEAST:
        middle = 0.0  # a number that vanishes by symmetry
    return middle, max(math.frexp(radius)[1], LEAST) if radius else EXACT
