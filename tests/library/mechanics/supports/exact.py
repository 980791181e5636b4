"""Moments of supports in 50 digits, straight from their closed forms: mean distance, unit vector, torque.

Each takes a center of rotation in the body frame and gives D, G_x, G_y and the torque about the origin; the
closed forms cancel far away, which the digits pay for.
"""

from __future__ import annotations

from functools import singledispatch

from mpmath import mp, mpf

from planar_pushing.mechanics.supports.annulus import Annulus
from planar_pushing.mechanics.supports.composite import Composite
from planar_pushing.mechanics.supports.disc import Disc
from planar_pushing.mechanics.supports.even_ring import Ring
from planar_pushing.mechanics.supports.points import Points
from planar_pushing.mechanics.supports.polygon import Polygon
from planar_pushing.mechanics.supports.pressure_map import PressureMap
from planar_pushing.mechanics.supports.segment import Segment

DIGITS = 50


def exact_moments(support, c):
    """D, G_x, G_y and the torque about the center of pressure."""
    with mp.workdps(DIGITS):
        x, y = mpf(c[0]), mpf(c[1])
        d, g_x, g_y = about(support, x, y)
        p_x, p_y, _ = load(support)
        return d, g_x, g_y, d + (x - p_x) * g_x + (y - p_y) * g_y


def mixed(parts):
    """Weighted mean of tuples."""
    whole = sum(share for share, _ in parts)
    return tuple(
        sum(share * values[i] for share, values in parts) / whole for i in range(len(parts[0][1]))
    )


@singledispatch
def about(support, x, y):
    """D, G_x, G_y."""
    raise TypeError(support)


@singledispatch
def load(support):
    """Center of pressure, and a weight where members of a whole are compared."""
    raise TypeError(support)


@about.register
def _(support: Points, x, y):
    return mixed([(mpf(w), of_point(q, x, y)) for q, w in pairs(support)])


@load.register
def _(support: Points):
    return (*mixed([(mpf(w), (mpf(q[0]), mpf(q[1]))) for q, w in pairs(support)]), 1)


def pairs(support):
    return zip(support.positions, support.weights, strict=True)


def of_point(place, x, y):
    r_x, r_y = mpf(place[0]) - x, mpf(place[1]) - y
    rho = mp.sqrt(r_x**2 + r_y**2)
    return (rho, r_x / rho, r_y / rho) if rho else (rho, mpf(0), mpf(0))


def of_edge(start, end, x, y):
    """Of a line: its length, h, tangent, I, and the integral of r' / rho along and across it."""
    a_x, a_y = mpf(start[0]) - x, mpf(start[1]) - y
    d_x, d_y = mpf(end[0]) - mpf(start[0]), mpf(end[1]) - mpf(start[1])
    length = mp.sqrt(d_x**2 + d_y**2)
    t_x, t_y = d_x / length, d_y / length
    s1, h = a_x * t_x + a_y * t_y, a_x * t_y - a_y * t_x
    s2 = s1 + length
    rho1, rho2 = mp.sqrt(s1**2 + h**2), mp.sqrt(s2**2 + h**2)
    sigma = rho1 + rho2
    whole = mp.asinh(s2 / abs(h)) - mp.asinh(s1 / abs(h)) if h else mpf(0)
    integral = (length * (sigma + (s1 + s2) ** 2 / sigma) / 2 + h**2 * whole) / 2
    return length, h, (t_x, t_y), integral, rho2 - rho1, h * whole


@about.register
def _(support: Segment, x, y):
    length, _, (t_x, t_y), integral, along, across = of_edge(support.start, support.end, x, y)
    return (
        integral / length,
        (along * t_x + across * t_y) / length,
        (along * t_y - across * t_x) / length,
    )


@load.register
def _(support: Segment):
    return (*((mpf(a) + mpf(b)) / 2 for a, b in zip(support.start, support.end, strict=True)), 1)


@about.register
def _(support: Polygon, x, y):
    if support.holes:
        return mixed([(sign * load(ring)[2], about(ring, x, y)) for sign, ring in rings(support)])
    d, g_x, g_y = mpf(0), mpf(0), mpf(0)
    for start, end in sides(support.vertices):
        _, h, (t_x, t_y), integral, _, _ = of_edge(start, end, x, y)
        d, g_x, g_y = d + h * integral / 3, g_x + t_y * integral, g_y - t_x * integral
    area = load(support)[2]
    return d / area, g_x / area, g_y / area


@load.register
def _(support: Polygon):
    if support.holes:
        parts = [(sign * load(ring)[2], load(ring)[:2]) for sign, ring in rings(support)]
        return *mixed(parts), sum(area for area, _ in parts)
    area, m_x, m_y = mpf(0), mpf(0), mpf(0)
    for (a, b), (c, d) in sides(support.vertices):
        cross = mpf(a) * d - mpf(c) * b
        area += cross / 2
        m_x, m_y = m_x + cross * (mpf(a) + c) / 6, m_y + cross * (mpf(b) + d) / 6
    return m_x / area, m_y / area, area


def rings(support):
    """The polygon without its holes, counted positive, and its holes, counted negative."""
    whole = [Polygon(each) for each in (support.vertices, *support.holes)]
    return [
        ((1 if i == 0 else -1) * (1 if load(each)[2] > 0 else -1), each)
        for i, each in enumerate(whole)
    ]


def sides(vertices):
    return zip(vertices, [*vertices[1:], vertices[0]], strict=True)


def cells(support):
    """Cells of a pressure map as polygons, each with its load."""
    for j, row in enumerate(support.pressure):
        for i, pressure in enumerate(row):
            (a, b), (c, d) = support.x[i : i + 2], support.y[j : j + 2]
            if pressure:
                cell = Polygon([(a, c), (b, c), (b, d), (a, d)])
                yield mpf(pressure) * (mpf(b) - a) * (mpf(d) - c), cell


@about.register
def _(support: PressureMap, x, y):
    return mixed([(weight, about(cell, x, y)) for weight, cell in cells(support)])


@load.register
def _(support: PressureMap):
    return (*mixed([(weight, load(cell)[:2]) for weight, cell in cells(support)]), 1)


def radial(center, x, y, law):
    """A support that is symmetric about a center, from D and its slope at a distance."""
    r_x, r_y = mpf(center[0]) - x, mpf(center[1]) - y
    c = mp.sqrt(r_x**2 + r_y**2)
    d, slope = law(c)
    return (d, slope * r_x / c, slope * r_y / c) if c else (d, mpf(0), mpf(0))


def disc_law(radius):
    def law(distance):
        c = distance / mpf(radius)
        if c <= 1:
            d = mpf(2) / 3 * mp.hyp2f1(-0.5, -1.5, 1, c**2)
            return radius * d, c * mp.hyp2f1(-0.5, 0.5, 2, c**2)
        y = 1 / c**2
        return radius * c * mp.hyp2f1(-0.5, -0.5, 2, y), mp.hyp2f1(-0.5, 0.5, 2, y)

    return law


def ring_law(radius):
    def law(distance):
        c = distance / mpf(radius)
        inside, outside = mp.hyp2f1(-0.5, 0.5, 1, min(c, 1 / c) ** 2 if c else mpf(0)), mpf(0)
        if c:
            k = min(c, 1 / c)
            outside = k / 2 * mp.hyp2f1(0.5, 0.5, 2, k**2)
        force, torque = (outside, inside) if c <= 1 else (inside, outside)
        return radius * (torque + c * force), force

    return law


@about.register
def _(support: Disc, x, y):
    return radial(support.center, x, y, disc_law(support.radius))


@about.register
def _(support: Ring, x, y):
    return radial((0.0, 0.0), x, y, ring_law(support.extent))


@about.register
def _(support: Annulus, x, y):
    parts = [
        (sign * mpf(radius) ** 2, radial(support.center, x, y, disc_law(radius)))
        for sign, radius in ((1, support.outer), (-1, support.inner))
    ]
    return mixed(parts)


@load.register(Disc)
@load.register(Annulus)
def _(support):
    return (*map(mpf, support.center), 1)


@load.register
def _(support: Ring):
    return mpf(0), mpf(0), 1


@about.register
def _(support: Composite, x, y):
    return mixed([(mpf(share), about(member, x, y)) for share, member in support.members])


@load.register
def _(support: Composite):
    return (*mixed([(mpf(share), load(member)[:2]) for share, member in support.members]), 1)
