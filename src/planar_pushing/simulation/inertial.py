"""Inertia, with or without friction of the support: the twist is part of the state.

It is kept as the velocity (r_t, r_n) of the contact over the fence and the rotation R omega, so that a
contact that sticks has no relative velocity at all, and one that slips no normal one.
"""

from __future__ import annotations

import math

from planar_pushing.mechanics import response
from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.simulation.contact_inertia import (
    Instant,
    contact_inertia,
)
from planar_pushing.simulation.inertial_events import AT_REST, impact, set_off, starts, stopped
from planar_pushing.simulation.inertial_modes import Free, Rest, Slide, Stick
from planar_pushing.simulation.inertial_record import record
from planar_pushing.simulation.mode import SLACK, Cause, Entry, Mode, State
from planar_pushing.simulation.problem import Problem
from planar_pushing.simulation.pusher import Segment
from planar_pushing.simulation.record import Record
from planar_pushing.simulation.setting import Vector, setting
from planar_pushing.simulation.support import Support

#: Below this part of the typical speed a slider that starts has no direction but the impending one.
NO_DIRECTION = 1e-13


class Inertial:
    """The system of a scene with an effect of degree 2."""

    def __init__(self, problem: Problem) -> None:
        effects = problem.scene.scaled_effects
        rubbing = response.of_degree(effects, 1)
        self.problem, self.setting = problem, setting(problem.scene)
        self.support = Support(rubbing) if rubbing else None
        self.count = len(rubbing)
        self.at = len(Entry) + self.count
        self.weight = float(response.profile(rubbing, 0.0)[0]) if rubbing else 0.0
        self.segment = problem.pusher.segments(problem.duration)[0]
        self.fence: Vector = (0.0, 0.0)
        self.speed = self._typical_speed()
        self.instants = 0
        mass, radius = self.setting.mass, self.setting.radius
        self.force = mass * self.speed**2 / radius + self.weight

    def _typical_speed(self) -> float:
        v_x, v_y, omega = self.problem.twist
        fence = self.problem.pusher.typical_speed(self.problem.duration)
        return max(math.hypot(v_x, v_y), abs(omega) * self.setting.radius, fence) or 1.0

    def initial(self) -> State:
        psi, gap = self.problem.scene.slider.rod_angle, self.problem.gap
        v_x, v_y, omega = self.problem.twist
        spin = omega * self.setting.radius
        lever = self.setting.length * spin
        contact = v_x + lever * math.sin(psi), v_y - lever * math.cos(psi)
        return [0.0, gap, psi, 0.0, -gap, 0.0, 0.0, 0.0, *([0.0] * self.count), *contact, spin]

    def scales(self) -> list[float]:
        lengths = self.setting.radius * max(1.0, self.setting.length)
        energy = self.force * lengths
        size = [lengths, lengths, 1.0, lengths, lengths, lengths]
        return size + [energy] * (2 + self.count) + [0.01 * self.speed] * 3

    def pace(self, time: float) -> float:
        pace = self.setting.radius * max(1.0, self.setting.length) / self.speed
        return min(pace, self.setting.mass * self.speed / self.weight) if self.weight else pace

    def settling(self, time: float, state: State) -> float:
        size = self._size(time, state)
        return self.weight / (self.setting.mass * max(size, AT_REST * self.speed))

    def _size(self, time: float, state: State) -> float:
        """Speed of the centre and of the rotation together."""
        own, at, psi = self.setting, self.at, state[Entry.ANGLE]
        fence, spin = self.segment.velocity(time), state[at + 2]
        lever = own.length * spin
        v_x = fence[0] + state[at] - lever * math.sin(psi)
        v_y = fence[1] + state[at + 1] + lever * math.cos(psi)
        return math.hypot(v_x, v_y) + abs(spin)

    def instant(self, time: float, state: State, impending: tuple[float, ...]) -> Instant:
        """Everything at an instant that the contact force does not change."""
        own, at, psi = self.setting, self.at, state[Entry.ANGLE]
        along, rise, spin = state[at], state[at + 1], state[at + 2]
        fence, turn = self.segment.velocity(time), self.segment.acceleration(time)
        e_x, e_y = math.cos(psi), math.sin(psi)
        lever = own.length * spin
        velocity = fence[0] + along - lever * e_y, fence[1] + rise + lever * e_x
        resistance, powers = self._resistance(velocity, spin, impending)
        pull = own.length * spin * spin / own.radius
        swing = -own.length * resistance[2] / own.moment
        free = (
            -resistance[0] / own.mass + swing * e_y + pull * e_x - turn[0],
            -resistance[1] / own.mass - swing * e_x + pull * e_y - turn[1],
        )
        inertia = contact_inertia(own, psi)
        return Instant(velocity, fence, turn, free, resistance, powers, inertia)

    def _resistance(
        self, velocity: Vector, spin: float, impending: tuple[float, ...]
    ) -> tuple[tuple[float, float, float], tuple[float, ...]]:
        """Friction on the support along the motion, or along the impending one from rest."""
        self.instants += 1
        if self.support is None:
            return (0.0, 0.0, 0.0), ()
        v_x, v_y = velocity
        speed = math.sqrt(v_x * v_x + v_y * v_y)
        starts = any(impending) and speed + abs(spin) <= NO_DIRECTION * self.speed
        if starts:
            v_x, v_y, spin = impending
            speed = math.hypot(v_x, v_y)
        if speed == 0.0 and spin == 0.0:
            return (0.0, 0.0, 0.0), (0.0,) * self.count
        force, torque, _ = self.support.at(speed, spin)
        part = force / speed if speed else 0.0
        resistance = part * v_x, part * v_y, torque
        if starts:
            return resistance, (0.0,) * self.count
        if self.count == 1:
            return resistance, (force * speed + torque * spin,)
        return resistance, self.support.powers(speed, spin)

    def is_at_rest(self, time: float, state: State) -> bool:
        """Whether friction holds a slider that does not move."""
        return self.support is not None and self._size(time, state) <= AT_REST * self.speed

    def is_on_fence(self, state: State) -> bool:
        """Whether there is no gap."""
        return state[Entry.GAP] <= SLACK * self.setting.radius

    def touches(self, state: State) -> bool:
        """Whether the contact is on the fence and does not leave it."""
        return self.is_on_fence(state) and abs(state[self.at + 1]) <= SLACK * self.speed

    def modes(self, time: float, state: State) -> list[Mode]:
        rests = self.is_at_rest(time, state)
        if not self.touches(state):
            return [Rest(self, touching=False) if rests else Free(self)]
        if rests:
            return self._from_rest(time, state)
        found: list[Mode] = []
        rises = self.instant(time, state, (0.0, 0.0, 0.0)).free[1]
        if rises >= -SLACK * self.force / self.setting.mass:
            found.append(Free(self))
        slip = state[self.at]
        if abs(slip) <= SLACK * self.speed:
            found.append(Stick(self))
            slip = 0.0
        if self.setting.slips:
            sides = {ContactMode.SLIP_RIGHT: 1.0, ContactMode.SLIP_LEFT: -1.0}
            found += [Slide(self, kind) for kind, side in sides.items() if side * slip >= 0.0]
        return found

    def _from_rest(self, time: float, state: State) -> list[Mode]:
        """Modes in which a slider at rest on the fence may start."""
        found: list[Mode] = []
        for kind, start in starts(self, time, state):
            match kind:
                case ContactMode.SEPARATE:
                    found.append(Rest(self, touching=True))
                case ContactMode.STICK:
                    found.append(Stick(self, start))
                case _:
                    found.append(Slide(self, kind, start))
        return found

    def enter(self, segment: Segment, state: State, mode: Mode | None) -> State:
        """Take up a new motion of the fence; a jump of its velocity is an impact on what it touches."""
        before, self.segment = self.fence, segment
        now = segment.velocity(segment.start)
        at = self.at
        jump = (before[0] - now[0], before[1] - now[1])
        state = [*state]
        state[at], state[at + 1] = state[at] + jump[0], state[at + 1] + jump[1]
        end = segment.velocity(segment.end)
        self.fence = end
        slack = SLACK * self.speed
        if self.is_on_fence(state) and (math.hypot(*jump) > slack or state[at + 1] < -slack):
            impact(self, segment.start, state, mode)
        return state

    def after(self, cause: Cause, time: float, state: State, mode: Mode) -> tuple[float, State]:
        at = self.at
        match cause:
            case Cause.TOUCHES:
                state[Entry.GAP] = 0.0
                impact(self, time, state, mode)
            case Cause.SLIP_ENDS:
                state[at] = 0.0
            case Cause.STOPS:
                return stopped(self, time, state, mode)
            case Cause.STARTS:
                set_off(self, time, state, mode)
        return time, state

    def kinetic_energy(self, time: float, state: State) -> float:
        """Of the slider."""
        own = self.setting
        velocity = self.instant(time, state, (0.0, 0.0, 0.0)).velocity
        spin = state[self.at + 2]
        total = own.mass * (velocity[0] ** 2 + velocity[1] ** 2) + own.moment * spin**2
        return total / 2

    def record(self, time: float, state: State, mode: Mode | None, solutions: int) -> Record:
        return record(self, time, state, mode, solutions)
