"""A run of an object that several movers touch, without inertia: by events, or in steps of order 1.

The motion at an instant is that of the contacts. In steps, a gap that is open can close at the speed at
which it is zero at the end of the step. From event to event, the modes of the contacts stay as they are,
and the pose is integrated by a pair of Runge-Kutta formulas of orders 5 and 4 (Dormand and Prince, Journal
of Computational and Applied Mathematics 6, 1980). A mode ends where the modes are not among the consistent
ones: the step is halved until it is negligible. After each step the gaps of closed contacts are removed.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from scipy.integrate import RK45

from planar_pushing.core.instant.several_frames import MOST_CONTACTS
from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.simulation.fields import Stop
from planar_pushing.simulation.several.instants import (
    Instants,
    Motion,
    gap_rate,
    slip_rate,
)
from planar_pushing.simulation.several.movers import Mover, Pose, Shape, Touch, Vector3
from planar_pushing.terms.numbers import Array
from planar_pushing.terms.options import Reason

#: Distance in sizes of the outline up to which an object touches a mover.
TOUCHES = 1e-9
#: Distance in sizes of the outline in which a place of a contact is looked for again.
NEAR = 1e-3
#: Reasons of an early end without a consistent motion.
STOPS: dict[Reason | None, Stop] = {Reason.JAMMED: Stop.JAMMED, Reason.WEDGED: Stop.WEDGED}
#: Shortest step in durations, and the time by which a run goes on beyond the end of a mode.
SHORTEST, BEYOND_END = 1e-12, 1e-9
#: Maximum number of events, and of those without any time between them.
MOST_EVENTS, MOST_AT_ONCE = 10000, 25


class Row(NamedTuple):
    """An instant of the log.

    Attributes
    ----------
    time, pose : float, Pose
    twist : (v_x, v_y, omega)
        In the body frame.
    touches : tuple of Touch
    modes, forces : tuples
        Of the touches; forces in the body frame.
    totals : Totals
        Accumulated.
    solutions : int
    evaluations : int
        Of the motion, accumulated.
    """

    time: float
    pose: Pose
    twist: Vector3
    touches: tuple[Touch, ...]
    modes: tuple[int, ...]
    forces: tuple[tuple[float, float], ...]
    totals: Totals
    solutions: int
    evaluations: int


class Totals(NamedTuple):
    """Accumulated numbers of a run.

    Attributes
    ----------
    slipped, work : ndarray, shape (movers,)
        Slip of the object over each mover, and work of each.
    rubbed, load_work : float
        Energy dissipated at the contacts, and work of the loads.
    dissipated : ndarray
        Energies dissipated by the effects that resist.
    """

    slipped: Array
    work: Array
    rubbed: float
    load_work: float
    dissipated: Array


class Step(NamedTuple):
    """A step of the pair of formulas, with its interpolant.

    Attributes
    ----------
    start : ndarray, shape (3,)
        The pose at the beginning.
    length, rates : float, ndarray
        Length of the step, and rates of the pose and of the accumulated numbers at its stages.
    error : float
        Of the pose, in sizes of the outline and in radians.
    """

    start: Array
    length: float
    rates: Array
    error: float

    def pose_at(self, part: float) -> Pose:
        """The pose after a part of the step."""
        return Pose(*(self.start + self._change(part)[:3]).tolist())

    def sums_at(self, part: float) -> Array:
        """Changes of the accumulated numbers in a part of the step."""
        return self._change(part)[3:]

    def _change(self, part: float) -> Array:
        powers = part ** np.arange(1, 5)
        return np.asarray(self.length * ((RK45.P @ powers) @ self.rates))


class EndOfModeError(Exception):
    """The modes of the contacts are not consistent."""


class SeveralRun:
    """A run of one object; its rows are in `log`, and `stop` says why it has ended early.

    Parameters
    ----------
    shape : Shape
    instants : Instants
    movers : sequence of Mover
    pose : Pose
        Of the body frame at time 0.
    breaks : sequence of float
        Times at which the velocity of a mover jumps.
    """

    def __init__(
        self,
        shape: Shape,
        instants: Instants,
        movers: Sequence[Mover],
        pose: Pose,
        breaks: Sequence[float] = (),
    ) -> None:
        self.shape, self.instants, self.movers = shape, instants, list(movers)
        self.pose, self.start, self.time = pose, pose, 0.0
        self.breaks = sorted(breaks)
        self.sums = np.zeros(2 * len(self.movers) + 2 + instants.resisting)
        self.modes: dict[int, int] = {}
        self.log: list[Row] = []
        self.stop = Stop.NO

    def begin_at(self, time: float, pose: Pose) -> None:
        """Begin the run at an instant, at which the object has another pose."""
        self.time, self.pose = time, pose

    @property
    def stopped(self) -> bool:
        """Whether the run has ended early."""
        return self.stop != Stop.NO

    # The contacts at an instant

    def _touches(self, pose: Pose, time: float, reach: float) -> list[Touch]:
        """Touches of all movers that are nearer than a reach."""
        return [
            touch
            for number, mover in enumerate(self.movers)
            for touch in self.shape.touches(number, mover, pose, time, reach)
        ]

    def _closed(self, pose: Pose, time: float) -> list[Touch]:
        """The touches at which the object touches a mover; of those of one line, the outer two."""
        found: list[Touch] = []
        for number, mover in enumerate(self.movers):
            reach = TOUCHES * self.shape.size
            touches = self.shape.touches(number, mover, pose, time, reach)
            if len(touches) > 2 and mover.normal is not None:
                touches = [touches[0], touches[-1]]
            found += touches
        return found

    def _choose(self, touches: list[Touch], step: float = 0.0) -> tuple[Motion, int] | None:
        """The preferred motion, and how many there are; None without any, with the reason in `stop`."""
        if len(touches) > MOST_CONTACTS:
            self.stop = Stop.MANY_CONTACTS
            return None
        motions = self.instants.motions(touches, self.pose.angle - self.start.angle, step)
        motion = self.instants.preferred(motions, touches, self.modes, self.time)
        if motion is None:
            self.stop = STOPS.get(self.instants.reason, Stop.INCONSISTENT)
            return None
        for touch, mode in zip(touches, motion.modes, strict=True):
            self.modes[touch.mover] = mode
        return motion, len(motions)

    def _write(self, touches: Sequence[Touch], motion: Motion, solutions: int) -> None:
        """Add the current instant to the log."""
        row = Row(
            self.time, self.pose, motion.twist, tuple(touches), motion.modes, motion.forces,
            self._totals(), solutions, self.instants.evaluations,
        )  # fmt: skip
        if self.log and self.log[-1].time == row.time:
            self.log.pop()
        self.log.append(row)

    def _totals(self) -> Totals:
        """The accumulated numbers."""
        count, sums = len(self.movers), self.sums.copy()
        slipped, work, rest = sums[:count], sums[count : 2 * count], sums[2 * count :]
        return Totals(slipped, work, float(rest[0]), float(rest[1]), rest[2:])

    def _rates(self, touches: Sequence[Touch], motion: Motion, pose: Pose) -> Array:
        """The rates of the accumulated numbers."""
        count, rates = len(self.movers), np.zeros(len(self.sums))
        for touch, mode, force in zip(touches, motion.modes, motion.forces, strict=True):
            if mode == ContactMode.SEPARATE:
                continue
            slip = slip_rate(touch, motion.twist) if mode != ContactMode.STICK else 0.0
            rates[touch.mover] += slip
            rates[count + touch.mover] += (
                force[0] * touch.velocity[0] + force[1] * touch.velocity[1]
            )
            along = force[0] * touch.normal[1] - force[1] * touch.normal[0]
            rates[2 * count] -= along * slip
        load, powers = self.instants.powers(motion.twist, pose.angle - self.start.angle)
        rates[2 * count + 1] = load
        rates[2 * count + 2 :] = powers
        return rates

    # Steps of order 1

    def run_steps(self, times: Sequence[float], step: float) -> None:
        """Take equal steps between times, of at most a length, and log the times."""
        if not self._log_now():
            return
        bounds = sorted({*times, *(time for time in self.breaks if time < times[-1])})
        logged = set(times)
        for low, high in itertools.pairwise(bounds):
            count = max(1, math.ceil((high - low) / step - 1e-9))
            for k in range(count):
                taken = self._take_step(low + (high - low) * (k + 1) / count)
                if taken is None:
                    self._end()
                    return
            if high in logged and taken is not None:
                self._write(*taken)

    def _log_now(self) -> bool:
        """Log the motion at the current instant; return whether there is one."""
        touches = self._closed(self.pose, self.time)
        choice = self._choose(touches)
        if choice is None:
            self._end()
            return False
        self._write(touches, *choice)
        return True

    def _end(self) -> None:
        """Log the instant at which the run ends early, at rest."""
        rest = Motion((), (0.0, 0.0, 0.0), ())
        self._write((), rest, 0)

    def _take_step(self, until: float) -> tuple[list[Touch], Motion, int] | None:
        """Take a step to a time; return its contacts, its motion, and how many there are, or None.

        Contacts whose gaps would be negative after the step are added one by one.
        """
        step = until - self.time
        candidates = self._touches(self.pose, self.time, self.shape.size)
        middle = self.time + step / 2.0
        moved = [self._at_time(touch, middle) for touch in candidates]
        slack = TOUCHES * self.shape.size
        chosen = [touch for touch in moved if touch.gap <= slack][:MOST_CONTACTS]
        chosen = self._outer(chosen)
        while True:
            choice = self._choose(chosen, step)
            if choice is None:
                return None
            motion, solutions = choice
            deepest, worst = -slack, None
            for touch in moved:
                gap = touch.gap + step * gap_rate(touch, motion.twist)
                if gap < deepest and touch not in chosen:
                    deepest, worst = gap, touch
            if worst is None or len(chosen) == MOST_CONTACTS:
                break
            chosen = sorted([*chosen, worst], key=moved.index)
        self.sums += step * self._rates(chosen, motion, self.pose)
        self.pose = self.pose.moved_by(motion.twist, step)
        self.time = until
        return chosen, motion, solutions

    def _at_time(self, touch: Touch, time: float) -> Touch:
        """A touch with the velocity of its mover at another time."""
        _, (v_x, v_y) = self.movers[touch.mover].at(time)
        c, s = math.cos(self.pose.angle), math.sin(self.pose.angle)
        return touch._replace(velocity=(c * v_x + s * v_y, c * v_y - s * v_x))

    def _outer(self, touches: list[Touch]) -> list[Touch]:
        """The touches without those of a line between two others."""
        kept: list[Touch] = []
        for number, mover in enumerate(self.movers):
            of_mover = [touch for touch in touches if touch.mover == number]
            if mover.normal is not None and len(of_mover) > 2:
                of_mover = [of_mover[0], of_mover[-1]]
            kept += of_mover
        return kept

    # From event to event

    def run_events(self, times: Sequence[float], rtol: float) -> None:
        """Integrate from event to event, and log the times and the events."""
        end, events, at_once = times[-1], 0, 0
        while True:
            touches = self._closed(self.pose, self.time)
            choice = self._choose(touches)
            if choice is None:
                self._end()
                return
            motion, solutions = choice
            self._write(touches, motion, solutions)
            if self.time >= end:
                return
            began = self.time
            self._follow(touches, motion, solutions, times, rtol)
            events += 1
            at_once = at_once + 1 if self.time - began <= 1e-8 * end else 0
            if self.stopped or events > MOST_EVENTS or at_once > MOST_AT_ONCE:
                self.stop = self.stop or Stop.EVENTS
                self._end()
                return

    def _follow(
        self,
        touches: list[Touch],
        motion: Motion,
        solutions: int,
        times: Sequence[float],
        rtol: float,
    ) -> None:
        """Follow a motion until a contact arrives, its modes end, or a mover's velocity jumps."""
        active = [
            touch
            for touch, mode in zip(touches, motion.modes, strict=True)
            if mode != ContactMode.SEPARATE
        ]
        modes = tuple(mode for mode in motion.modes if mode != ContactMode.SEPARATE)
        bound = min([time for time in self.breaks if time > self.time], default=times[-1])
        bound = min(bound, times[-1])
        shortest, size = SHORTEST * times[-1], times[-1] / 50.0
        ending, last = False, motion
        while self.time < bound:
            step = min(size, bound - self.time)
            try:
                taken = self._integrate(active, modes, last, step)
                arrives = taken.error <= rtol and self._overlaps(
                    taken.pose_at(1.0), self.time + step, active
                )
            except EndOfModeError:
                taken, arrives = None, True
            if taken is None or arrives:
                ending, size = True, step / 2.0
                if size < shortest:
                    self._pass_end(active, last)
                    return
                continue
            if taken.error > rtol:
                size = step * max(0.2, 0.9 * (rtol / taken.error) ** 0.2)
                continue
            until = bound if step == bound - self.time else self.time + step
            begin, sums = self.time, self.sums
            for time in (time for time in times if begin < time < until):
                part = (time - begin) / step
                self.time, self.pose = time, self._without_gaps(taken.pose_at(part), time, active)
                self.sums = sums + taken.sums_at(part)
                inner, places = self._motion_at(self.pose, time, active, modes, last)
                self._write(places, inner, solutions)
            self.time, self.sums = until, sums + taken.sums_at(1.0)
            self.pose = self._without_gaps(taken.pose_at(1.0), until, active)
            last, active = self._motion_at(self.pose, until, active, modes, last)
            if not ending:
                size = step * min(5.0, 0.9 * (rtol / max(taken.error, 1e-3 * rtol)) ** 0.2)

    def _integrate(
        self, active: list[Touch], modes: tuple[int, ...], last: Motion, step: float
    ) -> Step:
        """A step of the pose and of the accumulated numbers."""
        rates, motion, start = np.zeros((7, 3 + len(self.sums))), last, np.array(self.pose)
        for k in range(7):
            weights, node = (RK45.A[k][:k], RK45.C[k]) if k < 6 else (RK45.B, 1.0)
            change = weights @ rates[: len(weights), :3] if k else np.zeros(3)
            pose = Pose(*(start + step * change).tolist())
            time = self.time + float(node) * step
            motion, touches = self._motion_at(pose, time, active, modes, motion)
            c, s = math.cos(pose.angle), math.sin(pose.angle)
            v_x, v_y, omega = motion.twist
            rates[k, :3] = c * v_x - s * v_y, s * v_x + c * v_y, omega
            rates[k, 3:] = self._rates(touches, motion, pose)
        x, y, turn = step * (RK45.E @ rates[:, :3])
        error = max(math.hypot(x, y) / self.shape.size, abs(turn))
        return Step(start, step, rates, error)

    def _motion_at(
        self, pose: Pose, time: float, active: list[Touch], modes: tuple[int, ...], last: Motion
    ) -> tuple[Motion, list[Touch]]:
        """The motion with given modes that is nearest to the last one, and the touches there."""
        touches = [self._again(touch, pose, time) for touch in active]
        found = self.instants.motions(touches, pose.angle - self.start.angle)
        same = [motion for motion in found if motion.modes == modes]
        if not same:
            raise EndOfModeError
        return min(same, key=lambda motion: math.dist(motion.twist, last.twist)), touches

    def _again(self, touch: Touch, pose: Pose, time: float) -> Touch:
        """The touch of the same mover that is nearest to an earlier one."""
        near = NEAR * self.shape.size
        mover = self.movers[touch.mover]
        found = self.shape.touches(touch.mover, mover, pose, time, near)

        def distance(other: Touch) -> float:
            turned = math.dist(touch.normal, other.normal) if mover.normal is None else 0.0
            return math.dist(touch.point, other.point) + turned * self.shape.size

        nearest = min(found, key=distance, default=None)
        if nearest is None or distance(nearest) > 0.3 * self.shape.size:
            raise EndOfModeError
        return nearest

    def _overlaps(self, pose: Pose, time: float, active: list[Touch]) -> bool:
        """Whether the object overlaps a mover at another place than its contacts."""
        slack = TOUCHES * self.shape.size / 10.0
        touches = self._touches(pose, time, -slack)
        if not touches:
            return False
        known = [self._again(touch, pose, time) for touch in active]
        return any(touch not in known for touch in touches)

    def _without_gaps(self, pose: Pose, time: float, active: list[Touch]) -> Pose:
        """The nearest pose at which the contacts have no gap."""
        if not active:
            return pose
        for _ in range(2):
            touches = [self._again(touch, pose, time) for touch in active]
            rows = np.array([
                [*touch.normal, (touch.point[0] * touch.normal[1] - touch.point[1] * touch.normal[0])
                 / self.shape.size]
                for touch in touches
            ])  # fmt: skip
            gaps = np.array([touch.gap for touch in touches])
            x, y, turn = np.linalg.lstsq(rows, -gaps, rcond=1e-9)[0]
            pose = pose.moved_by((float(x), float(y), float(turn) / self.shape.size), 1.0)
        return pose

    def _pass_end(self, active: list[Touch], last: Motion) -> None:
        """Go a little beyond the end of a mode, so that the modes after it are consistent."""
        step = BEYOND_END * max(self.time, 1e-3)
        self.pose, self.time = self.pose.moved_by(last.twist, step), self.time + step
        try:
            self.pose = self._without_gaps(self.pose, self.time, active)
        except EndOfModeError:
            return
