"""How the contact answers forces and impulses through the slider's inertia.

A force f at the contact accelerates it by ``G f`` with ``G = I / m + (l^2 / J) e e^T``, where `e` is the
rod's right-hand normal.
"""

from __future__ import annotations

from math import cos, sin
from typing import NamedTuple

from planar_pushing.mechanics.compiled import compiled


class ContactInertia(NamedTuple):
    """The symmetric matrix G, along the fence and normal to it."""

    xx: float
    xy: float
    yy: float


@compiled
def contact_inertia(body, angle):
    """G at a rod angle."""
    turn, shift = body.length * body.length / body.moment, 1.0 / body.mass
    e_x, e_y = sin(angle), -cos(angle)
    return ContactInertia(shift + turn * e_x * e_x, turn * e_x * e_y, shift + turn * e_y * e_y)


@compiled
def motion_of(inertia, f_x, f_y):
    """Acceleration of the contact under a force."""
    return inertia.xx * f_x + inertia.xy * f_y, inertia.xy * f_x + inertia.yy * f_y


@compiled
def force_of(inertia, a_x, a_y):
    """Force that accelerates the contact."""
    determinant = inertia.xx * inertia.yy - inertia.xy * inertia.xy
    return (
        (inertia.yy * a_x - inertia.xy * a_y) / determinant,
        (inertia.xx * a_y - inertia.xy * a_x) / determinant,
    )
