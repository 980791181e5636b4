"""Errors of the ellipsoid in place of a support, in plain doubles and by formulas of their own.

They are means and maxima over the motions that `fit_ellipsoid` names: spread over half a sphere of
(v_x, v_y, a omega) by the golden angle. Near the support D and G are sums over its pieces, by the
closed forms; the torque then loses the distance's digits, so that far away it is a plain quadrature.
"""

from __future__ import annotations

import numpy as np

from planar_pushing.certified.doubled.numbers import Floats
from planar_pushing.certified.supports.pressure.pieces import Pieces
from planar_pushing.evidence.golden.residual.sliders.means import means
from planar_pushing.evidence.golden.residual.sliders.nodes import doubles, nodes

#: Names of the errors, radians here: worst and mean of the force, worst and mean of the motion.
ERRORS = ("worst_force_error", "mean_force_error", "worst_motion_error", "mean_motion_error")
MOTIONS = 20_000
#: The golden angle: a turn over the square of the golden ratio.
TURN = 2 * np.pi / ((1 + np.sqrt(5)) / 2) ** 2
#: Distance of a centre of rotation in extents from which on the support is a sum over nodes.
FAR = 8.0


def errors(support: Pieces) -> tuple[float, ...]:
    """Worst and mean angle of force, and of motion, between the support and its ellipsoid."""
    index, extent = np.arange(MOTIONS), float(support.extent)
    spin = (index + 0.5) / MOTIONS
    v = np.sqrt(1 - spin**2) * np.array([np.cos(index * TURN), np.sin(index * TURN)])
    away = extent * np.array([-v[1], v[0]]) / spin
    middle = np.array(doubles(support.center))[:, None]
    constant = float(means(support, middle)[0][0]) / extent
    wrench = np.empty((3, MOTIONS))
    near = np.hypot(*away) < FAR * extent
    wrench[:, near] = _near(support, middle, away[:, near])
    wrench[:, ~near] = _far(support, middle, away[:, ~near])
    wrench[2] /= extent
    model = np.array([*v, constant**2 * spin])
    follows = np.array([*wrench[:2], wrench[2] / constant**2])
    first, second = _angles(wrench, model), _angles(np.array([*v, spin]), follows)
    return first.max(), first.mean(), second.max(), second.mean()


def _near(support: Pieces, middle: Floats, away: Floats) -> Floats:
    """Wrench about the centre of pressure of rotations about places off it."""
    distance, g_x, g_y = means(support, middle + away)
    return np.array([-g_y, g_x, distance + away[0] * g_x + away[1] * g_y])


def _far(support: Pieces, middle: Floats, away: Floats) -> Floats:
    """The same as sums of the unit forces at nodes."""
    x, y, weight = nodes(support)
    x, y = x - middle[0], y - middle[1]
    found = []
    for c_x, c_y in away.T:
        r_x, r_y = x - c_x, y - c_y
        force = weight / np.hypot(r_x, r_y)
        found.append([-force @ r_y, force @ r_x, force @ (x * r_x + y * r_y)])
    return np.array(found).T


def _angles(one: Floats, other: Floats) -> Floats:
    """Angles between vectors along the first dimension, by half angles (Kahan)."""
    one, other = (each / np.linalg.norm(each, axis=0) for each in (one, other))
    apart, together = (np.linalg.norm(one + side * other, axis=0) for side in (-1, 1))
    return np.asarray(2 * np.arctan2(apart, together))
