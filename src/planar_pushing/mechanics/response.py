"""How a motion and its force respond to a change of the problem: the implicit function theorem.

At a solution the wrench of the effects balances the force, and the contact imposes a condition: the
pusher's whole motion, its normal part and the direction of the force, or the force. A change of a parameter
changes the terms of these equations at the same motion; the Hessian of the potential, with the rotation
eliminated as in `psi`, gives the change of motion and force that restores them.

While the slider pivots about a support point, the point's friction takes up each change of the balance
across the point, so only the place of the point and the condition at the contact fix the motion. All is in
the body frame; lengths are in radii.
"""

from __future__ import annotations

from collections.abc import Callable
from math import nan, sqrt
from typing import Any, NamedTuple

import numpy as np

from planar_pushing.mechanics.compiled import compiled, generic, kernel, owning
from planar_pushing.mechanics.effects.base import (
    Resistance,
    count_fields,
    count_points,
    made,
    place,
)
from planar_pushing.mechanics.plane import rod, toward
from planar_pushing.mechanics.reduced.motion import about, contact_at

#: Conditions at the contact: it moves with the pusher, or has its normal part and a force along an edge;
#: a force along a line, with a contact motion of constant magnitude; a given force; none.
STICK, SLIP, LINE, FORCE, FREE = range(5)
#: Values of `Smoothness`.
SMOOTH, PIVOT, OPEN, CHANGE = range(1, 5)
#: Parameters before the effects: two of the condition, the contact's position, the angle of the force.
FIRST = 5
#: A support point slower than this, relative to the twist, is about to be a pivot, or was one.
SLOW = 1e-11
#: A pivot whose friction is this near to its share, relative to it, is about to slide.
SHARE = 1e-9
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
        Force, and the unit vector of the edge or line along which it is.
    m_x, m_y : float
        Direction in which the condition fixes the contact's motion: the pusher's normal, or the motion.
    r_x, r_y : float
        The pivot from the contact.
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

    Of the pusher's motion, of a given force, of the angle of the edge, of the contact's position, and of
    the wrench about the contact at the same rotation and motion of the contact.
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
    """The response: of the contact's motion, of the rotation, and of the force."""

    u_x: float
    u_y: float
    spin: float
    f_x: float
    f_y: float


NOTHING = Change(0.0, 0.0, 0.0, 0.0, 0.0)
UNKNOWN = Change(nan, nan, nan, nan, nan)


@compiled
def _cross(x, y, other_x, other_y):
    return x * other_y - y * other_x


@compiled
def _bend(now):
    """Hessian of Psi, and derivatives of the rotation by the contact's motion."""
    turn_x, turn_y = -now.xs / now.ss, -now.ys / now.ss
    xx, xy, yy = now.xx + turn_x * now.xs, now.xy + turn_x * now.ys, now.yy + turn_y * now.ys
    return xx, xy, yy, turn_x, turn_y


@compiled
def smooth(of, cause):
    """The change of a motion that is no pivot; NaN where the equations are singular."""
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
        slope = _cross(of.e_x, of.e_y, xx * d_x + xy * d_y, xy * d_x + yy * d_y)
        if not abs(slope) > ROUNDING * size * (abs(d_x) + abs(d_y)):
            return UNKNOWN
        part = u_x * of.m_x + u_y * of.m_y
        u_x, u_y = part * of.m_x, part * of.m_y
        b_x, b_y = xx * u_x + xy * u_y + a_x, xy * u_x + yy * u_y + a_y
        force = of.e_x * of.f_x + of.e_y * of.f_y
        s = (cause.turn * force - _cross(of.e_x, of.e_y, b_x, b_y)) / slope
        u_x, u_y = u_x + s * d_x, u_y + s * d_y
    spin = own + turn_x * u_x + turn_y * u_y
    return Change(u_x, u_y, spin, xx * u_x + xy * u_y + a_x, xy * u_x + yy * u_y + a_y)


@compiled
def pivoting(of, cause):
    """The change of a pivot: the point rests, whatever the force, and the moments about it balance."""
    if of.condition == STICK:
        return _held(of, cause)
    now, r_x, r_y = of.now, of.r_x, of.r_y
    # The motion of the contact is the rotation times (r_y, -r_x), and the position changes r.
    own_x, own_y = -of.spin * cause.c_y, of.spin * cause.c_x
    along_x, along_y = now.xx * r_y - now.xy * r_x + now.xs, now.xy * r_y - now.yy * r_x + now.ys
    stiff = r_y * along_x - r_x * along_y + r_y * now.xs - r_x * now.ys + now.ss
    moment = r_y * cause.q_x - r_x * cause.q_y + cause.torque
    shift = _cross(cause.c_x, cause.c_y, of.f_x, of.f_y)
    if of.condition in (FORCE, FREE):
        lever = -_cross(r_x, r_y, cause.f_x, cause.f_y)
        if not stiff > 0.0:
            return UNKNOWN
        spin = (lever + shift - moment) / stiff
        return Change(spin * r_y + own_x, -spin * r_x + own_y, spin, cause.f_x, cause.f_y)
    part, lever = of.m_x * r_y - of.m_y * r_x, -_cross(r_x, r_y, of.e_x, of.e_y)
    size = abs(r_x) + abs(r_y)
    if not min(abs(part), abs(lever)) > ROUNDING * size:
        return UNKNOWN
    fixed = of.m_x * cause.u_x + of.m_y * cause.u_y
    spin = (fixed - of.m_x * own_x - of.m_y * own_y) / part
    force = of.e_x * of.f_x + of.e_y * of.f_y
    t_x, t_y = -cause.turn * of.e_y, cause.turn * of.e_x
    grows = stiff * spin + moment - shift + force * _cross(r_x, r_y, t_x, t_y)
    more = grows / lever
    return Change(
        spin * r_y + own_x, -spin * r_x + own_y, spin,
        more * of.e_x + force * t_x, more * of.e_y + force * t_y,
    )  # fmt: skip


@compiled
def _held(of, cause):
    """The change of a motion that sticks and pivots, whose force is any of an interval.

    A change that moves the point along its line to the contact lets it slide one way or the other: NaN.
    """
    r_x, r_y = of.r_x, of.r_y
    square = r_x * r_x + r_y * r_y
    ahead = cause.u_x * r_x + cause.u_y * r_y - of.u_x * cause.c_x - of.u_y * cause.c_y
    size = abs(cause.u_x) + abs(cause.u_y) + abs(of.spin) * (abs(cause.c_x) + abs(cause.c_y))
    if abs(ahead) > ROUNDING * sqrt(square) * size:
        return UNKNOWN
    back = 2.0 * of.spin * (r_x * cause.c_x + r_y * cause.c_y)
    aside = _cross(cause.u_x, cause.u_y, r_x, r_y) - _cross(of.u_x, of.u_y, cause.c_x, cause.c_y)
    return Change(cause.u_x, cause.u_y, (aside + back) / square, nan, nan)


@compiled
def _first(effects, at, x, y, spin, blur, wrenches, i):
    now = about((effects[0],), at, x, y, spin, blur)
    wrenches[i, 0], wrenches[i, 1], wrenches[i, 2] = now.f_x, now.f_y, now.torque
    return i + 1


@compiled
def _all(effects, at, x, y, spin, blur, wrenches, i):
    _first(effects, at, x, y, spin, blur, wrenches, i)
    return write_wrenches(effects[1:], at, x, y, spin, blur, wrenches, i + 1)


@generic
def write_wrenches(kinds: Any) -> Callable[..., Any]:
    """Write down the wrench of each effect about the contact: effects, at, twist, blur, wrenches, row."""
    return _first if len(kinds) == 1 else _all


@compiled
def _write_feet(effects, at, x, y, spin, pivot, wrenches, first):
    """Write down the wrench of each support point about the contact, of a friction of size one.

    That of a pivot is not at its limit, so a change of it changes nothing. Places without a point are NaN.
    """
    count = count_points(effects)
    for i in range(len(wrenches) - first):
        row = wrenches[first + i]
        row[0], row[1], row[2] = nan, nan, nan
        if i < count:
            p_x, p_y = place(effects, i)
            w_x, w_y = x - spin * p_y, y + spin * p_x
            speed = sqrt(w_x * w_x + w_y * w_y)
            row[0], row[1] = (0.0, 0.0) if i == pivot else (w_x / speed, w_y / speed)
            row[2] = _cross(p_x - at.x, p_y - at.y, row[0], row[1])


@compiled
def _caused(of, at, k, t_x, t_y, wrenches):
    """The change of the problem by its k-th parameter; (t_x, t_y) is the pusher's tangent."""
    if k >= FIRST:
        own = wrenches[k - FIRST]
        return Cause(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, own[0], own[1], own[2])
    x, y = (t_x, t_y) if k % 2 == 0 else (-t_y, t_x)
    if k == 4:
        size = of.e_x * of.f_x + of.e_y * of.f_y if of.condition == FORCE else 0.0
        turn = 1.0 if of.condition in (SLIP, LINE) else 0.0
        return Cause(0.0, 0.0, -size * of.e_y, size * of.e_x, turn, 0.0, 0.0, 0.0, 0.0, 0.0)
    if k >= 2:
        now, b_x, b_y = of.now, of.spin * y, -of.spin * x
        turned = now.xs * b_x + now.ys * b_y - _cross(x, y, now.f_x, now.f_y)
        q_x, q_y = now.xx * b_x + now.xy * b_y, now.xy * b_x + now.yy * b_y
        pivots = of.r_x != 0.0 or of.r_y != 0.0
        q_x, q_y, turned = (0.0, 0.0, 0.0) if pivots else (q_x, q_y, turned)
        return Cause(0.0, 0.0, 0.0, 0.0, 0.0, x, y, q_x, q_y, turned)
    if of.condition in (STICK, SLIP):
        return Cause(x, y, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    more = 1.0 if of.condition == FORCE and k == 0 else 0.0
    return Cause(0.0, 0.0, more * of.e_x, more * of.e_y, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)


@compiled
def _response(of, at, pivots, k, t_x, t_y, wrenches):
    """The change by a parameter of the twist of the origin and of the force, in the contact's frame."""
    cause = _caused(of, at, k, t_x, t_y, wrenches)
    change = pivoting(of, cause) if pivots else smooth(of, cause)
    spin = change.spin
    v_x = change.u_x + spin * at.y + of.spin * cause.c_y
    v_y = change.u_y - spin * at.x - of.spin * cause.c_x
    return (
        t_x * v_x + t_y * v_y, t_x * v_y - t_y * v_x, spin,
        t_x * change.f_x + t_y * change.f_y, t_x * change.f_y - t_y * change.f_x,
    )  # fmt: skip


@compiled
def _state(effects, at, own, row, i, pivot):
    """The solution in the columns of a row from i on, and the twist of the origin."""
    t_x, t_y, condition = own.x, -own.y, int(row[i + 6])
    x, y = t_x * row[i] - t_y * row[i + 1], t_y * row[i] + t_x * row[i + 1]
    f_x, f_y = t_x * row[i + 3] - t_y * row[i + 4], t_y * row[i + 3] + t_x * row[i + 4]
    spin, r_x, r_y = row[i + 2], 0.0, 0.0
    if pivot >= 0:
        p_x, p_y = place(effects, pivot)
        x, y, r_x, r_y = spin * p_y, -spin * p_x, p_x - at.x, p_y - at.y
    u_x, u_y = x - spin * at.y, y + spin * at.x
    edge = toward(own, row[i + 5])
    m_x, m_y = (u_x, u_y) if condition == LINE else (-t_y, t_x)
    now = about(effects, at, x, y, spin, SLOW * (sqrt(x * x + y * y) + abs(spin)))
    return State(
        condition, now, u_x, u_y, spin, f_x, f_y, edge.along, -edge.aside, m_x, m_y, r_x, r_y
    ), x, y  # fmt: skip


@compiled
def _is_changing(of, pivots):
    """Whether a support point is about to become a pivot or to leave from being one."""
    most = (1.0 - SHARE) * of.now.most
    if not pivots:
        return most > 0.0
    if of.condition == STICK:  # the balance gives the friction across the line to the contact alone
        return not abs(of.now.torque) <= most * sqrt(of.r_x * of.r_x + of.r_y * of.r_y)
    g_x, g_y = of.f_x - of.now.f_x, of.f_y - of.now.f_y
    return not sqrt(g_x * g_x + g_y * g_y) <= most


@kernel
@owning
def respond(kinds, rows, status, twists, forces):
    """Responses to each parameter.

    The columns of a row behind those of the effects: length and angle of the rod; twist and force in the
    frame of the contact; angle of the edge; condition; number of the pivot; whether the mode changes.
    """
    count = count_fields(kinds)
    wrenches = np.empty((twists.shape[2] - FIRST, 3))
    for i in range(len(rows)):
        row = rows[i]
        twists[i], forces[i], status[i] = nan, nan, CHANGE
        if row[count + 10] != 0.0:
            continue
        if row[count + 2] == 0.0 and row[count + 3] == 0.0 and row[count + 4] == 0.0:
            twists[i], forces[i], status[i] = 0.0, 0.0, SMOOTH
            continue
        effects, own = made(kinds, row, 0), rod(row[count], row[count + 1])
        at, pivot = contact_at(-own.length, 0.0), int(row[count + 9])
        of, x, y = _state(effects, at, own, row, count + 2, pivot)
        pivots = pivot >= 0
        if _is_changing(of, pivots):
            continue
        blur = SLOW * (sqrt(x * x + y * y) + abs(of.spin))
        first = write_wrenches(effects, at, x, y, of.spin, blur, wrenches, 0)
        _write_feet(effects, at, x, y, of.spin, pivot, wrenches, first)
        for k in range(twists.shape[2]):
            v_x, v_y, spin, f_x, f_y = _response(of, at, pivots, k, own.x, -own.y, wrenches)
            twists[i, 0, k], twists[i, 1, k], twists[i, 2, k] = v_x, v_y, spin
            forces[i, 0, k], forces[i, 1, k] = f_x, f_y
        status[i] = PIVOT if pivots else SMOOTH
        if pivots and of.condition == STICK:
            status[i] = OPEN
        elif twists[i, 0, 0] != twists[i, 0, 0]:
            status[i] = CHANGE
