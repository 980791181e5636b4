"""One step of the time-stepping integrator with inertia, and with or without friction.

The step solves ``M (v+ - v) + h dD(v+) = J^T P`` for the twist v+ and the contact's impulse P. By isotropy
every part of it is a root in one unknown: the direction of the motion under a known impulse, the
rotation in a stick, the impulse's size in a slip. Rest is a solution where the impulse lies inside the
limit surface times h.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable

from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.simulation.energies import Energies
from planar_pushing.simulation.incremental import REST, SLACK, Step, Trial, Twist, contact_motion
from planar_pushing.simulation.pusher import Vector
from planar_pushing.simulation.scalar_root import bracketed, safe_newton

#: Parts into which the range of a slip's impulse is cut; two roots in one part go unseen.
PARTS = 6
#: A target below this part of the speeds is a contact that stands still.
STILL = 1e-14


class InertialIncrement:
    """Steps of a scene with inertia.

    Parameters
    ----------
    energies : Energies
        The friction and the inertia.
    length : float
        Rod length in radii.
    """

    def __init__(self, energies: Energies, length: float) -> None:
        support = energies.support if energies.friction else None
        self.support, self.length = support, length
        self.mass, self.moment = energies.mass, energies.moment
        self.evaluations, self.angle = 0, math.pi / 4
        self.weights = (support.at(1.0, 0.0)[0], support.at(0.0, 1.0)[1]) if support else (0.0, 0.0)

    def free(self, step: Step) -> Twist:
        return self.response(step, (0.0, 0.0), 0.0)

    def response(self, step: Step, impulse: Vector, torque: float) -> Twist:
        """Twist after a step under a known impulse: the minimum of a strictly convex potential."""
        self.evaluations += 1
        v_x, v_y, spin = step.twist
        b_x, b_y = self.mass * v_x + impulse[0], self.mass * v_y + impulse[1]
        turn = self.moment * spin + torque
        if self.support is None:
            return b_x / self.mass, b_y / self.mass, turn / self.moment
        push = math.hypot(b_x, b_y)
        speed, spin = self._slowed(push, abs(turn), step.size)
        scale = speed / push if push > 0.0 else 0.0
        return scale * b_x, scale * b_y, math.copysign(spin, turn)

    def _slowed(self, push: float, turn: float, h: float) -> tuple[float, float]:
        """Speed and rotation after friction took its part of an impulse; both zero at rest.

        The unknown is the angle of (v, R omega). Where the impulse lies inside the limit surface times h
        the motion at the root is negative; elsewhere the root sought last lies between the
        directions that friction alone and inertia alone would give.
        """
        if push == 0.0 and turn == 0.0:
            return 0.0, 0.0
        found = self._moving(push, turn, h, 0.0, math.pi / 2)
        if found is None and not self._holds(push, turn, h):
            slow, fast = self._limit(push, turn), (push / self.mass, turn / self.moment)
            low, high = sorted(math.atan2(spin, speed) for speed, spin in (slow, fast))
            found = self._moving(push, turn, h, low, high)
        return found or (0.0, 0.0)

    def _moving(
        self, push: float, turn: float, h: float, low: float, high: float
    ) -> tuple[float, float] | None:
        """Speed and rotation whose direction lies between two angles, None where they come out negative."""
        support, mass, moment = self.support, self.mass, self.moment
        assert support is not None

        def excess(angle: float) -> tuple[float, float]:
            c, s = math.cos(angle), math.sin(angle)
            force, torque, bend = support.at(c, s)
            left, over = push - h * force, turn - h * torque
            value = left * moment * s - over * mass * c
            slope = h * bend * (mass * c * c + moment * s * s) + over * mass * s + left * moment * c
            return value, slope

        angle = safe_newton(excess, low, high, min(max(self.angle, low), high))
        c, s = math.cos(angle), math.sin(angle)
        force, torque, _ = support.at(c, s)
        left, over = push - h * force, turn - h * torque
        size = (mass * c * left + moment * s * over) / ((mass * c) ** 2 + (moment * s) ** 2)
        if size <= 0.0:
            return None
        self.angle = angle
        return size * c, size * s

    def _limit(self, push: float, turn: float) -> tuple[float, float]:
        """Motion under friction alone whose wrench has the direction of an impulse."""
        assert self.support is not None
        if push == 0.0 or turn == 0.0:
            return push, turn
        return self.support.spin_ratio(turn / push, 0.5)

    def _holds(self, push: float, turn: float, h: float) -> bool:
        """Whether an impulse lies inside the limit surface times h."""
        if push == 0.0 and turn == 0.0:
            return True
        assert self.support is not None
        force, torque, _ = self.support.at(*self._limit(push, turn))
        return push * force + turn * torque <= h * (force * force + torque * torque)

    def stick(self, step: Step) -> Trial | None:
        w_x, w_y = step.target
        c, s = self.length * math.cos(step.rod_angle), self.length * math.sin(step.rod_angle)
        along, across, spin = step.twist
        stiffness = self.moment + self.mass * self.length**2
        # The rotation that inertia alone takes; friction shifts it by no more than its own torque.
        pull = self.moment * spin + self.mass * (s * (w_x - along) - c * (w_y - across))
        middle = pull / stiffness
        spin = self._turned(step, middle, stiffness)
        twist = w_x - s * spin, w_y + c * spin, spin
        p_x, p_y = (self.mass * (twist[i] - step.twist[i]) for i in (0, 1))
        f_x, f_y = self._sustained(step, twist, stiffness * middle)
        return Trial(ContactMode.STICK, twist, (p_x + step.size * f_x, p_y + step.size * f_y))

    def _turned(self, step: Step, middle: float, stiffness: float) -> float:
        """Rotation of a sticking step: the root of the torque about the contact."""
        if self.support is None:
            return middle
        (w_x, w_y), h, support = step.target, step.size, self.support
        c, s = self.length * math.cos(step.rod_angle), self.length * math.sin(step.rod_angle)
        force, torque, _ = support.at(self.length, 1.0)
        spread = h * (self.length * self.weights[0] + self.weights[1]) / stiffness
        if math.hypot(w_x, w_y) <= STILL * self.length * abs(middle):
            shift = h * (self.length * force + torque) / stiffness
            return math.copysign(max(abs(middle) - shift, 0.0), middle)
        if w_x == 0.0 and w_y == 0.0:
            return 0.0

        def excess(spin: float) -> tuple[float, float]:
            v_x, v_y = w_x - s * spin, w_y + c * spin
            speed = math.hypot(v_x, v_y)
            force, torque, bend = support.at(speed, abs(spin))
            torque = math.copysign(torque, spin)
            rate = (c * v_y - s * v_x) / speed if speed > 0.0 else self.length
            side = (c * v_x + s * v_y) / speed if speed > 0.0 else 0.0
            value = stiffness * (spin - middle) + h * (force * rate + torque)
            tangential = force * side * side / speed if speed > 0.0 else 0.0
            return value, stiffness + h * (bend * (rate * spin - speed) ** 2 + tangential)

        return safe_newton(excess, middle - spread, middle + spread, middle)

    def _sustained(self, step: Step, twist: Twist, pull: float) -> Vector:
        """Force of friction in a stick; at rest the one whose torque about the contact is just enough."""
        if self.support is None:
            return 0.0, 0.0
        if twist != REST:
            speed = math.hypot(twist[0], twist[1])
            force = self.support.at(speed, abs(twist[2]))[0] / speed if speed > 0.0 else 0.0
            return force * twist[0], force * twist[1]
        force, torque, _ = self.support.at(self.length, 1.0)
        part = pull / (step.size * (self.length * force + torque))
        c, s = math.cos(step.rod_angle), math.sin(step.rod_angle)
        return -part * force * s, part * force * c

    def slips(self, step: Step, force: Vector, mode: ContactMode) -> list[Trial]:
        c, s = math.cos(step.rod_angle), math.sin(step.rod_angle)
        arm = self.length * (force[0] * s - force[1] * c)
        gain = force[1] / self.mass - self.length * c * arm / self.moment

        def motion(size: float) -> Twist:
            return self.response(step, (size * force[0], size * force[1]), size * arm)

        def excess(size: float) -> float:
            return contact_motion(motion(size), self.length, step.rod_angle)[1] - step.target[1]

        sizes = self._sizes(step, gain, excess)
        return [Trial(mode, motion(p), (p * force[0], p * force[1])) for p in sizes]

    def _sizes(self, step: Step, gain: float, excess: Callable[[float], float]) -> list[float]:
        """Impulses without an excess of normal motion; `gain` is its slope without friction."""
        low, high = self._range(step, gain)
        if self.support is None:
            return [high] if high > 0.0 else []
        if not low < high:
            return []
        sizes = [low + (high - low) * i / PARTS for i in range(PARTS + 1)]
        ends = itertools.pairwise((size, excess(size)) for size in sizes)
        return [bracketed(excess, a, b, f, g) for (a, f), (b, g) in ends if (f < 0.0) != (g < 0.0)]

    def _range(self, step: Step, gain: float) -> Vector:
        """Bounds of a slip's impulse: that of inertia alone, shifted by what friction can do at most."""
        away = contact_motion(step.twist, self.length, step.rod_angle)[1] - step.target[1]
        reach = self.length * abs(math.cos(step.rod_angle))
        shift = step.size * (self.weights[0] / self.mass + reach * self.weights[1] / self.moment)
        # A gain of nothing but rounding leaves the size open.
        gain = math.copysign(max(abs(gain), SLACK / self.mass), gain)
        ends = sorted(((-away - shift) / gain, (-away + shift) / gain))
        # Friction along the contact's motion shifts it by exactly its all: the root is then at an end.
        margin = 1e-3 * (ends[1] - ends[0])
        return max(ends[0] - margin, 0.0), ends[1] + margin
