"""Supports as many points, by quadrature rules alone: lines and areas by Gauss, circles by even points.

Exact to rounding for a center of rotation that is not next to the support.
"""

from __future__ import annotations

from functools import singledispatch
from itertools import pairwise

import numpy as np

from planar_pushing.mechanics.supports.annulus import Annulus
from planar_pushing.mechanics.supports.composite import Composite
from planar_pushing.mechanics.supports.disc import Disc
from planar_pushing.mechanics.supports.even_ring import Ring
from planar_pushing.mechanics.supports.points import Points
from planar_pushing.mechanics.supports.polygon import Polygon
from planar_pushing.mechanics.supports.pressure_map import PressureMap
from planar_pushing.mechanics.supports.segment import Segment

NODES, EVEN = 24, 200
AT, SHARE = np.polynomial.legendre.leggauss(NODES)
AT, SHARE = (1 + AT) / 2, SHARE / 2


@singledispatch
def sampled(support):
    """Positions, shape (n, 2), and their shares, which add to 1."""
    raise TypeError(support)


def whole(parts):
    """Parts, each with its share, as one."""
    places = np.concatenate([place for _, (place, _) in parts])
    shares = np.concatenate([part * share for part, (_, share) in parts])
    return places, shares / shares.sum()


@sampled.register
def _(support: Points):
    return whole([(1.0, (np.array(support.positions), np.array(support.weights)))])


@sampled.register
def _(support: Segment):
    start, end = np.array(support.start), np.array(support.end)
    return start + AT[:, None] * (end - start), SHARE


def circle(radius):
    turn = 2 * np.pi * np.arange(EVEN) / EVEN
    return radius * np.column_stack([np.cos(turn), np.sin(turn)]), np.full(EVEN, 1 / EVEN)


@sampled.register
def _(support: Ring):
    places, shares = circle(support.extent)
    return places + support.center_of_pressure, shares


def circles(inner, outer, center):
    """An annulus as circles, whose shares are their lengths."""
    radii = inner + AT * (outer - inner)
    places, shares = whole([(s * r, circle(r)) for r, s in zip(radii, SHARE, strict=True)])
    return places + center, shares


@sampled.register
def _(support: Disc):
    return circles(0.0, support.radius, support.center)


@sampled.register
def _(support: Annulus):
    return circles(support.inner, support.outer, support.center)


def triangle(a, b, c):
    """Places of a triangle, and twice its signed area times their shares."""
    s, t = (each.ravel()[:, None] for each in np.meshgrid(AT, AT))
    weight = np.outer(SHARE, SHARE).ravel() * s[:, 0]
    (x, y), (u, v) = b - a, c - a
    return a + s * ((1 - t) * (b - a) + t * (c - a)), (x * v - y * u) * weight


@sampled.register
def _(support: Polygon):
    """Triangles from the first vertex; those outside of the polygon and holes count negative."""
    outer, *holes = (fan(np.array(each)) for each in (support.vertices, *support.holes))
    return whole([(1.0, outer), *((-1.0, hole) for hole in holes)])


def fan(corners):
    """Triangles from a first corner, with shares that add to the area between the corners."""
    parts = [triangle(corners[0], *corners[i : i + 2]) for i in range(1, len(corners) - 1)]
    places, shares = (np.concatenate(each) for each in zip(*parts, strict=True))
    return places, shares * np.sign(shares.sum())


@sampled.register
def _(support: PressureMap):
    cells = []
    for (bottom, top), row in zip(pairwise(support.y), support.pressure, strict=True):
        for (left, right), pressure in zip(pairwise(support.x), row, strict=True):
            area = (right - left) * (top - bottom)
            if pressure > 0:
                corners = [(left, bottom), (right, bottom), (right, top), (left, top)]
                cells.append((pressure * area, sampled(Polygon(corners))))
    return whole(cells)


@sampled.register
def _(support: Composite):
    return whole([(share, sampled(member)) for share, member in support.members])
