"""The pusher's motion as rows of numbers for the core, and values that are piecewise constant over time.

A motion consists of spans of smooth velocity, and a span of polynomial pieces, which hold Chebyshev
coefficients. A constant velocity is a polynomial of degree 0, and a span of its own. A function of time is
interpolated to rounding error.
"""

from __future__ import annotations

import heapq
import itertools
import math
from collections.abc import Callable, Iterable, Sequence
from typing import Any, NamedTuple, TypeVar

import numpy as np
import numpy.typing as npt
from numpy.polynomial import chebyshev

from planar_pushing.core.motion.kinematics.fence import (
    ACCELERATION_SERIES,
    MEAN_SERIES,
    VELOCITY_SERIES,
)
from planar_pushing.core.motion.kinematics.run import PIECE, SERIES_OF_PIECE, PusherPiece
from planar_pushing.mechanics.kernels.columns import Columns
from planar_pushing.terms.errors import (
    InvalidValue,
    SceneWarning,
    require_number,
    require_option,
    warn_user,
)
from planar_pushing.terms.numbers import Array
from planar_pushing.terms.options import Policy

Value = TypeVar("Value")
Velocity = Callable[[float], tuple[float, float]]
#: Start times, the first of which is 0, and the policies from then on.
Policies = tuple[tuple[float, Policy], ...]
POLICIES = f"{', '.join(Policy)}, or a sequence of (start_time, policy)"
POLICY_REMEDY = "name one of these policies"

#: Number of coefficients of a series of a piece that interpolates a function.
POINTS = 16
#: Nodes of a piece: zeros of a Chebyshev polynomial, so that a piece does not sample jumps at its ends.
NODES = np.cos(np.pi * (np.arange(POINTS)[::-1] + 0.5) / POINTS)
TO_COEFFICIENTS = np.linalg.inv(chebyshev.chebvander(NODES, POINTS - 1))
#: Rounding errors of values and of coefficients, relative to the largest of a piece.
ROUNDING = 2e-15
#: Points other than the nodes at which an interpolant is checked.
CHECKS = np.array([-0.97, 0.021, 0.53])
#: Smallest length of a piece as a fraction of the span, and maximum number of pieces, which end the
#: subdivision for a function that is not smooth.
SHORTEST, MOST_PIECES = 2.0**-30, 4096
#: Points at which the largest values of a function are looked for.
SPREAD = np.linspace(-0.99, 0.99, 64)
#: Error relative to the largest values above which a function counts as not resolved.
UNRESOLVED = 1e-6


def values_over_time(
    name: str, pairs: Any, read: Callable[[Any], Value], allowed: str, remedy: str
) -> tuple[tuple[float, Value], ...]:
    """Read pairs of start time and value, with a function that reads the values.

    Raises
    ------
    InvalidValue
        If an entry is not a pair, or the times do not start at 0 and increase; the error has this name.
    """
    pieces = []
    for item in pairs:
        if not isinstance(item, Sequence) or len(item) != 2:
            raise InvalidValue(name, pairs, allowed, remedy)
        pieces.append((_time(name, item[0]), read(item[1])))
    times = [time for time, _ in pieces]
    if times[:1] != [0] or any(b <= a for a, b in itertools.pairwise(times)):
        raise InvalidValue(
            name, pairs, "start times that begin at 0 and increase", "put the pieces in order"
        )
    return tuple(pieces)


def _time(name: str, value: object) -> float:
    return require_number(
        name, value, lambda t: 0 <= t < math.inf, "times >= 0", "start the first piece at time 0"
    )


def require_policies(value: Any) -> Policies:
    """Validate policies over time; a single policy applies from time 0."""
    if isinstance(value, (list, tuple)):
        return values_over_time("on_ambiguity", value, _policy, POLICIES, POLICY_REMEDY)
    if not isinstance(value, str) or value not in list(Policy):
        raise InvalidValue("on_ambiguity", value, POLICIES, POLICY_REMEDY)
    return ((0.0, Policy(value)),)


def _policy(value: Any) -> Policy:
    return require_option("on_ambiguity", value, Policy, POLICY_REMEDY)


def starts_of(policies: Policies) -> list[float]:
    """Start times of the policies."""
    return [start for start, _ in policies]


def write_policies(pieces: Array, policies: Policies) -> None:
    """Store in each piece, shape S + (numbers,), the policy at its start."""
    numbers = np.array([list(Policy).index(policy) for _, policy in policies])
    columns = Columns(PusherPiece, pieces)
    current = np.searchsorted(starts_of(policies), columns.start, side="right") - 1
    columns.policy = numbers[current]


def constant_pieces(
    starts: Sequence[float], velocities: Array, ends: Array, cuts: Iterable[float]
) -> tuple[Array, npt.NDArray[np.int64]]:
    """Pieces of many scenes with piecewise constant velocities.

    Parameters
    ----------
    starts : sequence of float
        Start times of the velocities.
    velocities : ndarray, shape (scenes, velocities, 2)
        In radii.
    ends : ndarray, shape (scenes,)
        Durations.
    cuts : iterable of float
        Times at which pieces start as well.

    Returns
    -------
    ndarray, shape (scenes, pieces, numbers), and ndarray, shape (scenes,)
        Pieces in the form of the core, with one coefficient in each series, and the number of valid pieces,
        which are those that begin before the end of the scene.
    """
    times = np.array(sorted({*starts, *cuts}))
    velocities = velocities[:, np.searchsorted(starts, times, side="right") - 1]
    counts = (times < ends[:, None]).sum(axis=1)
    most = int(counts.max())
    times, velocities, numbers = times[:most], velocities[:, :most], np.arange(most)
    marks = np.empty((len(ends), most + 1))
    marks[:, :-1], marks[:, -1] = np.minimum(times, ends[:, None]), ends
    pieces = np.zeros((len(ends), most, PIECE + SERIES_OF_PIECE))
    columns = Columns(PusherPiece, pieces)
    columns.start, columns.end = marks[:, :-1], marks[:, 1:]
    columns.first, columns.last = numbers, numbers + 1
    for series in (VELOCITY_SERIES, MEAN_SERIES):
        pieces[..., PIECE + series : PIECE + series + 2] = velocities
    paths = np.diff(marks)[..., None] * velocities
    columns.origin[:, 1:] = paths.cumsum(axis=1)[:, :-1]
    return pieces, counts


def smooth_pieces(velocity: Velocity, times: Sequence[float], radius: float) -> Array:
    """Pieces of a velocity that is a function of time, smooth between the given times.

    Returns
    -------
    ndarray, shape (pieces, numbers)
        Pieces in the form of the core, with `POINTS` coefficients in each series, in radii.
    """
    spans = [interpolants(velocity, *ends) for ends in itertools.pairwise(times)]
    joined = list(itertools.chain(*spans))
    counts = np.array([len(span) for span in spans])
    rows = np.zeros((len(joined), PIECE + SERIES_OF_PIECE * POINTS))
    series = rows[:, PIECE:].reshape(-1, SERIES_OF_PIECE, POINTS)
    coefficients = np.array([piece.coefficients.T for piece in joined]) / radius
    columns = Columns(PusherPiece, rows)
    columns.end = [piece.end for piece in joined]
    columns.start[1:] = columns.end[:-1]
    columns.degree = [np.flatnonzero(c.any(axis=0)).max(initial=0) for c in coefficients]
    columns.last = np.repeat(counts.cumsum(), counts)
    columns.first = columns.last - np.repeat(counts, counts)
    columns.noise = np.array([piece.noise for piece in joined]) / radius
    lengths = (columns.end - columns.start)[:, None]
    slopes, means = coefficients @ SLOPE.T, coefficients @ MEAN.T
    series[:, VELOCITY_SERIES : VELOCITY_SERIES + 2] = coefficients
    series[:, ACCELERATION_SERIES : ACCELERATION_SERIES + 2] = 2 / lengths[..., None] * slopes
    series[:, MEAN_SERIES : MEAN_SERIES + 2] = means
    # At the end of a piece, every Chebyshev polynomial is 1.
    paths = lengths * means.sum(axis=-1)
    columns.origin[1:] = paths.cumsum(axis=0)[:-1]
    return rows


def _operator(function: Callable[[Any], Any]) -> Array:
    """Matrix of a linear function of coefficients."""
    matrix = np.zeros((POINTS, POINTS))
    for column, unit in zip(matrix.T, np.eye(POINTS), strict=True):
        image = function(unit)
        column[: len(image)] = image
    return matrix


#: Matrices from a piece's coefficients to those of its derivative, over -1 to 1, and of its running mean.
SLOPE = _operator(chebyshev.chebder)
MEAN = _operator(lambda c: chebyshev.chebdiv(chebyshev.chebint(c, lbnd=-1), [1.0, 1.0])[0])


class Interpolant(NamedTuple):
    """A velocity up to a time: coefficients, shape (POINTS, 2), and their rounding error."""

    end: float
    coefficients: Array
    noise: Array


def interpolants(velocity: Velocity, start: float, end: float) -> list[Interpolant]:
    """Interpolants of a velocity between two times, matching to rounding error of its largest values.

    The worst interval is halved first.

    Warns
    -----
    SceneWarning
        If the function is not resolved, because it jumps or has kinks at many places.
    """
    times = (start + end) / 2 + (end - start) / 2 * SPREAD
    size = np.abs([velocity(time) for time in times]).max(axis=0)
    first, error = _interpolate(velocity, start, end, size)
    intervals = [(-error, start, end, first)]
    done: list[tuple[float, Interpolant]] = []
    while intervals:
        error, low, high, piece = heapq.heappop(intervals)
        short = high - low <= SHORTEST * (end - start)
        if error == 0.0 or short or len(done) + len(intervals) >= MOST_PIECES:
            done.append((low, piece))
            if not short and -error > UNRESOLVED:
                _warn_unresolved(low, high)
                done += [(low, piece) for _, low, _, piece in intervals]
                break
            continue
        middle = (low + high) / 2
        for ends in ((low, middle), (middle, high)):
            half, half_error = _interpolate(velocity, *ends, size)
            heapq.heappush(intervals, (-half_error, *ends, half))
    return [piece for _, piece in sorted(done, key=lambda pair: pair[0])]


def _warn_unresolved(low: float, high: float) -> None:
    message = (
        f"velocity: a function that is not smooth between the times {low:.6g} and {high:.6g} given; "
        "its motion is wrong there; list the times at which it jumps or has kinks in breakpoints"
    )
    warn_user(SceneWarning(message))


def _interpolate(
    velocity: Velocity, low: float, high: float, size: Array
) -> tuple[Interpolant, float]:
    """Interpolant between two times, and its error relative to a size, 0 if it is rounding error."""
    middle, half = (low + high) / 2, (high - low) / 2
    values = np.array([velocity(middle + half * node) for node in NODES])
    coefficients = TO_COEFFICIENTS @ values
    size = np.maximum(size, np.abs(values).max(axis=0))
    coefficients[np.abs(coefficients) <= ROUNDING * size] = 0.0
    checks = np.array([velocity(middle + half * node) for node in CHECKS])
    errors = np.abs(chebyshev.chebval(CHECKS, coefficients).T - checks)
    resolved = not coefficients[-2:].any() and bool((errors <= POINTS * ROUNDING * size).all())
    noise = 0.0 if resolved and not coefficients[1:].any() else ROUNDING
    error = 0.0
    if not resolved:
        worst = np.maximum(np.abs(coefficients[-2:]).max(axis=0), errors.max(axis=0))
        error = max(float(worst.max() / size.max()), ROUNDING)
    return Interpolant(high, coefficients, noise * size), error
