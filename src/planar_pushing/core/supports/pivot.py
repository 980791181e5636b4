"""Motions exactly or nearly about a support point, whose friction follows from the balance of torques."""

from __future__ import annotations

from math import copysign, fabs, sqrt

from planar_pushing.core.numbers import INFINITY
from planar_pushing.core.supports.contact import Contact, is_at_contact, resistance_about
from planar_pushing.core.supports.potential import Psi, unknown_psi
from planar_pushing.core.supports.rows import NO_POINT, Effects, foot_position
from planar_pushing.core.supports.tolerances import (
    BALANCED,
    BARELY,
    LIMITED,
    ROUNDING,
    SHARE,
    SMALL_PART,
)


def pivot_spin(effects: Effects, contact: Contact, x: float, y: float, point: int) -> float:
    """The rotation for which a support point has no motion across its line to the contact."""
    foot = foot_position(effects, point)
    r_x, r_y = foot.x - contact.x, foot.y - contact.y
    return (x * r_y - y * r_x) / (r_x * r_x + r_y * r_y)


def refine_psi(
    effects: Effects, contact: Contact, x: float, y: float, root: Psi, tolerance: float
) -> Psi:
    """Psi, with the friction of a support point that barely moves taken from the balance of torques.

    It has not converged if that point does not balance the torque: near the point, the torque is so steep
    that any Newton step is small.
    """
    slowest, square, next_square = NO_POINT, INFINITY, INFINITY
    for i in range(effects.feet):
        foot = foot_position(effects, i)
        w_x, w_y = root.v_x - root.spin * foot.y, root.v_y + root.spin * foot.x
        speed = w_x * w_x + w_y * w_y
        if speed < square and not is_at_contact(contact, foot.x, foot.y):
            slowest, square, next_square = i, speed, square
        else:
            next_square = min(next_square, speed)
    if slowest < 0:
        return root
    speed, size = sqrt(square), sqrt(x * x + y * y) + contact.reach * fabs(root.spin)
    if speed > BARELY * size or speed >= sqrt(next_square) / 4.0:
        return root
    spin = pivot_spin(effects, contact, x, y, slowest)
    exact = pivot_psi(effects, contact, x, y, slowest, spin, tolerance)
    if exact.converged and exact.point >= 0:
        return exact
    return pivot_psi(effects, contact, x, y, slowest, root.spin, tolerance)


def pivot_psi(
    effects: Effects, contact: Contact, x: float, y: float,
    point: int, spin: float, tolerance: float,
) -> Psi:  # fmt: skip
    """Psi of a rotation exactly or nearly about a support point, which balances the remaining torque.

    The direction of motion of a point that barely moves is lost in the rounding of the twist. Let r be the
    position of the point from the contact. The component of its friction across r follows from the torques.
    The component along r follows from the magnitude of the friction, and has the sense of the motion along
    r, ``u . r``. If ``u . r`` is zero to rounding, or to within `tolerance` relative to the motion, the
    slider pivots about the point, and the component along r is undetermined within an interval.
    """
    foot = foot_position(effects, point)
    r_x, r_y = foot.x - contact.x, foot.y - contact.y
    reach = sqrt(r_x * r_x + r_y * r_y)
    r_x, r_y = r_x / reach, r_y / reach
    ahead, across = x * r_x + y * r_y, reach * spin - (x * r_y - y * r_x)
    if fabs(ahead) <= max(
        ROUNDING * (fabs(x * r_x) + fabs(y * r_y)), tolerance * (fabs(x) + fabs(y))
    ):
        ahead = 0.0
    w_x, w_y = ahead * r_x - across * r_y, ahead * r_y + across * r_x
    v_x, v_y = w_x + spin * foot.y, w_y - spin * foot.x
    rounding = ROUNDING * fabs(spin) * (reach + contact.reach)
    blur = 2.0 * (fabs(ahead) + fabs(across)) + rounding
    rest = resistance_about(effects, contact, x=v_x, y=v_y, spin=spin, blur=blur)
    limit = rest.limit
    if limit == 0.0:
        return unknown_psi()
    pivots: bool = ahead == 0.0 and fabs(across) <= rounding
    # The rotation is known to rounding, and so is the torque of everything else.
    excess = LIMITED if pivots else BALANCED
    most = limit * reach * (1.0 + excess) + SHARE * rest.ss * fabs(spin)
    balances: bool = rest.point == point and fabs(rest.torque) <= most
    part = min(max(-rest.torque / reach, -limit), limit)
    half = sqrt(limit * limit - part * part)
    f_x, f_y = rest.f_x - part * r_y, rest.f_y + part * r_x
    # A change of the point's direction of motion changes its friction along n, at right angles to it, and
    # does so more the slower the point is.
    slack, n_x, n_y, turns = 0.0, -r_y, r_x, reach
    slides: bool = fabs(across) > rounding and half <= SMALL_PART * limit
    if ahead != 0.0 or slides:
        sense = copysign(1.0, ahead) if ahead != 0.0 else 0.0
        f_x, f_y = f_x + sense * half * r_x, f_y + sense * half * r_y
        n_x = (-half * r_y - sense * part * r_x) / limit
        n_y = (half * r_x - sense * part * r_y) / limit
        slack = (fabs(ahead) + fabs(across)) / limit
        if half > SMALL_PART * limit:
            slack = fabs(ahead) / half
        turns = reach * half / limit
    stiff = slack * rest.ss + turns * turns
    stiff = stiff if stiff > 0.0 else INFINITY  # nothing resists the rotation
    turn_x = -(slack * rest.xs + turns * n_x) / stiff
    turn_y = -(slack * rest.ys + turns * n_y) / stiff
    # A rounding error of the component across r is amplified in the component along r if that is small.
    noise = 4.0 * ROUNDING * (fabs(rest.f_x) + fabs(rest.f_y) + limit + fabs(part))
    along = noise * fabs(part) / max(half, SMALL_PART * limit)
    if ahead == 0.0 and not pivots:
        along = 0.0  # there is none
    return Psi(
        v_x,
        v_y,
        spin,
        f_x,
        f_y,
        xx=rest.xx + (n_x * n_x * rest.ss - turns * n_x * rest.xs) / stiff + turn_x * rest.xs,
        xy=rest.xy + (n_x * n_y * rest.ss - turns * n_y * rest.xs) / stiff + turn_x * rest.ys,
        yy=rest.yy + (n_y * n_y * rest.ss - turns * n_y * rest.ys) / stiff + turn_y * rest.ys,
        turn_x=turn_x,
        turn_y=turn_y,
        half_x=half * r_x if pivots else 0.0,
        half_y=half * r_y if pivots else 0.0,
        point=point if pivots else NO_POINT,
        noise_x=noise + along * fabs(r_x),
        noise_y=noise + along * fabs(r_y),
        continuum=False,
        converged=balances,
    )
