"""The modes of a slider with inertia: free, at rest, sticking to the fence, slipping over it.

Each knows the contact force at an instant; the accelerations follow from it in `_rates`.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.simulation.contact_inertia import Instant
from planar_pushing.simulation.mode import Cause, Entry, Guard, State
from planar_pushing.simulation.setting import Vector

if TYPE_CHECKING:
    from planar_pushing.simulation.inertial import Inertial

#: Part of the typical force below which a force has no direction of its own.
NO_FORCE = 1e-9
#: The slider rests below this part of the typical speed; what is left is finished in closed form.
STOPPED = 2e-9
#: The fence pushes a slider at rest from this part of the typical speed on.
PUSHES = 2e-10
AT_REST = (0.0, 0.0, 0.0)


def _rates(system: Inertial, state: State, now: Instant, force: Vector, slips: bool) -> State:
    """Derivative of the state under a contact force; accelerations over the fence not yet held at 0."""
    own, at, psi = system.setting, system.at, state[Entry.ANGLE]
    slip, rise, spin = state[at], state[at + 1], state[at + 2]
    torque = own.length * (force[0] * math.sin(psi) - force[1] * math.cos(psi))
    push = now.inertia.apply(force)
    return [
        slip, rise, spin / own.radius, *now.fence,
        slip if slips else 0.0,
        -force[0] * slip - force[1] * rise,
        force[0] * now.fence[0] + force[1] * now.fence[1],
        *now.powers,
        now.free[0] + push[0], now.free[1] + push[1],
        (torque - now.resistance[2]) / own.moment,
    ]  # fmt: skip


def _common(system: Inertial, state: State, now: Instant) -> list[Guard]:
    """What every mode looks out for: the ring's centre at the fence, and rest where there is friction."""
    own, guards = system.setting, []
    if own.length > 0:
        height = state[Entry.GAP] / own.radius + own.length * math.sin(state[Entry.ANGLE])
        guards.append(Guard(Cause.LIES, height))
    if system.support is not None:
        size = math.hypot(*now.velocity) + abs(state[system.at + 2])
        guards.append(Guard(Cause.STOPS, size / system.speed - STOPPED, True))
    return guards


class Free:
    """No contact force."""

    kind = ContactMode.SEPARATE

    def __init__(self, system: Inertial) -> None:
        self.system = system

    def force(self, time: float, state: State) -> Vector:
        return 0.0, 0.0

    def rates(self, time: float, state: State) -> State:
        now = self.system.instant(time, state, AT_REST)
        return _rates(self.system, state, now, (0.0, 0.0), slips=False)

    def guards(self, time: float, state: State) -> tuple[Guard, ...]:
        now = self.system.instant(time, state, AT_REST)
        clear = Guard(Cause.TOUCHES, state[Entry.GAP] / self.system.setting.radius)
        return clear, *_common(self.system, state, now)


class Rest:
    """Friction holds the slider; the fence is clear of it or does not push it."""

    kind = ContactMode.SEPARATE

    def __init__(self, system: Inertial, touching: bool) -> None:
        self.system, self.touching = system, touching

    def force(self, time: float, state: State) -> Vector:
        return 0.0, 0.0

    def rates(self, time: float, state: State) -> State:
        system = self.system
        fence, turn = system.segment.velocity(time), system.segment.acceleration(time)
        still = [0.0] * (3 + system.count)
        return [-fence[0], -fence[1], 0.0, *fence, *still, -turn[0], -turn[1], 0.0]

    def guards(self, time: float, state: State) -> tuple[Guard, ...]:
        system = self.system
        if not self.touching:
            return (Guard(Cause.TOUCHES, state[Entry.GAP] / system.setting.radius),)
        pushes = system.segment.velocity(time)[1] / system.speed
        return (Guard(Cause.STARTS, PUSHES - pushes),)


class Stick:
    """The contact moves with the fence, under a force in the friction cone.

    Parameters
    ----------
    impending : (a_x, a_y, R alpha)
        Acceleration with which the slider starts from rest.
    """

    kind = ContactMode.STICK

    def __init__(self, system: Inertial, impending: tuple[float, ...] = AT_REST) -> None:
        self.system, self.impending = system, impending

    def force(self, time: float, state: State) -> Vector:
        return self._force(self.system.instant(time, state, self.impending))

    @staticmethod
    def _force(now: Instant) -> Vector:
        return now.inertia.solve((-now.free[0], -now.free[1]))

    def rates(self, time: float, state: State) -> State:
        now = self.system.instant(time, state, self.impending)
        rates = _rates(self.system, state, now, self._force(now), slips=True)
        rates[self.system.at] = rates[self.system.at + 1] = 0.0
        return rates

    def guards(self, time: float, state: State) -> tuple[Guard, ...]:
        system, now = self.system, self.system.instant(time, state, self.impending)
        margin = system.setting.holds(*self._force(now), NO_FORCE * system.force)
        lifts = now.free[1] * system.setting.mass / system.force
        return (
            Guard(Cause.LEAVES_CONE, margin),
            Guard(Cause.CHOICE, lifts, True),
            *_common(system, state, now),
        )


class Slide:
    """The contact moves along the fence, under a force on the opposite edge of the friction cone."""

    def __init__(
        self, system: Inertial, kind: ContactMode, impending: tuple[float, ...] = AT_REST
    ) -> None:
        self.system, self.kind, self.impending = system, kind, impending
        self.side = 1.0 if kind is ContactMode.SLIP_RIGHT else -1.0
        self.edge = system.setting.edges[kind]

    def force(self, time: float, state: State) -> Vector:
        size = self._size(self.system.instant(time, state, self.impending))
        return size * self.edge[0], size * self.edge[1]

    def _size(self, now: Instant) -> float:
        normal = now.inertia.apply(self.edge)[1]
        return -now.free[1] / normal if normal else 0.0

    def rates(self, time: float, state: State) -> State:
        now = self.system.instant(time, state, self.impending)
        size = self._size(now)
        force = size * self.edge[0], size * self.edge[1]
        rates = _rates(self.system, state, now, force, slips=True)
        rates[self.system.at + 1] = 0.0
        return rates

    def guards(self, time: float, state: State) -> tuple[Guard, ...]:
        system, now = self.system, self.system.instant(time, state, self.impending)
        size = self._size(now)
        return (
            Guard(Cause.SLIP_ENDS, self.side * state[system.at] / system.speed),
            Guard(Cause.FORCE_ENDS, size / (abs(size) + system.force)),
            Guard(Cause.CHOICE, now.free[1] * system.setting.mass / system.force, True),
            *_common(system, state, now),
        )
