"""A run of several contacts in steps of order 1.

A gap that is open can close at the speed at which it is zero at the end of the step.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from contextlib import suppress

from planar_pushing.core.contacts.several_frames import MOST_CONTACTS
from planar_pushing.simulation.fields import Stop
from planar_pushing.simulation.several.instants import Motion, gap_rate
from planar_pushing.simulation.several.movers import Touch
from planar_pushing.simulation.several.run import TOUCHES, EndOfModeError, SeveralRun

#: Gaps in sizes of the outline that a step leaves as they are, so that an object at rest stays there.
ROUNDING = 1e-12


class StepRun(SeveralRun):
    """A run in steps of order 1; the parameters are those of `SeveralRun`."""

    def advance(self, times: Sequence[float], step: float) -> None:
        """Take equal steps between times, of at most a length, and log the times."""
        if not self._log_now():
            return
        breaks = [time for time in self.breaks if times[0] < time < times[-1]]
        bounds = sorted({*times, *breaks})
        logged = set(times)
        for low, high in itertools.pairwise(bounds):
            count = max(1, math.ceil((high - low) / step - 1e-9))
            for k in range(count):
                taken = self._take_step(low + (high - low) * (k + 1) / count)
                if taken is None:
                    self.end()
                    return
            if high in logged and taken is not None:
                touches, motion, solutions = taken
                self.write([self._at_end(touch) for touch in touches], motion, solutions)

    def close_contacts(self, until: float) -> None:
        """Close the gaps of the places that the object would touch in a step to a time."""
        pose, time, sums, modes = self.pose, self.time, self.sums.copy(), dict(self.modes)
        taken = self._take_step(until)
        self.pose, self.time, self.sums, self.modes, self.stop = pose, time, sums, modes, Stop.NO
        if taken is not None:
            with suppress(EndOfModeError):
                self.pose = self.without_gaps(pose, time, taken[0])

    def _log_now(self) -> bool:
        """Log the motion at the current instant; return whether there is one."""
        touches = self.closed_touches(self.pose, self.time)
        choice = self.choose(touches)
        if choice is None:
            self.end()
            return False
        self.write(touches, *choice)
        return True

    def _take_step(self, until: float) -> tuple[list[Touch], Motion, int] | None:
        """Take a step to a time; return its contacts, its motion, and how many there are, or None.

        Contacts whose gaps would be negative after the step are added one by one.
        """
        step = until - self.time
        candidates = self.near_touches(self.pose, self.time, self.shape.size)
        middle = self.time + step / 2.0
        moved = [self._at_time(touch, middle) for touch in candidates]
        slack = TOUCHES * self.shape.size
        chosen = [touch for touch in moved if touch.gap <= slack][:MOST_CONTACTS]
        chosen = self._outer(chosen)
        while True:
            choice = self.choose(chosen, step)
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
        self.sums += step * self.rates(chosen, motion, self.pose)
        self.pose = self.pose.after(motion.twist, step)
        self.time = until
        return chosen, motion, solutions

    def _at_end(self, touch: Touch) -> Touch:
        """A touch of the last step at its end, where it is still near."""
        try:
            return self.touch_again(touch, self.pose, self.time)
        except EndOfModeError:
            return touch

    def _at_time(self, touch: Touch, time: float) -> Touch:
        """A touch with the velocity of its mover at another time; a gap of rounding error is none."""
        gap = touch.gap if abs(touch.gap) > ROUNDING * self.shape.size else 0.0
        _, (v_x, v_y) = self.movers[touch.mover].at(time)
        c, s = math.cos(self.pose.angle), math.sin(self.pose.angle)
        return touch._replace(gap=gap, velocity=(c * v_x + s * v_y, c * v_y - s * v_x))

    def _outer(self, touches: list[Touch]) -> list[Touch]:
        """The touches without those of a line between two others."""
        kept: list[Touch] = []
        for number, mover in enumerate(self.movers):
            of_mover = [touch for touch in touches if touch.mover == number]
            if mover.normal is not None and len(of_mover) > 2:
                of_mover = [of_mover[0], of_mover[-1]]
            kept += of_mover
        return kept
