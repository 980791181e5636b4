"""The fence's motion in the compiled core: spans of smooth velocity, made of polynomial pieces.

A piece holds Chebyshev coefficients over its time interval for the velocity, its derivative, and the mean
velocity since the start of the piece. A constant velocity is a polynomial of degree 0.
"""

from __future__ import annotations

from math import sqrt
from typing import NamedTuple

import numpy as np

from planar_pushing.simulation.legacy.compiled import compiled

#: Rows of a piece's coefficients; each quantity has one row along the fence and one normal to it.
VELOCITY, ACCELERATION, MEAN = 0, 2, 4
#: Maximum number of coefficients of a piece.
POINTS = 16
#: A piece, in units of the slider's radius: its time interval and degree, the pieces of its span from
#: `first` to before `last`, its policy, the rounding error of each velocity component, the displacement at
#: its start, and its coefficients.
PIECE = np.dtype(
    [
        ("start", "f8"), ("end", "f8"), ("degree", "i8"), ("first", "i8"), ("last", "i8"),
        ("policy", "i8"), ("noise", "f8", (2,)), ("origin", "f8", (2,)), ("series", "f8", (6, POINTS)),
    ],
    align=True,
)  # fmt: skip
#: Number of intervals of a span at which its speed is sampled.
PARTS = 64
#: Nodes and weights of the quadrature for the displacement from a velocity.
NODES, WEIGHTS = np.polynomial.legendre.leggauss(8)


class Span(NamedTuple):
    """A time interval of smooth velocity, and its pieces from `first` to before `last`."""

    start: float
    end: float
    first: int
    last: int
    constant: bool


@compiled
def span(fence, index):
    """Span of a piece; the fence is an array of pieces."""
    piece = fence[index]
    constant = piece.last - piece.first == 1 and piece.degree == 0
    return Span(
        fence[piece.first].start, fence[piece.last - 1].end, piece.first, piece.last, constant
    )


@compiled
def _piece(fence, during, time):
    """Index of the piece of a span that contains a time."""
    low, high = during.first, during.last
    while high - low > 1:
        middle = (low + high) // 2
        if time >= fence[middle].start:
            low = middle
        else:
            high = middle
    return low


@compiled
def _value(piece, row, time):
    """Value of a Chebyshev series by Clenshaw's recurrence."""
    series, degree = piece.series[row], piece.degree
    if degree == 0:
        return series[0]
    x = ((time - piece.start) - (piece.end - time)) / (piece.end - piece.start)
    one, two = 0.0, 0.0
    for i in range(degree, 0, -1):
        one, two = 2.0 * x * one - two + series[i], one
    return x * one - two + series[0]


@compiled
def velocity(fence, during, time):
    """Velocity of the fence at a time of a span; components that are only rounding error are zero."""
    piece = fence[_piece(fence, during, time)]
    x, y = _value(piece, VELOCITY, time), _value(piece, VELOCITY + 1, time)
    return x if abs(x) > piece.noise[0] else 0.0, y if abs(y) > piece.noise[1] else 0.0


@compiled
def acceleration(fence, during, time):
    """Acceleration of the fence at a time of a span."""
    if during.constant:
        return 0.0, 0.0
    piece = fence[_piece(fence, during, time)]
    return _value(piece, ACCELERATION, time), _value(piece, ACCELERATION + 1, time)


@compiled
def displacement(fence, during, time):
    """Displacement of the fence from the start of its motion."""
    piece = fence[_piece(fence, during, time)]
    passed, origin = time - piece.start, piece.origin
    x, y = _value(piece, MEAN, time), _value(piece, MEAN + 1, time)
    return origin[0] + passed * x, origin[1] + passed * y


@compiled
def way(fence, during, start, end):
    """Displacement of the fence between two times of a span."""
    if during.constant:
        x, y = velocity(fence, during, start)
        return x * (end - start), y * (end - start)
    half, middle, x, y = (end - start) / 2.0, (end + start) / 2.0, 0.0, 0.0
    for i in range(len(NODES)):
        v_x, v_y = velocity(fence, during, middle + half * NODES[i])
        x, y = x + half * WEIGHTS[i] * v_x, y + half * WEIGHTS[i] * v_y
    return x, y


@compiled
def typical_speed(fence):
    """Maximum speed among samples of the fence's motion."""
    most, index = 0.0, 0
    while index < len(fence):
        during = span(fence, index)
        for part in range(1 if during.constant else PARTS + 1):
            time = during.start + part / PARTS * (during.end - during.start)
            x, y = velocity(fence, during, time)
            most = max(most, sqrt(x * x + y * y))
        index = during.last
    return most
