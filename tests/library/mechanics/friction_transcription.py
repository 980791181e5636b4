"""Friction of every support, straight from its formulas, for arrays of twists.

Nothing of the package is used but the fields of its public dataclasses. An even piece of pressure has a
closed form about a center of rotation that is near it; farther away, where the closed forms cancel, and
for translations, a Gauss rule over the piece has no cancellation and converges to rounding.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.special import ellipe, ellipkm1, hyp2f1

import planar_pushing as pp

#: From this many extents on, between the center of rotation and a piece, the Gauss rule stands.
FAR = 3.0
LEGENDRE = np.polynomial.legendre.leggauss(10)
NODES, WEIGHTS = (LEGENDRE[0] + 1) / 2, LEGENDRE[1] / 2
RIM = 2 * np.pi * np.arange(32) / 32


@dataclass(frozen=True)
class Area:
    """An even piece of pressure: its share, its closed form and its Gauss rule.

    `about(c)` gives G and the torque about the body origin of the unit rotation about each c, and `rule`
    has rows (x, y, weight), whose weights add up to 1.
    """

    share: float
    about: Any
    rule: Any

    @property
    def center(self):
        return self.rule[:, 2] @ self.rule[:, :2]

    @property
    def extent(self):
        return np.hypot(*(self.rule[:, :2] - self.center).T).max()


@dataclass(frozen=True)
class Pressure:
    """A unit pressure: atoms with rows (x, y, share), and areas."""

    atoms: Any
    areas: tuple[Area, ...]

    @property
    def center(self):
        """Center of pressure."""
        return self.atoms[:, 2] @ self.atoms[:, :2] + sum(
            (each.share * each.center for each in self.areas), np.zeros(2)
        )

    @property
    def extent(self):
        """Largest distance from the center of pressure, to a few percent for areas."""
        places = [self.atoms[:, :2], *(each.rule[:, :2] for each in self.areas)]
        return float(np.hypot(*(np.concatenate(places) - self.center).T).max())


def pressure_of(support, radius=1.0, share=1.0):
    """The pressure of a support; a ring without a radius has the slider's."""
    if isinstance(support, pp.Points):
        loads = np.array(support.weights)
        atoms = np.column_stack([support.positions, share * loads / loads.sum()])
        return Pressure(atoms, ())
    if isinstance(support, pp.Composite):
        whole = sum(each for each, _ in support.members)
        parts = [pressure_of(each, radius, share * own / whole) for own, each in support.members]
        atoms = np.concatenate([each.atoms for each in parts])
        return Pressure(atoms, tuple(area for each in parts for area in each.areas))
    return Pressure(np.empty((0, 3)), _areas(support, radius, share))


def _areas(support, radius, share):
    if isinstance(support, pp.Ring):
        return (_ring(share, support.radius or radius),)
    if isinstance(support, pp.Disc):
        return (_disc(share, support.radius, support.center),)
    if isinstance(support, pp.Annulus):
        inner, outer = support.inner**2, support.outer**2
        return (
            _disc(share * outer / (outer - inner), support.outer, support.center),
            _disc(-share * inner / (outer - inner), support.inner, support.center),
        )
    if isinstance(support, pp.Segment):
        return (_segment(share, np.array(support.start), np.array(support.end)),)
    if isinstance(support, pp.Polygon):
        return (_polygon(share, np.array(support.vertices)),)
    return _cells(support, share)


def _cells(support, share):
    """The cells of a pressure map are rectangles."""
    x, y, loads = map(np.array, (support.x, support.y, support.pressure))
    loads = loads * np.diff(y)[:, None] * np.diff(x)
    loads = share * loads / loads.sum()
    return tuple(
        _polygon(loads[j, i], np.column_stack([x[[i, i + 1, i + 1, i]], y[[j, j, j + 1, j + 1]]]))
        for j, i in np.argwhere(loads > 0)
    )


# --- Rings and discs -----------------------------------------------------------------------------


def _ring(share, radius):
    rule = [radius * np.cos(RIM), radius * np.sin(RIM), np.full(32, 1 / 32)]
    return Area(share, lambda c: _round(c, radius, (0.0, 0.0), _ring_of), np.column_stack(rule))


def _disc(share, radius, center):
    depth = np.sqrt(NODES)[:, None]  # even in the square of the distance: a Gauss rule in it
    rule = [radius * depth * np.cos(RIM) + center[0], radius * depth * np.sin(RIM) + center[1]]
    weights = np.broadcast_to(WEIGHTS[:, None] / 32, rule[0].shape)
    rule = np.column_stack([each.ravel() for each in (*rule, weights)])
    return Area(share, lambda c: _round(c, radius, center, _disc_of), rule)


def _round(c, radius, center, form):
    """G and torque about the origin from |G| and the torque about the center of a round piece."""
    away = (c - center) / radius
    distance = np.hypot(*away.T)
    pull, torque = form(distance)
    unit = -away / np.where(distance > 0, distance, 1.0)[:, None]
    own = pull[:, None] * unit
    return own, radius * torque + own @ center


def _ring_of(d):
    """Eqs. (2)-(3) with k = 1/d; both are functions of the smaller of k and d."""
    k = np.minimum(d, 1 / np.maximum(d, 1e-300))
    square = k**2
    e = ellipe(square)
    kept = np.where(k < 1, (1 - k) * (1 + k) * ellipkm1(np.maximum((1 - k) * (1 + k), 1e-300)), 0.0)
    near = (e - kept) / np.where(k > 0, k, 1.0) * 2 / np.pi
    f, t = (
        2 / np.pi * e,
        np.where(k < 0.5, k / 2 * hyp2f1(0.5, 0.5, 2, np.minimum(square, 0.3)), near),
    )
    return np.where(d < 1, t, f), np.where(d < 1, f, t)


def _disc_of(d):
    """|G| and T of the unit disc: hypergeometric series, and elliptic integrals near the rim."""
    inside, y = np.minimum(d, 0.9) ** 2, 1 / np.maximum(d, 1.1) ** 2
    pull = np.where(
        d < 1, np.minimum(d, 0.9) * hyp2f1(-0.5, 0.5, 2, inside), hyp2f1(-0.5, 0.5, 2, y)
    )
    torque = np.where(
        d < 1, 2 / 3 * hyp2f1(-1.5, 0.5, 1, inside), hyp2f1(0.5, 0.5, 3, y) * np.sqrt(y) / 4
    )
    rim = (d > 0.9) & (d < 1.1)
    c = np.where(rim, d, 1.0)
    m = np.minimum(c, 1 / c)
    gap = (1 - m) * (1 + m)
    e, k = ellipe(m**2), np.where(gap > 0, ellipkm1(np.maximum(gap, 1e-300)), 0.0)
    g_in = 4 * ((1 + c**2) * e - (1 - c**2) * k) / (3 * np.pi * c)
    g_out = 4 * ((1 + c**2) * e - (c**2 - 1) * k) / (3 * np.pi)
    d_in = 4 * ((7 + c**2) * e - 4 * (1 - c**2) * k) / (9 * np.pi)
    d_out = 4 * (c * (7 + c**2) * e - (c**4 + 2 * c**2 - 3) * k / c) / (9 * np.pi)
    near, mean = np.where(c < 1, g_in, g_out), np.where(c < 1, d_in, d_out)
    return np.where(rim, near, pull), np.where(rim, mean - c * near, torque)


# --- Edges ---------------------------------------------------------------------------------------


def _edge(c, start, end):
    """Of an edge seen from c: outward normal, tangent, h, h L, I = integral of rho, rho2 - rho1."""
    length = np.hypot(*(end - start))
    tangent = (end - start) / length
    normal = np.array([tangent[1], -tangent[0]])
    h, s1 = (start - c) @ normal, (start - c) @ tangent
    s2, size = s1 + length, np.maximum(np.abs(h), 1e-300)
    bend = h * np.where(h != 0, np.arcsinh(s2 / size) - np.arcsinh(s1 / size), 0.0)
    rho1, rho2 = np.hypot(h, s1), np.hypot(h, s2)
    return normal, tangent, h, bend, (s2 * rho2 - s1 * rho1 + h * bend) / 2, rho2 - rho1


def _segment(share, start, end):
    length = np.hypot(*(end - start))

    def about(c):
        normal, tangent, _, bend, mean, along = _edge(c, start, end)
        pull = (bend[:, None] * normal + along[:, None] * tangent) / length
        return pull, mean / length + np.sum(c * pull, axis=-1)

    rule = np.column_stack([start + NODES[:, None] * (end - start), WEIGHTS])
    return Area(share, about, rule)


def _polygon(share, vertices):
    x, y = vertices.T
    area = np.sum(x * np.roll(y, -1) - y * np.roll(x, -1)) / 2
    if area < 0:
        return _polygon(share, vertices[::-1])
    edges = list(zip(vertices, np.roll(vertices, -1, axis=0), strict=True))

    def about(c):
        mean, pull = 0.0, np.zeros_like(c)
        for start, end in edges:
            normal, _, h, _, whole, _ = _edge(c, start, end)
            mean = mean + h * whole / (3 * area)
            pull += whole[:, None] * normal / area
        return pull, mean + np.sum(c * pull, axis=-1)

    return Area(share, about, np.concatenate([_triangle(vertices[0], *e, area) for e in edges]))


def _triangle(apex, start, end, area):
    """Gauss rule on a triangle, its weight signed as the triangle turns."""
    a, b = start - apex, end - apex
    size = (a[0] * b[1] - a[1] * b[0]) / area  # twice the triangle's share
    depth, side = np.meshgrid(NODES, NODES)
    places = apex + depth[..., None] * (a + side[..., None] * (b - a))
    weights = size * depth * np.outer(WEIGHTS, WEIGHTS)
    return np.column_stack([places.reshape(-1, 2), weights.ravel()])


# --- Friction ------------------------------------------------------------------------------------


def point_velocities(twist, places):
    """Velocities of points of the body, shape (n, points, 2), by twists about its origin."""
    v, omega = twist[:, None, :2], twist[:, 2, None, None]
    return v + omega * np.stack([-places[..., 1], places[..., 0]], axis=-1)


def of_places(twist, places, weights):
    """Force, and torque about the origin, of weighted points; one that is at rest exerts nothing."""
    velocity = point_velocities(twist, places)
    speed = np.hypot(velocity[..., 0], velocity[..., 1])
    each = (weights / np.where(speed > 0, speed, np.inf))[..., None] * velocity
    torque = places[..., 0] * each[..., 1] - places[..., 1] * each[..., 0]
    return each.sum(axis=1), torque.sum(axis=1)


def of_area(twist, area):
    """Force and torque about the origin that sustain twists over an even piece, per unit weight."""
    force, torque = np.zeros((len(twist), 2)), np.zeros(len(twist))
    omega = twist[:, 2]
    v = point_velocities(twist, area.center[None])[:, 0]
    near = np.hypot(*v.T) < FAR * area.extent * np.abs(omega)
    if near.any():
        turn, speed = omega[near, None], twist[near, :2]
        c = np.stack([-speed[:, 1], speed[:, 0]], axis=-1) / turn
        pull, own = area.about(c)
        sense = np.sign(turn)
        force[near] = sense * np.stack([-pull[:, 1], pull[:, 0]], axis=-1)
        torque[near] = sense[:, 0] * own
    for rows in np.array_split(np.flatnonzero(~near), max(1, (~near).sum() // 500)):
        force[rows], torque[rows] = of_places(twist[rows], area.rule[:, :2], area.rule[:, 2])
    return area.share * force, area.share * torque
