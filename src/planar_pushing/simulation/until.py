"""`until`: a run that ends at the first instant at which a condition on the log holds."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.mechanics.plane import Array
from planar_pushing.simulation.log.variables import arrays
from planar_pushing.simulation.problem import Problem
from planar_pushing.terms.errors import InvalidValue, require_positive, suggestion
from planar_pushing.terms.options import Event, Method

#: The names of the events and of the contact modes, as the flag meanings of a log have them.
EVENTS = {event.name: event for event in Event if event is not Event.NONE}
MODES = {mode.name: mode for mode in ContactMode}
ALLOWED = "an Event or a ContactMode or its name, an Until, or a function of an instant of the log"
#: Times that the instant is bracketed anew, each time 65 times narrower: to rounding from any duration.
PASSES = 20
#: The values of an instant, or of many, by the names of the log's variables.
Values = dict[str, Any]


@dataclass(frozen=True, slots=True, kw_only=True)
class Until:
    """How far a motion goes until `simulate` stops: to the first of these that is reached.

    Parameters
    ----------
    rotation : float, optional
        Angle by which the slider has turned since time 0, in either sense; radians, > 0.
    distance : float, optional
        Straight distance of the slider's center from its place at time 0, > 0.
    pusher_distance : float, optional
        Straight distance of the pusher from its place at time 0, > 0.

    Raises
    ------
    InvalidValue
        Where none is given, or one is no finite number > 0.
    """

    rotation: float | None = None
    distance: float | None = None
    pusher_distance: float | None = None

    def __post_init__(self) -> None:
        given = {
            name: value for name in self.__slots__ if (value := getattr(self, name)) is not None
        }
        if not given:
            raise InvalidValue(
                "Until", None, ", ".join(self.__slots__), "say how far the motion goes"
            )
        for name, value in given.items():
            positive = require_positive(name, value, "say how far the motion goes, or leave it out")
            object.__setattr__(self, name, positive)


class Condition(NamedTuple):
    """When a run ends: of which instants that is so, given the log's variables, and in words."""

    holds: Callable[[Values], Array]
    reason: str


def required_condition(given: Any, problem: Problem, method: str) -> Condition:
    """The condition that `until` stands for, or `InvalidValue`."""
    if isinstance(given, Until):
        return Condition(lambda now: _reached(given, now, problem), _goal(given))
    named = {**EVENTS, **MODES}.get(given) if isinstance(given, str) else given
    if isinstance(named, Event) and named is not Event.NONE:
        if method == Method.TIME_STEPPING:
            raise InvalidValue(
                "until", named.name, "a mode, an Until or a function for the time-stepping method",
                "take the event-driven method, which alone locates events",
            )  # fmt: skip
        return Condition(lambda now: now["event"] == named, f"event {named.name}")
    if isinstance(named, ContactMode):
        return Condition(lambda now: now["mode"] == named, f"mode {named.name}")
    if callable(given):
        return Condition(lambda now: _told(given, now), "the function returns True")
    remedy = suggestion(
        given, [*EVENTS, *MODES], "name one as the log does, for instance SLIP_ENDS"
    )
    raise InvalidValue("until", given, ALLOWED, remedy)


def _goal(until: Until) -> str:
    given = {name: getattr(until, name) for name in Until.__slots__}
    return " or ".join(f"{name} {value:.12g}" for name, value in given.items() if value is not None)


def _reached(until: Until, now: Values, problem: Problem) -> Array:
    """Whether one of the goals is reached, of each instant."""
    slider = problem.scene.slider
    angle, length = float(slider.rod_angle), float(slider.rod_length)
    center = length * math.cos(angle), length * math.sin(angle)
    moved = {
        "rotation": np.abs(np.deg2rad(now["rod_angle"]) - angle),
        "distance": np.hypot(*(now["position"] - center).T),
        "pusher_distance": np.hypot(*(now["pusher"] - (0.0, -float(problem.gap))).T),
    }
    goals = {name: getattr(until, name) for name in moved}
    every = [moved[name] >= goal for name, goal in goals.items() if goal is not None]
    return np.asarray(np.any(every, axis=0))


def _told(function: Callable[[Values], Any], now: Values) -> Array:
    """The answers of a function of an instant, one by one."""
    count = len(now["time"])
    instants = ({name: each[i] for name, each in now.items()} for i in range(count))
    return np.array([_truth(function(instant)) for instant in instants], bool)


def _truth(answer: Any) -> bool:
    single = getattr(getattr(answer, "dtype", None), "kind", "") == "b" and np.ndim(answer) == 0
    if not single and not isinstance(answer, bool):
        raise InvalidValue(
            "until", answer, "a function that returns True or False", "compare with a number in it"
        )
    return bool(answer)


class UntilRun:
    """A run that ends at the first instant at which a condition holds; iterating hands on its rows.

    Parameters
    ----------
    start : callable
        A new run that samples these times; both methods take the same path for any samples.
    times : ndarray
        Samples to record. Between the last at which the condition does not hold and the first at which it
        does the run is repeated with more of them, until the instant is known to rounding or is the end of
        a step.
    """

    def __init__(
        self, start: Callable[[Array], Any], times: Array, condition: Condition, problem: Problem
    ) -> None:
        self.start, self.times, self.condition, self.problem = start, times, condition, problem
        self.stopped = ""

    def __iter__(self) -> Iterator[Any]:
        end = self._end()
        run = self.start(self.times if end is None else np.union1d(self.times, [end]))
        for rows in run:
            holds = self._holds(rows)
            if holds.any():
                self.stopped = f"until: {self.condition.reason}"
                yield rows[: holds.argmax() + 1]
                return
            yield rows
        self.stopped = run.stopped

    def _holds(self, rows: Any) -> Array:
        return self.condition.holds(arrays(rows, self.problem))

    def _end(self) -> float | None:
        """The first instant at which the condition holds; None where there is none."""
        run, found = self.start(self.times), None
        bracket = self._bracket(run)
        for _ in range(PASSES):
            if bracket is None:
                break
            found = bracket[1]
            finer = run.between(*bracket)
            if not len(finer):
                break
            bracket = self._bracket(self.start(np.union1d(self.times, [*finer, found])))
        return found

    def _bracket(self, run: Any) -> tuple[float, float] | None:
        """The last time before the condition holds, and the first at which it does."""
        before = 0.0
        for rows in run:
            holds, times = self._holds(rows), rows["time"]
            if holds.any():
                first = int(holds.argmax())
                return float(times[first - 1]) if first else before, float(times[first])
            before = float(times[-1])
        return None
