"""What pushes, and its prescribed motion: constant, piecewise constant or any function of time."""

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
from planar_pushing.terms.errors import InvalidValue, as_floats, require_option, suggestion
from planar_pushing.terms.options import PusherFrame, Shape

Vector = tuple[float, float]
#: A velocity, or the velocities of many pushers.
Vectors = tuple[npt.ArrayLike, npt.ArrayLike]
Motion = Callable[[float], Vector]

#: What `velocity` and `waypoints` may be, and what to do otherwise.
ALLOWED = (
    "(v_x, v_y), a sequence of (start_time, (v_x, v_y)), or a function of time that returns one"
)
REMEDY = "give the fence's velocity as finite numbers in the scene's units"
PLACES = "at least two (time, (x, y)) of finite numbers"
TIMES = "give places of the pusher in the scene's length, with times from 0 on"


def vector(given: object) -> Vector:
    """Two numbers as floats, whose size a square can hold, or `InvalidValue`."""
    numbers = as_floats(given)
    if len(numbers) != 2 or not all(map(math.isfinite, numbers)):
        raise InvalidValue("velocity", given, ALLOWED, REMEDY)
    if math.hypot(*numbers) > SPEEDS[1]:
        required("velocity", math.hypot(*numbers))
    return numbers


def required_shape(given: object) -> Shape:
    """The shape of a pusher, or `InvalidValue`."""
    remedy = suggestion(given, Shape, "name one of these shapes")
    return require_option("shape", given, Shape, remedy)


@dataclass(frozen=True, slots=True, kw_only=True)
class Pusher:
    """What pushes, and its velocity: a fence, which stays parallel to x, or a finger, a disc or a point.

    Parameters
    ----------
    velocity : (v_x, v_y), sequence of (start_time, (v_x, v_y)), or callable
        Length per time; of a finger that of its center. The pieces start at 0 and follow one another; each
        holds until the next starts. For `simulate_batch` v_x and v_y may be arrays over the scenes, shape
        (scenes,), or labelled arrays, also in each piece.
    waypoints : sequence of (time, (x, y)), instead of a velocity
        Places of the pusher with their times, the first at time 0: straight from one to the next at
        constant velocity, and at rest after the last. Only the way between them counts, as the pusher
        starts at the contact, or a gap below it.
    acceleration : callable, optional
        Derivative of a callable velocity. It is not needed: a callable velocity becomes polynomials,
        whose derivatives are known.
    breakpoints : sequence of float
        Times at which a callable velocity is not smooth.
    shape : {"fence", "finger"}
        A fence meets the rod's free end. A finger meets a flat side of the slider (`Slider.side`), which is
        along x at time 0, turns with the slider, and along which the contact travels as it slips. A finger
        does not rotate.
    radius : float
        Radius of the finger in the scene's length, >= 0: by default 0, a point. The side is tangent to the
        disc, so the contact also travels where it sticks while the slider turns, by ``-radius`` times the
        turn; along the side ``ds/dt = tangent . (v_finger - v_slider) - radius omega``. For
        `simulate_batch` it may be an array. A fence has none.
    frame : {"fence", "world"}
        Axes of velocity and waypoints: along the fence and normal to it (the finger's side, at time 0), or
        those of the world, for which `simulate` takes the object's pose.

    Raises
    ------
    InvalidValue
        Where the velocity has another shape, times do not increase, the pusher's shape or its frame is
        unknown, the radius is negative or that of a fence, or not exactly one of velocity and waypoints is
        given.
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
        if not (hasattr(self.breakpoints, "__len__") and increase and all(t >= 0 for t in times)):
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
        """Start times, and velocities of shape (pieces, 2), where the velocity is piecewise constant."""
        return np.array([time for time, _ in self.pieces]), np.array([v for _, v in self.pieces])

    def in_fence_frame(self, fence: Frame) -> Pusher:
        """The same motion along the axes of the fence frame, of a pusher that moves along the world's."""
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
        """The fence's motion as an array of pieces, from 0 to the duration; a span ends at each cut.

        Raises
        ------
        InvalidValue
            Where a function returns something else than a velocity.
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
    """Fences of many scenes whose velocities, shape (scenes, pieces, 2), are constant from given times on.

    Pieces start at the cuts as well. Returns the fences and, of each, the number of pieces that begin
    before its end; the others do not count.
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
    """The pieces of each span as the compiled core has them."""
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
    # At the end of a piece every Chebyshev polynomial is 1.
    paths = lengths[:, None] * fence["series"][:, MEAN:].sum(axis=-1)
    fence["origin"][1:] = paths.cumsum(axis=0)[:-1]
    return fence


def _are_arrays(given: Any) -> bool:
    """Whether a velocity is two parts, of which one at least is an array of numbers."""
    pair = isinstance(given, (tuple, list)) and len(given) == 2
    return pair and any(getattr(each, "ndim", 0) > 0 for each in given)


def _hold_arrays(given: Any) -> bool:
    """Whether a velocity is pieces, of which one at least holds arrays."""
    pieces = given if isinstance(given, (tuple, list)) else ()
    pairs = (each for each in pieces if isinstance(each, (tuple, list)) and len(each) == 2)
    return any(_are_arrays(velocity) for _, velocity in pairs)


def _required_radius(given: Number, shape: str) -> Number:
    """The radius of a finger, or of many; that of a fence is 0. Or `InvalidValue`."""
    radius = required_finger_radius(given)
    if shape == Shape.FENCE and np.any(np.asarray(radius) != 0):
        raise InvalidValue(
            "radius", given, "0 for a fence, which is a line",
            'leave the radius out, or push with shape="finger"',
        )  # fmt: skip
    return radius


def _required_arrays(given: Any) -> tuple[Any, Any]:
    """The parts of the velocities of many pushers, or `InvalidValue`."""
    if not isinstance(given, (tuple, list)) or len(given) != 2:
        raise InvalidValue("velocity", given, ALLOWED, REMEDY)
    x, y = given
    for each in given:
        numbers = np.asarray(each)
        if numbers.dtype.kind not in "iuf" or not np.isfinite(numbers).all():
            wrong = numbers[~np.isfinite(numbers)] if numbers.dtype.kind in "iuf" else numbers
            raise InvalidValue("velocity", wrong.ravel().tolist()[0], "finite numbers", REMEDY)
    try:
        speeds = np.hypot(x, y)
    except ValueError:
        shapes = np.shape(x), np.shape(y)
        raise InvalidValue("velocity", shapes, "two arrays of one shape", REMEDY) from None
    required("velocity", speeds)
    return x, y


def _constant(given: object) -> Vector:
    """The velocity of a piece, which may be at rest."""
    found = vector(given)
    required("velocity", math.hypot(*found))
    return found


def _pieces(given: Any) -> tuple[tuple[float, Vector], ...]:
    """Start times and velocities; one velocity alone holds from 0."""
    items = list(given) if hasattr(given, "__len__") else []
    if not any(isinstance(each, Iterable) for each in items):
        return ((0.0, _constant(given)),)
    return timed("velocity", given, _constant, ALLOWED, REMEDY)


def _require_alone(velocity: Any) -> None:
    """Reject a velocity beside waypoints."""
    if velocity is not None:
        raise InvalidValue(
            "velocity", velocity, "none beside waypoints", "give the velocity or the waypoints"
        )


def _legs(given: Any) -> tuple[tuple[float, Vector], ...]:
    """Start times and velocities between places with times, or `InvalidValue`."""
    if not hasattr(given, "__len__") or len(given) < 2:
        raise InvalidValue("waypoints", given, PLACES, TIMES)
    places = timed("waypoints", given, lambda place: _place(given, place), PLACES, TIMES)
    legs = [
        (start, _constant([(q - p) / (end - start) for p, q in zip(here, there, strict=True)]))
        for (start, here), (end, there) in itertools.pairwise(places)
    ]
    return (*legs, (places[-1][0], (0.0, 0.0)))


def _place(every: Any, given: Any) -> Vector:
    """A place of the pusher."""
    place = as_floats(given)
    if len(place) != 2 or not all(map(math.isfinite, place)):
        raise InvalidValue("waypoints", every, PLACES, TIMES)
    return place
