"""The fence's prescribed motion: a translation, constant, piecewise constant or any function of time."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field

import numpy as np

from planar_pushing.mechanics.errors import InvalidValue

Vector = tuple[float, float]
Motion = Callable[[float], Vector]

ALLOWED = (
    "(v_x, v_y), a sequence of (start_time, (v_x, v_y)), or a function of time that returns one"
)
REMEDY = "give the fence's velocity as finite numbers in the scene's units"
#: Nodes and weights of the quadrature that turns a velocity into a displacement.
NODES, WEIGHTS = (tuple(map(float, each)) for each in np.polynomial.legendre.leggauss(8))
#: Sixth-order central differences; the step balances truncation against rounding.
STENCIL = ((1, 3 / 4), (2, -3 / 20), (3, 1 / 60))
STEP = 2e-3
#: Parts of a segment at which its speed is looked at.
PARTS = tuple(i / 64 for i in range(65))


def vector(given: object) -> Vector:
    """Two finite numbers as floats, or `InvalidValue`."""
    try:
        x, y = (float(each) for each in given)  # type: ignore[attr-defined]
    except (TypeError, ValueError):
        raise InvalidValue("velocity", given, ALLOWED, REMEDY) from None
    if not (math.isfinite(x) and math.isfinite(y)):
        raise InvalidValue("velocity", given, ALLOWED, REMEDY)
    return x, y


@dataclass(frozen=True, slots=True)
class Segment:
    """A span of time in which the fence's velocity is smooth.

    Attributes
    ----------
    start, end : float
    velocity, acceleration : callable
        Of the time, (x, y) each.
    constant : bool
        Whether the velocity is constant.
    """

    start: float
    end: float
    velocity: Motion
    acceleration: Motion
    constant: bool

    def displacement(self, start: float, end: float) -> Vector:
        """How far the fence travels between two times of the segment."""
        if self.constant:
            x, y = self.velocity(start)
            return x * (end - start), y * (end - start)
        half, middle = (end - start) / 2, (end + start) / 2
        speeds = [self.velocity(middle + half * node) for node in NODES]
        return (
            half * sum(w * v[0] for w, v in zip(WEIGHTS, speeds, strict=True)),
            half * sum(w * v[1] for w, v in zip(WEIGHTS, speeds, strict=True)),
        )


def _constant(start: float, end: float, velocity: Vector) -> Segment:
    return Segment(start, end, lambda _: velocity, lambda _: (0.0, 0.0), True)


def _difference(velocity: Motion, start: float, end: float) -> Motion:
    """Derivative of a velocity, from a stencil that stays inside the segment."""
    step = min(STEP, (end - start) / 8)

    def acceleration(time: float) -> Vector:
        middle = min(max(time, start + 3 * step), end - 3 * step)
        if middle == time:
            pairs = [(w, velocity(time + i * step), velocity(time - i * step)) for i, w in STENCIL]
            x, y = (sum(w * (b[i] - a[i]) for w, b, a in pairs) / step for i in (0, 1))
            return x, y
        values = np.array([velocity(middle + i * step) for i in range(-3, 4)])
        coefficients = np.polynomial.polynomial.polyfit(np.arange(-3, 4), values, 6)
        slope = np.polynomial.polynomial.polyder(coefficients)
        at = np.array((time - middle) / step)
        x, y = np.polynomial.polynomial.polyval(at, slope)
        return float(x) / step, float(y) / step

    return acceleration


@dataclass(frozen=True, slots=True, kw_only=True)
class Pusher:
    """The fence's velocity; the fence translates and stays parallel to x.

    Parameters
    ----------
    velocity : (v_x, v_y), sequence of (start_time, (v_x, v_y)), or callable
        Length per time. The pieces start at 0 and follow one another; each holds until the next starts.
    acceleration : callable, optional
        Derivative of a callable velocity; without it sixth-order differences stand in.
    breakpoints : sequence of float
        Times at which a callable velocity is not smooth.

    Raises
    ------
    InvalidValue
        Where the velocity has another shape, or times do not increase.
    """

    velocity: Vector | Sequence[tuple[float, Vector]] | Motion
    acceleration: Motion | None = None
    breakpoints: Sequence[float] = ()
    pieces: tuple[tuple[float, Vector], ...] = field(init=False, default=(), repr=False)

    def __post_init__(self) -> None:
        if not callable(self.velocity):
            object.__setattr__(self, "pieces", _pieces(self.velocity))
        times = tuple(map(_time, self.breakpoints))
        if any(b <= a for a, b in itertools.pairwise(times)):
            raise InvalidValue(
                "breakpoints", self.breakpoints, "increasing times", "put them in order"
            )
        object.__setattr__(self, "breakpoints", times)

    def segments(self, duration: float) -> tuple[Segment, ...]:
        """The smooth spans of the fence's motion, from 0 to the duration."""
        if self.pieces:
            ends = [start for start, _ in self.pieces[1:]] + [math.inf]
            return tuple(
                _constant(start, min(end, duration), velocity)
                for (start, velocity), end in zip(self.pieces, ends, strict=True)
                if start < duration
            )
        inner = [time for time in self.breakpoints if 0 < time < duration]
        ends = [0.0, *inner, duration]
        return tuple(self._smooth(a, b) for a, b in itertools.pairwise(ends))

    def typical_speed(self, duration: float) -> float:
        """The greatest speed among samples of the fence's motion."""
        return max(
            math.hypot(*segment.velocity(segment.start + part * (segment.end - segment.start)))
            for segment in self.segments(duration)
            for part in ((0.0,) if segment.constant else PARTS)
        )

    def _smooth(self, start: float, end: float) -> Segment:
        given = self.velocity
        # At its ends a segment shows its own side of a jump.
        first, last = math.nextafter(start, end), math.nextafter(end, start)

        def velocity(time: float) -> Vector:
            return vector(given(min(max(time, first), last)))  # type: ignore[operator]

        slope = self.acceleration
        if slope is None:
            return Segment(start, end, velocity, _difference(velocity, start, end), False)
        return Segment(start, end, velocity, lambda time: vector(slope(time)), False)


def _time(given: object) -> float:
    try:
        time = float(given)  # type: ignore[arg-type]
    except (TypeError, ValueError):
        time = math.nan
    if not 0 <= time < math.inf:
        raise InvalidValue("velocity", given, "times >= 0", "start the first piece at time 0")
    return time


def _pieces(given: object) -> tuple[tuple[float, Vector], ...]:
    """Start times and velocities; one velocity alone holds from 0."""
    items = list(given) if isinstance(given, Iterable) else []
    if not any(isinstance(each, Iterable) for each in items):
        return ((0.0, vector(given)),)
    pieces = []
    for item in items:
        if not isinstance(item, Sequence) or len(item) != 2:
            raise InvalidValue("velocity", given, ALLOWED, REMEDY)
        pieces.append((_time(item[0]), vector(item[1])))
    times = [piece[0] for piece in pieces]
    if times[0] != 0 or any(b <= a for a, b in itertools.pairwise(times)):
        raise InvalidValue(
            "velocity", given, "start times that begin at 0 and increase", "put the pieces in order"
        )
    return tuple(pieces)
