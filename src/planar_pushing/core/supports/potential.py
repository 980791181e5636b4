"""The reduced potential of a contact at one motion, from the resistance there."""

from __future__ import annotations

from math import fabs
from typing import NamedTuple

from planar_pushing.core.numbers import UNKNOWN
from planar_pushing.core.supports.contact import Contact, resistance_about
from planar_pushing.core.supports.resistance import Resistance
from planar_pushing.core.supports.rows import NO_POINT, Effects
from planar_pushing.core.supports.tolerances import ROUNDING


class Psi(NamedTuple):
    """Motion of the slider for a given motion of the contact, and gradient and Hessian of Psi there.

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
    half_x, half_y : float
        Half of a pivot's interval of forces, otherwise zero.
    point : int
        Number of the support point about which the slider pivots, -1 without one.
    noise_x, noise_y : float
        Rounding errors of the force.
    continuum : bool
        Whether the rotation is one of an interval of rotations that all have this force.
    converged : bool
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
    half_x: float
    half_y: float
    point: int
    noise_x: float
    noise_y: float
    continuum: bool
    converged: bool


def held_potential(effects: Effects, contact: Contact, x: float, y: float) -> Psi:
    """Psi at a motion of a contact with a given rotation."""
    spin = contact.spin
    v_x, v_y = x + spin * contact.y, y - spin * contact.x
    total = resistance_about(effects, contact, x=v_x, y=v_y, spin=spin, blur=0.0)
    # Without a resistance to rotation, `potential_at` eliminates none.
    total = Resistance(
        total.f_x,
        total.f_y,
        total.torque,
        total.xx,
        total.xy,
        total.yy,
        xs=0.0,
        ys=0.0,
        ss=0.0,
        limit=0.0,
        point=NO_POINT,
        terms=total.terms,
    )
    return potential_at(
        total, contact, v_x, v_y, spin, step=0.0, x=x, y=y, size=0.0, converged=True
    )


def potential_at(
    total: Resistance, contact: Contact, v_x: float, v_y: float, spin: float, step: float,
    x: float, y: float, size: float, converged: bool,
) -> Psi:  # fmt: skip
    """Psi at a root, extrapolated by the last Newton step, for an unknown of magnitude `size`."""
    turn_x, turn_y = 0.0, 0.0
    if total.ss > 0.0:
        turn_x, turn_y = -total.xs / total.ss, -total.ys / total.ss
    xx, xy = total.xx + turn_x * total.xs, total.xy + turn_x * total.ys
    yy = total.yy + turn_y * total.ys
    f_x, f_y = total.f_x + step * total.xs, total.f_y + step * total.ys
    # The torque has the rounding error of its terms. The rotation has that error and its own rounding.
    lever = (1.0 + contact.reach) * (fabs(contact.a_x * f_x) + fabs(contact.a_y * f_y))
    noise_x = total.terms + fabs(f_x) + fabs(xx * x) + fabs(xy * y)
    noise_y = total.terms + fabs(f_y) + fabs(xy * x) + fabs(yy * y)
    noise_x += lever * fabs(turn_x) + (size + fabs(step)) * fabs(total.xs)
    noise_y += lever * fabs(turn_y) + (size + fabs(step)) * fabs(total.ys)
    carried = step * contact.reach
    return Psi(
        v_x=v_x + carried * contact.a_x,
        v_y=v_y + carried * contact.a_y,
        spin=spin + step,
        f_x=f_x,
        f_y=f_y,
        xx=xx,
        xy=xy,
        yy=yy,
        turn_x=turn_x,
        turn_y=turn_y,
        half_x=0.0,
        half_y=0.0,
        point=NO_POINT,
        noise_x=ROUNDING * noise_x,
        noise_y=ROUNDING * noise_y,
        continuum=False,
        converged=converged,
    )


def unknown_psi() -> Psi:
    """A `Psi` marked as not converged."""
    return Psi(
        v_x=UNKNOWN,
        v_y=UNKNOWN,
        spin=UNKNOWN,
        f_x=UNKNOWN,
        f_y=UNKNOWN,
        xx=UNKNOWN,
        xy=UNKNOWN,
        yy=UNKNOWN,
        turn_x=UNKNOWN,
        turn_y=UNKNOWN,
        half_x=0.0,
        half_y=0.0,
        point=NO_POINT,
        noise_x=UNKNOWN,
        noise_y=UNKNOWN,
        continuum=False,
        converged=False,
    )
