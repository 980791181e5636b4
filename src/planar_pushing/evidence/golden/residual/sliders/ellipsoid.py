"""Errors of the ellipsoid in place of a support, in plain doubles and by formulas of their own.

They are means and maxima over the motions that `fit_ellipsoid` names: spread over half a sphere of
(v_x, v_y, a omega) by the golden angle. Means of rho and r' / rho are sums over the pieces, as PHYSICS.md
has them; the torque loses the distance's digits, so that the errors are good to 1e-13 radians.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
from scipy.special import ellipe, ellipkm1

from planar_pushing.certified.doubled.numbers import Floats
from planar_pushing.certified.supports.pieces import Circle, Line, Pieces, Place

#: Names of the errors, radians here: worst and mean of the force, worst and mean of the motion.
ERRORS = ("worst_force_error", "mean_force_error", "worst_motion_error", "mean_motion_error")
MOTIONS = 20_000
#: The golden angle: a turn over the square of the golden ratio.
TURN = 2 * np.pi / ((1 + np.sqrt(5)) / 2) ** 2

Means = tuple[Any, Any, Any]


def errors(support: Pieces) -> tuple[float, ...]:
    """Worst and mean angle of force, and of motion, between the support and its ellipsoid."""
    index, extent = np.arange(MOTIONS), float(support.extent)
    spin = (index + 0.5) / MOTIONS
    v = np.sqrt(1 - spin**2) * np.array([np.cos(index * TURN), np.sin(index * TURN)])
    p = np.array(_doubles(support.center))
    away = extent * np.array([-v[1], v[0]]) / spin
    constant = _means(support, p[:, None])[0][0] / extent
    distance, g_x, g_y = _means(support, p[:, None] + away)
    torque = (distance + away[0] * g_x + away[1] * g_y) / extent
    force = np.array([-g_y, g_x, torque])
    model = np.array([*v, constant**2 * spin])
    follows = np.array([-g_y, g_x, torque / constant**2])
    first, second = _angles(force, model), _angles(np.array([*v, spin]), follows)
    return first.max(), first.mean(), second.max(), second.mean()


def _angles(one: Floats, other: Floats) -> Floats:
    """Angles between vectors along the first dimension, by half angles (Kahan)."""
    one, other = (each / np.linalg.norm(each, axis=0) for each in (one, other))
    apart, together = (np.linalg.norm(one + side * other, axis=0) for side in (-1, 1))
    return np.asarray(2 * np.arctan2(apart, together))


def _doubles(place: Place) -> tuple[float, float]:
    x, y = (int(each.p) / int(each.q) for each in place)
    return x, y


def _means(support: Pieces, c: Floats) -> Means:
    """D and G at centres of rotation, shape (2, n)."""
    parts = list(_parts(support, c))
    return tuple(np.sum([part[i] for part in parts], axis=0) for i in range(3))  # type: ignore[return-value]


def _parts(support: Pieces, c: Floats) -> Iterable[Means]:
    for point in support.points:
        x, y = (place - each for place, each in zip(_doubles(point.place), c, strict=True))
        rho, share = np.hypot(x, y), int(point.share.p) / int(point.share.q)
        near = np.where(rho > 0, rho, 1.0)
        yield share * rho, share * x / near, share * y / near
    yield from (_segment(each, c) for each in support.segments)
    yield from (_edge(each, c) for each in support.edges)
    for law, circles in ((_ring, support.rings), (_disc, support.discs)):
        yield from (_radial(each, c, law) for each in circles)


def _seen(line: Line, c: Floats) -> tuple[Any, ...]:
    """Share, tangent, distance, ends' difference, h L and the integral of rho of a line."""
    (a, b), (d, e) = _doubles(line.start), _doubles(line.end)
    length = np.hypot(d - a, e - b)
    t_x, t_y = (d - a) / length, (e - b) / length
    x, y = a - c[0], b - c[1]
    s, h = x * t_x + y * t_y, x * t_y - y * t_x
    rho_1, rho_2 = np.hypot(s, h), np.hypot(s + length, h)
    with np.errstate(divide="ignore", invalid="ignore"):
        log = np.arcsinh((s + length) / np.abs(h)) - np.arcsinh(s / np.abs(h))
    log = np.where(h == 0, 0.0, h * log)
    whole = ((s + length) * rho_2 - s * rho_1 + h * log) / 2
    share = int(line.share.p) / int(line.share.q)
    return share, length, t_x, t_y, h, rho_2 - rho_1, log, whole


def _segment(line: Line, c: Floats) -> Means:
    share, length, t_x, t_y, _, along, log, whole = _seen(line, c)
    rate = share / length
    return rate * whole, rate * (along * t_x + log * t_y), rate * (along * t_y - log * t_x)


def _edge(line: Line, c: Floats) -> Means:
    rate, _, t_x, t_y, h, _, _, whole = _seen(line, c)
    return rate * h * whole / 3, rate * t_y * whole, -rate * t_x * whole


def _radial(circle: Circle, c: Floats, law: Any) -> Means:
    x, y = (place - each for place, each in zip(_doubles(circle.center), c, strict=True))
    radius, size = int(circle.radius.p) / int(circle.radius.q), np.hypot(x, y)
    distance, slope = law(size / radius)
    share, near = int(circle.share.p) / int(circle.share.q), np.where(size > 0, size, 1.0)
    return share * radius * distance, share * slope * x / near, share * slope * y / near


def _elliptic(c: Floats) -> tuple[Any, ...]:
    """E and (1 - m) K at the parameter m = c^2 or 1 / c^2, which is below 1."""
    m = np.minimum(c, 1 / np.where(c > 0, c, 1.0)) ** 2
    rest = (1 - np.sqrt(m)) * (1 + np.sqrt(m))
    with np.errstate(invalid="ignore"):
        first = np.where(rest > 0, rest * ellipkm1(np.where(rest > 0, rest, 1.0)), 0.0)
    return m, ellipe(m), first


def _ring(c: Floats) -> tuple[Any, Any]:
    """D and |G| of the unit ring: the perimeter of an ellipse, and its derivative."""
    modulus = 4 * c / (1 + c) ** 2
    distance = 2 / np.pi * (1 + c) * ellipe(modulus)
    m, second, first = _elliptic(c)
    k = np.where(c > 0, np.sqrt(m), 1.0)
    inside = 2 / np.pi * (second - first) / k
    return distance, np.where(c > 1, 2 / np.pi * second, np.where(c > 0, inside, 0.0))


def _disc(c: Floats) -> tuple[Any, Any]:
    """D and |G| of the unit disc, by E and K."""
    _, second, first = _elliptic(c)
    near = np.where(c > 0, c, 1.0)
    inside = ((7 + c**2) * second - 4 * first) / 9, ((1 + c**2) * second - first) / (3 * near)
    # (c^4 + 2 c^2 - 3) K / c = c (c^2 + 3) (1 - 1/c^2) K, and (c^2 - 1) K = c^2 (1 - 1/c^2) K.
    outside = (
        c * ((7 + c**2) * second - (c**2 + 3) * first) / 9,
        ((1 + c**2) * second - c**2 * first) / 3,
    )
    return tuple(4 / np.pi * np.where(c > 1, b, a) for a, b in zip(inside, outside, strict=True))  # type: ignore[return-value]
