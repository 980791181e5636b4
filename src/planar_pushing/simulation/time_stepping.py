"""The time-stepping integrator: one incremental problem a step, of order 1, without events.

A step sees the rod angle of its start. While the contact lasts, the contact point itself is moved by its
own motion and the ring's centre follows from the rod: a stick is then a stick and the gap is
closed to rounding, whatever the step. In flight the ring's centre is moved; the contact's path is then
above its tangent, so the step's condition on the gap keeps the true gap open as well.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Sequence

from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.mechanics.errors import require_positive
from planar_pushing.simulation.energies import Energies
from planar_pushing.simulation.incremental import (
    Contact,
    Increment,
    QuasiStaticIncrement,
    Step,
    Trial,
    Twist,
    contact_motion,
)
from planar_pushing.simulation.incremental_inertia import InertialIncrement
from planar_pushing.simulation.mode import Cause
from planar_pushing.simulation.problem import Problem, preference
from planar_pushing.simulation.pusher import Segment, Vector
from planar_pushing.simulation.record import NO_MODE, Record, Records

#: Steps of a run whose step is not given.
STEPS = 1000
#: Records handed on at once.
BATCH = 256
#: A gap that is this small in radii is closed.
CLOSED = 1e-12
#: Times closer than this part of the time that has passed are one time.
APART = 1e-12


def integrate(problem: Problem, times: Sequence[float], step: float | None = None) -> Records:
    """Simulate a problem by steps of equal length between the times to be recorded.

    Parameters
    ----------
    problem : Problem
        Its tolerance has no part in this method.
    times : sequence of float
        Increasing, within the duration. The records hold these times and every change of mode or of
        the number of consistent ones.
    step : float, optional
        Greatest length of a step; a thousandth of the duration by default. The error is proportional
        to it.

    Returns
    -------
    iterator of lists of Record
        `force` is the mean over the step that ends or, at a change of mode, starts there. The work of
        the fence equals the change of kinetic energy plus what is dissipated, to rounding; the scheme's
        own loss, of the order of the step, counts as the contact's, or as the effects' in flight.

    Raises
    ------
    InvalidValue
        Where the step is not a positive number.
    """
    if step is None:
        step = problem.duration / STEPS
    size = require_positive("step", step, "give the length of a step in the unit of the duration")
    return TimeStepping(problem).run(times, size)


class TimeStepping:
    """One run: where it is, and what was recorded and not yet handed on."""

    def __init__(self, problem: Problem) -> None:
        scene, slider = problem.scene, problem.scene.slider
        self.problem, self.radius, self.length = problem, slider.radius, slider.length_ratio
        self.energies = Energies(scene.scaled_effects)
        self.increment: Increment = (
            InertialIncrement(self.energies, self.length)
            if problem.has_inertia
            else QuasiStaticIncrement(self.energies.support, self.length)
        )
        self.contact = Contact(scene.contact, self.length)
        self.time, self.along, self.gap, self.slip = 0.0, 0.0, problem.gap, 0.0
        self.fence, self.rod_angle = (0.0, -problem.gap), slider.rod_angle
        v_x, v_y, omega = problem.twist
        self.twist: Twist = (v_x, v_y, self.radius * omega)
        self.mode: ContactMode | None = None
        self.solutions, self.force, self.stopped = 0, (0.0, 0.0), ""
        self.records: list[Record] = []

    def run(self, times: Sequence[float], size: float) -> Records:
        """Lists of records, in order of time."""
        wanted = sorted({*map(float, times), 0.0, float(self.problem.duration)})
        for segment in self.problem.pusher.segments(self.problem.duration):
            for start, end in itertools.pairwise(_marks(segment, wanted)):
                for _ in self._span(segment, start, end, size):
                    if len(self.records) >= BATCH:
                        yield self._handed_on()
                self._log()
                if self.stopped:
                    yield self._handed_on()
                    return
        yield self._handed_on()

    def _handed_on(self) -> list[Record]:
        records, self.records = self.records, []
        return records

    def _span(self, segment: Segment, start: float, end: float, size: float) -> Iterator[None]:
        """Equal steps from one time to another."""
        count = max(1, math.ceil((end - start) / size * (1 - 1e-9)))
        for index in range(count):
            until = start + (end - start) * (index + 1) / count
            self._advance(segment, until)
            if self.stopped:
                return
            yield

    def _advance(self, segment: Segment, until: float) -> None:
        h = until - self.time
        moved = segment.displacement(self.time, until)
        target = moved[0] / h, (moved[1] - self.gap) / h
        touching = self.gap <= CLOSED * self.radius
        step = Step(h, self.rod_angle, self.twist, target, touching)
        trials = self.contact.trials(self.increment, step)
        previous = self.mode
        chosen = self._chosen(trials)
        if chosen is None:
            self.mode, self.solutions, self.force = None, 0, (0.0, 0.0)
            self.stopped = "no contact mode is consistent"
            return
        changes = chosen.mode is not previous or len(trials) != self.solutions
        self.mode, self.solutions = chosen.mode, len(trials)
        self.force = chosen.impulse[0] / h, chosen.impulse[1] / h
        if not self.problem.has_inertia:
            self.twist = chosen.twist
        if changes:
            self._log()
        self.energies.account(chosen, self.twist, moved, h)
        self._move(chosen, moved, h)
        self.time = until
        if self.length > 0 and self.gap + self.length * self.radius * math.sin(self.rod_angle) <= 0:
            self.stopped = Cause.LIES.value

    def _chosen(self, trials: list[Trial]) -> Trial | None:
        """The trial that the policy takes; of several in one mode that of the least impulse."""
        order = preference(self.problem.on_ambiguity, self.mode)
        key = lambda trial: (order.index(trial.mode), math.hypot(*trial.impulse))  # noqa: E731
        return min(trials, key=key, default=None)

    def _move(self, trial: Trial, moved: Vector, h: float) -> None:
        """Take the slider and the fence to the end of the step."""
        angle, reach = self.rod_angle, self.length * self.radius
        turned = angle + h * trial.twist[2] / self.radius
        if trial.mode is ContactMode.SEPARATE:
            x = h * trial.twist[0] - reach * (math.cos(turned) - math.cos(angle))
            y = h * trial.twist[1] - reach * (math.sin(turned) - math.sin(angle))
        else:
            x, y = (h * u for u in contact_motion(trial.twist, self.length, angle))
            y = moved[1] - self.gap
            self.slip += x - moved[0] if trial.mode is not ContactMode.STICK else 0.0
            x = moved[0] if trial.mode is ContactMode.STICK else x
        self.along += x - moved[0]
        self.gap += y - moved[1]
        self.fence = self.fence[0] + moved[0], self.fence[1] + moved[1]
        self.rod_angle, self.twist = turned, trial.twist

    def _log(self) -> None:
        """Record where the run is; the last record of an instant replaces those before."""
        psi, reach = self.rod_angle, self.length * self.radius
        contact = self.fence[0] + self.along, self.fence[1] + self.gap
        speed, spin = math.hypot(*self.twist[:2]), self.twist[2]
        if self.records and self.records[-1].time == self.time:
            self.records.pop()
        self.records.append(
            Record(
                time=self.time,
                position=(contact[0] + reach * math.cos(psi), contact[1] + reach * math.sin(psi)),
                rod_angle=psi,
                twist=self.twist,
                fence=self.fence,
                slip=self.slip,
                gap=self.gap,
                force=self.force,
                mode=NO_MODE if self.mode is None else int(self.mode),
                solutions=self.solutions,
                spin_ratio=_ratio(spin, speed),
                dissipated=tuple(self.energies.dissipated),
                contact_dissipated=self.energies.lost,
                work=self.energies.work,
                kinetic_energy=self.energies.kinetic(self.twist),
                evaluations=self.energies.evaluations(self.increment.evaluations),
                stopped=self.stopped,
            )
        )


def _marks(segment: Segment, wanted: Sequence[float]) -> list[float]:
    """Ends of a segment and the times wanted between them, without those that rounding doubles."""
    least = APART * segment.end
    marks = [segment.start]
    for time in wanted:
        if marks[-1] + least < time < segment.end - least:
            marks.append(time)
    return [*marks, segment.end]


def _ratio(spin: float, speed: float) -> float:
    if spin == 0.0:
        return 0.0
    return spin / speed if speed > 0.0 else math.copysign(math.inf, spin)
