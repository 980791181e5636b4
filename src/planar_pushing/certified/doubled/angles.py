"""Angles with 32 digits: directions of doubles in degrees, sines, and the residual of an angle.

An angle in degrees stands for the double nearest to it in radians, which is what the public functions
take; the double nearest to a multiple of a quarter turn stands for the multiple itself.
"""

from __future__ import annotations

from math import factorial
from typing import Any

import numpy as np

from planar_pushing.certified.doubled.numbers import Doubled, choose, doubled, settled

#: A quarter turn, and the rounding error of its double.
QUARTER = Doubled(np.float64(1.5707963267948966), np.float64(6.123233995736766e-17))
TURN = QUARTER * 4.0
#: Terms of the series up to an eighth of a turn: the next one is below 2^-106.
_TERMS = 14


def radians(degrees: Any) -> Doubled:
    """Angles of degrees given as doubles."""
    return exact_quarters(np.deg2rad(np.asarray(degrees, dtype=float)))


def exact_quarters(angles: Any) -> Doubled:
    """Angles given in radians; the doubles nearest to quarter turns are these."""
    angles = np.asarray(angles, dtype=float)
    turns = np.rint(angles / QUARTER.high)
    return choose(turns * QUARTER.high == angles, QUARTER * turns, angles)


def cosine_sine(angle: Doubled) -> tuple[Doubled, Doubled]:
    """Cosine and sine of angles of some turns."""
    turns = np.rint(angle.high / QUARTER.high)
    cosine, sine = _series(settled(angle - QUARTER * turns))
    quadrant = turns % 4
    odd = quadrant % 2 == 1
    c, s = choose(odd, sine, cosine), choose(odd, cosine, sine)
    below = np.where(quadrant >= 2, -1.0, 1.0)
    left = np.where((quadrant == 1) | (quadrant == 2), -1.0, 1.0)
    return Doubled(c.high * left, c.low * left), Doubled(s.high * below, s.low * below)


def _series(angle: Doubled) -> tuple[Doubled, Doubled]:
    """Cosine and sine of angles up to an eighth of a turn."""
    square = -(angle * angle)
    cosine, sine = doubled(np.zeros_like(angle.high)), doubled(np.zeros_like(angle.high))
    for n in reversed(range(_TERMS)):
        cosine = cosine * square + _inverse_factorial(2 * n)
        sine = sine * square + _inverse_factorial(2 * n + 1)
    return cosine, sine * angle


def _inverse_factorial(n: int) -> Doubled:
    # Both parts of a factorial up to 27! are exact doubles.
    whole = factorial(n)
    high = float(whole)
    return 1.0 / Doubled(np.float64(high), np.float64(whole - int(high)))


def off_direction(angle: Doubled, x: Any, y: Any) -> Doubled:
    """Sine of the turn from an angle to a vector; 2 where they point apart."""
    cosine, sine = cosine_sine(angle)
    x, y = doubled(x), doubled(y)
    size = (x * x + y * y).sqrt()
    apart = (cosine * x + sine * y).high <= 0
    return choose(apart, 2.0, (cosine * y - sine * x) / choose(size.high > 0, size, 1.0))
