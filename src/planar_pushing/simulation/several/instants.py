"""Every consistent motion of an object at an instant, for the places where movers touch it."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from planar_pushing.core.contacts.several_frames import MOST_OF_SEVERAL, SeveralRow
from planar_pushing.core.contacts.several_solutions import (
    SEVERAL_SOLUTION,
    SeveralResults,
    SeveralSolution,
)
from planar_pushing.core.supports.rows import LOAD, LoadRow
from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.mechanics.kernels.calls import run
from planar_pushing.mechanics.kernels.columns import row_of
from planar_pushing.mechanics.rows import EffectColumns, data_of, in_units, strengths_of
from planar_pushing.mechanics.scene import Scene
from planar_pushing.simulation.several.movers import Mover, Touch, Vector, Vector3
from planar_pushing.terms.options import Policy, Reason

WIDTH = SeveralResults.size + MOST_OF_SEVERAL * SEVERAL_SOLUTION
PLACES = SeveralSolution.places
MODES, TWIST = PLACES["modes"], PLACES["twist"]
FORCES, ENDS = PLACES["low_forces"], PLACES["high_forces"]
INFINITE = PLACES["low_infinite"], PLACES["high_infinite"]
#: Ranks of the modes by policy: the lowest is preferred.
RANKS = {
    Policy.KEEP_CONTACT: (3, 0, 1, 2), Policy.SEPARATE: (0, 1, 2, 3),
    Policy.STICK: (3, 0, 1, 2), Policy.SLIP_RIGHT: (3, 1, 0, 2), Policy.SLIP_LEFT: (3, 1, 2, 0),
    Policy.STAY_IN_MODE: (3, 0, 1, 2),
}  # fmt: skip


class Motion(NamedTuple):
    """A consistent motion: modes and forces of the contacts, and the twist, in the body frame."""

    modes: tuple[int, ...]
    twist: Vector3
    forces: tuple[Vector, ...]


class Instants:
    """The motions of one object at its instants.

    Parameters
    ----------
    scene : Scene
        Its effects, with the body frame and the radius.
    movers : sequence of Mover
    policies : sequence of (start_time, policy)
        Which of several motions is chosen, by the modes of the contacts in their order.
    """

    def __init__(
        self, scene: Scene, movers: Sequence[Mover], policies: Sequence[tuple[float, Policy]]
    ) -> None:
        self.rows, self.radius = scene.rows, float(scene.slider.radius)
        self.movers, self.policies = movers, policies
        self.levers = _levers(scene)
        self.reason: Reason | None = None
        self.evaluations = 0
        self.resisting = sum(entry.resists for entry in self.rows.entries)
        # The kernel evaluates all effects of a row together, so that each has data of its own.
        self.data = [data_of([entry]) for entry in self.rows.entries]

    def motions(self, touches: Sequence[Touch], turned: float, step: float = 0.0) -> list[Motion]:
        """Every consistent motion.

        Parameters
        ----------
        touches : sequence of Touch
            At most four; their order is that of the modes.
        turned : float
            Angle by which the object has turned, with which the loads do not turn.
        step : float
            Length of a step in which a gap can close; without one, every touch is closed.
        """
        self.evaluations += 1
        size = max((math.hypot(*touch.velocity) for touch in touches), default=0.0)
        if step:
            size = max([size, *(abs(touch.gap) / step for touch in touches)])
        size = size or 1.0
        columns = self._columns(turned)
        strengths = self.rows.strengths if not turned else strengths_of(self.rows.entries, columns)
        unit, row = in_units(self.rows.entries, columns, strengths, size)
        for touch in touches:
            (n_x, n_y), (v_x, v_y) = touch.normal, touch.velocity
            if step:
                v_x, v_y = v_x - n_x * touch.gap / step, v_y - n_y * touch.gap / step
            law = self.movers[touch.mover].law
            row += row_of(
                SeveralRow,
                point=[touch.point[0] / self.radius, touch.point[1] / self.radius],
                normal=[n_x, n_y],
                velocity=[v_x / size, v_y / size],
                right=law.right, left=law.left, slips=law.slips, closed=law.closed, rough=law.rough,
            )  # fmt: skip
        numbers = run("solve_contacts", self.rows.data, [row], WIDTH)[0].tolist()
        count, _, reason = map(int, numbers[: SeveralResults.size])
        self.reason = None if count else (None, Reason.JAMMED, Reason.WEDGED)[reason]
        found = []
        for k in range(count):
            first = SeveralResults.size + SEVERAL_SOLUTION * k
            motion = self._read(numbers[first : first + SEVERAL_SOLUTION], len(touches), size, unit)
            if math.isnan(math.fsum(map(sum, motion.forces))):
                motion = motion._replace(forces=self._least_forces(touches, motion, turned))
            found.append(motion)
        return found

    def _least_forces(
        self, touches: Sequence[Touch], motion: Motion, turned: float
    ) -> tuple[Vector, ...]:
        """The smallest forces of contacts that stick, between which any force can act."""
        wrench = np.sum([force for _, force in self._wrenches(motion.twist, turned)], axis=0)
        sticks = [k for k, mode in enumerate(motion.modes) if mode == ContactMode.STICK]
        points = np.array([touches[k].point for k in sticks]) / self.radius
        rows = np.zeros((3, 2 * len(sticks)))
        rows[0, ::2] = rows[1, 1::2] = 1.0
        rows[2, ::2], rows[2, 1::2] = -points[:, 1], points[:, 0]
        forces = np.zeros((len(touches), 2))
        forces[sticks] = np.linalg.lstsq(rows, wrench, rcond=None)[0].reshape(-1, 2)
        return tuple((float(x), float(y)) for x, y in forces)

    def _wrenches(self, twist: Vector3, turned: float) -> list[tuple[EffectColumns, list[float]]]:
        """Force and torque, in units of the radius, of each effect at a twist."""
        columns, place, wrenches = self._columns(turned), 0, []
        motion = twist[0], twist[1], self.radius * twist[2]
        for entry, data in zip(self.rows.entries, self.data, strict=True):
            width = len(entry.columns)
            row = [*columns[place : place + width], *motion]
            place += width
            wrenches.append((entry, run("wrenches", data, [row], 3)[0].tolist()))
        return wrenches

    def _read(self, numbers: list[float], count: int, size: float, unit: float) -> Motion:
        """A solution in the units of the object; forces in the middle of their range, if it has ends."""
        modes = tuple(map(int, numbers[MODES][:count]))
        v_x, v_y, spin = numbers[TWIST]
        without = [numbers[place] == 1.0 for place in INFINITE]
        low, high = numbers[FORCES], numbers[ENDS]
        if without[0] or without[1]:
            middle = high if without[0] else low
            middle = [math.nan] * len(low) if all(without) else middle
        else:
            middle = [(one + other) / 2.0 for one, other in zip(low, high, strict=True)]
        forces = tuple((unit * middle[2 * i], unit * middle[2 * i + 1]) for i in range(count))
        return Motion(modes, (size * v_x, size * v_y, size * spin / self.radius), forces)

    def _columns(self, turned: float) -> Sequence[float]:
        """The columns of the effects, with loads whose forces do not turn with the object."""
        columns = list(map(float, self.rows.columns))
        if not turned or not self.levers:
            return columns
        c, s = math.cos(turned), math.sin(turned)
        for place, (p_x, p_y) in self.levers.items():
            x, y = columns[place : place + 2]
            x, y = c * x + s * y, c * y - s * x
            columns[place : place + LoadRow.size] = x, y, p_x * y - p_y * x
        return columns

    def powers(self, twist: Vector3, turned: float) -> tuple[float, list[float]]:
        """Power of the loads, and the power that each other effect dissipates."""
        load, powers = 0.0, []
        motion = twist[0], twist[1], self.radius * twist[2]
        for entry, force in self._wrenches(twist, turned):
            power = sum(f * v for f, v in zip(force, motion, strict=True))
            if entry.resists:
                powers.append(power)
            else:
                load -= power
        order = [entry.number for entry in self.rows.entries if entry.resists]
        return load, [power for _, power in sorted(zip(order, powers, strict=True))]

    def choose(
        self,
        motions: Sequence[Motion],
        touches: Sequence[Touch],
        last: Mapping[int, int],
        time: float,
    ) -> Motion | None:
        """The motion that the policy prefers; of `STAY_IN_MODE`, the one whose modes change least."""
        policy = [policy for start, policy in self.policies if start <= time][-1]
        stays = policy == Policy.STAY_IN_MODE

        def rank(motion: Motion) -> tuple[int, ...]:
            ranks = [RANKS[policy][mode] for mode in motion.modes]
            changes = sum(
                last.get(touch.mover, mode) != mode
                for touch, mode in zip(touches, motion.modes, strict=True)
            )
            return (changes if stays else 0, *ranks)

        return min(motions, key=rank, default=None)


def _levers(scene: Scene) -> dict[int, Vector]:
    """The columns at which loads begin, and the points of their forces in radii."""
    place, found = 0, {}
    for entry in scene.rows.entries:
        if entry.kind == LOAD:
            load: Any = scene.effects[entry.number]
            center = scene.mass_center
            if load.center is not None:
                center = tuple(coordinate / scene.slider.radius for coordinate in load.center)
            found[place] = (float(center[0]), float(center[1]))
        place += len(entry.columns)
    return found


def gap_rate(touch: Touch, twist: Vector3) -> float:
    """How fast a gap opens."""
    (x, y), (n_x, n_y) = touch.point, touch.normal
    v_x, v_y, omega = twist
    u_x, u_y = v_x - omega * y - touch.velocity[0], v_y + omega * x - touch.velocity[1]
    return n_x * u_x + n_y * u_y


def slip_rate(touch: Touch, twist: Vector3) -> float:
    """How fast the object slips over the mover, along the tangent."""
    (x, y), (n_x, n_y) = touch.point, touch.normal
    v_x, v_y, omega = twist
    u_x, u_y = v_x - omega * y - touch.velocity[0], v_y + omega * x - touch.velocity[1]
    return n_y * u_x - n_x * u_y
