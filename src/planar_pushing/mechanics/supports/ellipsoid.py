"""The ellipsoid that planners put in place of a support, and what it costs."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi, sqrt

import numpy as np

from planar_pushing.mechanics.compiled import compiled, kernel
from planar_pushing.mechanics.supports.base import Position, Support
from planar_pushing.mechanics.supports.moments import moments
from planar_pushing.mechanics.supports.pressure.assembly import assembled
from planar_pushing.mechanics.supports.pressure.record import Array
from planar_pushing.mechanics.supports.pressure.table import extent_of

#: Motions at which the ellipsoid is compared; means differ by less than 1e-4 from those at ten times more.
MOTIONS = 20_000
#: Turn between motions that follow each other, which spreads them evenly: the golden angle.
GOLDEN = pi * (3.0 - sqrt(5.0))


@dataclass(frozen=True, slots=True, kw_only=True)
class EllipsoidFit:
    """Ellipsoid in place of a support's limit surface, and its errors.

    Parameters
    ----------
    center : pair of float
        Centre of pressure, in the body frame, about which torques are taken.
    extent : float
        Largest distance a of the support from it.
    integration_constant : float
        c, the torque of spinning about the centre of pressure over weight and extent.
    matrix : array, shape (3, 3)
        M: wrenches (f_x, f_y, tau) that slide satisfy ``w . M w = 1``, per unit weight, and the motion
        (v_x, v_y, omega) is along M w. Diagonal: 1, 1, ``1 / (c a)^2``.
    worst_force_error, mean_force_error : float
        Angle in radians between the wrenches (f_x, f_y, tau / a) of the support and of the ellipsoid for
        the same motion.
    worst_motion_error, mean_motion_error : float
        Angle in radians between the motions (v_x, v_y, a omega) of the support and of the ellipsoid for the
        same wrench, that which the support exerts in its motion.

    Notes
    -----
    Errors are taken over motions spread evenly over the sphere of (v_x, v_y, a omega), where v is the
    velocity of the centre of pressure; the worst is the largest of them.
    """

    center: Position
    extent: float
    integration_constant: float
    matrix: Array
    worst_force_error: float
    mean_force_error: float
    worst_motion_error: float
    mean_motion_error: float


def fit_ellipsoid(support: Support) -> EllipsoidFit:
    """Ellipsoid with the support's friction in translation and in spinning about the centre of pressure.

    Parameters
    ----------
    support : Support

    Returns
    -------
    EllipsoidFit
        ``f_x^2 + f_y^2 + tau^2 / (c a)^2 = W^2``, and its errors against the support.

    Raises
    ------
    InvalidValue
        Where the support is one point, which resists no rotation.
    """
    extent = extent_of(support)
    pressure = assembled(support.pieces(), extent)
    constant = moments(pressure, pressure.center_x, pressure.center_y).torque
    force, motion = np.empty(MOTIONS), np.empty(MOTIONS)
    _errors(pressure, constant, force, motion)
    return EllipsoidFit(
        center=support.center_of_pressure,
        extent=extent,
        integration_constant=float(constant),
        matrix=np.diag([1.0, 1.0, 1.0 / (constant * extent) ** 2]),
        worst_force_error=float(force.max()),
        mean_force_error=float(force.mean()),
        worst_motion_error=float(motion.max()),
        mean_motion_error=float(motion.mean()),
    )


@kernel
@compiled
def _errors(pressure, constant, force, motion):
    """Angles between the support and the ellipsoid at motions spread over half a sphere.

    The other half has the opposite motions and wrenches, and the same angles.
    """
    square = constant * constant
    for i in range(len(force)):
        spin, turn = (i + 0.5) / len(force), i * GOLDEN
        speed = sqrt(1.0 - spin * spin)
        v_x, v_y = speed * np.cos(turn), speed * np.sin(turn)
        c_x, c_y = pressure.center_x - v_y / spin, pressure.center_y + v_x / spin
        found = moments(pressure, c_x, c_y)
        f_x, f_y, torque = -found.unit_y, found.unit_x, found.torque
        force[i] = _angle(f_x, f_y, torque, v_x, v_y, square * spin)
        motion[i] = _angle(v_x, v_y, spin, f_x, f_y, torque / square)


@compiled
def _angle(a_x, a_y, a_z, b_x, b_y, b_z):
    """Angle between two vectors of space, accurate where it is small."""
    x, y, z = a_y * b_z - a_z * b_y, a_z * b_x - a_x * b_z, a_x * b_y - a_y * b_x
    return np.arctan2(sqrt(x * x + y * y + z * z), a_x * b_x + a_y * b_y + a_z * b_z)
