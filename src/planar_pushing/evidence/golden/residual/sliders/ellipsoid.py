"""Errors of the ellipsoid in place of a support, in plain doubles and by formulas of their own.

Means are taken over the motions that `fit_ellipsoid` names: spread over half a sphere of
(v_x, v_y, a omega) by the golden angle. Maxima are those of clouds of motions that shrink about the
largest errors of these, and of the wrenches that sustain a rotation about a foot. Near the support D and G
are sums over its pieces, by the closed forms; the torque then loses the distance's digits, so that far away
it is a plain quadrature.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import numpy as np

from planar_pushing.certified.doubled.numbers import Floats
from planar_pushing.certified.supports.pressure.pieces import Pieces
from planar_pushing.evidence.golden.residual.sliders.means import means
from planar_pushing.evidence.golden.residual.sliders.nodes import doubles, nodes, share

#: Names of the errors, radians here: worst and mean of the force, worst and mean of the motion.
ERRORS = ("worst_force_error", "mean_force_error", "worst_motion_error", "mean_motion_error")
MOTIONS = 20_000
#: The golden angle: a turn over the square of the golden ratio.
TURN = 2 * np.pi / ((1 + np.sqrt(5)) / 2) ** 2
#: Distance of a center of rotation in extents from which on the support is a sum over nodes.
FAR = 8.0
#: Clouds of motions: how many, of how many motions, the radius of the first, by what factor it shrinks, and
#: how often.
CLOUDS, CLOUD, WIDTH, SHRINKING, TIMES = 12, 64, 0.03, 0.7, 90


def errors(support: Pieces) -> tuple[float, ...]:
    """Worst and mean angle of force, and of motion, between the support and its ellipsoid."""
    middle = np.array(doubles(support.center))[:, None]
    constant = float(means(support, middle)[0][0]) / float(support.extent)
    motions = _spread(MOTIONS)
    angles = _errors(support, constant, motions)
    feet = [_at_foot(support, constant, i) for i in range(len(support.points))]
    worst = []
    for i in range(2):
        largest = _largest(partial(_error, support, constant, i), motions, angles[i])
        worst.append(max([largest, *(foot[i] for foot in feet)]))
    return worst[0], angles[0].mean(), worst[1], angles[1].mean()


def _spread(count: int) -> Floats:
    """Motions spread over half a sphere, shape (3, count)."""
    index = np.arange(count)
    spin = (index + 0.5) / count
    speed = np.sqrt(1 - spin**2)
    return np.array([speed * np.cos(index * TURN), speed * np.sin(index * TURN), spin])


def _errors(support: Pieces, constant: float, motions: Floats) -> tuple[Floats, Floats]:
    """Angles of force and of motion at motions, shape (3, n)."""
    extent = float(support.extent)
    v_x, v_y, spin = motions
    away = extent * np.array([-v_y, v_x]) / spin
    middle = np.array(doubles(support.center))[:, None]
    wrench = np.empty(motions.shape)
    near = np.hypot(*away) < FAR * extent
    wrench[:, near] = _near(support, middle, away[:, near])
    wrench[:, ~near] = _far(support, middle, away[:, ~near])
    wrench[2] /= extent
    return _from_ellipsoid(constant, motions, wrench)


def _error(support: Pieces, constant: float, which: int, motions: Floats) -> Floats:
    """Angles of force, 0, or of motion, 1."""
    return _errors(support, constant, motions)[which]


def _from_ellipsoid(constant: float, motions: Floats, wrench: Floats) -> tuple[Floats, Floats]:
    """Angles of force and of motion between motions with their wrenches, and the ellipsoid."""
    scale = np.array([1.0, 1.0, constant**2])[:, None]
    return _angles(wrench, scale * motions), _angles(motions, wrench / scale)


def _largest(error: Callable[[Floats], Floats], motions: Floats, errors: Floats) -> float:
    """The largest error in clouds of motions, the first about the largest errors."""
    places = motions[:, np.argsort(errors)[-CLOUDS:]]
    half = _spread(CLOUD // 2)
    cloud = np.concatenate([half, -half], axis=1)
    best = float(errors.max())
    for radius in WIDTH * SHRINKING ** np.arange(TIMES):
        tried = places[:, :, None] + radius * cloud[:, None, :]
        tried *= np.copysign(1.0, tried[2])
        tried = (tried / np.linalg.norm(tried, axis=0)).reshape(3, -1)
        found = error(tried).reshape(CLOUDS, CLOUD)
        at = np.arange(CLOUDS) * CLOUD + found.argmax(axis=1)
        better = found.max(axis=1) > error(places)
        places = np.where(better, tried[:, at], places)
        best = max(best, float(found.max()))
    return best


def _at_foot(support: Pieces, constant: float, foot: int) -> tuple[float, float]:
    """Largest angles of force and of motion of rotations about a foot with full friction there."""
    extent, middle = float(support.extent), np.array(doubles(support.center))[:, None]
    point = support.points[foot]
    away = np.array(doubles(point.place))[:, None] - middle
    motion = np.array([away[1], -away[0], [extent]])
    motion = motion / np.linalg.norm(motion)
    others = _near(support, middle, away)

    def angles(turn: Floats) -> tuple[Floats, Floats]:
        f_x, f_y = share(point) * np.array([np.cos(turn), np.sin(turn)])
        wrench = others + np.array([f_x, f_y, away[0] * f_y - away[1] * f_x])
        wrench[2] /= extent
        return _from_ellipsoid(constant, np.repeat(motion, len(turn), axis=1), wrench)

    best = []
    for i in range(2):
        turn, width = 0.0, np.pi
        for _ in range(TIMES):
            tried = turn + width * np.linspace(-1.0, 1.0, CLOUD)
            turn, width = tried[np.argmax(angles(tried)[i])], SHRINKING * width
        best.append(float(angles(np.array([turn]))[i][0]))
    return best[0], best[1]


def _near(support: Pieces, middle: Floats, away: Floats) -> Floats:
    """Wrench about the center of pressure of rotations about places off it."""
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
