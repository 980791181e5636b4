"""The pusher's prescribed motion: spans of smooth velocity, made of polynomial pieces.

A constant velocity is a polynomial of degree 0.
"""

from __future__ import annotations

from math import fabs, sqrt
from typing import NamedTuple

from planar_pushing.core.motion.kinematics.run import (
    PIECE,
    SERIES_OF_PIECE,
    PusherPiece,
)
from planar_pushing.core.numbers import GAUSS_NODES, GAUSS_WEIGHTS, Numbers

#: Series of a piece, two for each quantity.
VELOCITY_SERIES, ACCELERATION_SERIES, MEAN_SERIES = 0, 2, 4
#: Number of intervals of a span at which its speed is sampled.
SPEED_SAMPLES = 64


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


def piece_of(fence: Fence, index: int) -> PusherPiece:
    """A piece of the motion."""
    return PusherPiece(fence.pieces[index * (PIECE + SERIES_OF_PIECE * fence.coefficients) :])


def span_at(fence: Fence, index: int) -> Span:
    """The span of a piece."""
    piece = piece_of(fence, index)
    first, last = piece.first, piece.last
    constant: bool = last - first == 1 and piece.degree == 0
    return Span(
        piece_of(fence, first).start, piece_of(fence, last - 1).end, first, last, constant
    )  # fmt: skip


def policy_at(fence: Fence, index: int) -> int:
    """The policy for choosing among several modes in a piece."""
    return piece_of(fence, index).policy


def end_of_fence(fence: Fence) -> float:
    """The time at which the motion ends."""
    return piece_of(fence, fence.number - 1).end


def _piece_at(fence: Fence, during: Span, time: float) -> PusherPiece:
    """The piece of a span that contains a time."""
    low, high = during.first, during.last
    while high - low > 1:
        middle = (low + high) // 2
        if time >= piece_of(fence, middle).start:
            low = middle
        else:
            high = middle
    return piece_of(fence, low)


def _series_value(fence: Fence, piece: PusherPiece, number: int, time: float) -> float:
    """The value of a Chebyshev series by Clenshaw's recurrence."""
    series = piece[PIECE + number * fence.coefficients :]
    degree = piece.degree
    if degree == 0:
        return series[0]
    start, end = piece.start, piece.end
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
    if fabs(x) <= piece.noise.x:
        x = 0.0
    if fabs(y) <= piece.noise.y:
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
    elapsed = time - piece.start
    x = _series_value(fence, piece, MEAN_SERIES, time)
    y = _series_value(fence, piece, MEAN_SERIES + 1, time)
    return piece.origin.x + elapsed * x, piece.origin.y + elapsed * y


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
