"""`until`: end a run at the first instant at which a condition on the log holds."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Annotated, Any, NamedTuple

import numpy as np

from planar_pushing.core.motion.kinematics.run import LogRow
from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.simulation.early_end import UNTIL
from planar_pushing.simulation.fields import arrays, logged_fields
from planar_pushing.simulation.problem import Problem
from planar_pushing.terms.declared import require_declared
from planar_pushing.terms.domain import DISTANCE, ROTATION
from planar_pushing.terms.errors import InvalidValue, suggestion
from planar_pushing.terms.numbers import Array
from planar_pushing.terms.options import Event, Method

#: Events and contact modes by the names that are flag meanings in a log.
EVENTS = {event.name: event for event in Event if event is not Event.NONE}
MODES = {mode.name: mode for mode in ContactMode}
ALLOWED = "an Event or a ContactMode or its name, an Until, or a function of an instant of the log"
#: Number of times that the bracket is narrowed by a factor of 65, enough to reach rounding error.
PASSES = 20
#: Values at one or many instants, by the names of the log's variables.
LogValues = dict[str, Any]


@dataclass(frozen=True, slots=True, kw_only=True)
class Until:
    """Rotation or distances at which `simulate` stops, whichever is reached first.

    Parameters
    ----------
    rotation : float, optional
        Angle of rotation of the slider since time 0, in either direction; radians in (0, 4 pi].
    distance : float, optional
        Straight-line distance of the slider's center from its position at time 0, > 0.
    pusher_distance : float, optional
        Straight-line distance of the pusher from its position at time 0, > 0.

    Raises
    ------
    InvalidValue
        If none is given, one is not a finite number > 0, or the rotation is beyond 4 pi, which is most
        likely in degrees.
    """

    rotation: Annotated[float | None, ROTATION] = None
    distance: Annotated[float | None, DISTANCE] = None
    pusher_distance: Annotated[float | None, DISTANCE] = None

    def __post_init__(self) -> None:
        if not self.goals:
            raise InvalidValue(
                "Until", None, ", ".join(self.__slots__), "give at least one of them"
            )
        require_declared(self)

    @property
    def goals(self) -> dict[str, float]:
        """The values by name."""
        values = {name: getattr(self, name) for name in self.__slots__}
        return {name: value for name, value in values.items() if value is not None}


class Condition(NamedTuple):
    """Condition that ends a run: a function of the log's variables at many instants, and its text."""

    holds: Callable[[LogValues], Array]
    reason: str


def require_condition(until: Any, problem: Problem, method: str) -> Condition:
    """Validate `until` and convert it to a condition."""
    if isinstance(until, Until):
        goals = " or ".join(f"{name} {value:.12g}" for name, value in until.goals.items())
        return Condition(lambda values: _are_reached(until.goals, values, problem), goals)
    named = {**EVENTS, **MODES}.get(until) if isinstance(until, str) else until
    if isinstance(named, Event) and named is not Event.NONE:
        if method == Method.TIME_STEPPING:
            raise InvalidValue(
                "until", named.name, "a mode, an Until or a function for the time-stepping method",
                "use the event-driven method, since only it locates events",
            )  # fmt: skip
        return Condition(lambda values: values["event"] == named, f"event {named.name}")
    if isinstance(named, ContactMode):
        return Condition(lambda values: values["mode"] == named, f"mode {named.name}")
    if callable(until):
        return Condition(lambda values: _results(until, values), "the function returns True")
    remedy = suggestion(until, [*EVENTS, *MODES], "use a name from the log, such as SLIP_ENDS")
    raise InvalidValue("until", until, ALLOWED, remedy)


def _are_reached(goals: dict[str, float], values: LogValues, problem: Problem) -> Array:
    """Whether one of the goals of an `Until` is reached at each instant."""
    slider = problem.scene.slider
    angle, length = float(slider.rod_angle), float(slider.rod_length)
    center = length * math.cos(angle), length * math.sin(angle)
    reached = {
        "rotation": np.abs(np.deg2rad(values["rod_angle"]) - angle),
        "distance": np.hypot(*(values["position"] - center).T),
        "pusher_distance": np.hypot(*(values["pusher"] - (0.0, -float(problem.gap))).T),
    }
    return np.asarray(np.any([reached[name] >= goal for name, goal in goals.items()], axis=0))


def _results(function: Callable[[LogValues], Any], values: LogValues) -> Array:
    """Results of a function of an instant, one for each instant."""
    instants = (
        {name: numbers[i] for name, numbers in values.items()} for i in range(len(values["time"]))
    )
    return np.array([_truth(function(instant)) for instant in instants], bool)


def _truth(answer: Any) -> bool:
    single = getattr(getattr(answer, "dtype", None), "kind", "") == "b" and np.ndim(answer) == 0
    if not single and not isinstance(answer, bool):
        raise InvalidValue(
            "until", answer, "a function that returns True or False", "return a comparison from it"
        )
    return bool(answer)


class UntilRun:
    """A run that ends at the first instant at which a condition holds; iteration yields its rows.

    Parameters
    ----------
    start : callable
        Function that creates a run with samples at given times; in both methods, the motion does not depend
        on the samples.
    times : ndarray
        Times to record. Between the last sample at which the condition does not hold and the first at which
        it does, the run is repeated with more samples until the instant is known to rounding error or is
        the end of a step.
    """

    def __init__(
        self, start: Callable[[Array], Any], times: Array, condition: Condition, problem: Problem,
        method: str,
    ) -> None:  # fmt: skip
        self.start, self.times, self.condition, self.problem = start, times, condition, problem
        self.fields, self.stopped = logged_fields(problem, method), ""

    def __iter__(self) -> Iterator[Array]:
        end = self._end()
        run = self.start(self.times if end is None else np.union1d(self.times, [end]))
        self.last: Any = run
        for rows in run:
            holds = self._holds(rows)
            if holds.any():
                self.stopped = f"{UNTIL}{self.condition.reason}"
                yield rows[: holds.argmax() + 1]
                return
            yield rows
        self.stopped = run.stopped

    def _holds(self, rows: Array) -> Array:
        return self.condition.holds(arrays(rows, self.problem, self.fields))

    def _end(self) -> float | None:
        """First instant at which the condition holds; None if there is none."""
        run, end = self.start(self.times), None
        bracket = self._bracket(run)
        for _ in range(PASSES):
            if bracket is None:
                break
            end = bracket[1]
            finer = run.between(*bracket)
            if not len(finer):
                break
            bracket = self._bracket(self.start(np.union1d(self.times, [*finer, end])))
        return end

    def _bracket(self, run: Any) -> tuple[float, float] | None:
        """Last time at which the condition does not hold, and first time at which it does."""
        before = 0.0
        for rows in run:
            holds, times = self._holds(rows), rows[:, LogRow.places["time"]]
            if holds.any():
                first = int(holds.argmax())
                return float(times[first - 1]) if first else before, float(times[first])
            before = float(times[-1])
        return None
