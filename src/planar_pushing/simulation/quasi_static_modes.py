"""The modes of a quasi-static slider: at rest, sticking to the fence, slipping over it.

Each yields a `Flow`: rotation, motion of the contact over the fence, and force.
"""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from typing import TYPE_CHECKING, NamedTuple

from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.simulation.mode import Cause, Entry, Guard, State
from planar_pushing.simulation.setting import Vector

if TYPE_CHECKING:
    from planar_pushing.simulation.quasi_static import QuasiStatic

#: The fence pushes a slider at rest from this part of its typical speed on.
PUSHES = 2e-10


class Flow(NamedTuple):
    """R omega, speed of the centre, velocity of the contact relative to the fence, force."""

    spin: float = 0.0
    speed: float = 0.0
    slip: float = 0.0
    rise: float = 0.0
    force_x: float = 0.0
    force_y: float = 0.0


class QuasiStaticMode(ABC):
    """A mode whose force and rates follow from its flow."""

    kind: ContactMode
    system: QuasiStatic

    @abstractmethod
    def flow(self, time: float, state: State) -> Flow:
        """The motion at an instant, and the force that it takes."""

    @abstractmethod
    def guards(self, time: float, state: State) -> tuple[Guard, ...]: ...

    def force(self, time: float, state: State) -> Vector:
        flow = self.flow(time, state)
        return flow.force_x, flow.force_y

    def rates(self, time: float, state: State) -> State:
        return self.system.rates(time, self.flow(time, state))


class Rest(QuasiStaticMode):
    """No force and no motion; the fence is clear of the slider, or does not push it."""

    kind = ContactMode.SEPARATE

    def __init__(self, system: QuasiStatic, touching: bool) -> None:
        self.system, self.touching = system, touching

    def flow(self, time: float, state: State) -> Flow:
        fence_x, fence_y = self.system.segment.velocity(time)
        return Flow(slip=-fence_x, rise=-fence_y)

    def guards(self, time: float, state: State) -> tuple[Guard, ...]:
        system = self.system
        if not self.touching:
            return (Guard(Cause.TOUCHES, state[Entry.GAP] / system.setting.radius),)
        fence = system.segment.velocity(time)
        pushes = Guard(Cause.STARTS, PUSHES - fence[1] / system.speed)
        if system.segment.constant:
            return (pushes,)
        return pushes, Guard(Cause.CHOICE, 1.0 if fence != (0.0, 0.0) else -1.0, True)


class Stick(QuasiStaticMode):
    """The contact moves with the fence, the force lies in the friction cone."""

    kind = ContactMode.STICK

    def __init__(self, system: QuasiStatic) -> None:
        length = system.setting.length
        self.system = system
        # The share of a nearly translating ring.
        self.share = 2 * length**2 / (1 + 2 * length**2)

    def flow(self, time: float, state: State) -> Flow:
        system, psi = self.system, state[Entry.ANGLE]
        fence_x, fence_y = system.segment.velocity(time)
        e_x, e_y = math.cos(psi), math.sin(psi)
        pace = math.hypot(fence_x, fence_y)
        if pace == 0.0:
            return Flow()
        w_x, w_y = fence_x / pace, fence_y / pace
        along, aside = w_x * e_x + w_y * e_y, w_x * e_y - w_y * e_x
        motion = system.support.stick(along, aside, system.setting.length, self.share)
        self.share, spin, force_along, force_aside = motion
        return Flow(
            spin=pace * spin,
            speed=pace * math.hypot(along, (1.0 - self.share) * aside),
            force_x=force_along * e_x + force_aside * e_y,
            force_y=force_along * e_y - force_aside * e_x,
        )

    def guards(self, time: float, state: State) -> tuple[Guard, ...]:
        system, flow = self.system, self.flow(time, state)
        rests = flow.force_x == 0.0 and flow.force_y == 0.0
        inside = -1.0 if rests else system.setting.holds(flow.force_x, flow.force_y, 0.0)
        return Guard(Cause.LEAVES_CONE, inside), *system.common_guards(time, state, flow)


class Slip(QuasiStaticMode):
    """The contact moves over the fence, under a force on the opposite edge of the friction cone."""

    def __init__(self, system: QuasiStatic, kind: ContactMode) -> None:
        self.system, self.kind = system, kind
        self.side = 1.0 if kind is ContactMode.SLIP_RIGHT else -1.0
        self.toward = system.setting.edges[kind]
        self.guess, self.advance = 0.5, 0.0

    def flow(self, time: float, state: State) -> Flow:
        system, psi = self.system, state[Entry.ANGLE]
        fence_x, fence_y = system.segment.velocity(time)
        e_x, e_y = math.cos(psi), math.sin(psi)
        t_x, t_y = self.toward
        arm = system.setting.length * (e_y * t_x - e_x * t_y)
        speed, spin = system.support.spin_ratio(arm, self.guess)
        self.guess = speed if abs(arm) > 1.0 else abs(spin)
        lever = system.setting.length * spin
        self.advance = speed * t_y - lever * e_x
        scale = fence_y / self.advance if self.advance else 0.0
        force = system.support.at(speed, spin)[0]
        return Flow(
            spin=scale * spin,
            speed=scale * speed,
            slip=scale * (speed * t_x + lever * e_y) - fence_x,
            force_x=force * t_x,
            force_y=force * t_y,
        )

    def guards(self, time: float, state: State) -> tuple[Guard, ...]:
        system, flow = self.system, self.flow(time, state)
        fence_x, fence_y = system.segment.velocity(time)
        pace = math.hypot(fence_x, fence_y)
        if pace == 0.0:
            return (
                Guard(Cause.SLIP_ENDS, -1.0),
                Guard(Cause.FORCE_ENDS, -1.0),
                *system.common_guards(time, state, flow),
            )
        slips = self.side * flow.slip / (pace + abs(flow.slip))
        # A fence that keeps moving along itself moves nothing by slip.
        lifts = fence_y != 0.0 or not system.segment.constant
        moves = self.advance / (1.0 + system.setting.length) * fence_y / pace if lifts else -1.0
        return (
            Guard(Cause.SLIP_ENDS, slips),
            Guard(Cause.FORCE_ENDS, moves),
            *system.common_guards(time, state, flow),
        )
