"""Approximation of a smooth function of time by Chebyshev polynomials, to rounding error."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from numpy.polynomial import chebyshev

from planar_pushing.mechanics.plane import Array
from planar_pushing.simulation.fence import POINTS

#: Nodes of a piece: zeros of a Chebyshev polynomial, so that a piece does not sample jumps at its ends.
NODES = np.cos(np.pi * (np.arange(POINTS)[::-1] + 0.5) / POINTS)
TO_COEFFICIENTS = np.linalg.inv(chebyshev.chebvander(NODES, POINTS - 1))
#: Rounding errors of values and of coefficients, relative to the largest of a piece.
ROUNDING = 2e-15
#: Points other than the nodes at which an interpolant is checked.
CHECKS = np.array([-0.97, 0.021, 0.53])
#: Smallest length of a piece as a fraction of the span, and maximum number of pieces, which end the
#: subdivision for a function that is not smooth.
SHORTEST, MOST = 2.0**-30, 4096


def _operator(function: Callable[[Any], Any]) -> Array:
    """Matrix of a linear function of coefficients."""
    found = np.zeros((POINTS, POINTS))
    for column, unit in zip(found.T, np.eye(POINTS), strict=True):
        image = function(unit)
        column[: len(image)] = image
    return found


#: Matrices from a piece's coefficients to those of its derivative, over -1 to 1, and of its running mean.
SLOPE = _operator(chebyshev.chebder)
MEAN = _operator(lambda c: chebyshev.chebdiv(chebyshev.chebint(c, lbnd=-1), [1.0, 1.0])[0])


class Piece(NamedTuple):
    """The fence's velocity up to a time: coefficients, shape (POINTS, 2), and their rounding error."""

    end: float
    coefficients: Array
    noise: Array


def pieces_of(
    velocity: Callable[[float], tuple[float, float]], start: float, end: float
) -> list[Piece]:
    """Pieces of a velocity between two times, halved until each is a polynomial to rounding error."""
    found: list[Piece] = []
    left = [(start, end)]
    while left:
        low, high = left.pop()
        piece, resolved = _interpolated(velocity, low, high)
        short = high - low <= SHORTEST * (end - start) or len(found) + len(left) >= MOST
        if resolved or short:
            found.append(piece)
        else:
            middle = (low + high) / 2
            left += [(middle, high), (low, middle)]
    return found


def _interpolated(
    velocity: Callable[[float], tuple[float, float]], low: float, high: float
) -> tuple[Piece, bool]:
    """Interpolant between two times, and whether it matches the function to rounding error."""
    middle, half = (low + high) / 2, (high - low) / 2
    values = np.array([velocity(middle + half * node) for node in NODES])
    coefficients = TO_COEFFICIENTS @ values
    size = np.abs(values).max(axis=0)
    coefficients[np.abs(coefficients) <= ROUNDING * size] = 0.0
    there = np.array([velocity(middle + half * node) for node in CHECKS])
    apart = np.abs(chebyshev.chebval(CHECKS, coefficients).T - there)
    resolved = not coefficients[-2:].any() and bool((apart <= POINTS * ROUNDING * size).all())
    noise = 0.0 if resolved and not coefficients[1:].any() else ROUNDING
    return Piece(high, coefficients, noise * size), resolved
