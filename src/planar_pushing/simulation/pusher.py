"""The pusher and its prescribed motion: constant, piecewise constant, or any function of time."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import InitVar, dataclass, field
from enum import StrEnum
from typing import Annotated, Any, Literal, Protocol, TypeVar

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
    suggestion,
)
from planar_pushing.terms.numbers import as_array, as_numbers, remedy_for
from planar_pushing.terms.options import PusherFrame, Shape

Option = TypeVar("Option", bound=StrEnum)
Vector = tuple[float, float]
#: A velocity, or the velocities of many pushers.
Vectors = tuple[npt.ArrayLike, npt.ArrayLike]
VelocityFunction = Callable[[float], Vector]


class DataFrame(Protocol):
    """A table with named columns, such as that of pandas."""

    @property
    def columns(self) -> Any: ...

    def to_numpy(self) -> npt.NDArray[Any]: ...


Table = npt.NDArray[Any] | DataFrame

#: Allowed values of `velocity` and `waypoints`, and remedies.
ALLOWED = (
    "(v_x, v_y), a sequence of (start_time, (v_x, v_y)), a table of time, v_x and v_y, or a function of "
    "time that returns one"
)
REMEDY = "give the fence's velocity as finite numbers in the scene's units"
POSITIONS = "at least two (time, (x, y)) of finite numbers, or a table of time, x and y"
TIMES = "give positions of the pusher in the scene's unit of length, with times from 0"
#: Columns of tables, in the order of those without names.
VELOCITIES, PATH = ("time", "v_x", "v_y"), ("time", "x", "y")


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
    velocity : (v_x, v_y), sequence of (start_time, (v_x, v_y)), table, or callable
        Velocity in length per time; for a finger, that of its center. The first piece starts at time 0, and
        each piece lasts until the next one starts. A table has a piece in each row: an array of shape
        (pieces, 3) with start time, v_x and v_y, or a pandas DataFrame with the columns `time`, `v_x` and
        `v_y`, as read from a CSV file. For `simulate_batch`, v_x and v_y can be arrays over the
        scenes, shape (scenes,), or labeled arrays, also in each piece.
    waypoints : sequence of (time, (x, y)), or table, instead of a velocity
        Positions of the pusher with their times, the first at time 0; a table has the columns `time`, `x`
        and `y`, or is an array of shape (positions, 3). The pusher moves straight from one to
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

    velocity: Vectors | Sequence[tuple[float, Vectors]] | Table | VelocityFunction | None = None
    waypoints: Sequence[tuple[float, Vector]] | Table | None = None
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
        self._read_tables()
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

    def _read_tables(self) -> None:
        """Replace tables with sequences, so that pushers can be compared."""
        for name, labels in (("velocity", VELOCITIES), ("waypoints", PATH)):
            value = getattr(self, name)
            if getattr(value, "ndim", 0) == 2 or _column_names(value) is not None:
                self._set(name, _pieces_of_table(name, value, labels))

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


def _column_names(table: Any) -> list[Any] | None:
    """Names of the columns of a data frame or of an array of records; None for anything else."""
    names = getattr(table, "columns", None)
    if names is None:
        names = getattr(getattr(table, "dtype", None), "names", None)
    return None if names is None else list(names)


def _pieces_of_table(
    name: str, table: Any, labels: tuple[str, str, str]
) -> list[tuple[float, Vector]]:
    """The rows of a table of times and vectors, whose columns are found by their names if they have any."""
    names = _column_names(table)
    if names is None:
        shape = np.shape(table)
        if shape[1] != 3:
            raise InvalidValue(
                name, f"an array of shape {shape}", "shape (rows, 3)",
                f"give {', '.join(labels)} in each row",
            )  # fmt: skip
        columns = list(table.T)
    else:
        _require_columns(name, names, labels)
        columns = [table[label] for label in labels]
    numbers = [
        _required_column(name, label, column) for label, column in zip(labels, columns, strict=True)
    ]
    return [(time, (x, y)) for time, x, y in zip(*numbers, strict=True)]


def _require_columns(name: str, names: list[Any], labels: tuple[str, str, str]) -> None:
    """Reject a table whose columns are not those with these labels, each once."""
    unknown = [label for label in names if label not in labels]
    if unknown or len(names) != len(labels) or {*names} != {*labels}:
        columns = ", ".join(map(str, names)) or "none"
        otherwise = "name the columns so, and choose these three of them"
        remedy = suggestion(unknown[0], labels, otherwise) if unknown else otherwise
        raise InvalidValue(name, f"a table with the columns {columns}", ", ".join(labels), remedy)


def _required_column(name: str, label: str, column: Any) -> list[float]:
    """The finite numbers in a column of a table."""
    values = as_array(column)
    remedy = "fill the gaps, or leave out such rows"
    if values is None:
        raise InvalidValue(name, f"a column {label} of other values", "finite numbers", remedy)
    for row in np.flatnonzero(~np.isfinite(values))[:1].tolist():
        raise InvalidValue(name, f"{values[row]} in row {row} of {label}", "finite numbers", remedy)
    numbers: list[float] = values.tolist()
    return numbers


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
