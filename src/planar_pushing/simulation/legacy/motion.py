"""The contact, the slider's resistance about it, and the reduced potential at one motion."""

from __future__ import annotations

from math import sqrt
from typing import NamedTuple

from planar_pushing.simulation.legacy.base import Resistance, resistance
from planar_pushing.simulation.legacy.compiled import compiled
from planar_pushing.simulation.legacy.root import EPSILON

#: Rounding error of a motion, relative to its components.
ROUNDING = 4.0 * EPSILON
#: Number of a support point if there is none.
NOWHERE = -1


class Contact(NamedTuple):
    """Position of the contact in the body frame.

    `reach` is its distance from the origin, and (a_x, a_y) the direction in which the origin moves in a
    rotation about the contact.
    """

    x: float
    y: float
    reach: float
    a_x: float
    a_y: float


class Psi(NamedTuple):
    """Motion of the slider under one motion of the contact, and gradient and Hessian of Psi there.

    Attributes
    ----------
    v_x, v_y, spin : float
        Twist of the origin.
    f_x, f_y : float
        Force at the contact; for a pivot the midpoint of its interval.
    xx, xy, yy : float
        Hessian of Psi; for a pivot that of the motion about the point.
    turn_x, turn_y : float
        Derivatives of the rotation with respect to the contact's motion.
    free_x, free_y : float
        Half of a pivot's interval of forces, otherwise zero.
    point : int
        Number of the support point about which the slider pivots, -1 without one.
    noise_x, noise_y : float
        Rounding errors of the force.
    continuum : bool
        Whether the rotation is one of an interval, all of which have this force.
    found : bool
        Whether the iteration has converged.
    """

    v_x: float
    v_y: float
    spin: float
    f_x: float
    f_y: float
    xx: float
    xy: float
    yy: float
    turn_x: float
    turn_y: float
    free_x: float
    free_y: float
    point: int
    noise_x: float
    noise_y: float
    continuum: bool
    found: bool


@compiled
def contact_at(x, y):
    """The contact at a position in the body frame."""
    reach = sqrt(x * x + y * y)
    return (
        Contact(x, y, reach, y / reach, -x / reach) if reach > 0.0 else Contact(x, y, 0.0, 1.0, 0.0)
    )


@compiled
def about(effects, at, x, y, spin, blur):
    """`Resistance` about the contact at a twist (x, y, spin) of the origin."""
    now = resistance(effects, x, y, spin, blur)
    a, b = at.y, -at.x
    across, turn = now.xs + a * now.xx + b * now.xy, now.ys + a * now.xy + b * now.yy
    return Resistance(
        now.f_x, now.f_y, now.torque + (a * now.f_x + b * now.f_y), now.xx, now.xy, now.yy, across, turn,
        now.ss + a * (now.xs + across) + b * (now.ys + turn), now.most, now.point, now.gross,
    )  # fmt: skip


@compiled
def settled(now, at, v_x, v_y, spin, step, x, y, size, found):
    """Psi at a root, extrapolated by the last Newton step, for an unknown of magnitude `size`."""
    turn_x, turn_y = (-now.xs / now.ss, -now.ys / now.ss) if now.ss > 0.0 else (0.0, 0.0)
    xx, xy, yy = now.xx + turn_x * now.xs, now.xy + turn_x * now.ys, now.yy + turn_y * now.ys
    f_x, f_y = now.f_x + step * now.xs, now.f_y + step * now.ys
    # The torque is known to the rounding of its terms, and the rotation to that and its own rounding.
    lever = (1.0 + at.reach) * (abs(at.a_x * f_x) + abs(at.a_y * f_y))
    noise_x = now.gross + abs(f_x) + abs(xx * x) + abs(xy * y)
    noise_y = now.gross + abs(f_y) + abs(xy * x) + abs(yy * y)
    noise_x += lever * abs(turn_x) + (size + abs(step)) * abs(now.xs)
    noise_y += lever * abs(turn_y) + (size + abs(step)) * abs(now.ys)
    carried = step * at.reach
    return Psi(
        v_x + carried * at.a_x, v_y + carried * at.a_y, spin + step, f_x, f_y, xx, xy, yy,
        turn_x, turn_y, 0.0, 0.0, NOWHERE, ROUNDING * noise_x, ROUNDING * noise_y, False, found,
    )  # fmt: skip
