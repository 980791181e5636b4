"""Segments and edges of plates: integrals of rho along a line, and the moments derived from them."""

from __future__ import annotations

from typing import NamedTuple

from flint import arb

from planar_pushing.certified.balls import Undecided, norm
from planar_pushing.certified.supports.pressure.pieces import Line

Vector = tuple[arb, arb]
Part = tuple[arb, arb, arb, arb, arb, arb]


class Seen(NamedTuple):
    """A line relative to a center of rotation.

    Attributes
    ----------
    length, t_x, t_y : arb
        Length and unit tangent; the normal is (t_y, -t_x).
    s : tuple of arb
        The two ends along the tangent.
    h : arb
        Distance of the line along the normal.
    rho : tuple of arb
        Distances of the ends.
    log : arb
        ``h L``, L the integral of 1 / rho along the line.
    """

    length: arb
    t_x: arb
    t_y: arb
    s: Vector
    h: arb
    rho: Vector
    log: arb

    @property
    def whole(self) -> arb:
        """Integral of rho along the line."""
        sigma, both = self.rho[0] + self.rho[1], self.s[0] + self.s[1]
        return (self.length * (sigma + both * both / sigma) / 2 + self.h * self.log) / 2


def seen(line: Line, c: Vector) -> Seen:
    """A line relative to a center of rotation, exact or a ball."""
    d_x, d_y = map(arb, line.along)
    length = (d_x * d_x + d_y * d_y).sqrt()
    ends = [(x - c[0], y - c[1]) for x, y in (line.start, line.end)]
    s_1, s_2 = ((x * d_x + y * d_y) / length for x, y in ends)
    rho_1, rho_2 = (norm(x, y) for x, y in ends)
    # The product of exact places is exact, so that a center on the line is recognized as such.
    h = (ends[0][0] * d_y - ends[0][1] * d_x) / length
    log = _log(length, (s_1, s_2), (rho_1, rho_2), h)
    return Seen(length, d_x / length, d_y / length, (s_1, s_2), h, (rho_1, rho_2), log)


def _log(length: arb, s: Vector, rho: Vector, h: arb) -> arb:
    """``h L = h log((sigma + l) / (sigma - l))`` with ``sigma = rho_1 + rho_2``; 0 on the line."""
    if h.is_zero():
        return arb(0)
    sigma = rho[0] + rho[1]
    between = s[0] < 0 < s[1]
    parts = 1 / (rho[0] + abs(s[0])) + 1 / (rho[1] + abs(s[1]))
    if 2 * length < sigma:  # far away, where the argument of the logarithm is close to one
        return 2 * h * (length / sigma).atanh()
    if not h * h > 0:
        return _next_to_line(abs(h).upper(), (sigma + length) / parts)
    rest = h * h * parts if between else sigma - length
    return h * ((sigma + length) / rest).log()


def _next_to_line(size: arb, scale: arb) -> arb:
    """Bounds of h L for |h| <= size.

    As ``sigma - l`` is at least ``h^2`` times the `parts` in `_log`, |h L| is at most ``|h| log(scale /
    h^2)``, which increases up to ``sqrt(scale) / e``.
    """
    bound = scale.upper()
    if not (bound.is_finite() and size * size * 8 < scale.lower()):
        raise Undecided("a center next to the end of a line")
    most = (size * (bound / (size * size)).log()).upper()
    return (-most).union(most)


def segment(line: Line, c: Vector) -> Part:
    """The contribution of a segment; it has no second derivatives between its ends."""
    at = seen(line, c)
    rate = line.share / at.length
    (s_1, s_2), (rho_1, rho_2), h = at.s, at.rho, at.h
    tt, tn = s_2 / rho_2 - s_1 / rho_1, h * (1 / rho_2 - 1 / rho_1)
    second = _placed(at, (tt, tn, _inverse(at) - tt))
    along, across = rho_2 - rho_1, at.log
    return (
        rate * at.whole,
        rate * (along * at.t_x + across * at.t_y),
        rate * (along * at.t_y - across * at.t_x),
        rate * second[0],
        rate * second[1],
        rate * second[2],
    )


def _inverse(at: Seen) -> arb:
    """Integral of 1 / rho along a line, infinite if the line contains the center."""
    if not at.h.is_zero():
        return at.log / at.h
    return arb.pos_inf() if at.s[0] < 0 < at.s[1] else abs((at.rho[1] / at.rho[0]).log())


def _placed(at: Seen, local: tuple[arb, arb, arb]) -> tuple[arb, arb, arb]:
    """Second derivatives, from tangent and normal to x and y."""
    tt, tn, nn = local
    x, y = at.t_x, at.t_y
    return (
        tt * x * x + 2 * tn * x * y + nn * y * y,
        (tt - nn) * x * y + tn * (y * y - x * x),
        tt * y * y - 2 * tn * x * y + nn * x * x,
    )


def edge(line: Line, c: Vector) -> Part:
    """The contribution of an edge, where the share is that of the pressure on its left."""
    at, rate = seen(line, c), line.share
    n_x, n_y, whole, along = at.t_y, -at.t_x, at.whole, at.rho[1] - at.rho[0]
    bend_x, bend_y = at.log * n_x + along * at.t_x, at.log * n_y + along * at.t_y
    return (
        rate * at.h * whole / 3,
        rate * n_x * whole,
        rate * n_y * whole,
        rate * n_x * bend_x,
        rate * (n_x * bend_y + n_y * bend_x) / 2,
        rate * n_y * bend_y,
    )
