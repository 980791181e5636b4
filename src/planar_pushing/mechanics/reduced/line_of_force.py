"""The motion of any support and any centre of mass under a line of force; no symmetry is presumed.

Frame and letters are those of `rotation`. The motion under a line of force of direction t that has
``t . u`` given is the one of least potential: its force has no part across t and no torque about the
contact. The potential is convex, with kinks where the centre of rotation is a support point; those are
tried first (`pivots`). It is flat where a support on one line turns about a place on that line; there a
root of its slope is bracketed.
"""

from __future__ import annotations

from math import inf, pi, tan
from typing import Any, NamedTuple

from planar_pushing.mechanics.compiled import compiled
from planar_pushing.mechanics.effects.base import rough
from planar_pushing.mechanics.numerics.bracket import bracketed
from planar_pushing.mechanics.numerics.root import EQUATIONS, is_last
from planar_pushing.mechanics.reduced.rotation import Motion, felt, spin_of

#: Newton steps at most, and trials of one; and what a step has to leave of the slope at most.
STEPS, CUTS, ENOUGH = 100, 12, 0.5
#: Part of the curvature in one direction that is left in every direction where Newton's method is sure.
CURVED = 1e-14


class Line(NamedTuple):
    """A line of force at the contact, and the part of the contact's motion along it."""

    effects: tuple[Any, ...]
    length: float
    x: float
    y: float
    along: float


class SlopeAcross(NamedTuple):
    """Slope of the reduced potential across a line, over the angle from it to the contact's motion."""

    line: Line


@compiled
def rough_motion(line):
    """The motion under a line of force, as if the first effect were a mass."""
    c_x, c_y, gyration = rough(line.effects[0])
    r_x, r_y = -line.length - c_x, -c_y
    arm = r_x * line.y - r_y * line.x
    spin = line.along * arm / (gyration + arm * arm)
    across = spin * (r_x * line.x + r_y * line.y)
    return _composed(line, across, spin)


@compiled
def _composed(line, across, spin):
    """The motion with a part across the line and a rotation."""
    x, y = line.along * line.x - across * line.y, line.along * line.y + across * line.x
    return Motion(x, y, spin)


@compiled
def _slopes(line, motion):
    """Slopes of the potential across the line and over the rotation, and its second derivatives.

    And the force along the line, with its derivatives by the two.
    """
    now, t_x, t_y = felt(line.effects, line.length, motion), line.x, line.y
    bend = now.xx * t_y * t_y - 2.0 * now.xy * t_x * t_y + now.yy * t_x * t_x
    turn = now.ys * t_x - now.xs * t_y
    along = (now.yy - now.xx) * t_x * t_y + now.xy * (t_x * t_x - t_y * t_y)
    force = now.f_x * t_x + now.f_y * t_y, along, now.xs * t_x + now.ys * t_y
    return now.f_y * t_x - now.f_x * t_y, now.torque, bend, turn, now.ss, force


@compiled
def _slope_across(of, angle):
    line = of.line
    x, y, _ = _composed(line, line.along * tan(angle), 0.0)
    now = felt(line.effects, line.length, Motion(x, y, spin_of(line.effects, line.length, x, y)))
    return now.f_y * line.x - now.f_x * line.y, 0.0


EQUATIONS[SlopeAcross] = _slope_across


@compiled
def _between(line):
    """The motion under a line of force, and the force: a root for the rotation in one for the direction."""
    angle = bracketed(SlopeAcross(line), -pi / 2.0, pi / 2.0, -1.0, 1.0)
    x, y, _ = _composed(line, line.along * tan(angle), 0.0)
    motion = Motion(x, y, spin_of(line.effects, line.length, x, y))
    return motion, force_of(line, motion)


@compiled
def force_of(line, motion):
    """Size of the force that a motion takes along a line."""
    now = felt(line.effects, line.length, motion)
    return now.f_x * line.x + now.f_y * line.y


@compiled
def _newton(line, start):
    """The motion by Newton's method in two unknowns, the size of its force, and whether it has settled.

    Along a step the slope of the convex potential increases; a step that it does not fall enough in is
    cut to where the secant has the slope zero.
    """
    across, spin = start.y * line.x - start.x * line.y, start.spin
    one, other, bend, turn, stiff, force = _slopes(line, start)
    last = inf
    for _ in range(STEPS):
        whole = bend * stiff - turn * turn
        if not whole > CURVED * bend * stiff:
            break
        step, swing = (turn * other - stiff * one) / whole, (turn * one - bend * other) / whole
        size = max(_over(step, line.along + abs(across)), _over(swing, spin))
        if is_last(size, last):
            size = force[0] + step * force[1] + swing * force[2]
            return _composed(line, across + step, spin + swing), size, True
        slope, part, last = one * step + other * swing, 1.0, size
        for _ in range(CUTS):
            motion = _composed(line, across + part * step, spin + part * swing)
            one, other, bend, turn, stiff, force = _slopes(line, motion)
            left = one * step + other * swing
            if abs(left) <= ENOUGH * abs(slope):
                break
            part *= slope / (slope - left) if left > 0.0 else 2.0
        across, spin = across + part * step, spin + part * swing
    return _composed(line, across, spin), force[0], False


@compiled
def _over(step, size):
    """Size of a step over that of what it changes."""
    if step == 0.0:
        return 0.0
    return abs(step / size) if size != 0.0 else inf


@compiled
def motion_under(line, start):
    """The motion under a line of force, from a first guess, and the size of the force."""
    motion, force, settled = _newton(line, start)
    return (motion, force) if settled else _between(line)
