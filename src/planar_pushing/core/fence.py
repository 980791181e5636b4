"""The pusher's prescribed motion: spans of smooth velocity, made of polynomial pieces.

A constant velocity is a polynomial of degree 0.
"""

from __future__ import annotations

from math import fabs, sqrt
from typing import NamedTuple

from planar_pushing.core.numbers import Numbers
from planar_pushing.core.run import (
    PIECE_DEGREE,
    PIECE_END,
    PIECE_FIRST,
    PIECE_LAST,
    PIECE_NOISE,
    PIECE_ORIGIN,
    PIECE_POLICY,
    PIECE_SERIES,
    PIECE_START,
    SERIES_OF_PIECE,
)

#: Series of a piece, two for each quantity.
VELOCITY_SERIES, ACCELERATION_SERIES, MEAN_SERIES = 0, 2, 4
#: Number of intervals of a span at which its speed is sampled.
SPEED_SAMPLES = 64
#: Nodes and weights of the Gauss quadrature of order 8 on [-1, 1], for the displacement from a velocity.
GAUSS_NODES = (
    -0.9602898564975362, -0.7966664774136267, -0.525532409916329, -0.18343464249564978,
    0.18343464249564978, 0.525532409916329, 0.7966664774136267, 0.9602898564975362,
)  # fmt: skip
GAUSS_WEIGHTS = (
    0.10122853629037706, 0.22238103445337443, 0.3137066458778869, 0.36268378337836166,
    0.36268378337836166, 0.3137066458778869, 0.22238103445337443, 0.10122853629037706,
)  # fmt: skip


class Fence(NamedTuple):
    """The motion of a pusher: its pieces, their number, and the number of coefficients of their series."""

    pieces: Numbers
    number: int
    coefficients: int


class Span(NamedTuple):
    """A time interval of smooth velocity, and its pieces from `first` to before `last`."""

    start: float
    end: float
    first: int
    last: int
    constant: bool


def piece_of(fence: Fence, index: int) -> Numbers:
    """A piece of the motion."""
    return fence.pieces[index * (PIECE_SERIES + SERIES_OF_PIECE * fence.coefficients) :]


def span_at(fence: Fence, index: int) -> Span:
    """The span of a piece."""
    piece = piece_of(fence, index)
    first, last = int(piece[PIECE_FIRST]), int(piece[PIECE_LAST])
    constant: bool = last - first == 1 and piece[PIECE_DEGREE] == 0.0
    return Span(
        piece_of(fence, first)[PIECE_START], piece_of(fence, last - 1)[PIECE_END], first, last, constant
    )  # fmt: skip


def policy_at(fence: Fence, index: int) -> int:
    """The policy for choosing among several modes in a piece."""
    return int(piece_of(fence, index)[PIECE_POLICY])


def end_of_fence(fence: Fence) -> float:
    """The time at which the motion ends."""
    return piece_of(fence, fence.number - 1)[PIECE_END]


def _piece_at(fence: Fence, during: Span, time: float) -> Numbers:
    """The piece of a span that contains a time."""
    low, high = during.first, during.last
    while high - low > 1:
        middle = (low + high) // 2
        if time >= piece_of(fence, middle)[PIECE_START]:
            low = middle
        else:
            high = middle
    return piece_of(fence, low)


def _series_value(fence: Fence, piece: Numbers, number: int, time: float) -> float:
    """The value of a Chebyshev series by Clenshaw's recurrence."""
    series = piece[PIECE_SERIES + number * fence.coefficients :]
    degree = int(piece[PIECE_DEGREE])
    if degree == 0:
        return series[0]
    start, end = piece[PIECE_START], piece[PIECE_END]
    x = ((time - start) - (end - time)) / (end - start)
    one, two = 0.0, 0.0
    for i in range(degree, 0, -1):
        one, two = 2.0 * x * one - two + series[i], one
    return x * one - two + series[0]


def fence_velocity(fence: Fence, during: Span, time: float) -> tuple[float, float]:
    """The velocity at a time of a span; components that are only rounding error are zero."""
    piece = _piece_at(fence, during, time)
    x = _series_value(fence, piece, VELOCITY_SERIES, time)
    y = _series_value(fence, piece, VELOCITY_SERIES + 1, time)
    if fabs(x) <= piece[PIECE_NOISE]:
        x = 0.0
    if fabs(y) <= piece[PIECE_NOISE + 1]:
        y = 0.0
    return x, y


def fence_acceleration(fence: Fence, during: Span, time: float) -> tuple[float, float]:
    """The acceleration at a time of a span."""
    if during.constant:
        return 0.0, 0.0
    piece = _piece_at(fence, during, time)
    x = _series_value(fence, piece, ACCELERATION_SERIES, time)
    return x, _series_value(fence, piece, ACCELERATION_SERIES + 1, time)


def fence_displacement(fence: Fence, during: Span, time: float) -> tuple[float, float]:
    """The displacement from the start of the motion to a time of a span."""
    piece = _piece_at(fence, during, time)
    elapsed = time - piece[PIECE_START]
    x = _series_value(fence, piece, MEAN_SERIES, time)
    y = _series_value(fence, piece, MEAN_SERIES + 1, time)
    return piece[PIECE_ORIGIN] + elapsed * x, piece[PIECE_ORIGIN + 1] + elapsed * y


def fence_path(fence: Fence, during: Span, start: float, end: float) -> tuple[float, float]:
    """The displacement between two times of a span."""
    if during.constant:
        v_x, v_y = fence_velocity(fence, during, start)
        return v_x * (end - start), v_y * (end - start)
    half, middle, x, y = (end - start) / 2.0, (end + start) / 2.0, 0.0, 0.0
    for i in range(len(GAUSS_NODES)):
        v_x, v_y = fence_velocity(fence, during, middle + half * GAUSS_NODES[i])
        x, y = x + half * GAUSS_WEIGHTS[i] * v_x, y + half * GAUSS_WEIGHTS[i] * v_y
    return x, y


def typical_speed(fence: Fence) -> float:
    """The largest speed among samples of the motion."""
    speed, index = 0.0, 0
    while index < fence.number:
        during = span_at(fence, index)
        for part in range(1 if during.constant else SPEED_SAMPLES + 1):
            time = during.start + float(part) / float(SPEED_SAMPLES) * (during.end - during.start)
            x, y = fence_velocity(fence, during, time)
            speed = max(speed, sqrt(x * x + y * y))
        index = during.last
    return speed
