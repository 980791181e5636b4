"""Equations of motion over time in a contact mode, and those of sliders with inertia.

Vectors are in the frame of the fence, whose normal is y, unless a name ends in `rod`. Numbers are
midpoints of balls: the equations are solved to the working precision, and their errors are not enclosed.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import NamedTuple, TypeVar

from flint import arb, fmpq

from pulling_by_pushing.oracle.balls import Position, Vector, cross, dot, sign
from pulling_by_pushing.oracle.body import Body, Matrix, Row
from pulling_by_pushing.oracle.modes import Mode

#: Sense of the slip along the fence.
SENSE = {Mode.SLIP_RIGHT: 1, Mode.SLIP_LEFT: -1}
#: Events, as numbered in a log.
LEAVES_CONE, SLIP_ENDS, FORCE_ENDS, TOUCHES, STOPS, KINK = 0, 1, 2, 3, 8, 10
NO_FOOT = -1
ZERO_VECTOR: Vector = (arb(0), arb(0))
#: A slower rotation, over the speed of the contact, is evaluated as a change of a translation.
STRAIGHT = arb(2) ** -60
#: Numbers that are positive while a phase lasts, each with the event that ends it.
Margins = tuple[tuple[int, arb], ...]
Numbers = TypeVar("Numbers", bound=tuple[arb, ...])


class State(NamedTuple):
    """Rod angle; place of the contact on the fence, and gap, with their rates; rotation; sums; time.

    The sums are the slip, which is the path along the fence while the contact is closed, the work of the
    fence, and what support and contact dissipate. With friction alone the rates and the rotation follow
    from the angle, and those of the state are zero.
    """

    angle: arb
    along: arb
    gap: arb
    along_rate: arb
    gap_rate: arb
    spin: arb
    slip: arb
    work: arb
    support_loss: arb
    contact_loss: arb
    time: arb


class Phase(NamedTuple):
    """A contact mode on a fence of constant velocity, and the foot about which the slider pivots.

    `side` is 1 if the motion center of a sticking ring is outside the ring, and -1 if it is inside.
    """

    fence: Vector
    mode: Mode
    foot: int = NO_FOOT
    side: int = 0


class PhaseMotion(NamedTuple):
    """Contact's velocity; force; rotation; power of friction; margins; rates of the state's rates."""

    contact: Vector
    force: Vector
    spin: arb
    power: arb
    margins: Margins = ()
    changes: tuple[arb, arb, arb] = (arb(0),) * 3


def turn(vector: Sequence[arb], angle: arb) -> Vector:
    """Rotate a vector counterclockwise by an angle in radians."""
    sine, cosine = angle.sin_cos()
    x, y = vector
    return (cosine * x - sine * y).mid(), (sine * x + cosine * y).mid()


def line(start: Numbers, direction: Sequence[arb], size: arb | int) -> Numbers:
    """Midpoints of ``start + size direction``."""
    terms = ((a + size * b).mid() for a, b in zip(start, direction, strict=True))
    return tuple(terms)  # type: ignore[return-value]


@dataclass(frozen=True, eq=False, kw_only=True)
class Slider(ABC):
    """A slider on a fence.

    Attributes
    ----------
    length : fmpq
        Length of the rod.
    edges : tuple
        Right and left edge of the friction cone.
    body : Body or None
        Support friction.
    """

    length: fmpq
    edges: tuple[Vector, Vector]
    body: Body | None

    @abstractmethod
    def move(self, state: State, phase: Phase) -> PhaseMotion:
        """Velocities, force and margins of a state in a phase."""

    @abstractmethod
    def phases(self, state: State, fence: Vector) -> list[Phase]:
        """The consistent phases on a fence of some velocity."""

    def energy(self, angle: arb, contact: Vector, spin: arb) -> arb:
        """Kinetic energy at a rod angle, for the velocity of the contact and the rotation."""
        return arb(0)

    def rates(self, state: State, phase: Phase) -> State:
        """Derivative of the state by time."""
        motion = self.move(state, phase)
        relative = line(motion.contact, phase.fence, -1)
        work, contact_loss = dot(motion.force, phase.fence), -dot(motion.force, relative)
        slip = arb(0) if phase.mode is Mode.SEPARATE else relative[0]
        return State(
            motion.spin, *relative, *motion.changes, slip, work, motion.power, contact_loss, arb(1)
        )  # fmt: skip

    def rod(self, angle: arb) -> Vector:
        """Vector from the contact to the slider's center."""
        return turn((arb(self.length), arb(0)), angle)

    def edge(self, mode: Mode) -> Vector:
        """The edge of the friction cone on which the force of a slip lies."""
        return self.edges[mode is Mode.SLIP_RIGHT]

    def cone(self, force: Vector) -> Vector:
        """Two numbers that are positive if a force lies inside the friction cone."""
        return cross(self.edges[0], force), cross(force, self.edges[1])

    def wrench(self, q: Sequence[arb], skip: int = NO_FOOT) -> tuple[Row, Matrix]:
        """Force of friction and its torque about the contact, and their Jacobian, in the rod's frame."""
        if self.body is None:
            return [arb(0)] * 3, [[arb(0)] * 3] * 3
        if abs(q[2]) * self.body.lever < STRAIGHT * (abs(q[0]) + abs(q[1])) and skip == NO_FOOT:
            value, slopes, _ = self.body.wrench([q[0], q[1], arb(0)])
            return [a + row[2] * q[2] for a, row in zip(value, slopes, strict=True)], slopes
        value, slopes, _ = self.body.wrench(q, skip)
        return value, slopes


@dataclass(frozen=True, eq=False, kw_only=True)
class Massive(Slider):
    """A slider with a mass, with or without support friction.

    A force f at the contact accelerates it by ``f / m + (c x f) J c / I``, where the center of mass is at c
    from it; an impulse changes its velocity alike. Impacts are inelastic; friction has no part in them.

    Attributes
    ----------
    mass, moment : fmpq
        Mass, and moment of inertia about its center.
    center : tuple of fmpq
        Center of mass from the contact, in the rod's frame.
    """

    mass: fmpq
    moment: fmpq
    center: Position

    def move(self, state: State, phase: Phase) -> PhaseMotion:
        fence, mode = phase.fence, phase.mode
        u, edge = self.velocity(state, fence), self.edge(mode)
        margins: Margins = ((TOUCHES, state.gap),)
        if _rests(u, state):
            return PhaseMotion(
                ZERO_VECTOR, ZERO_VECTOR, arb(0), arb(0), margins if fence[1] > 0 else ()
            )
        friction, torque = self._friction(state, u)
        free, turn = self._free(state, friction, torque)
        force = self._force(state.angle, mode, free)
        change = line(free, self._response(state.angle, force), 1)
        if mode is Mode.STICK:
            margins = tuple((LEAVES_CONE, margin) for margin in self.cone(force))
        elif mode is not Mode.SEPARATE:
            margins = (FORCE_ENDS, dot(force, edge)), (SLIP_ENDS, SENSE[mode] * state.along_rate)
        changes = (
            arb(0) if mode is Mode.STICK else change[0],
            change[1] if mode is Mode.SEPARATE else arb(0),
            (turn + self._torque(state.angle, force) / self.moment).mid(),
        )
        power = (dot(friction, u) + torque * state.spin).mid()
        return PhaseMotion(u, force, state.spin, power, margins, changes)

    def phases(self, state: State, fence: Vector) -> list[Phase]:
        u = self.velocity(state, fence)
        if state.gap > 0 or state.gap_rate > 0 or _rests(u, state):
            return [Phase(fence, Mode.SEPARATE)]
        free, _ = self._free(state, *self._friction(state, u))
        return [Phase(fence, mode) for mode in self._modes(state.angle, state.along_rate, free)]

    def impact(self, state: State, fence: Vector, choose: Callable[[list[Mode]], Mode]) -> State:
        """The state after an inelastic impact on the fence, in the mode that `choose` selects."""
        before = state.along_rate, state.gap_rate
        mode = choose(self._modes(state.angle, arb(0), before))
        p = self._force(state.angle, mode, before)
        slip_rate, gap_rate = line(before, self._response(state.angle, p), 1)
        slip_rate = arb(0) if mode is Mode.STICK else slip_rate
        gap_rate = gap_rate if mode is Mode.SEPARATE else arb(0)
        loss = -dot(p, (before[0] + slip_rate, before[1] + gap_rate)) / 2
        return state._replace(
            along_rate=slip_rate, gap_rate=gap_rate,
            spin=(state.spin + self._torque(state.angle, p) / self.moment).mid(),
            work=(state.work + dot(p, fence)).mid(), contact_loss=(state.contact_loss + loss).mid(),
        )  # fmt: skip

    def velocity(self, state: State, fence: Vector) -> Vector:
        """Velocity of the contact relative to the table."""
        return line(fence, (state.along_rate, state.gap_rate), 1)

    def energy(self, angle: arb, contact: Vector, spin: arb) -> arb:
        x, y = self._arm(angle)
        u, v = contact[0] - spin * y, contact[1] + spin * x
        return (self.mass * (u * u + v * v) + self.moment * spin**2) / 2

    def _modes(self, angle: arb, slip: arb, free: Vector) -> list[Mode]:
        """Consistent modes of the contact, for accelerations or for an impact.

        Parameters
        ----------
        slip : arb
            Velocity along the fence; zero, as at an impact, allows either sense.
        free : tuple of arb
            Acceleration of the contact relative to the fence without its force, or velocity before an
            impact.
        """
        modes = [Mode.SEPARATE] if sign(free[1]) >= 0 else []
        if slip == 0 and min(map(sign, self.cone(self._force(angle, Mode.STICK, free)))) > 0:
            modes.append(Mode.STICK)
        for mode, sense in SENSE.items():
            force = self._force(angle, mode, free)
            after = free[0] + self._response(angle, force)[0] if slip == 0 else slip
            if sign(after) == sense and sign(dot(force, self.edge(mode))) > 0:
                modes.append(mode)
        return modes

    def _force(self, angle: arb, mode: Mode, free: Vector) -> Vector:
        """Force of a mode, or its impulse; `free` as in `_modes`."""
        if mode is Mode.SEPARATE:
            return ZERO_VECTOR
        if mode is not Mode.STICK:
            edge = self.edge(mode)
            size = -free[1] / self._response(angle, edge)[1]
            return (size * edge[0]).mid(), (size * edge[1]).mid()
        a, b = (self._response(angle, unit) for unit in ((arb(1), arb(0)), (arb(0), arb(1))))
        return (cross(b, free) / cross(a, b)).mid(), (cross(free, a) / cross(a, b)).mid()

    def _response(self, angle: arb, force: Vector) -> Vector:
        """Acceleration of the contact by a force there."""
        (x, y), turn = self._arm(angle), self._torque(angle, force) / self.moment
        return (force[0] / self.mass + turn * y).mid(), (force[1] / self.mass - turn * x).mid()

    def _arm(self, angle: arb) -> Vector:
        """Vector from the contact to the center of mass."""
        return turn((arb(self.center[0]), arb(self.center[1])), angle)

    def _torque(self, angle: arb, force: Vector) -> arb:
        """Torque about the center of mass of a force at the contact."""
        x, y = self._arm(angle)
        return force[0] * y - force[1] * x

    def _friction(self, state: State, u: Vector) -> tuple[Vector, arb]:
        """Force that support friction requires at the contact, and torque about it."""
        x, y, torque = self.wrench([*turn(u, -state.angle), state.spin])[0]
        return turn((x, y), state.angle), torque

    def _free(self, state: State, friction: Vector, torque: arb) -> tuple[Vector, arb]:
        """Accelerations of the contact and of the rotation without a force of the fence."""
        x, y = arm = self._arm(state.angle)
        turn, spin_square = (cross(arm, friction) - torque) / self.moment, state.spin**2
        slip_change = turn * y + spin_square * x - friction[0] / self.mass
        gap_change = spin_square * y - turn * x - friction[1] / self.mass
        return (slip_change.mid(), gap_change.mid()), turn.mid()


def _rests(u: Vector, state: State) -> bool:
    return bool(u[0] == 0 and u[1] == 0 and state.spin == 0)
