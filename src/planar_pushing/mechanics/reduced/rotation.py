"""What a motion of the contact takes, and the rotation at which the torque about the contact vanishes.

All is seen in the body frame: x along the rod and away from the contact, y to its left, lengths in radii. A
motion is that of the contact, u = (x, y), with the rotation `spin`. The reduced potential Psi(u) is what
is left of the potential at the rotation of no torque.
"""

from __future__ import annotations

from math import inf
from typing import Any, NamedTuple

from planar_pushing.mechanics.compiled import compiled
from planar_pushing.mechanics.effects.base import fastest, gradient, rough
from planar_pushing.mechanics.numerics.root import EQUATIONS, is_last, root

#: Newton steps to a rotation at most, and what one may leave of the last.
STEPS, SHRINK = 8, 0.3
#: Change of the slider's motion by the last step, in parts of that motion; the rest is rounding.
SETTLED = 1e-11


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


EQUATIONS[TorqueOfSpin] = _torque_of_spin


@compiled
def _as_of_a_mass(effect, length, x, y):
    """Of the mass that an effect roughly acts like: rotation times moment, and moment about the contact."""
    c_x, c_y, gyration = rough(effect)
    arm = c_x + length
    return x * c_y - y * arm, arm * arm + c_y * c_y + gyration


@compiled
def spin_of(effects, length, x, y):
    """Rotation of a contact that moves by (x, y), at which the torque about it vanishes."""
    start = rough_spin(effects, length, x, y)
    most = fastest(effects[0], length) * (x * x + y * y) ** 0.5
    low, high = -most, most
    if len(effects) > 1:
        pull, moment = _as_of_a_mass(effects[1], length, x, y)
        low, high = min(low, pull / moment), max(high, pull / moment)
    elif most == 0.0:
        return start
    return root(TorqueOfSpin(effects, length, x, y), low, high, min(max(start, low), high))[0]


@compiled
def rough_spin(effects, length, x, y):
    """A first guess of `spin_of`; exact for a mass."""
    pull, moment = _as_of_a_mass(effects[0], length, x, y)
    if len(effects) > 1:
        one, other = effects[0].weight, effects[1].mass * (x * x + y * y) ** 0.5
        more_pull, more_moment = _as_of_a_mass(effects[1], length, x, y)
        pull, moment = one * pull + other * more_pull, one * moment + other * more_moment
    return pull / moment


@compiled
def turned(effects, length, x, y, spin, enough):
    """The rotation of no torque: by Newton's method from a first guess, or bracketed if that fails.

    Parameters
    ----------
    effects, length, x, y
    spin : float
        The guess.
    enough : float
        A step that changes the slider's motion by this part at most is the last: `SETTLED` for all digits.

    Returns
    -------
    spin : float
    now : Felt
        The force there, to the square of the last step; torque and derivatives of before that step.
    """
    last = inf
    for _ in range(STEPS):
        now = felt(effects, length, Motion(x, y, spin))
        step = -now.torque / now.ss if now.ss > 0.0 else inf
        size = abs(step) * (1.0 + length) / (abs(x) + abs(y + length * spin) + abs(spin))
        if size <= enough or is_last(size, last):
            return spin + step, _moved(now, step)
        if not size <= SHRINK * last:
            break
        spin, last = spin + step, size
    spin = spin_of(effects, length, x, y)
    return spin, felt(effects, length, Motion(x, y, spin))


@compiled
def _moved(now, step):
    """What is felt, with the force a step of the rotation further."""
    f_x, f_y, torque, xx, xy, yy, xs, ys, ss = now
    return Felt(f_x + step * xs, f_y + step * ys, torque, xx, xy, yy, xs, ys, ss)
