"""The ellipsoid that planners use in place of a support, and its error."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import pi, sqrt
from typing import Any

import numpy as np

from planar_pushing.mechanics.kernels.arrays import same
from planar_pushing.mechanics.pressure.pieces import Array
from planar_pushing.mechanics.pressure.table import Table, extent_of, moments, table_of
from planar_pushing.mechanics.supports.base import Position, Support, require_support

#: Number of motions at which the ellipsoid is compared; ten times as many change the means by under 1e-4.
MOTIONS = 20_000
#: Angle between successive motions, which spreads them evenly: the golden angle.
GOLDEN = pi * (3.0 - sqrt(5.0))
#: Number of motions from which, and of directions in which, the maxima are searched; and the steps of a
#: search, in radians: the first, which is the distance between motions, the last, and their maximum number.
STARTS, DIRECTIONS = 12, 16
FIRST, LAST, STEPS = 0.02, 1e-13, 400
#: Distance of a center of rotation beside a foot, where the foot has full friction, relative to the numbers
#: from which it is computed.
BESIDE = 1e-12
#: Smallest spin of a motion with a velocity of 1.
SLOWEST_SPIN = 1e-9


@dataclass(frozen=True, slots=True, kw_only=True)
class EllipsoidFit:
    """Ellipsoid in place of a support's limit surface, and its errors.

    Parameters
    ----------
    center : pair of float
        Center of pressure, in the body frame, about which torques are taken.
    extent : float
        Largest distance a of the support from the center of pressure.
    integration_constant : float
        c, the torque of spinning about the center of pressure divided by weight and extent.
    matrix : array, shape (3, 3)
        M: wrenches (f_x, f_y, tau) of sliding satisfy ``w . M w = 1``, per unit weight, and the motion
        (v_x, v_y, omega) is along M w. Diagonal: 1, 1, ``1 / (c a)^2``.
    worst_force_error, mean_force_error : float
        Angle in radians between the wrenches (f_x, f_y, tau / a) of the support and of the ellipsoid for
        the same motion.
    worst_motion_error, mean_motion_error : float
        Angle in radians between the motions (v_x, v_y, a omega) of the support and of the ellipsoid for the
        same wrench, the one that sustains the motion of the support.

    Notes
    -----
    Means are taken over motions spread evenly over the sphere of (v_x, v_y, a omega), where v is the
    velocity of the center of pressure. The worst errors are maxima over all motions and the wrenches that
    sustain them. Many wrenches sustain a rotation about a foot; the largest angle is at one of those with
    full friction at the foot.
    """

    center: Position
    extent: float
    integration_constant: float
    matrix: Array
    worst_force_error: float
    mean_force_error: float
    worst_motion_error: float
    mean_motion_error: float

    def __eq__(self, other: object) -> Any:
        return same(self, other)


def fit_ellipsoid(support: Support) -> EllipsoidFit:
    """Ellipsoid that matches a support in translation and in spinning about the center of pressure.

    Parameters
    ----------
    support : Support

    Returns
    -------
    EllipsoidFit
        ``f_x^2 + f_y^2 + tau^2 / (c a)^2 = W^2`` with tau about the center of pressure, and its errors
        relative to the support.

    Raises
    ------
    InvalidValue
        If the argument is not a support, or is a single point, which resists no rotation.
    """
    require_support("support", support)
    extent, table = extent_of(support), table_of([support])
    constant = float(moments(table, *table.centers[0]).torque)

    def errors(motions: Array) -> Array:
        return ellipsoid_errors(table, constant, motions)

    motions = spread_motions(MOTIONS)
    force, motion = errors(motions)
    return EllipsoidFit(
        center=support.center_of_pressure,
        extent=extent,
        integration_constant=constant,
        matrix=np.diag([1.0, 1.0, 1.0 / (constant * extent) ** 2]),
        worst_force_error=_worst(lambda trial: errors(trial)[0], motions, force, table),
        mean_force_error=float(force.mean()),
        worst_motion_error=_worst(lambda trial: errors(trial)[1], motions, motion, table),
        mean_motion_error=float(motion.mean()),
    )


def spread_motions(count: int) -> Array:
    """Motions spread evenly over a hemisphere, shape (count, 3).

    The other hemisphere has the opposite motions and wrenches, and the same angles.
    """
    index = np.arange(count)
    spin, turn = (index + 0.5) / count, index * GOLDEN
    speed = np.sqrt(1.0 - spin * spin)
    return np.column_stack([speed * np.cos(turn), speed * np.sin(turn), spin])


def _worst(error: Callable[[Array], Array], motions: Array, errors: Array, table: Table) -> float:
    """Maximum of an error, searched from the largest of `errors` at `motions` and around every foot."""

    def of_motion(vectors: Array) -> Array:
        upper = np.where(vectors[..., 2:] < 0.0, -vectors, vectors)
        return error(upper / np.linalg.norm(upper, axis=-1, keepdims=True))

    def beside_feet(turn: Array) -> Array:
        to_feet = np.expand_dims(feet, tuple(range(1, turn.ndim - 1)))
        away = to_feet + beside * np.concatenate([np.cos(turn), np.sin(turn)], axis=-1)
        return of_motion(np.stack([away[..., 1], -away[..., 0], np.ones(away.shape[:-1])], axis=-1))

    half = spread_motions(DIRECTIONS)
    worst = _climb(
        of_motion, motions[np.argsort(errors)[-STARTS:]], FIRST, np.concatenate([half, -half])
    )
    center = table.centers[0]
    feet, beside = table.atoms(0)[:, :2] - center, BESIDE * (1.0 + np.abs(center).sum())
    if not len(feet):
        return worst
    around = np.linspace(-pi, pi, DIRECTIONS)[:, None]
    return max(worst, _climb(beside_feet, np.zeros((len(feet), 1)), 1.0, around))


def _climb(value: Callable[[Array], Array], start: Array, step: float, directions: Array) -> float:
    """Largest value that a climb from each start reaches; a step without a gain is halved.

    Parameters
    ----------
    value : callable
        Function of arrays of places, shape (n, ..., d).
    start : ndarray, shape (n, d)
    step : float
    directions : ndarray, shape (m, d)
    """
    points, best, sizes = start, value(start), np.full(len(start), step)
    every = np.arange(len(start))
    for _ in range(STEPS):
        tried = points[:, None] + sizes[:, None, None] * directions
        values = value(tried)
        best_trial = values.argmax(axis=1)
        better = values[every, best_trial] > best
        points = np.where(better[:, None], tried[every, best_trial], points)
        best, sizes = (
            np.maximum(best, values[every, best_trial]),
            np.where(better, sizes, sizes / 2.0),
        )
        if sizes.max() < LAST:
            break
    return float(best.max())


def ellipsoid_errors(table: Table, constant: float, motions: Array) -> Array:
    """Angles between a support and its ellipsoid at counterclockwise motions.

    Parameters
    ----------
    table : Table
        Of the support, in units of its extent.
    constant : float
        Torque of spinning about the center of pressure.
    motions : ndarray, shape (..., 3)
        Velocity of the center of pressure, and spin.

    Returns
    -------
    ndarray, shape (2, ...)
        Angle between the forces of a motion, and between the motions under the force.
    """
    (p_x, p_y), square = table.centers[0], constant * constant
    v_x, v_y, spin = np.moveaxis(motions, -1, 0)
    spin = np.maximum(spin, SLOWEST_SPIN)
    total = moments(table, p_x - v_y / spin, p_y + v_x / spin)
    force_x, force_y, torque = -total.unit_y, total.unit_x, total.torque
    force = _angle((force_x, force_y, torque), (v_x, v_y, square * spin))
    motion = _angle((v_x, v_y, spin), (force_x, force_y, torque / square))
    return np.stack([force, motion])


def _angle(one: tuple[Array, Array, Array], other: tuple[Array, Array, Array]) -> Array:
    """Angle between vectors in space, accurate also when it is small."""
    (a_x, a_y, a_z), (b_x, b_y, b_z) = one, other
    x, y, z = a_y * b_z - a_z * b_y, a_z * b_x - a_x * b_z, a_x * b_y - a_y * b_x
    angle: Array = np.arctan2(np.sqrt(x * x + y * y + z * z), a_x * b_x + a_y * b_y + a_z * b_z)
    return angle
