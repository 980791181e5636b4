"""A run of an object that several movers touch, without inertia: its contacts, its log, and its sums."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from planar_pushing.core.contacts.several_frames import MOST_CONTACTS
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


class EndOfModeError(Exception):
    """The modes of the contacts are not consistent."""


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
        Slip of the object over each mover, the mean of its places, and work of each.
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


class SeveralRun:
    """A run of one object, which `EventRun` and `StepRun` advance.

    Its rows are in `log`, and `stop` says why it has ended early.

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

    @property
    def stopped(self) -> bool:
        """Whether the run has ended early."""
        return self.stop != Stop.NO

    # The contacts at an instant

    def near_touches(self, pose: Pose, time: float, reach: float) -> list[Touch]:
        """Touches of all movers that are nearer than a reach."""
        return [
            touch
            for number, mover in enumerate(self.movers)
            for touch in self.shape.touches(number, mover, pose, time, reach)
        ]

    def closed_touches(self, pose: Pose, time: float) -> list[Touch]:
        """The touches at which the object touches a mover; of those of one line, the outer two."""
        found: list[Touch] = []
        for number, mover in enumerate(self.movers):
            reach = TOUCHES * self.shape.size
            touches = self.shape.touches(number, mover, pose, time, reach)
            if len(touches) > 2 and mover.normal is not None:
                touches = [touches[0], touches[-1]]
            found += touches
        return found

    def start_from(self, time: float, pose: Pose, sums: Array, mode: int) -> None:
        """Begin later: at a time and a pose, with accumulated numbers and a mode of the first mover."""
        self.time, self.pose, self.sums, self.modes = time, pose, sums, {0: mode}

    def touch_again(self, touch: Touch, pose: Pose, time: float) -> Touch:
        """The touch of the same mover that is nearest to an earlier one."""
        near = max(NEAR * self.shape.size, 2.0 * touch.gap)
        mover = self.movers[touch.mover]
        found = self.shape.touches(touch.mover, mover, pose, time, near)

        def distance(other: Touch) -> float:
            turned = math.dist(touch.normal, other.normal) if mover.normal is None else 0.0
            return math.dist(touch.point, other.point) + turned * self.shape.size

        nearest = min(found, key=distance, default=None)
        if nearest is None or distance(nearest) > 0.3 * self.shape.size:
            raise EndOfModeError
        return nearest

    def without_gaps(self, pose: Pose, time: float, active: list[Touch]) -> Pose:
        """The nearest pose at which the contacts have no gap."""
        if not active:
            return pose
        for _ in range(2):
            touches = [self.touch_again(touch, pose, time) for touch in active]
            rows = np.array([
                [*touch.normal, (touch.point[0] * touch.normal[1] - touch.point[1] * touch.normal[0])
                 / self.shape.size]
                for touch in touches
            ])  # fmt: skip
            gaps = np.array([touch.gap for touch in touches])
            x, y, turn = np.linalg.lstsq(rows, -gaps, rcond=1e-9)[0]
            pose = pose.after((float(x), float(y), float(turn) / self.shape.size), 1.0)
        return pose

    def choose(self, touches: list[Touch], step: float = 0.0) -> tuple[Motion, int] | None:
        """The preferred motion, and how many there are; None without any, with the reason in `stop`."""
        if len(touches) > MOST_CONTACTS:
            self.stop = Stop.MANY_CONTACTS
            return None
        motions = self.instants.motions(touches, self.pose.angle - self.start.angle, step)
        motion = self.instants.choose(motions, touches, self.modes, self.time)
        if motion is None:
            self.stop = STOPS.get(self.instants.reason, Stop.INCONSISTENT)
            return None
        for touch, mode in zip(touches, motion.modes, strict=True):
            self.modes[touch.mover] = mode
        return motion, len(motions)

    def write(self, touches: Sequence[Touch], motion: Motion, solutions: int) -> None:
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

    def rates(self, touches: Sequence[Touch], motion: Motion, pose: Pose) -> Array:
        """The rates of the accumulated numbers."""
        count, rates = len(self.movers), np.zeros(len(self.sums))
        places = [0] * count
        for touch, mode, force in zip(touches, motion.modes, motion.forces, strict=True):
            if mode == ContactMode.SEPARATE:
                continue
            slip = slip_rate(touch, motion.twist) if mode != ContactMode.STICK else 0.0
            places[touch.mover] += 1
            rates[touch.mover] += (slip - rates[touch.mover]) / places[touch.mover]
            rates[count + touch.mover] += (
                force[0] * touch.velocity[0] + force[1] * touch.velocity[1]
            )
            along = force[0] * touch.normal[1] - force[1] * touch.normal[0]
            rates[2 * count] -= along * slip
            if touch.gap:
                # A gap that closes in a step, or an overlap that opens, is not part of the work.
                push = force[0] * touch.normal[0] + force[1] * touch.normal[1]
                rates[2 * count] -= push * gap_rate(touch, motion.twist)
        load, powers = self.instants.powers(motion.twist, pose.angle - self.start.angle)
        rates[2 * count + 1] = load
        rates[2 * count + 2 :] = powers
        return rates

    def end(self) -> None:
        """Log the instant at which the run ends early, at rest."""
        rest = Motion((), (0.0, 0.0, 0.0), ())
        self.write((), rest, 0)
