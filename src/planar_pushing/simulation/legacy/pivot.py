"""Motions about a support point, or nearly, where the balance of torques determines its friction."""

from __future__ import annotations

from math import copysign, inf, sqrt

from planar_pushing.simulation.legacy.base import count_points, place
from planar_pushing.simulation.legacy.compiled import compiled
from planar_pushing.simulation.legacy.motion import NOWHERE, ROUNDING, Psi, about

#: A support point slower than this, relative to the slider, barely moves.
NEAR = 1e-5
#: Smallest fraction of a share that can be resolved next to the rest of it: the square root of a rounding
#: error.
SHORT = 1e-8
#: Relative tolerance by which the friction of a point that barely moves can exceed its share.
BALANCED = 1e-9


@compiled
def _nearest(effects, at, v_x, v_y, spin):
    """The slowest support point that is not at the contact, and a quarter of the speed of the next one."""
    found, least, next_least = NOWHERE, inf, inf
    for i in range(count_points(effects)):
        x, y = place(effects, i)
        w_x, w_y = v_x - spin * y, v_y + spin * x
        square = w_x * w_x + w_y * w_y
        if square < least and (x != at.x or y != at.y):
            found, least, next_least = i, square, least
        else:
            next_least = min(next_least, square)
    return found, sqrt(least), sqrt(next_least) / 4.0


@compiled
def refined(effects, at, x, y, now, blur):
    """Psi, with the friction of a support point that barely moves taken from the balance of torques.

    It is not found if that point does not balance the torque: near it the torque is so steep that any step
    is small.
    """
    if count_points(effects) > 0:
        i, least, apart = _nearest(effects, at, now.v_x, now.v_y, now.spin)
        if least <= NEAR * (sqrt(x * x + y * y) + at.reach * abs(now.spin)) and least < apart:
            exact = about_point(effects, at, x, y, i, pivot_spin(effects, at, x, y, i), blur)
            if exact.found and exact.point >= 0:
                return exact
            return about_point(effects, at, x, y, i, now.spin, blur)
    return now


@compiled
def pivot_spin(effects, at, x, y, i):
    """The rotation for which a support point moves at most along its line to the contact."""
    p_x, p_y = place(effects, i)
    r_x, r_y = p_x - at.x, p_y - at.y
    return (x * r_y - y * r_x) / (r_x * r_x + r_y * r_y)


@compiled
def about_point(effects, at, x, y, i, spin, blur):
    """Psi of a rotation exactly or nearly about a support point, which balances the remaining torque.

    The direction in which a point that barely moves does so is lost in the rounding of the twist. Let r be
    the position of the point from the contact. The component of its friction across r follows from the
    torques, and the component along r from its share, in the sense of its motion along r, ``u . r``. If
    ``u . r`` is zero to rounding, or to within `blur` relative to the motion, the slider pivots about the
    point, and the component along r has an interval of values.
    """
    p_x, p_y = place(effects, i)
    r_x, r_y = p_x - at.x, p_y - at.y
    reach = sqrt(r_x * r_x + r_y * r_y)
    r_x, r_y = r_x / reach, r_y / reach
    ahead, aside = x * r_x + y * r_y, reach * spin - (x * r_y - y * r_x)
    if abs(ahead) <= max(ROUNDING * (abs(x * r_x) + abs(y * r_y)), blur * (abs(x) + abs(y))):
        ahead = 0.0
    w_x, w_y = ahead * r_x - aside * r_y, ahead * r_y + aside * r_x
    v_x, v_y = w_x + spin * p_y, w_y - spin * p_x
    rounding = ROUNDING * abs(spin) * (reach + at.reach)
    now = about(effects, at, v_x, v_y, spin, 2.0 * (abs(ahead) + abs(aside)) + rounding)
    found = now.point == i and abs(now.torque) <= now.most * reach * (1.0 + BALANCED)
    part = min(max(-now.torque / reach, -now.most), now.most)
    free = sqrt(now.most * now.most - part * part)
    f_x, f_y = now.f_x - part * r_y, now.f_y + part * r_x
    # A change of the direction of motion changes the friction along n, across itself; more so if it is
    # slow.
    slack, n_x, n_y, turns = 0.0, -r_y, r_x, reach
    slides = abs(aside) > rounding and free <= SHORT * now.most
    if ahead != 0.0 or slides:
        sense = copysign(1.0, ahead) if ahead != 0.0 else 0.0
        f_x, f_y = f_x + sense * free * r_x, f_y + sense * free * r_y
        n_x = (-free * r_y - sense * part * r_x) / now.most
        n_y = (free * r_x - sense * part * r_y) / now.most
        slack = (
            abs(ahead) / free if free > SHORT * now.most else (abs(ahead) + abs(aside)) / now.most
        )
        turns = reach * free / now.most
    whole = slack * now.ss + turns * turns
    whole = whole if whole > 0.0 else inf  # nothing resists the rotation
    turn_x, turn_y = (
        -(slack * now.xs + turns * n_x) / whole,
        -(slack * now.ys + turns * n_y) / whole,
    )
    # A rounding error of the component across r is amplified in the component along r if that is short.
    noise = 4.0 * ROUNDING * (abs(now.f_x) + abs(now.f_y) + now.most + abs(part))
    along = noise * abs(part) / max(free, SHORT * now.most)
    pivots = 0.0 if ahead != 0.0 or abs(aside) > rounding else 1.0
    return Psi(
        v_x, v_y, spin, f_x, f_y,
        now.xx + (n_x * n_x * now.ss - turns * n_x * now.xs) / whole + turn_x * now.xs,
        now.xy + (n_x * n_y * now.ss - turns * n_y * now.xs) / whole + turn_x * now.ys,
        now.yy + (n_y * n_y * now.ss - turns * n_y * now.ys) / whole + turn_y * now.ys,
        turn_x, turn_y, pivots * free * r_x, pivots * free * r_y, i if pivots > 0.0 else NOWHERE,
        noise + along * abs(r_x), noise + along * abs(r_y), False, found,
    )  # fmt: skip
