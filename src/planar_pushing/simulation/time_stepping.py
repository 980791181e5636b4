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
from planar_pushing.mechanics.response import of_degree
from planar_pushing.simulation.incremental import (
    REST,
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
from planar_pushing.simulation.support import Support

#: Steps of a run whose step is not given.
STEPS = 1000
#: Records handed on at once.
BATCH = 256
#: A gap that is this small in radii is closed.
CLOSED = 1e-12


def integrate(problem: Problem, times: Sequence[float], step: float | None = None) -> Records:
    """Simulate a problem by steps of equal length between the times to be recorded.

    Parameters
    ----------
    problem : Problem
        Its tolerance has no part in this method.
    times : sequence of float
        Increasing, within the duration. The records hold these times and every change of mode.
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
        friction = of_degree(scene.scaled_effects, 1)
        self.friction = [i for i, e in enumerate(scene.effects) if e.degree == 1]
        self.support = Support(friction)
        self.inertia = _inertia(problem)
        self.increment: Increment = (
            InertialIncrement(self.support if friction else None, self.inertia, self.length)
            if self.inertia
            else QuasiStaticIncrement(self.support, self.length)
        )
        self.contact = Contact(scene.contact, self.length)
        self.time, self.along, self.gap, self.slip = 0.0, 0.0, problem.gap, 0.0
        self.fence, self.rod_angle = (0.0, -problem.gap), slider.rod_angle
        v_x, v_y, omega = problem.twist
        self.twist: Twist = (v_x, v_y, self.radius * omega)
        self.mode: ContactMode | None = None
        self.solutions, self.force, self.stopped = 0, (0.0, 0.0), ""
        self.work, self.lost, self.dissipated = 0.0, 0.0, [0.0] * len(scene.effects)
        self.records: list[Record] = []

    def run(self, times: Sequence[float], size: float) -> Records:
        """Lists of records, in order of time."""
        wanted = sorted({*map(float, times), 0.0, float(self.problem.duration)})
        for segment in self.problem.pusher.segments(self.problem.duration):
            inner = [time for time in wanted if segment.start < time < segment.end]
            for start, end in itertools.pairwise([segment.start, *inner, segment.end]):
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
        first = previous is None
        self.mode, self.solutions = chosen.mode, len(trials)
        self.force = chosen.impulse[0] / h, chosen.impulse[1] / h
        if first and not self.problem.has_inertia:
            self.twist = chosen.twist
        if chosen.mode is not previous:
            self._log()
        self._account(chosen, (moved[0] / h, moved[1] / h), h)
        self._move(chosen, moved, h)
        self.time = until
        if self.length > 0 and self.gap + self.length * self.radius * math.sin(self.rod_angle) <= 0:
            self.stopped = Cause.LIES.value

    def _chosen(self, trials: list[Trial]) -> Trial | None:
        """The trial that the policy takes; of several in one mode that of the least impulse."""
        order = preference(self.problem.on_ambiguity, self.mode)
        key = lambda trial: (order.index(trial.mode), math.hypot(*trial.impulse))  # noqa: E731
        return min(trials, key=key, default=None)

    def _account(self, trial: Trial, fence: Vector, h: float) -> None:
        """Work of the fence, and the energies that it becomes."""
        work = trial.impulse[0] * fence[0] + trial.impulse[1] * fence[1]
        gained = self._kinetic(trial.twist) - self._kinetic(self.twist) if self.inertia else 0.0
        v_x, v_y, spin = trial.twist
        powers = [0.0] * len(self.friction)
        if trial.twist != REST and self.friction:
            powers = list(self.support.powers(math.hypot(v_x, v_y), spin))
        self.work += work
        rest = work - gained - h * sum(powers)
        flight = trial.impulse == (0.0, 0.0) and sum(powers) > 0.0
        share = 1.0 + rest / (h * sum(powers)) if flight else 1.0
        for index, power in zip(self.friction, powers, strict=True):
            self.dissipated[index] += share * h * power
        self.lost += 0.0 if flight else rest

    def _kinetic(self, twist: Twist) -> float:
        assert self.inertia is not None
        mass, moment = self.inertia
        return (mass * (twist[0] ** 2 + twist[1] ** 2) + moment * twist[2] ** 2) / 2

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
                dissipated=tuple(self.dissipated),
                contact_dissipated=self.lost,
                work=self.work,
                kinetic_energy=self._kinetic(self.twist) if self.inertia else 0.0,
                evaluations=self._evaluations(),
                stopped=self.stopped,
            )
        )

    def _evaluations(self) -> tuple[int, ...]:
        made = self.increment.evaluations if isinstance(self.increment, InertialIncrement) else 0
        effects = range(len(self.dissipated))
        return tuple(self.support.evaluations if i in self.friction else made for i in effects)


def _ratio(spin: float, speed: float) -> float:
    if spin == 0.0:
        return 0.0
    return spin / speed if speed > 0.0 else math.copysign(math.inf, spin)


def _inertia(problem: Problem) -> tuple[float, float] | None:
    """Mass, and moment of inertia over the radius squared, of all effects of degree 2."""
    effects = of_degree(problem.scene.scaled_effects, 2)
    if not effects:
        return None
    profiles = [effect.profile(1.0) for effect in effects]
    mass, moment = (math.fsum(float(part) for part in parts) for parts in zip(*profiles, strict=True))
    return mass, moment
