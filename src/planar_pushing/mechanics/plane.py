r"""Geometry of the plane: frame, signs and the kinematics of a pushed slider.

::

                       ring (radius R, center c)
             y'  y   .-'''-.            psi   rod angle
               \ |  /   c   \           l     rod length, from the contact to the slider's center
                \|  \  /    /           phi   force angle: f points along (cos phi, sin phi)
                 |   `/....'            n     outward normal of the fence = +y
                 |   / rod              theta angle of a velocity or an acceleration
                 |  / ) psi             all angles from +x (the fence), counter-clockwise
   --------------+-*----------- x
         fence     contact = free end of the rod, origin of all positions; slider above the fence

A twist is ``(v_x, v_y, omega)`` and a wrench ``(f_x, f_y, tau)``, both at the slider's center. `f` is
the force of the pusher on the slider. The moment arm ``h = l sin(psi - phi)`` is the signed distance of
the line of force from the slider's center, and the spin ratio ``k = R omega / v`` compares the rotation
with the center's speed `v` along `f`. "Motion" is velocity in a quasi-static scene and initial
acceleration from rest otherwise. Angles are radians. The compiled core has lengths in units of R.
"""

from __future__ import annotations

from math import atan2, copysign, cos, hypot, inf, isinf, pi, sin
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.compiled import compiled, kernel

Array = npt.NDArray[np.float64]

QUARTER_TURN = pi / 2
#: Rounding error of the direction of a translation, in radians, and of R omega relative to the speed.
ALONG = 1e-15


class Rod(NamedTuple):
    """Length in radii, angle, and unit vector from the contact to the slider's center."""

    length: float
    angle: float
    x: float
    y: float


class Seen(NamedTuple):
    """An angle and its unit vector along the rod and along the rod's right-hand normal."""

    angle: float
    along: float
    aside: float


class Direction(NamedTuple):
    """As `Seen`, and the unit vector along x and y."""

    angle: float
    x: float
    y: float
    along: float
    aside: float


@compiled
def is_quarter(angle):
    """Whether an angle is the double nearest to a multiple of 90 degrees."""
    return np.rint(angle / QUARTER_TURN) * QUARTER_TURN == angle


@compiled
def unit_vector(angle):
    """Unit vector at an angle, exact if the angle is the double nearest to a multiple of 90 degrees.

    A fence that moves along its own line then has exactly zero normal motion.
    """
    x, y = cos(angle), sin(angle)
    if is_quarter(angle):
        return np.rint(x), np.rint(y)
    return x, y


@compiled
def rod(length, angle):
    """The rod of a slider."""
    x, y = unit_vector(angle)
    return Rod(length, angle, x, y)


@compiled
def seen(own, angle):
    """The direction at an angle, relative to a rod.

    If the direction or the rod is along an axis, the products of the components are exact. Elsewhere these
    products cancel, so the difference of the angles, corrected for the rounding error of the subtraction,
    is used instead: a long rod multiplies an error by its length.
    """
    if is_quarter(angle) or own.x == 0.0 or own.y == 0.0:
        x, y = unit_vector(angle)
        return Seen(angle, x * own.x + y * own.y, x * own.y - y * own.x)
    lean = own.angle - angle
    back = lean - own.angle
    rounding = (own.angle - (lean - back)) - (angle + back)
    c, s = cos(lean), sin(lean)
    return Seen(angle, c - rounding * s, s + rounding * c)


@compiled
def toward(own, angle):
    """The direction at an angle, also along x and y; it costs twice the sines and cosines of `seen`."""
    x, y = unit_vector(angle)
    _, along, aside = seen(own, angle)
    return Direction(angle, x, y, along, aside)


@compiled
def moment_arm(own, force):
    """Moment arm of a line of force about the slider's center, Eq. (10): ``l sin(psi - phi)``."""
    return own.length * force.aside


@compiled
def contact_motion(own, v_x, v_y, spin):
    """Motion of the contact under a twist."""
    lever = own.length * spin
    return v_x + lever * own.y, v_y - lever * own.x


@compiled
def contact_motion_angle(own, force, spin_ratio):
    """Angle of the contact's motion, on the branch within 90 degrees of the force.

    The contact moves along ``f + k l (sin psi, -cos psi)`` (Eqs. 11-12 for inertia). Its deviation from
    `f` has a cosine proportional to ``1 + k l sin(psi - phi) >= 1``: the pusher never does negative work.
    """
    pull = spin_ratio * own.length
    if isinf(pull):
        sign = copysign(1.0, pull)
        return force.angle - atan2(sign * force.along, sign * force.aside)
    return force.angle - atan2(pull * force.along, 1.0 + pull * force.aside)


@compiled
def motion_center(own, v_x, v_y, spin):
    """Motion center relative to the contact, in radii, of a twist at the slider's center.

    A translation has its center at infinity, so the coordinates are infinite. In a translation along x or y
    the coordinate along that axis is the slider center's.
    """
    x, y = center_from(v_x, v_y, spin)
    return own.length * own.x + x, own.length * own.y + y


@compiled
def center_from(v_x, v_y, spin):
    """Motion center relative to the slider's center; a rotation of rounding size counts as zero."""
    if abs(spin) > ALONG * hypot(v_x, v_y):
        return -v_y / spin, v_x / spin
    # A translation along an axis, to rounding, has its center on the other axis.
    x = -copysign(inf, v_y) if abs(v_y) > ALONG * abs(v_x) else 0.0
    # Adding zero gives a negative zero the positive sign.
    return x, copysign(inf, v_x + 0.0) if abs(v_x) > ALONG * abs(v_y) or x == 0.0 else 0.0


@kernel
@compiled
def _unit_vectors(angles, vectors):
    for i in range(len(angles)):
        vectors[i, 0], vectors[i, 1] = unit_vector(angles[i])


def direction(angle: npt.ArrayLike) -> Array:
    """Unit vectors at `angle` (radians, shape S), shape S + (2,), as in `unit_vector`."""
    angles = np.asarray(angle, dtype=float)
    vectors = np.empty((angles.size, 2))
    _unit_vectors(np.ascontiguousarray(angles.reshape(-1)), vectors)
    return vectors.reshape(*angles.shape, 2)
