"""The contact, the slider's resistance about it, and the reduced potential at a root for the rotation."""

from __future__ import annotations

from math import fabs, sqrt
from typing import NamedTuple

from planar_pushing.core.numbers import UNKNOWN
from planar_pushing.core.supports.resistance import Resistance, resistance
from planar_pushing.core.supports.rows import Effects
from planar_pushing.core.supports.tolerances import ALIGNED


class Contact(NamedTuple):
    """Position of the contact in the body frame.

    `reach` is its distance from the origin, and (a_x, a_y) the direction in which the origin moves in a
    rotation about the contact. `spin` is the rotation of a side that stays on the fence, NaN if the slider
    can rotate about the contact.
    """

    x: float
    y: float
    reach: float
    a_x: float
    a_y: float
    spin: float


def contact_at(x: float, y: float) -> Contact:
    """The contact at a position in the body frame."""
    reach = sqrt(x * x + y * y)
    if reach > 0.0:
        return Contact(x, y, reach, a_x=y / reach, a_y=-x / reach, spin=UNKNOWN)
    return Contact(x, y, reach=0.0, a_x=1.0, a_y=0.0, spin=UNKNOWN)


def hold_rotation(contact: Contact, spin: float) -> Contact:
    """A contact about which the slider cannot rotate freely: a side that stays on the fence."""
    return Contact(contact.x, contact.y, contact.reach, contact.a_x, contact.a_y, spin)


def is_held(contact: Contact) -> bool:
    """Whether the rotation of the slider is given."""
    return contact.spin == contact.spin


def is_at_contact(contact: Contact, x: float, y: float) -> bool:
    """Whether a position is that of the contact, to the rounding of the body frame."""
    return fabs(x - contact.x) + fabs(y - contact.y) <= ALIGNED * contact.reach


def resistance_about(
    effects: Effects, contact: Contact, x: float, y: float, spin: float, blur: float
) -> Resistance:
    """`Resistance` about the contact at a twist (x, y, spin) of the origin."""
    total = resistance(effects, x, y, spin, blur)
    a, b = contact.y, -contact.x
    xs = total.xs + a * total.xx + b * total.xy
    ys = total.ys + a * total.xy + b * total.yy
    return Resistance(
        total.f_x,
        total.f_y,
        torque=total.torque + (a * total.f_x + b * total.f_y),
        xx=total.xx,
        xy=total.xy,
        yy=total.yy,
        xs=xs,
        ys=ys,
        ss=total.ss + a * (total.xs + xs) + b * (total.ys + ys),
        limit=total.limit,
        point=total.point,
        terms=total.terms,
    )
