"""Derivatives of solutions with respect to each parameter of their problems, in the compiled core."""

from __future__ import annotations

from collections.abc import Callable
from math import nan, sqrt
from typing import Any

import numpy as np

from planar_pushing.mechanics.compiled import compiled, generic, kernel, owning
from planar_pushing.mechanics.effects.base import (
    Resistance,
    count_fields,
    count_points,
    made,
    place,
)
from planar_pushing.mechanics.effects.far import far_terms
from planar_pushing.mechanics.plane import rod, toward
from planar_pushing.mechanics.reduced.implicit import (
    FORCE,
    FREE,
    LINE,
    SLIP,
    STICK,
    Cause,
    State,
    cross,
    pivoting,
    smooth,
)
from planar_pushing.mechanics.reduced.motion import about, contact_at

__all__ = ["FIRST", "FORCE", "FREE", "LINE", "SLIP", "STICK", "respond"]

#: Values of `Smoothness`.
SMOOTH, PIVOT, OPEN, CHANGE = range(1, 5)
#: Number of parameters before the effects: two of the condition, the position of the contact, and the angle
#: of the force.
FIRST = 5
#: A support point slower than this, relative to the twist, is about to become a pivot, or was one.
SLOW = 1e-11
#: A pivot with friction this close to its share, relative to the share, is about to slide.
SHARE = 1e-9


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
    """Write the wrench of each effect about the contact: effects, at, twist, blur, wrenches, row."""
    return _first if len(kinds) == 1 else _all


@compiled
def _write_feet(effects, at, x, y, spin, pivot, wrenches, first):
    """Write the wrench about the contact of unit friction at each support point.

    The friction of a pivot is below its limit, so a change of the limit has no effect. Rows without a point
    are NaN.
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
            row[2] = cross(p_x - at.x, p_y - at.y, row[0], row[1])


@compiled
def _caused(of, at, k, t_x, t_y, wrenches):
    """The change of the problem with its k-th parameter; (t_x, t_y) is the pusher's tangent."""
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
        turned = now.xs * b_x + now.ys * b_y - cross(x, y, now.f_x, now.f_y)
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
    """The change of the origin's twist and of the force with a parameter, in the contact's frame."""
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
def _with_far_terms(effects, at, x, y, spin, blur):
    """`Resistance` about the contact, with accurate second derivatives also for near-translations."""
    now, (xs, ys, ss) = about(effects, at, x, y, spin, blur), far_terms(effects, x, y, spin)
    whole = now.ss + ss + 2.0 * (at.y * xs - at.x * ys)
    return Resistance(
        now.f_x, now.f_y, now.torque, now.xx, now.xy, now.yy, now.xs + xs, now.ys + ys, whole,
        now.most, now.point, now.gross,
    )  # fmt: skip


@compiled
def _state(effects, at, own, row, i, pivot):
    """The solution in the columns of a row, starting at i, and the velocity of the origin."""
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
    now = _with_far_terms(effects, at, x, y, spin, SLOW * (sqrt(x * x + y * y) + abs(spin)))
    return State(
        condition, now, u_x, u_y, spin, f_x, f_y, edge.along, -edge.aside, m_x, m_y, r_x, r_y
    ), x, y  # fmt: skip


@compiled
def _is_changing(of, pivots):
    """Whether a support point is about to become a pivot or to stop being one."""
    most = (1.0 - SHARE) * of.now.most
    if not pivots:
        return most > 0.0
    if of.condition == STICK:
        # The balance determines only the friction across the line to the contact.
        return not abs(of.now.torque) <= most * sqrt(of.r_x * of.r_x + of.r_y * of.r_y)
    g_x, g_y = of.f_x - of.now.f_x, of.f_y - of.now.f_y
    return not sqrt(g_x * g_x + g_y * g_y) <= most


@kernel
@owning
def respond(kinds, rows, status, twists, forces):
    """Derivatives with respect to each parameter.

    After the columns of the effects, a row holds: length and angle of the rod; twist and force in the frame
    of the contact; angle of the edge; condition; number of the pivot; whether the mode changes.
    """
    count = count_fields(kinds)
    wrenches = np.empty((twists.shape[2] - FIRST, 3))
    for i in range(len(rows)):
        row = rows[i]
        twists[i], forces[i], status[i] = nan, nan, CHANGE
        if row[count + 10] != 0.0:
            continue
        effects = made(kinds, row, 0)
        if row[count + 2] == 0.0 and row[count + 3] == 0.0 and row[count + 4] == 0.0:
            known = FIRST + len(kinds) + count_points(effects)
            twists[i, :, :known], forces[i, :, :known], status[i] = 0.0, 0.0, SMOOTH
            continue
        own = rod(row[count], row[count + 1])
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
