"""How the contact point answers forces and impulses through the slider's inertia.

A force f at the contact accelerates it by ``G f`` with ``G = I / m + (L^2 / J) e e^T``, where `e` is the
rod's right-hand normal.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.simulation.setting import Setting, Vector


class ContactInertia(NamedTuple):
    """The symmetric matrix G, along the fence and normal to it."""

    xx: float
    xy: float
    yy: float

    def apply(self, force: Vector) -> Vector:
        """Acceleration of the contact under a force."""
        return self.xx * force[0] + self.xy * force[1], self.xy * force[0] + self.yy * force[1]

    def solve(self, motion: Vector) -> Vector:
        """Force that accelerates the contact by `motion`."""
        determinant = self.xx * self.yy - self.xy * self.xy
        return (
            (self.yy * motion[0] - self.xy * motion[1]) / determinant,
            (self.xx * motion[1] - self.xy * motion[0]) / determinant,
        )


def contact_inertia(setting: Setting, rod_angle: float) -> ContactInertia:
    """G at a rod angle."""
    turn, shift = setting.length**2 / setting.moment, 1.0 / setting.mass
    e_x, e_y = math.sin(rod_angle), -math.cos(rod_angle)
    return ContactInertia(shift + turn * e_x * e_x, turn * e_x * e_y, shift + turn * e_y * e_y)


class Instant(NamedTuple):
    """What the forces at one instant follow from.

    Attributes
    ----------
    velocity : (v_x, v_y)
        Of the ring centre.
    fence, turn : (x, y)
        Velocity and acceleration of the fence.
    free : (x, y)
        Acceleration of the contact without a contact force, relative to that of the fence.
    resistance : (f_x, f_y, torque)
        Friction on the support.
    powers : tuple of float
        What each effect of degree 1 dissipates.
    inertia : ContactInertia
    """

    velocity: Vector
    fence: Vector
    turn: Vector
    free: Vector
    resistance: tuple[float, float, float]
    powers: tuple[float, ...]
    inertia: ContactInertia


class Impulse(NamedTuple):
    """A consistent impulse at the contact, and the contact's velocity over the fence after it."""

    kind: ContactMode
    impulse: Vector
    after: Vector


def impulses(
    setting: Setting, inertia: ContactInertia, before: Vector, slack: float
) -> list[Impulse]:
    """Every inelastic impulse that the contact law admits.

    Parameters
    ----------
    before : (r_t, r_n)
        Velocity of the contact relative to the fence; it approaches where ``r_n < 0``.
    slack : float
        Velocities below it are zero.

    Returns
    -------
    list of Impulse
        None (the contact already parts), one that ends the relative motion, and those on an edge of the
        friction cone after which the contact slips away from it. Friction of the support is finite and has
        no part in it.
    """
    found = []
    if before[1] >= -slack:
        found.append(Impulse(ContactMode.SEPARATE, (0.0, 0.0), before))
    stop = inertia.solve((-before[0], -before[1]))
    margin = setting.holds(*stop, 0.0) if stop != (0.0, 0.0) else 0.0
    if margin >= (-1e-12 if setting.closed else 1e-12):
        found.append(Impulse(ContactMode.STICK, stop, (0.0, 0.0)))
    elif setting.slips:
        found += _slipping(setting, inertia, before, slack)
    return found


def _slipping(
    setting: Setting, inertia: ContactInertia, before: Vector, slack: float
) -> list[Impulse]:
    found = []
    for kind, edge in setting.edges.items():
        along, normal = inertia.apply(edge)
        size = -before[1] / normal if normal else 0.0
        after = before[0] + size * along
        side = 1.0 if kind is ContactMode.SLIP_RIGHT else -1.0
        if size > 0.0 and side * after > slack:
            found.append(Impulse(kind, (size * edge[0], size * edge[1]), (after, 0.0)))
    return found
