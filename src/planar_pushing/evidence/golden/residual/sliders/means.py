"""D and G of supports in plain doubles, by their closed forms, over arrays of centers of rotation."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

import numpy as np
from scipy.special import ellipe, ellipkm1

from planar_pushing.certified.doubled.numbers import Floats
from planar_pushing.certified.supports.pressure.pieces import Circle, Line, Pieces
from planar_pushing.evidence.golden.residual.sliders.nodes import doubles, share

Means = tuple[Any, Any, Any]
#: D and |G| of a unit circle or disc at a distance.
Law = Callable[[Floats], tuple[Any, Any]]


def means(support: Pieces, c: Floats) -> Means:
    """D and G at centers of rotation, shape (2, n)."""
    parts = list(_parts(support, c))
    distance, g_x, g_y = (np.sum([part[i] for part in parts], axis=0) for i in range(3))
    return distance, g_x, g_y


def _parts(support: Pieces, c: Floats) -> Iterable[Means]:
    for point in support.points:
        x, y = (place - each for place, each in zip(doubles(point.place), c, strict=True))
        rho, part = np.hypot(x, y), share(point)
        near = np.where(rho > 0, rho, 1.0)
        yield part * rho, part * x / near, part * y / near
    yield from (_segment(each, c) for each in support.segments)
    yield from (_edge(each, c) for each in support.edges)
    for law, circles in ((_ring, support.rings), (_disc, support.discs)):
        yield from (_radial(each, c, law) for each in circles)


def _seen(line: Line, c: Floats) -> tuple[Any, ...]:
    """Length, tangent, distance along the normal, difference of the ends' distances, h L, and I."""
    (a, b), (d, e) = doubles(line.start), doubles(line.end)
    length = np.hypot(d - a, e - b)
    t_x, t_y = (d - a) / length, (e - b) / length
    x, y = a - c[0], b - c[1]
    s, h = x * t_x + y * t_y, x * t_y - y * t_x
    rho_1, rho_2 = np.hypot(s, h), np.hypot(s + length, h)
    across = np.where(h == 0, 1.0, np.abs(h))
    log = h * (np.arcsinh((s + length) / across) - np.arcsinh(s / across))
    whole = ((s + length) * rho_2 - s * rho_1 + h * log) / 2
    return length, t_x, t_y, h, rho_2 - rho_1, log, whole


def _segment(line: Line, c: Floats) -> Means:
    length, t_x, t_y, _, along, log, whole = _seen(line, c)
    rate = share(line) / length
    return rate * whole, rate * (along * t_x + log * t_y), rate * (along * t_y - log * t_x)


def _edge(line: Line, c: Floats) -> Means:
    _, t_x, t_y, h, _, _, whole = _seen(line, c)
    rate = share(line)
    return rate * h * whole / 3, rate * t_y * whole, -rate * t_x * whole


def _radial(circle: Circle, c: Floats, law: Law) -> Means:
    x, y = (place - each for place, each in zip(doubles(circle.center), c, strict=True))
    radius, size, part = int(circle.radius.p) / int(circle.radius.q), np.hypot(x, y), share(circle)
    distance, slope = law(size / radius)
    near = np.where(size > 0, size, 1.0)
    return part * radius * distance, part * slope * x / near, part * slope * y / near


def _elliptic(c: Floats) -> tuple[Any, Any]:
    """E and (1 - m) K at the parameter m = c^2 or 1 / c^2, whichever is below 1."""
    k = np.minimum(c, 1 / np.where(c > 0, c, 1.0))
    rest = (1 - k) * (1 + k)
    # (1 - m) K vanishes at m = 1.
    return ellipe(k * k), rest * ellipkm1(np.where(rest > 0, rest, 1.0))


def _ring(c: Floats) -> tuple[Any, Any]:
    """The mean distance is the perimeter of an ellipse, and |G| its derivative."""
    distance = 2 / np.pi * (1 + c) * ellipe(4 * c / (1 + c) ** 2)
    second, first = _elliptic(c)
    inside = (second - first) / np.where(c > 0, c, 1.0)
    return distance, 2 / np.pi * np.where(c > 1, second, inside)


def _disc(c: Floats) -> tuple[Any, Any]:
    second, first = _elliptic(c)
    square, near = c * c, np.where(c > 0, c, 1.0)
    inside = ((7 + square) * second - 4 * first) / 9, ((1 + square) * second - first) / near / 3
    # (1 - m) K is (1 - 1 / c^2) K outside.
    outside = (
        c * ((7 + square) * second - (square + 3) * first) / 9,
        ((1 + square) * second - square * first) / 3,
    )
    distance, slope = (np.where(c > 1, b, a) for a, b in zip(inside, outside, strict=True))
    return 4 / np.pi * distance, 4 / np.pi * slope
