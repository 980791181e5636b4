"""The motion of minimal potential under a line of force, in floats of the working precision.

Newton's method minimizes the potential over contact motions ``p e + s n``, with n to the left of the
direction e of the force, and rotations omega. The potential is convex, with a kink at the rotation
about each foot, where a descent would stall. The iteration starts below the potential of all kinks and
thus never reaches one. Nothing is proved here.
"""

from __future__ import annotations

from typing import NamedTuple

from flint import arb, ctx, fmpq

from planar_pushing.certified.balls import Undecided
from planar_pushing.certified.potential.gradient import Motion, response, slopes
from planar_pushing.certified.potential.resistance import Resistance
from planar_pushing.certified.supports.pressure.moments import Vector

#: Maximum number of Newton steps, of halvings of a step, and of halvings of a step away from a foot.
STEPS, HALVINGS, AWAY = 50, 60, 40
#: Bits of a potential that rounding affects.
LAST = 12
#: Squared radius of gyration that represents a support in the first guess, in units of its extent.
ROUGH = fmpq(61, 100)


class State(NamedTuple):
    """Component of the contact's motion across the force, and rotation; without a radius."""

    s: arb
    spin: arb

    def after(self, step: State, part: arb) -> State:
        """The state after a fraction of a step."""
        return State((self.s + part * step.s).mid(), (self.spin + part * step.spin).mid())


class Line(NamedTuple):
    """Contact motions ``power e + s n`` of a resistance."""

    total: Resistance
    e: Vector
    power: arb

    def motion(self, at: State) -> Motion:
        """The motion at a state."""
        (x, y), p = self.e, self.power
        return Motion((p * x - at.s * y, p * y + at.s * x), at.spin)

    def excess(self, at: State, foot: int = -1) -> Vector:
        """Force along n, and torque: the slopes of the potential; with a foot, without its friction."""
        now, (x, y) = response(self.total, self.motion(at), foot), self.e
        return x * now.y - y * now.x, now.torque

    def potential(self, at: State) -> arb:
        """The potential, infinite if the balls do not bound it."""
        motion, total = self.motion(at), self.total
        (t_x, t_y), spin = motion.t, motion.spin
        (s_x, s_y), mass = total.first, total.mass
        try:
            now = response(total, motion)
        except Undecided:
            return arb.pos_inf()
        energy = mass * (t_x * t_x + t_y * t_y) + spin * spin * total.second
        energy += 2 * spin * (s_x * t_y - s_y * t_x)
        found = now.x * t_x + now.y * t_y + now.torque * spin - energy / 2
        return found.mid() if found.is_finite() else arb.pos_inf()


def least(line: Line) -> State:
    """The motion of minimal potential, to about the size of the last step."""
    beside = (_beside(line, foot) for foot in range(len(line.total.support.points)))
    starts = [_guess(line), *(each for each in beside if each is not None)]
    at = min(starts, key=line.potential)
    here = line.potential(at)
    for _ in range(STEPS):
        step, fall = _step(line, at)
        # A decrease below the rounding error marks the last step: one more would only square its error.
        last, part = bool(fall < abs(here) * arb(2) ** (LAST - ctx.prec)), arb(1)
        for _ in range(HALVINGS):
            tried = at.after(step, part)
            there = line.potential(tried)
            if last or there < (here - part * fall / 8).mid():
                break
            part = part / 2
        at, here = tried, there
        if last:
            break
    return at


def _step(line: Line, at: State) -> tuple[State, arb]:
    """Newton's step, and the rate at which the potential decreases along it."""
    one, other = (each.mid() for each in line.excess(at))
    bend = slopes(line.total, line.motion(at))
    x, y = line.e
    across = (bend.xx * y - bend.xy * x) * y + (bend.yy * x - bend.xy * y) * x
    turn = x * bend.ys - y * bend.xs
    whole = across * bend.ss - turn * turn
    step = State(
        ((turn * other - bend.ss * one) / whole).mid(),
        ((turn * one - across * other) / whole).mid(),
    )
    if not (step.s.is_finite() and step.spin.is_finite()):
        raise Undecided("no step toward the least potential")
    return step, -(one * step.s + other * step.spin).mid()


def _guess(line: Line) -> State:
    """The motion as if the support were a mass."""
    total, (x, y), power = line.total, line.e, line.power
    rate = total.weight / arb.max(abs(power), arb(2) ** -60)
    (p_x, p_y), extent = total.pressure, total.support.extent
    mass, s_x, s_y = total.mass + rate, total.first[0] + rate * p_x, total.first[1] + rate * p_y
    second = total.second + rate * (ROUGH * extent * extent + p_x * p_x + p_y * p_y)
    turn = x * s_x + y * s_y
    one = x * total.load[1] - y * total.load[0]
    other = total.load[2] - power * (s_x * y - s_y * x)
    whole = mass * second - turn * turn
    return State(
        ((second * one - turn * other) / whole).mid(), ((mass * other - turn * one) / whole).mid()
    )


def _beside(line: Line, foot: int) -> State | None:
    """The motion of minimal potential on the steepest descent from the rotation about a foot.

    A velocity v of the foot costs its share times |v|, and the potential of the other effects decreases
    by e . v.
    """
    (t_x, t_y), (r_x, r_y) = line.e, line.total.foot(foot)
    arm = t_x * r_y - t_y * r_x
    if arm.contains(0) or line.power.contains(0):
        return None
    power = line.power
    at = State((-power * (t_x * r_x + t_y * r_y) / arm).mid(), (power / arm).mid())
    one, other = line.excess(at, foot)
    # v = s n + omega J r, so that e . n and e . J r are the slopes, and the descent is along v = -e.
    e_x, e_y = (r_x * one - t_x * other) / arm, (r_y * one - t_y * other) / arm
    step = State(-(r_x * e_x + r_y * e_y) / arm, (t_x * e_x + t_y * e_y) / arm)
    scale = abs(power).mid()
    found, lowest = None, arb.pos_inf()
    for i in range(AWAY):
        tried = at.after(step, scale * arb(2) ** (4 - i))
        power_there = line.potential(tried)
        if power_there >= lowest:
            break
        found, lowest = tried, power_there
    return found
