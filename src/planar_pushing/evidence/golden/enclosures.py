"""Stored enclosures: the midpoint of a number as a double, and its radius as an exponent of two in a byte."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import numpy.typing as npt
from flint import arb, ctx

from planar_pushing.certified.balls import PRECISION, Undecided

Floats = npt.NDArray[np.float64]
#: Ends the name of the variable that holds the exponents of another's radii.
RADIUS = "_radius"
#: Exponent of a number that is known exactly, and the least of the others.
EXACT, LEAST = -128, -127
#: Largest radius that is stored, relative to the number, or to 1 where the number is smaller.
WIDEST = 2.0**-48


def packed(value: Any) -> tuple[float, int]:
    """Midpoint and exponent of a ball; a plain number is exact.

    Raises
    ------
    Undecided
        Where the ball is too wide to be of use.
    """
    if not isinstance(value, arb):
        return float(value), EXACT
    middle = float(value.mid())
    if not value.is_finite():
        return middle, EXACT
    with ctx.workprec(4 * PRECISION):
        radius = float((value - middle).abs_upper())
    if radius > WIDEST * max(abs(middle), 1.0):
        raise Undecided(f"{value} is too wide to store")
    if middle and radius > abs(middle) and radius < 2.0**LEAST:
        middle = 0.0  # a number that vanishes by symmetry
    return middle, max(math.frexp(radius)[1], LEAST) if radius else EXACT


def radii(exponents: npt.NDArray[np.int8]) -> Floats:
    """Radii of exponents."""
    found: Floats = np.where(exponents == EXACT, 0.0, np.exp2(exponents.astype(float)))
    return found


def apart(one: Floats, one_radius: Floats, other: Floats, other_radius: Floats) -> Any:
    """Where enclosures do not overlap; the same infinity, and NaN twice, do."""
    same = (one == other) | (np.isnan(one) & np.isnan(other))
    with np.errstate(invalid="ignore"):
        return ~same & ~(np.abs(one - other) <= one_radius + other_radius)
