"""Friction of the support alone: the fence's velocity and the rod angle settle the twist (Sec. 3).

The state needs no twist, and the contact stays on the fence because the gap is part of the state.
"""

from __future__ import annotations

import math

from planar_pushing.simulation.mode import SLACK, Cause, Entry, Guard, Mode, State
from planar_pushing.simulation.problem import Problem
from planar_pushing.simulation.pusher import Segment
from planar_pushing.simulation.quasi_static_modes import Flow, QuasiStaticMode, Rest, Slip, Stick
from planar_pushing.simulation.record import NO_MODE, Record, spin_ratio
from planar_pushing.simulation.setting import setting
from planar_pushing.simulation.support import Support


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
        flow = mode.flow(time, state) if isinstance(mode, QuasiStaticMode) else Flow()
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
