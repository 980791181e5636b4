"""Response of a motion and its force to a change of the problem, by the implicit function theorem.

At a solution the wrench of the effects balances the force, and the contact imposes a condition: on the full
contact motion, on its normal component and the direction of the force, or on the force. A change of a
parameter changes the terms of these equations at the same motion. The Hessian of the potential, with the
rotation eliminated as in `psi`, gives the change of motion and force that restores the balance.

While the slider pivots about a support point, the friction of the point absorbs every change of the force
balance there, so the motion is fixed by the position of the point and the condition at the contact alone.
Everything is in the body frame, with lengths in radii.
"""

from __future__ import annotations

from math import nan, sqrt
from typing import NamedTuple

from planar_pushing.mechanics.compiled import compiled
from planar_pushing.mechanics.effects.base import Resistance

#: Conditions at the contact: it moves with the pusher; it has the pusher's normal motion and a force along
#: an edge; a force along a line, with a contact motion of constant magnitude; a given force; none.
STICK, SLIP, LINE, FORCE, FREE = range(5)
#: Rounding error of a sum of second derivatives, relative to its terms.
ROUNDING = 1e-14


class State(NamedTuple):
    """A solution.

    Attributes
    ----------
    condition : int
    now : Resistance
        About the contact, without the friction of a pivot.
    u_x, u_y, spin : float
        Motion of the contact, and rotation.
    f_x, f_y, e_x, e_y : float
        Force, and the unit vector of its edge or line.
    m_x, m_y : float
        Direction in which the condition fixes the contact's motion: the pusher's normal, or the motion.
    r_x, r_y : float
        Position of the pivot relative to the contact.
    """

    condition: int
    now: Resistance
    u_x: float
    u_y: float
    spin: float
    f_x: float
    f_y: float
    e_x: float
    e_y: float
    m_x: float
    m_y: float
    r_x: float
    r_y: float


class Cause(NamedTuple):
    """A change of the problem.

    Changes of the pusher's motion, a given force, the angle of the edge, the contact's position, and the
    wrench about the contact at the same rotation and motion of the contact.
    """

    u_x: float
    u_y: float
    f_x: float
    f_y: float
    turn: float
    c_x: float
    c_y: float
    q_x: float
    q_y: float
    torque: float


class Change(NamedTuple):
    """The response: changes of the contact's motion, the rotation, and the force."""

    u_x: float
    u_y: float
    spin: float
    f_x: float
    f_y: float


NOTHING = Change(0.0, 0.0, 0.0, 0.0, 0.0)
UNKNOWN = Change(nan, nan, nan, nan, nan)


@compiled
def cross(x, y, other_x, other_y):
    """The cross product of two vectors of the plane, a scalar."""
    return x * other_y - y * other_x


@compiled
def _bend(now):
    """Hessian of Psi, and derivatives of the rotation with respect to the contact's motion."""
    turn_x, turn_y = -now.xs / now.ss, -now.ys / now.ss
    xx, xy, yy = now.xx + turn_x * now.xs, now.xy + turn_x * now.ys, now.yy + turn_y * now.ys
    return xx, xy, yy, turn_x, turn_y


@compiled
def smooth(of, cause):
    """The change of a motion that is not a pivot; NaN if the equations are singular."""
    if not of.now.ss > 0.0:
        return UNKNOWN
    xx, xy, yy, turn_x, turn_y = _bend(of.now)
    own = -cause.torque / of.now.ss
    a_x, a_y = cause.q_x + of.now.xs * own, cause.q_y + of.now.ys * own
    size = abs(of.now.xx) + abs(of.now.xy) + abs(of.now.yy)
    u_x, u_y = cause.u_x, cause.u_y
    if of.condition in (FORCE, FREE):
        whole, b_x, b_y = xx * yy - xy * xy, cause.f_x - a_x, cause.f_y - a_y
        if not whole > ROUNDING * size * size:
            return UNKNOWN
        u_x, u_y = (yy * b_x - xy * b_y) / whole, (xx * b_y - xy * b_x) / whole
        return Change(u_x, u_y, own + turn_x * u_x + turn_y * u_y, cause.f_x, cause.f_y)
    if of.condition != STICK:
        d_x, d_y = of.m_y, -of.m_x
        slope = cross(of.e_x, of.e_y, xx * d_x + xy * d_y, xy * d_x + yy * d_y)
        if not abs(slope) > ROUNDING * size * (abs(d_x) + abs(d_y)):
            return UNKNOWN
        part = u_x * of.m_x + u_y * of.m_y
        u_x, u_y = part * of.m_x, part * of.m_y
        b_x, b_y = xx * u_x + xy * u_y + a_x, xy * u_x + yy * u_y + a_y
        force = of.e_x * of.f_x + of.e_y * of.f_y
        s = (cause.turn * force - cross(of.e_x, of.e_y, b_x, b_y)) / slope
        u_x, u_y = u_x + s * d_x, u_y + s * d_y
    spin = own + turn_x * u_x + turn_y * u_y
    return Change(u_x, u_y, spin, xx * u_x + xy * u_y + a_x, xy * u_x + yy * u_y + a_y)


@compiled
def pivoting(of, cause):
    """The change of a pivot: the point stays at rest, and the moments about it balance."""
    if of.condition == STICK:
        return _held(of, cause)
    now, r_x, r_y = of.now, of.r_x, of.r_y
    # The motion of the contact is the rotation times (r_y, -r_x), and the position changes r.
    own_x, own_y = -of.spin * cause.c_y, of.spin * cause.c_x
    along_x, along_y = now.xx * r_y - now.xy * r_x + now.xs, now.xy * r_y - now.yy * r_x + now.ys
    stiff = r_y * along_x - r_x * along_y + r_y * now.xs - r_x * now.ys + now.ss
    moment = r_y * cause.q_x - r_x * cause.q_y + cause.torque
    shift = cross(cause.c_x, cause.c_y, of.f_x, of.f_y)
    if of.condition in (FORCE, FREE):
        lever = -cross(r_x, r_y, cause.f_x, cause.f_y)
        if not stiff > 0.0:
            return UNKNOWN
        spin = (lever + shift - moment) / stiff
        return Change(spin * r_y + own_x, -spin * r_x + own_y, spin, cause.f_x, cause.f_y)
    part, lever = of.m_x * r_y - of.m_y * r_x, -cross(r_x, r_y, of.e_x, of.e_y)
    size = abs(r_x) + abs(r_y)
    if not min(abs(part), abs(lever)) > ROUNDING * size:
        return UNKNOWN
    fixed = of.m_x * cause.u_x + of.m_y * cause.u_y
    spin = (fixed - of.m_x * own_x - of.m_y * own_y) / part
    force = of.e_x * of.f_x + of.e_y * of.f_y
    t_x, t_y = -cause.turn * of.e_y, cause.turn * of.e_x
    grows = stiff * spin + moment - shift + force * cross(r_x, r_y, t_x, t_y)
    more = grows / lever
    return Change(
        spin * r_y + own_x, -spin * r_x + own_y, spin,
        more * of.e_x + force * t_x, more * of.e_y + force * t_y,
    )  # fmt: skip


@compiled
def _held(of, cause):
    """The change of a motion that sticks and pivots, with a force undetermined within an interval.

    The change is NaN if it moves the point along its line to the contact: the point then starts to slide.
    """
    r_x, r_y = of.r_x, of.r_y
    square = r_x * r_x + r_y * r_y
    ahead = cause.u_x * r_x + cause.u_y * r_y - of.u_x * cause.c_x - of.u_y * cause.c_y
    size = abs(cause.u_x) + abs(cause.u_y) + abs(of.spin) * (abs(cause.c_x) + abs(cause.c_y))
    if abs(ahead) > ROUNDING * sqrt(square) * size:
        return UNKNOWN
    back = 2.0 * of.spin * (r_x * cause.c_x + r_y * cause.c_y)
    aside = cross(cause.u_x, cause.u_y, r_x, r_y) - cross(of.u_x, of.u_y, cause.c_x, cause.c_y)
    return Change(cause.u_x, cause.u_y, (aside + back) / square, nan, nan)
