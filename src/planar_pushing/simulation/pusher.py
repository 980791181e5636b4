"""The pusher and its prescribed motion: constant, piecewise constant, or any function of time."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field
from typing import Any, Literal

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.frames import Frame
from planar_pushing.mechanics.plane import Array
from planar_pushing.simulation import chebyshev
from planar_pushing.simulation.chebyshev import Piece, pieces_of
from planar_pushing.simulation.fence import ACCELERATION, MEAN, PIECE, VELOCITY
from planar_pushing.simulation.rows import records
from planar_pushing.simulation.timed import timed
from planar_pushing.terms.domain import SPEEDS, Number, required, required_finger_radius
from planar_pushing.terms.errors import (
    InvalidValue,
    as_floats,
    has_entries,
    require_option,
    suggestion,
)
from planar_pushing.terms.numbers import as_numbers, remedy_for
from planar_pushing.terms.options import PusherFrame, Shape

Vector = tuple[float, float]
#: A velocity, or the velocities of many pushers.
Vectors = tuple[npt.ArrayLike, npt.ArrayLike]
Motion = Callable[[float], Vector]

#: Allowed values of `velocity` and `waypoints`, and remedies.
ALLOWED = (
    "(v_x, v_y), a sequence of (start_time, (v_x, v_y)), or a function of time that returns one"
)
REMEDY = "give the fence's velocity as finite numbers in the scene's units"
PLACES = "at least two (time, (x, y)) of finite numbers"
TIMES = "give positions of the pusher in the scene's unit of length, with times from 0"


def vector(given: object) -> Vector:
    """Validate a vector of two numbers with a magnitude in the allowed range."""
    numbers = as_floats(given)
    if len(numbers) != 2 or not all(map(math.isfinite, numbers)):
        raise InvalidValue("velocity", given, ALLOWED, REMEDY)
    if math.hypot(*numbers) > SPEEDS[1]:
        required("velocity", math.hypot(*numbers))
    return numbers


def required_shape(given: object) -> Shape:
    """Validate the shape of a pusher."""
    remedy = suggestion(given, Shape, "name one of these shapes")
    return require_option("shape", given, Shape, remedy)


@dataclass(frozen=True, slots=True, kw_only=True)
class Pusher:
    """A pusher and its motion: a fence, which stays parallel to x, or a finger, which is a disc or a point.

    Parameters
    ----------
    velocity : (v_x, v_y), sequence of (start_time, (v_x, v_y)), or callable
        Velocity in length per time; for a finger, that of its center. The first piece starts at time 0, and
        each piece lasts until the next one starts. For `simulate_batch`, v_x and v_y can be arrays over the
        scenes, shape (scenes,), or labeled arrays, also in each piece.
    waypoints : sequence of (time, (x, y)), instead of a velocity
        Positions of the pusher with their times, the first at time 0. The pusher moves straight from one to
        the next at constant velocity and rests after the last. Only their differences matter, since the
        pusher starts at the contact, or a gap below it.
    acceleration : callable, optional
        Derivative of a callable velocity. It is not needed, since a callable velocity is approximated by
        polynomials with known derivatives.
    breakpoints : sequence of float
        Times at which a callable velocity is not smooth.
    shape : {"fence", "finger"}
        A fence touches the rod's free end. A finger touches a flat side of the slider (`Slider.side`),
        which is along x at time 0 and rotates with the slider. A slipping contact travels along this side.
        A finger does not rotate.
    radius : float
        Radius of the finger in the scene's unit of length, >= 0; the default 0 is a point. The side is
        tangent to the disc. Therefore, when the slider rotates, even a sticking contact travels along the
        side, by ``-radius`` times the rotation: ``ds/dt = tangent . (v_finger - v_slider) - radius omega``.
        For `simulate_batch`, the radius can be an array. A fence has no radius.
    frame : {"fence", "world"}
        Axes of velocity and waypoints: along the fence and normal to it (for a finger, along its side at
        time 0), or those of the world, which requires the object's pose in `simulate`.

    Raises
    ------
    InvalidValue
        If the velocity has an invalid form, times do not increase, the pusher's shape or frame is unknown,
        the radius is negative or given for a fence, or not exactly one of velocity and waypoints is given.
    """

    velocity: Vectors | Sequence[tuple[float, Vectors]] | Motion | None = None
    waypoints: Sequence[tuple[float, Vector]] | None = None
    acceleration: Motion | None = None
    breakpoints: Sequence[float] = ()
    shape: Shape | Literal["fence", "finger"] = Shape.FENCE
    radius: npt.ArrayLike = 0.0
    frame: PusherFrame | Literal["fence", "world"] = PusherFrame.FENCE
    pieces: tuple[tuple[float, Vector], ...] = field(init=False, default=(), repr=False)
    arrays: tuple[tuple[float, tuple[Any, Any]], ...] = field(init=False, default=(), repr=False)

    def __post_init__(self) -> None:
        if self.waypoints is not None:
            _require_alone(self.velocity)
            object.__setattr__(self, "pieces", _legs(self.waypoints))
        elif _are_arrays(self.velocity):
            object.__setattr__(self, "arrays", ((0.0, _required_arrays(self.velocity)),))
        elif _hold_arrays(self.velocity):
            given: Any = self.velocity
            pieces = timed("velocity", given, _required_arrays, ALLOWED, REMEDY)
            object.__setattr__(self, "arrays", pieces)
        elif not callable(self.velocity):
            object.__setattr__(self, "pieces", _pieces(self.velocity))
        times = as_floats(self.breakpoints)
        increase = all(a < b for a, b in itertools.pairwise([*times, math.inf]))
        if not (has_entries(self.breakpoints) and increase and all(t >= 0 for t in times)):
            raise InvalidValue(
                "breakpoints", self.breakpoints, "increasing times >= 0", "put them in order"
            )
        object.__setattr__(self, "breakpoints", times)
        object.__setattr__(self, "shape", required_shape(self.shape))
        object.__setattr__(self, "radius", _required_radius(self.radius, self.shape))
        remedy = suggestion(self.frame, PusherFrame, "name one of these frames")
        object.__setattr__(self, "frame", require_option("frame", self.frame, PusherFrame, remedy))

    @property
    def steps(self) -> tuple[Array, Array]:
        """Start times, and velocities of shape (pieces, 2), of a piecewise constant velocity."""
        return np.array([time for time, _ in self.pieces]), np.array([v for _, v in self.pieces])

    def in_fence_frame(self, fence: Frame) -> Pusher:
        """Convert a motion along the axes of the world to the axes of the fence frame."""
        given: Any = self.velocity

        def turned(velocity: object) -> Vector:
            x, y = fence.vector_in(vector(velocity)).tolist()
            return x, y

        if self.pieces:
            given = [(t, turned(v)) for t, v in self.pieces]
            return Pusher(velocity=given, shape=self.shape, radius=self.radius)
        return Pusher(
            velocity=lambda time: turned(given(time)), breakpoints=self.breakpoints,
            shape=self.shape, radius=self.radius,
        )  # fmt: skip

    def fence(self, duration: float, radius: float, cuts: Sequence[float] = ()) -> Any:
        """The pusher's motion as an array of pieces, from 0 to the duration; a span ends at each cut.

        Raises
        ------
        InvalidValue
            If a function does not return a velocity.
        """
        if self.pieces:
            starts, moves = self.steps
            ends = np.array([duration])
            fences, counts = constant_fences(starts, moves[None] / radius, ends, cuts)
            return fences[0, : counts[0]]
        given: Motion = self.velocity  # type: ignore[assignment]
        inner = {time for time in (*self.breakpoints, *cuts) if 0 < time < duration}
        spans = itertools.pairwise([0.0, *sorted(inner), duration])
        return _fence([pieces_of(lambda t: vector(given(t)), *ends) for ends in spans], radius)


def constant_fences(
    starts: Array, velocities: Array, ends: Array, cuts: Sequence[float]
) -> tuple[Any, Array]:
    """Fences of many scenes with piecewise constant velocities, shape (scenes, pieces, 2).

    Pieces start at the given times and also at the cuts. Returns the fences and the number of valid pieces
    of each, which are those that begin before its end.
    """
    given, starts = starts, np.union1d(starts, cuts)
    velocities = velocities[:, np.searchsorted(given, starts, side="right") - 1]
    fences = records(PIECE, velocities[..., 0].size).reshape(velocities.shape[:2])
    marks = np.append(np.tile(starts, (len(ends), 1)), ends[:, None], axis=1)
    marks = np.minimum(marks, ends[:, None])
    fences["start"], fences["end"] = marks[:, :-1], marks[:, 1:]
    fences["first"] = np.arange(len(starts))
    fences["last"] = fences["first"] + 1
    for row in (VELOCITY, MEAN):
        fences["series"][..., row : row + 2, 0] = velocities
    paths = np.diff(marks)[..., None] * velocities
    fences["origin"][:, 1:] = paths.cumsum(axis=1)[:, :-1]
    return fences, (starts < ends[:, None]).sum(axis=1)


def _fence(spans: Sequence[Sequence[Piece]], radius: float) -> Any:
    """Convert the pieces of each span to the form of the compiled core."""
    pieces = [piece for during in spans for piece in during]
    series = np.array([piece.coefficients.T for piece in pieces]) / radius
    fence = records(PIECE, len(pieces))
    fence["end"] = [piece.end for piece in pieces]
    fence["start"][1:] = fence["end"][:-1]
    fence["degree"] = [np.flatnonzero(each.any(axis=0)).max(initial=0) for each in series]
    counts = np.array([len(during) for during in spans])
    fence["last"] = np.repeat(counts.cumsum(), counts)
    fence["first"] = fence["last"] - np.repeat(counts, counts)
    fence["noise"] = np.array([piece.noise for piece in pieces]) / radius
    lengths = fence["end"] - fence["start"]
    fence["series"][:, VELOCITY:ACCELERATION] = series
    slopes = series @ chebyshev.SLOPE.T
    fence["series"][:, ACCELERATION:MEAN] = 2 / lengths[:, None, None] * slopes
    fence["series"][:, MEAN:] = series @ chebyshev.MEAN.T
    # At the end of a piece, every Chebyshev polynomial is 1.
    paths = lengths[:, None] * fence["series"][:, MEAN:].sum(axis=-1)
    fence["origin"][1:] = paths.cumsum(axis=0)[:-1]
    return fence


def _are_arrays(given: Any) -> bool:
    """Whether a velocity has two components, at least one of which is an array of numbers."""
    pair = isinstance(given, (tuple, list)) and len(given) == 2
    return pair and any(getattr(each, "ndim", 0) > 0 for each in given)


def _hold_arrays(given: Any) -> bool:
    """Whether a velocity consists of pieces, at least one of which contains arrays."""
    pieces = given if isinstance(given, (tuple, list)) else ()
    pairs = (each for each in pieces if isinstance(each, (tuple, list)) and len(each) == 2)
    return any(_are_arrays(velocity) for _, velocity in pairs)


def _required_radius(given: Number, shape: str) -> Number:
    """Validate the radius of one or many fingers; that of a fence must be 0."""
    radius = required_finger_radius(given)
    if shape == Shape.FENCE and np.any(np.asarray(radius) != 0):
        raise InvalidValue(
            "radius", given, "0 for a fence, which is a line",
            'leave the radius out, or set shape="finger"',
        )  # fmt: skip
    return radius


def _required_arrays(given: Any) -> tuple[Any, Any]:
    """Validate the velocity components of many pushers."""
    if not isinstance(given, (tuple, list)) or len(given) != 2:
        raise InvalidValue("velocity", given, ALLOWED, REMEDY)
    x, y = (_component(each) for each in given)
    try:
        with np.errstate(over="ignore"):
            speeds = np.hypot(x, y)
    except ValueError:
        shapes = np.shape(x), np.shape(y)
        raise InvalidValue("velocity", shapes, "two arrays of one shape", REMEDY) from None
    required("velocity", speeds)
    return x, y


def _component(given: Any) -> Number:
    """Validate a component of the velocity of many pushers."""
    found = as_numbers(given)
    if found is None:
        raise InvalidValue("velocity", given, "finite numbers", remedy_for(given, REMEDY))
    wrong = np.ravel(found)[~np.isfinite(np.ravel(found))]
    if wrong.size:
        raise InvalidValue("velocity", float(wrong[0]), "finite numbers", REMEDY)
    return found


def _constant(given: object) -> Vector:
    """Validate the velocity of a piece, which can be zero."""
    found = vector(given)
    required("velocity", math.hypot(*found))
    return found


def _pieces(given: Any) -> tuple[tuple[float, Vector], ...]:
    """Start times and velocities; a single velocity applies from time 0."""
    items = list(given) if has_entries(given) else []
    if not any(isinstance(each, Iterable) for each in items):
        return ((0.0, _constant(given)),)
    return timed("velocity", given, _constant, ALLOWED, REMEDY)


def _require_alone(velocity: Any) -> None:
    """Reject a velocity in addition to waypoints."""
    if velocity is not None:
        raise InvalidValue(
            "velocity", velocity, "none with waypoints", "give either the velocity or the waypoints"
        )


def _legs(given: Any) -> tuple[tuple[float, Vector], ...]:
    """Validate waypoints, and return start times and velocities between them."""
    if not has_entries(given) or len(given) < 2:
        raise InvalidValue("waypoints", given, PLACES, TIMES)
    places = timed("waypoints", given, lambda place: _place(given, place), PLACES, TIMES)
    legs = [
        (start, _constant([(q - p) / (end - start) for p, q in zip(here, there, strict=True)]))
        for (start, here), (end, there) in itertools.pairwise(places)
    ]
    return (*legs, (places[-1][0], (0.0, 0.0)))


def _place(every: Any, given: Any) -> Vector:
    """Validate a position of the pusher."""
    place = as_floats(given)
    if len(place) != 2 or not all(map(math.isfinite, place)):
        raise InvalidValue("waypoints", every, PLACES, TIMES)
    return place
