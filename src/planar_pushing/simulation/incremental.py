"""One step of the time-stepping integrator without inertia: the least potential under the contact.

A step of length h minimises ``|v+ - v|_M^2 / 2 + h D(v+)`` over the twist v+ at its end, subject to the
contact, with the rod angle of its start. The normal motion of the contact is at least
``w_n - gap / h``, so that the gap never closes past zero; a contact mode takes it for equal. Without
inertia only `D` is left, and a contact mode prescribes the contact's motion or its line of force.

Motions are (v_x, v_y, R omega) in the unit of the scene's lengths per time, `length` is in radii.
"""

from __future__ import annotations

import math
from typing import NamedTuple, Protocol

from planar_pushing.mechanics.contact import ContactLaw, ContactMode
from planar_pushing.simulation.pusher import Vector
from planar_pushing.simulation.support import Support

Twist = tuple[float, float, float]
REST: Twist = (0.0, 0.0, 0.0)
#: Relative to the speeds of a step, and in radians: what rounding leaves of a slip or of a margin.
SLACK = 1e-12


class Trial(NamedTuple):
    """What one contact mode does in a step: the twist at its end and the contact's impulse over it."""

    mode: ContactMode
    twist: Twist
    impulse: Vector


class Step(NamedTuple):
    """What a step starts from.

    Attributes
    ----------
    size : float
        Its length h.
    rod_angle : float
    twist : (v_x, v_y, R omega)
        Before the step.
    target : (x, y)
        Motion of the contact that keeps it on the fence: tangential and normal.
    touching : bool
        Whether the gap is closed already.
    """

    size: float
    rod_angle: float
    twist: Twist
    target: Vector
    touching: bool


class Increment(Protocol):
    """The steps of a scene with one set of effects."""

    @property
    def evaluations(self) -> int:
        """How often the inertia was evaluated."""
        ...

    def free(self, step: Step) -> Twist:
        """Twist after a step without contact force."""
        ...

    def stick(self, step: Step) -> Trial | None:
        """The step whose contact moves with the fence, whatever force that takes."""
        ...

    def slips(self, step: Step, force: Vector, mode: ContactMode) -> list[Trial]:
        """Steps under an impulse along `force`, whose contact moves along the normal with the fence."""
        ...


def contact_motion(twist: Twist, length: float, rod_angle: float) -> Vector:
    """Motion of the contact point under a twist."""
    v_x, v_y, spin = twist
    lever = length * spin
    return v_x + lever * math.sin(rod_angle), v_y - lever * math.cos(rod_angle)


class Contact:
    """Enumeration of the contact modes of a step, and the conditions that each must meet."""

    def __init__(self, law: ContactLaw, length: float) -> None:
        angles = law.force_angles
        self.length = length
        self.half = angles.span / 2
        self.limit = self.half + (SLACK if angles.closed else -SLACK)
        self.edges: dict[ContactMode, Vector] = {}
        if law.slips:
            # The edges of infinite friction lie along the fence, where no rounding may lift the force.
            side, up = math.sin(self.half), max(math.cos(self.half), 0.0)
            up = 0.0 if self.half == math.pi / 2 else up
            self.edges = {ContactMode.SLIP_RIGHT: (-side, up), ContactMode.SLIP_LEFT: (side, up)}

    def trials(self, increment: Increment, step: Step) -> list[Trial]:
        """Every consistent step, in the order of `ContactMode`."""
        free = increment.free(step)
        away = self._motion(free, step)[1] - step.target[1]
        scale = math.hypot(*step.target) + math.hypot(*free[:2], self.length * free[2])
        parts = away >= -SLACK * scale
        found = [Trial(ContactMode.SEPARATE, free, (0.0, 0.0))] if parts else []
        if parts and not step.touching:
            return found
        stick = increment.stick(step)
        if stick and self._admits(stick.impulse) and not (parts and _same(stick, free, scale)):
            found.append(stick)
        for mode, force in self.edges.items():
            slipping = increment.slips(step, force, mode)
            found += [each for each in slipping if self._slips(each, step, scale)]
        return found

    def _motion(self, twist: Twist, step: Step) -> Vector:
        return contact_motion(twist, self.length, step.rod_angle)

    def _admits(self, impulse: Vector) -> bool:
        """Whether an impulse lies in the cone of the law, about the fence's normal."""
        x, y = impulse
        if x == 0.0 and y == 0.0:
            return False
        return abs(math.atan2(x, y)) <= self.limit

    def _slips(self, trial: Trial, step: Step, scale: float) -> bool:
        """Whether the contact slips to the side of its mode."""
        slip = self._motion(trial.twist, step)[0] - step.target[0]
        return (slip if trial.mode is ContactMode.SLIP_RIGHT else -slip) > SLACK * scale


def _same(trial: Trial, twist: Twist, scale: float) -> bool:
    """Whether a trial is the motion that happens without it."""
    return all(abs(a - b) <= SLACK * scale for a, b in zip(trial.twist, twist, strict=True))


class QuasiStaticIncrement:
    """Steps of a scene whose effects are all friction: no memory of the twist before."""

    def __init__(self, support: Support, length: float) -> None:
        self.support, self.length = support, length
        self.share = 2 * length**2 / (1 + 2 * length**2)
        self.guesses = dict.fromkeys(ContactMode, 0.5)
        self.evaluations = 0

    def free(self, step: Step) -> Twist:
        return REST

    def stick(self, step: Step) -> Trial | None:
        w_x, w_y = step.target
        if w_x == 0.0 and w_y == 0.0:
            return None
        c, s = math.cos(step.rod_angle), math.sin(step.rod_angle)
        along, aside = w_x * c + w_y * s, w_x * s - w_y * c
        motion = self.support.stick(along, aside, self.length, self.share)
        self.share, spin, force_along, force_aside = motion
        across = (1.0 - self.share) * aside
        twist = along * c + across * s, along * s - across * c, spin
        force = force_along * c + force_aside * s, force_along * s - force_aside * c
        return Trial(ContactMode.STICK, twist, (step.size * force[0], step.size * force[1]))

    def slips(self, step: Step, force: Vector, mode: ContactMode) -> list[Trial]:
        c, s = math.cos(step.rod_angle), math.sin(step.rod_angle)
        arm = self.length * (force[0] * s - force[1] * c)
        speed, spin = self.support.spin_ratio(arm, self.guesses[mode])
        self.guesses[mode] = speed if abs(arm) > 1.0 else abs(spin)
        advance = speed * force[1] - self.length * spin * c
        if advance * step.target[1] <= 0.0:
            return []
        scale = step.target[1] / advance
        size = step.size * self.support.at(speed, spin)[0]
        twist = scale * speed * force[0], scale * speed * force[1], scale * spin
        return [Trial(mode, twist, (size * force[0], size * force[1]))]
