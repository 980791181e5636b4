"""The reduced potential of any support and any centre of mass; no symmetry is presumed.

All is seen in the body frame: x along the rod and away from the contact, y to its left, lengths in radii. A
motion is that of the contact, (x, y), with the rotation `spin`. Psi is what is left of the potential at the
rotation of no torque. The motion under a line of force of direction t that has ``t . u`` given is the one
of least Psi: its force has no part across t. Both unknowns are roots of increasing functions, which jump
where the centre of rotation is a support point; those are tried first (`pivots`).
"""

from __future__ import annotations

from typing import Any, NamedTuple

from planar_pushing.mechanics.compiled import compiled
from planar_pushing.mechanics.effects.base import fastest, gradient, rough
from planar_pushing.mechanics.numerics.root import EQUATIONS, root

#: Doublings of a bracket, more than the domain needs.
DOUBLINGS = 80


class Felt(NamedTuple):
    """Force and torque at the contact, and their derivatives by the contact's motion and the spin."""

    f_x: float
    f_y: float
    torque: float
    xx: float
    xy: float
    yy: float
    xs: float
    ys: float
    ss: float


class Motion(NamedTuple):
    """Motion of the contact and rotation."""

    x: float
    y: float
    spin: float


class TorqueOfSpin(NamedTuple):
    """Torque about the contact over the rotation, in a motion of the contact."""

    effects: tuple[Any, ...]
    length: float
    x: float
    y: float


class Line(NamedTuple):
    """Force across a line over the contact's motion across it, its part along the line being given."""

    effects: tuple[Any, ...]
    length: float
    x: float
    y: float
    along: float


@compiled
def felt(effects, length, motion):
    """What a motion of the contact takes."""
    x, y, spin = motion
    f_x, f_y, torque, xx, xy, yy, xs, ys, ss = gradient(effects, x, y + length * spin, spin)
    across, turn = xs + length * xy, ys + length * yy
    bend = ss + length * (ys + turn)
    return Felt(f_x, f_y, torque + length * f_y, xx, xy, yy, across, turn, bend)


@compiled
def _torque_of_spin(of, spin):
    now = felt(of.effects, of.length, Motion(of.x, of.y, spin))
    return now.torque, now.ss


@compiled
def _rough_spin(effects, length, x, y):
    """Rotation of a contact that moves by (x, y), as if the first effect were a mass; exact for a mass."""
    c_x, c_y, gyration = rough(effects[0])
    arm = c_x + length
    return (x * c_y - y * arm) / (arm * arm + c_y * c_y + gyration)


@compiled
def spin_of(effects, length, x, y):
    """Rotation of a contact that moves by (x, y), at which the torque about it vanishes."""
    start = _rough_spin(effects, length, x, y)
    most = fastest(effects[0], length) * (x * x + y * y) ** 0.5
    low, high = -most, most
    if len(effects) > 1:
        other = _rough_spin(effects[1:], length, x, y)
        low, high, start = min(low, other), max(high, other), (start + other) / 2.0
    elif most == 0.0:
        return start
    return root(TorqueOfSpin(effects, length, x, y), low, high, min(max(start, low), high))[0]


@compiled
def moved(line, across):
    """The motion with a part across the line, at the rotation of no torque."""
    x, y = line.along * line.x - across * line.y, line.along * line.y + across * line.x
    return Motion(x, y, spin_of(line.effects, line.length, x, y))


@compiled
def _force_across(line, across):
    now, t_x, t_y = felt(line.effects, line.length, moved(line, across)), line.x, line.y
    bend = now.xx * t_y * t_y - 2.0 * now.xy * t_x * t_y + now.yy * t_x * t_x
    turn = now.ys * t_x - now.xs * t_y
    slope = bend - turn * turn / now.ss if now.ss > 0.0 else bend
    return now.f_y * t_x - now.f_x * t_y, slope


EQUATIONS.update({TorqueOfSpin: _torque_of_spin, Line: _force_across})


@compiled
def _rough_across(line):
    """Motion across a line, as if the first effect were a mass."""
    c_x, c_y, gyration = rough(line.effects[0])
    r_x, r_y = -line.length - c_x, -c_y
    arm = r_x * line.y - r_y * line.x
    spin = arm / gyration
    return line.along * spin * (r_x * line.x + r_y * line.y) / (1.0 + spin * arm)


@compiled
def _bracket(line, start):
    """Motions across a line under which the force across it is of either sign."""
    width = line.along / 8.0 + abs(start) / 8.0
    rises = _force_across(line, start)[0] > 0.0
    near, far = start, start - width if rises else start + width
    for _ in range(DOUBLINGS):
        if (_force_across(line, far)[0] > 0.0) != rises:
            break
        width *= 2.0
        near, far = far, far - width if rises else far + width
    return min(near, far), max(near, far)


@compiled
def motion_under(line):
    """The motion under a line of force."""
    low, high = _bracket(line, _rough_across(line))
    return moved(line, root(line, low, high, low + (high - low) / 2.0)[0])
