"""Friction of the support alone: the fence's velocity and the rod angle settle the twist (Sec. 3).

Each mode yields a `Flow`: rotation, motion of the contact over the fence and force. The state needs no
twist, and the contact stays on the fence because the gap is part of the state.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.simulation.mode import SLACK, Cause, Entry, Guard, Mode, State
from planar_pushing.simulation.problem import Problem
from planar_pushing.simulation.pusher import Segment
from planar_pushing.simulation.record import NO_MODE, Record, spin_ratio
from planar_pushing.simulation.setting import Vector, setting
from planar_pushing.simulation.support import Support

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


class QuasiStatic:
    """The system of a scene whose effects are all of degree 1."""

    def __init__(self, problem: Problem) -> None:
        scene = problem.scene
        self.problem = problem
        self.support = Support(scene.scaled_effects)
        self.count = len(scene.effects)
        self.kinks = sorted({kink for effect in scene.effects for kink in effect.kinks})
        self.setting = setting(scene)
        self.segment = problem.pusher.segments(problem.duration)[0]
        self.speed = problem.pusher.typical_speed(problem.duration) or 1.0

    def initial(self) -> State:
        slider, gap = self.problem.scene.slider, self.problem.gap
        return [0.0, gap, slider.rod_angle, 0.0, -gap, 0.0, 0.0, 0.0, *([0.0] * self.count)]

    def scales(self) -> list[float]:
        lengths = self.setting.radius * max(1.0, self.setting.length)
        weight = self.support.at(1.0, 0.0)[0]
        size = [lengths, lengths, 1.0, lengths, lengths, lengths]
        energies = [weight * lengths] * (2 + self.count)
        return size + energies

    def pace(self, time: float) -> float:
        speed = math.hypot(*self.segment.velocity(time))
        return self.setting.radius * max(1.0, self.setting.length) / speed if speed else math.inf

    def settling(self, time: float, state: State) -> float:
        return 0.0

    def enter(self, segment: Segment, state: State, mode: Mode | None) -> State:
        self.segment = segment
        return state

    def modes(self, time: float, state: State) -> list[Mode]:
        touching = state[Entry.GAP] <= SLACK * self.setting.radius
        found: list[Mode] = [Rest(self, touching)]
        moves = self.segment.velocity(time) != (0.0, 0.0)
        if touching and (moves or not self.segment.constant):
            found.append(Stick(self))
            if self.setting.slips:
                found += [Slip(self, kind) for kind in self.setting.edges]
        return found

    def after(self, cause: Cause, time: float, state: State, mode: Mode) -> tuple[float, State]:
        if cause is Cause.TOUCHES or state[Entry.GAP] <= SLACK * self.setting.radius:
            state[Entry.GAP] = 0.0
        return time, state

    def rates(self, time: float, flow: Flow) -> State:
        """Derivative of the state under a flow."""
        fence_x, fence_y = self.segment.velocity(time)
        work = flow.force_x * fence_x + flow.force_y * fence_y
        lost = -flow.force_x * flow.slip
        rates = [flow.slip, flow.rise, flow.spin / self.setting.radius, fence_x, fence_y]
        # A rest over the fence is no slip of the contact.
        slip = flow.slip if flow.rise == 0.0 and (flow.force_x or flow.force_y) else 0.0
        if self.count == 1:
            return [*rates, slip, lost, work, work - lost]
        rest = flow.speed == 0.0 and flow.spin == 0.0
        powers = [0.0] * self.count if rest else self.support.powers(flow.speed, flow.spin)
        return [*rates, slip, lost, work, *powers]

    def common_guards(self, time: float, state: State, flow: Flow) -> tuple[Guard, ...]:
        """What every mode of contact watches: the ring's centre, kinks, and the fence's turns."""
        guards = []
        if self.setting.length > 0:
            guards.append(Guard(Cause.LIES, math.sin(state[Entry.ANGLE])))
        for kink in self.kinks:
            total = abs(flow.spin) + kink * flow.speed
            off = abs(flow.spin) - kink * flow.speed
            guards.append(Guard(Cause.KINK, off / total if total else 0.0, True))
        if not self.segment.constant:
            x, y = self.segment.velocity(time)
            speed = math.hypot(x, y)
            guards.append(Guard(Cause.CHOICE, y / speed if speed else 0.0, True))
            guards.append(Guard(Cause.CHOICE, x / speed if speed else 0.0, True))
        return tuple(guards)

    def record(self, time: float, state: State, mode: Mode | None, solutions: int) -> Record:
        flow = mode.flow(time, state) if isinstance(mode, (Rest, Stick, Slip)) else Flow()
        along, gap, psi, fence_x, fence_y, slip, contact, work, *dissipated = state
        e_x, e_y = math.cos(psi), math.sin(psi)
        w_x, w_y = self.segment.velocity(time)
        lever = self.setting.length * flow.spin
        twist = (w_x + flow.slip - lever * e_y, w_y + flow.rise + lever * e_x, flow.spin)
        if flow.speed == 0.0:
            twist = (0.0, 0.0, flow.spin)
        reach = self.setting.length * self.setting.radius
        ratio = spin_ratio(flow.spin, flow.speed)
        return Record(
            time=time,
            position=(fence_x + along + reach * e_x, fence_y + gap + reach * e_y),
            rod_angle=psi,
            twist=twist,
            fence=(fence_x, fence_y),
            slip=slip,
            gap=gap,
            force=(flow.force_x, flow.force_y),
            mode=NO_MODE if mode is None else int(mode.kind),
            solutions=solutions,
            spin_ratio=ratio,
            dissipated=tuple(dissipated),
            contact_dissipated=contact,
            work=work,
            kinetic_energy=0.0,
            evaluations=(self.support.evaluations,) * self.count,
        )


class Rest:
    """No force and no motion; the fence is clear of the slider, or does not push it."""

    kind = ContactMode.SEPARATE

    def __init__(self, system: QuasiStatic, touching: bool) -> None:
        self.system, self.touching = system, touching

    def flow(self, time: float, state: State) -> Flow:
        fence_x, fence_y = self.system.segment.velocity(time)
        return Flow(slip=-fence_x, rise=-fence_y)

    def force(self, time: float, state: State) -> Vector:
        flow = self.flow(time, state)
        return flow.force_x, flow.force_y

    def rates(self, time: float, state: State) -> State:
        return self.system.rates(time, self.flow(time, state))

    def guards(self, time: float, state: State) -> tuple[Guard, ...]:
        system = self.system
        if not self.touching:
            return (Guard(Cause.TOUCHES, state[Entry.GAP] / system.setting.radius),)
        fence = system.segment.velocity(time)
        pushes = Guard(Cause.STARTS, PUSHES - fence[1] / system.speed)
        if system.segment.constant:
            return (pushes,)
        return pushes, Guard(Cause.CHOICE, 1.0 if fence != (0.0, 0.0) else -1.0, True)


class Stick:
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

    def force(self, time: float, state: State) -> Vector:
        flow = self.flow(time, state)
        return flow.force_x, flow.force_y

    def rates(self, time: float, state: State) -> State:
        return self.system.rates(time, self.flow(time, state))

    def guards(self, time: float, state: State) -> tuple[Guard, ...]:
        system, flow = self.system, self.flow(time, state)
        rests = flow.force_x == 0.0 and flow.force_y == 0.0
        inside = -1.0 if rests else system.setting.holds(flow.force_x, flow.force_y, 0.0)
        return Guard(Cause.LEAVES_CONE, inside), *system.common_guards(time, state, flow)


class Slip:
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

    def force(self, time: float, state: State) -> Vector:
        flow = self.flow(time, state)
        return flow.force_x, flow.force_y

    def rates(self, time: float, state: State) -> State:
        return self.system.rates(time, self.flow(time, state))

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
