"""A run of several contacts from event to event.

The modes of the contacts stay as they are, and the pose is integrated by a pair of Runge-Kutta formulas of
orders 5 and 4 (Dormand and Prince, Journal of Computational and Applied Mathematics 6, 1980). A mode ends
where the modes are not among the consistent ones: the step is halved until it is negligible. After each
step the gaps of closed contacts are removed.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from scipy.integrate import RK45

from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.simulation.fields import Stop
from planar_pushing.simulation.several.instants import Motion
from planar_pushing.simulation.several.movers import Pose, Touch
from planar_pushing.simulation.several.run import TOUCHES, EndOfModeError, SeveralRun
from planar_pushing.terms.numbers import Array

#: Largest overlap of a contact that arrives, in sizes of the outline.
SHALLOW = 1e-6
#: Shortest step in durations, and the time by which a run goes on beyond the end of a mode.
SHORTEST, BEYOND_END = 1e-12, 1e-9
#: Maximum number of events, and of those without any time between them.
MOST_EVENTS, MOST_AT_ONCE = 10000, 25


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


class EventRun(SeveralRun):
    """A run from event to event; the parameters are those of `SeveralRun`."""

    def close_contacts(self) -> None:
        """Remove gaps and overlaps of places that the object touches, within twice the tolerance."""
        near = self.near_touches(self.pose, self.time, 2.0 * TOUCHES * self.shape.size)
        self.pose = self.without_gaps(self.pose, self.time, near)

    def advance(self, times: Sequence[float], rtol: float) -> None:
        """Integrate from event to event, and log the times and the events."""
        end, events, at_once = times[-1], 0, 0
        while True:
            touches = self.closed_touches(self.pose, self.time)
            choice = self.choose(touches)
            if choice is None:
                self.end()
                return
            motion, solutions = choice
            self.write(touches, motion, solutions)
            if self.time >= end:
                return
            began = self.time
            self._follow(touches, motion, solutions, times, rtol)
            events += 1
            at_once = at_once + 1 if self.time - began <= 1e-8 * end else 0
            if self.stopped or events > MOST_EVENTS or at_once > MOST_AT_ONCE:
                self.stop = self.stop or Stop.EVENTS
                self.end()
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
        closed = [k for k, mode in enumerate(motion.modes) if mode != ContactMode.SEPARATE]
        active = [touches[k] for k in closed]
        modes = tuple(motion.modes[k] for k in closed)
        bound = min([time for time in self.breaks if time > self.time], default=times[-1])
        bound = min(bound, times[-1])
        shortest, size = SHORTEST * times[-1], times[-1] / 50.0
        ending = False
        last = motion._replace(modes=modes, forces=tuple(motion.forces[k] for k in closed))
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
                    self._pass_end(active, last, bound, BEYOND_END * times[-1])
                    return
                continue
            if taken.error > rtol:
                size = step * max(0.2, 0.9 * (rtol / taken.error) ** 0.2)
                continue
            until = bound if step == bound - self.time else self.time + step
            begin, sums = self.time, self.sums
            for time in (time for time in times if begin < time < until):
                part = (time - begin) / step
                self.time, self.pose = time, self.without_gaps(taken.pose_at(part), time, active)
                self.sums = sums + taken.sums_at(part)
                inner, places = self._motion_at(self.pose, time, active, modes, last)
                self.write(places, inner, solutions)
            self.time, self.sums = until, sums + taken.sums_at(1.0)
            self.pose = self.without_gaps(taken.pose_at(1.0), until, active)
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
            rates[k, 3:] = self.rates(touches, motion, pose)
        x, y, turn = step * (RK45.E @ rates[:, :3])
        error = max(math.hypot(x, y) / self.shape.size, abs(turn))
        return Step(start, step, rates, error)

    def _motion_at(
        self, pose: Pose, time: float, active: list[Touch], modes: tuple[int, ...], last: Motion
    ) -> tuple[Motion, list[Touch]]:
        """The motion with given modes that is nearest to the last one, and the touches there."""
        touches = [self.touch_again(touch, pose, time) for touch in active]
        found = self.instants.motions(touches, pose.angle - self.start.angle)
        same = [motion for motion in found if motion.modes == modes]
        if not same:
            raise EndOfModeError
        return min(same, key=lambda motion: math.dist(motion.twist, last.twist)), touches

    def _overlaps(self, pose: Pose, time: float, active: list[Touch]) -> bool:
        """Whether the object overlaps a mover at another place than its contacts."""
        slack = TOUCHES * self.shape.size / 10.0
        touches = self.near_touches(pose, time, -slack)
        if not touches:
            return False
        known = [self.touch_again(touch, pose, time) for touch in active]
        return any(touch not in known for touch in touches)

    def _pass_end(self, active: list[Touch], last: Motion, bound: float, step: float) -> None:
        """Go a little beyond the end of a mode, so that the modes after it are consistent."""
        until = min(self.time + step, bound)
        self.sums = self.sums + (until - self.time) * self.rates(active, last, self.pose)
        self.pose = self.pose.after(last.twist, until - self.time)
        self.time = until
        try:
            known = [self.touch_again(touch, self.pose, self.time) for touch in active]
            near = self.near_touches(self.pose, self.time, 0.0)
            shallow = [touch for touch in near if touch.gap > -SHALLOW * self.shape.size]
            arrived = [touch for touch in shallow if touch not in known]
            self.pose = self.without_gaps(self.pose, self.time, known + arrived)
        except EndOfModeError:
            return
