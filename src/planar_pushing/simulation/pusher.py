"""The pusher and its prescribed motion: constant, piecewise constant, or any function of time."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import InitVar, dataclass, field
from enum import StrEnum
from typing import Annotated, Any, Literal, TypeVar

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.plane import Frame, vector_in_frame
from planar_pushing.simulation.motion import values_over_time
from planar_pushing.terms.domain import FINGER_RADIUS, SPEEDS, Number, require_in_range
from planar_pushing.terms.errors import (
    InvalidValue,
    as_floats,
    has_entries,
    require_option,
)
from planar_pushing.terms.numbers import as_numbers, remedy_for
from planar_pushing.terms.options import PusherFrame, Shape

Option = TypeVar("Option", bound=StrEnum)
Vector = tuple[float, float]
#: A velocity, or the velocities of many pushers.
Vectors = tuple[npt.ArrayLike, npt.ArrayLike]
VelocityFunction = Callable[[float], Vector]

#: Allowed values of `velocity` and `waypoints`, and remedies.
ALLOWED = (
    "(v_x, v_y), a sequence of (start_time, (v_x, v_y)), or a function of time that returns one"
)
REMEDY = "give the fence's velocity as finite numbers in the scene's units"
POSITIONS = "at least two (time, (x, y)) of finite numbers"
TIMES = "give positions of the pusher in the scene's unit of length, with times from 0"


def require_velocity(value: object) -> Vector:
    """Validate a velocity of two numbers with a magnitude in the allowed range."""
    numbers = as_floats(value)
    if len(numbers) != 2 or not all(map(math.isfinite, numbers)):
        raise InvalidValue("velocity", value, ALLOWED, REMEDY)
    if math.hypot(*numbers) > SPEEDS[1]:
        require_in_range("velocity", math.hypot(*numbers))
    return numbers


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
    acceleration
        Refused: the velocity determines it. A callable velocity is approximated by polynomials.
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
        time 0), or those of the world, which requires the object's pose in `simulate` or `simulate_batch`.

    Raises
    ------
    InvalidValue
        If the velocity has an invalid form, times do not increase, the pusher's shape or frame is unknown,
        the radius is negative or given for a fence, or not exactly one of velocity and waypoints is given.
    """

    velocity: Vectors | Sequence[tuple[float, Vectors]] | VelocityFunction | None = None
    waypoints: Sequence[tuple[float, Vector]] | None = None
    acceleration: InitVar[Any] = None
    breakpoints: Sequence[float] = ()
    shape: Shape | Literal["fence", "finger"] = Shape.FENCE
    radius: Annotated[npt.ArrayLike, FINGER_RADIUS] = 0.0
    frame: PusherFrame | Literal["fence", "world"] = PusherFrame.FENCE
    pieces: tuple[tuple[float, Vector], ...] = field(init=False, default=(), repr=False)
    arrays: tuple[tuple[float, tuple[Any, Any]], ...] = field(init=False, default=(), repr=False)

    def __post_init__(self, acceleration: Any) -> None:
        if acceleration is not None:
            raise InvalidValue(
                "acceleration", acceleration, "none, since the velocity determines it",
                "give a velocity that changes, for instance velocity=lambda t: (0.0, 1.0 - 0.5 * t)",
            )  # fmt: skip
        if self.waypoints is not None:
            _require_no_velocity(self.velocity)
            self._set("pieces", _legs(self.waypoints))
        elif _has_arrays(self.velocity):
            self._set("arrays", ((0.0, _required_arrays(self.velocity)),))
        elif _has_pieces_of_arrays(self.velocity):
            self._set("arrays", _over_time(self.velocity, _required_arrays))
        elif not callable(self.velocity):
            self._set("pieces", _required_pieces(self.velocity))
        self._set("breakpoints", _required_breakpoints(self.breakpoints))
        shape = require_option("shape", self.shape, Shape, "name one of these shapes")
        self._set("shape", shape)
        self._set("radius", _required_radius(self.radius, shape))
        frame = require_option("frame", self.frame, PusherFrame, "name one of these frames")
        self._set("frame", frame)

    def _set(self, name: str, value: Any) -> None:
        object.__setattr__(self, name, value)

    @property
    def velocities(self) -> tuple[tuple[float, tuple[Any, Any]], ...]:
        """Start times and velocities, numbers or arrays over the scenes; empty for a function of time."""
        return self.arrays or self.pieces

    def velocity_at(self, time: float) -> Vector:
        """Velocity of a pusher that follows a function; errors as in `require_velocity`."""
        function: VelocityFunction = self.velocity  # type: ignore[assignment]
        return require_velocity(function(time))

    def in_fence_frame(self, fence: Frame) -> Pusher:
        """Convert a motion along the axes of the world to the axes of one or many fence frames."""

        def convert(velocity: Vectors) -> Vector:
            return vector_in_frame(velocity, fence)

        pieces: Any = [(time, convert(velocity)) for time, velocity in self.velocities]
        return Pusher(
            velocity=pieces or (lambda time: convert(self.velocity_at(time))),
            breakpoints=self.breakpoints, shape=self.shape, radius=self.radius,
        )  # fmt: skip


def _over_time(pieces: Any, read: Callable[[Any], Any]) -> tuple[tuple[float, Any], ...]:
    """Start times and velocities, which a function validates."""
    return values_over_time("velocity", pieces, read, ALLOWED, REMEDY)


def _has_arrays(velocity: Any) -> bool:
    """Whether a velocity has two components, at least one of which is an array of numbers."""
    pair = isinstance(velocity, (tuple, list)) and len(velocity) == 2
    return pair and any(getattr(component, "ndim", 0) > 0 for component in velocity)


def _has_pieces_of_arrays(velocity: Any) -> bool:
    """Whether a velocity consists of pieces, at least one of which has arrays."""
    pieces = velocity if isinstance(velocity, (tuple, list)) else ()
    pairs = (piece for piece in pieces if isinstance(piece, (tuple, list)) and len(piece) == 2)
    return any(_has_arrays(velocity) for _, velocity in pairs)


def _required_breakpoints(value: Any) -> tuple[float, ...]:
    """Validate the times at which a velocity is not smooth."""
    times = as_floats(value)
    increase = all(a < b for a, b in itertools.pairwise([*times, math.inf]))
    if not (has_entries(value) and increase and all(time >= 0 for time in times)):
        raise InvalidValue("breakpoints", value, "increasing times >= 0", "put them in order")
    return times


def _required_radius(value: Number, shape: Shape) -> Number:
    """Validate the radius of one or many fingers; that of a fence must be 0."""
    radius = FINGER_RADIUS.require("radius", value)
    if shape == Shape.FENCE and np.any(np.asarray(radius) != 0):
        raise InvalidValue(
            "radius", value, "0 for a fence, which is a line",
            'leave the radius out, or set shape="finger"',
        )  # fmt: skip
    return radius


def _required_arrays(value: Any) -> tuple[Any, Any]:
    """Validate the velocity components of many pushers."""
    if not isinstance(value, (tuple, list)) or len(value) != 2:
        raise InvalidValue("velocity", value, ALLOWED, REMEDY)
    x, y = map(_required_component, value)
    try:
        with np.errstate(over="ignore"):
            speeds = np.hypot(x, y)
    except ValueError:
        shapes = np.shape(x), np.shape(y)
        raise InvalidValue("velocity", shapes, "two arrays of one shape", REMEDY) from None
    require_in_range("velocity", speeds)
    return x, y


def _required_component(value: Any) -> Number:
    """Validate a component of the velocity of many pushers."""
    numbers = as_numbers(value)
    if numbers is None:
        raise InvalidValue("velocity", value, "finite numbers", remedy_for(value, REMEDY))
    wrong = np.ravel(numbers)[~np.isfinite(np.ravel(numbers))]
    if wrong.size:
        raise InvalidValue("velocity", float(wrong[0]), "finite numbers", REMEDY)
    return numbers


def _required_constant(value: object) -> Vector:
    """Validate the velocity of a piece, which can be zero."""
    velocity = require_velocity(value)
    require_in_range("velocity", math.hypot(*velocity))
    return velocity


def _required_pieces(value: Any) -> tuple[tuple[float, Vector], ...]:
    """Start times and velocities; a single velocity applies from time 0."""
    items = list(value) if has_entries(value) else []
    if not any(isinstance(item, Iterable) for item in items):
        return ((0.0, _required_constant(value)),)
    return _over_time(value, _required_constant)


def _require_no_velocity(velocity: Any) -> None:
    """Reject a velocity in addition to waypoints."""
    if velocity is not None:
        raise InvalidValue(
            "velocity", velocity, "none with waypoints", "give either the velocity or the waypoints"
        )


def _legs(waypoints: Any) -> tuple[tuple[float, Vector], ...]:
    """Validate waypoints, and return start times and velocities between them."""

    def position(value: Any) -> Vector:
        numbers = as_floats(value)
        if len(numbers) != 2 or not all(map(math.isfinite, numbers)):
            raise InvalidValue("waypoints", waypoints, POSITIONS, TIMES)
        return numbers

    if not has_entries(waypoints) or len(waypoints) < 2:
        raise InvalidValue("waypoints", waypoints, POSITIONS, TIMES)
    positions = values_over_time("waypoints", waypoints, position, POSITIONS, TIMES)
    legs = [
        (start, _required_constant([(q - p) / (end - start) for p, q in zip(a, b, strict=True)]))
        for (start, a), (end, b) in itertools.pairwise(positions)
    ]
    return (*legs, (positions[-1][0], (0.0, 0.0)))
