"""The event-driven integrator: DOP853 from event to event, and a choice of mode at each.

A mode is integrated until one of its guards says that it ends; then the modes whose conditions hold are
enumerated and the policy takes one. The driver knows nothing of the equations.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterator, Sequence

from scipy.integrate import DenseOutput

from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.simulation.guarding import Misjudged, Watcher
from planar_pushing.simulation.inertial import Inertial
from planar_pushing.simulation.mode import Cause, Inconsistent, Mode, State, System
from planar_pushing.simulation.problem import Problem, preference
from planar_pushing.simulation.pusher import Segment
from planar_pushing.simulation.quasi_static import QuasiStatic
from planar_pushing.simulation.record import Record, Records
from planar_pushing.simulation.stepping import Singular, steps

#: A margin this near to zero is judged by where it goes from there.
NEAR = 1e-10
#: How far ahead that is looked, as a part of the time in which the fence moves by one length.
AHEAD = 1e-5
TREND = 1e-12
#: Records handed on at once.
BATCH = 256
#: Events of one run, and events in a row between which no time passes, before it is given up.
MOST_EVENTS, MOST_AT_ONCE = 100_000, 25


#: Part of the tolerance that one step may use, since the errors of steps add up; and the least one.
STEP_PART, LEAST = 0.02, 2.3e-14


def step_tolerance(problem: Problem) -> float:
    """Relative tolerance of one step."""
    return max(STEP_PART * problem.rtol, LEAST)


def integrate(problem: Problem, times: Sequence[float]) -> Records:
    """Simulate a problem; the records hold these times and every event.

    Parameters
    ----------
    times : sequence of float
        Increasing, within the duration.
    """
    system = Inertial(problem) if problem.has_inertia else QuasiStatic(problem)
    return EventDriven(problem, system, times).run()


class EventDriven:
    """One run of a system: where it is, and what was recorded and not yet handed on."""

    def __init__(self, problem: Problem, system: System, times: Sequence[float]) -> None:
        self.problem, self.system = problem, system
        self.times, self.next = list(times), 0
        self.time, self.state = 0.0, system.initial()
        self.mode: Mode | None = None
        self.others: list[Mode] = []
        self.solutions = 0
        self.stopped = ""
        self.events, self.at_once = 0, 0
        self.records: list[Record] = []

    def run(self) -> Records:
        """Lists of records, in order of time."""
        for segment in self.problem.pusher.segments(self.problem.duration):
            try:
                self.state = self.system.enter(segment, self.state, self.mode)
                self._choose(segment, frozenset())
            except Inconsistent as error:
                self._stop(str(error))
            self._log(self.time, self.state)
            for _ in self._through(segment):
                if len(self.records) >= BATCH:
                    yield self._handed_on()
            if self.stopped:
                break
        self._log(self.time, self.state)
        yield self._handed_on()

    def _handed_on(self) -> list[Record]:
        records, self.records = self.records, []
        return records

    def _through(self, segment: Segment) -> Iterator[None]:
        """From event to event up to the end of a segment."""
        while not self.stopped and self.time < segment.end:
            excluded: frozenset[ContactMode] = frozenset()
            before, mode = self.time, self.mode
            assert mode is not None
            try:
                for _ in self._until_event(mode, segment):
                    yield
            except Misjudged:
                excluded = frozenset({mode.kind})
            self._count(before)
            if self.time < segment.end and not self.stopped:
                self._choose(segment, excluded)
                self._log(self.time, self.state)

    def _count(self, before: float) -> None:
        self.events += 1
        passed = self.time - before > 1e-12 * self.problem.duration
        self.at_once = 0 if passed else self.at_once + 1
        if self.at_once > MOST_AT_ONCE or self.events > MOST_EVENTS:
            self._stop(
                f"{self.events} events, {self.at_once} of them without any time between them"
            )

    def _until_event(self, mode: Mode, segment: Segment) -> Iterator[None]:
        """Integrate one mode; at its end time and state are those just after the event."""
        watcher = Watcher(mode, self.time)
        watcher.start(self.state)
        rtol = step_tolerance(self.problem)
        try:
            for time, state, dense in steps(
                self.system, mode, self.time, self.state, segment.end, rtol
            ):
                event = watcher.first_event(dense)
                yield from self._samples(time if event is None else event[0], dense, segment)
                if event is not None:
                    self._happened(mode, *event, dense)
                    return
                self.time, self.state = time, state
        except Singular:
            self._stop(f"the motion is singular in the mode {mode.kind.name}")

    def _happened(self, mode: Mode, time: float, cause: Cause, dense: DenseOutput) -> None:
        state = dense(time).tolist()
        self.time, self.state = time, state
        try:
            self.time, self.state = self.system.after(cause, time, state, mode)
        except Inconsistent as error:
            self._stop(str(error))
        if cause is Cause.LIES:
            self._stop(cause.value)

    def _stop(self, reason: str) -> None:
        self.stopped = reason
        record = self.system.record(self.time, self.state, self.mode, self.solutions)
        self.records.append(record._replace(stopped=reason))

    def _choose(self, segment: Segment, excluded: frozenset[ContactMode]) -> None:
        """Take a consistent mode by the policy, or stop where there is none."""
        modes = [m for m in self.system.modes(self.time, self.state) if m.kind not in excluded]
        held = [m for m in modes if self._holds(m, segment, self.time, self.state)]
        previous = None if self.mode is None else self.mode.kind
        order = preference(self.problem.on_ambiguity, previous)
        self.solutions = len(held)
        self.others = []
        self.mode = min(held, key=lambda mode: order.index(mode.kind)) if held else None
        self.others = [mode for mode in modes if mode is not self.mode]
        if self.mode is None:
            self._stop("no contact mode is consistent")

    def _holds(self, mode: Mode, segment: Segment, time: float, state: State) -> bool:
        """Whether the margins are positive, or zero and not about to fall."""
        margins = [guard.value for guard in mode.guards(time, state) if not guard.watch]
        if min(margins, default=1.0) > NEAR:
            return True
        if min(margins) < -NEAR:
            return False
        ahead = AHEAD * min(segment.end - segment.start, self.system.pace(time))
        rates = mode.rates(time, state)
        there = [y + ahead * rate for y, rate in zip(state, rates, strict=True)]
        later = [guard.value for guard in mode.guards(time + ahead, there) if not guard.watch]
        return all(
            now > NEAR or then >= now - TREND for now, then in zip(margins, later, strict=True)
        )

    def _samples(self, end: float, dense: DenseOutput, segment: Segment) -> Iterator[None]:
        """Log the uniform samples up to a time, a batch at a time."""
        stop = bisect_left(self.times, end, lo=self.next)
        while self.next < stop:
            times = self.times[self.next : min(stop, self.next + BATCH)]
            self.next += len(times)
            for time, state in zip(times, dense(times).T.tolist(), strict=True):
                others = (self._holds(mode, segment, time, state) for mode in self.others)
                held = 1 + sum(others)
                self.records.append(self.system.record(time, state, self.mode, held))
            yield

    def _log(self, time: float, state: State) -> None:
        """Log an instant, unless the run has just stopped there."""
        if not self.stopped:
            self.records.append(self.system.record(time, state, self.mode, self.solutions))
        while self.next < len(self.times) and self.times[self.next] <= time:
            self.next += 1
