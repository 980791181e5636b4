"""A support: mean distance D from a center of rotation, its gradient and Hessian, in balls.

Every friction force of a rotation follows from these six numbers, because the potential of friction is
``W |omega| D(c)``. A support consists of points, circles (rings and discs), and lines (segments and edges
of plates) with exact shares of one load; shares of holes are negative.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

from flint import acb, arb, ctx, fmpq

from pulling_by_pushing.oracle.balls import (
    ZERO,
    Position,
    Undecided,
    Vector,
    norm,
    remember,
)

#: D, its gradient (x, y), and its Hessian (xx, xy, yy).
Six = tuple[arb, arb, arb, arb, arb, arb]
#: Of a unit circle at the square of a distance: D, g and g', where the gradient at c is g(c^2) c.
Profile = Callable[[arb], tuple[arb, arb, arb]]
ONE = fmpq(1)


class Rim(Undecided):
    """D has no second derivatives: the center lies on a rim, a segment, or a point."""


class Point(NamedTuple):
    """A point of support, and its share of the load."""

    position: Position
    share: fmpq


class Circle(NamedTuple):
    """A ring or a disc, and its share."""

    profile: Profile
    center: Position
    radius: fmpq
    share: fmpq


class Line(NamedTuple):
    """A segment and its share, or an edge of a plate and the pressure on its left."""

    start: Position
    end: Position
    share: fmpq
    plate: bool


def ring(c2: arb) -> tuple[arb, arb, arb]:
    """The unit ring, by Eqs. (2)-(3); near the rim as elliptic integrals, elsewhere as power series."""
    if 0.25 < c2 < 4:
        return _near_rim(_ring_at_rim, c2)
    if c2 < 1:
        return _f(-1, -1, 1, c2), _f(1, 1, 2, c2) / 2, _f(3, 3, 3, c2) / 16
    y, inverse = 1 / c2, c2.rsqrt()
    slope = _f(-1, 1, 1, y)
    bend = inverse**3 * (-slope / 2 + y * _f(1, 3, 2, y) / 4)
    return _f(-1, -1, 1, y) / inverse, inverse * slope, bend


def disc(c2: arb) -> tuple[arb, arb, arb]:
    """The uniform unit disc; near the rim as elliptic integrals, elsewhere as power series."""
    if 0.25 < c2 < 4:
        return _near_rim(_disc_at_rim, c2)
    if c2 < 1:
        return _f(-1, -3, 1, c2) * 2 / 3, _f(-1, 1, 2, c2), -_f(1, 3, 3, c2) / 8
    y, inverse = 1 / c2, c2.rsqrt()
    slope = _f(-1, 1, 2, y)
    bend = inverse**3 * (-slope / 2 + y * _f(1, 3, 3, y) / 8)
    return _f(-1, -1, 2, y) / inverse, inverse * slope, bend


def _near_rim(
    at_rim: Callable[[arb, arb, arb], tuple[arb, arb, arb]], c2: arb
) -> tuple[arb, arb, arb]:
    """A profile from D, the gradient and its slope along the radius, as functions of c, K and E.

    Over a ball, K and E are poor next to the rim: there the value in the middle, and the mean value
    theorem.
    """
    enclosure = _from_integrals(at_rim, c2)
    if c2.is_exact():
        return enclosure
    middle = c2.mid()
    distance, slope, _ = _from_integrals(at_rim, middle)
    offset = c2 - middle
    return distance + offset * enclosure[1] / 2, slope + offset * enclosure[2], enclosure[2]


def _from_integrals(
    at_rim: Callable[[arb, arb, arb], tuple[arb, arb, arb]], c2: arb
) -> tuple[arb, arb, arb]:
    lost_bits = max(0, -math.floor(float((1 - c2).abs_lower().log() / arb(2).log())))
    with ctx.workprec(ctx.prec + 3 * lost_bits):
        c, m = c2.sqrt(), acb(c2 if c2 < 1 else 1 / c2)
        distance, gradient, slope = at_rim(c, m.elliptic_k().real, m.elliptic_e().real)
        return distance, gradient / c, (slope - gradient / c) / (2 * c2)


def _ring_at_rim(c: arb, first: arb, second: arb) -> tuple[arb, arb, arb]:
    """With k the one of c and 1 / c below 1: f = 2 E / pi, t = 2 (E - (1 - k^2) K) / (pi k), and t'."""
    k = c if c < 1 else 1 / c
    scale = 2 / arb.pi()
    force, slope = scale * second, scale * (first - second) / (k * k)
    torque = scale * (second - (1 - k) * (1 + k) * first) / k
    return (
        (force + c * torque, torque, slope) if c < 1 else (torque + c * force, force, k**3 * slope)
    )


def _disc_at_rim(c: arb, first: arb, second: arb) -> tuple[arb, arb, arb]:
    square = c * c
    if c < 1:
        distance = ((7 + square) * second - 4 * (1 - square) * first) * 4 / (9 * arb.pi())
        gradient = ((1 + square) * second - (1 - square) * first) * 4 / (3 * arb.pi() * c)
        return distance, gradient, 4 * second / arb.pi() - gradient / c
    falls = (square * square + 2 * square - 3) * first / c
    distance = (c * (7 + square) * second - falls) * 4 / (9 * arb.pi())
    gradient = ((1 + square) * second - (square - 1) * first) * 4 / (3 * arb.pi())
    return distance, gradient, (c * second - (c - 1 / c) * first) * 4 / arb.pi() - gradient / c


def _f(a: int, b: int, c: int, z: arb) -> arb:
    """2F1(a / 2, b / 2; c; z)."""
    return z.hypgeom_2f1(arb(fmpq(a, 2)), arb(fmpq(b, 2)), arb(c))


@dataclass(frozen=True, eq=False)
class Support:
    """Pieces whose shares sum to 1."""

    points: tuple[Point, ...] = ()
    circles: tuple[Circle, ...] = ()
    lines: tuple[Line, ...] = ()

    @cached_property
    def _moments(self) -> tuple[fmpq, ...]:
        """Load, and first and second moments x, y, xx, xy, yy about the origin."""
        return tuple(sum(column, fmpq(0)) for column in zip(*self._parts_of_moments(), strict=True))

    def _parts_of_moments(self) -> Iterator[tuple[fmpq, ...]]:
        for point in self.points:
            yield _scale(point.share, _products(point.position, point.position))
        for circle in self.circles:
            one, x, y, xx, xy, yy = _products(circle.center, circle.center)
            spread = circle.radius**2 / (2 if circle.profile is ring else 4)
            yield _scale(circle.share, (one, x, y, xx + spread, xy, yy + spread))
        for line in self.lines:
            (a, b), (c, d) = line.start, line.end
            pairs = ((line.start, line.start), (line.end, line.end), (line.start, line.end))
            one, x, y, *squares = (
                sum(column, fmpq(0)) / 3
                for column in zip(*(_products(*p) for p in pairs), strict=True)
            )
            if line.plate:  # a triangle from the origin
                area, middle = line.share * (a * d - b * c) / 2, ((a + c) / 3, (b + d) / 3)
                yield _scale(area, (ONE, *middle, *(square / 2 for square in squares)))
            else:
                yield _scale(line.share, (ONE, (a + c) / 2, (b + d) / 2, *squares))

    @property
    def center(self) -> Position:
        """First moments of the pressure."""
        return self._moments[1], self._moments[2]

    @property
    def second(self) -> tuple[fmpq, fmpq, fmpq]:
        """Second moments xx, xy, yy about the origin."""
        return self._moments[3], self._moments[4], self._moments[5]

    @property
    @remember(1 << 10)
    def extent(self) -> arb:
        """Largest distance from the center of pressure."""
        ends = [(point.position, fmpq(0)) for point in self.points]
        ends += [(end, fmpq(0)) for line in self.lines for end in (line.start, line.end)]
        ends += [(circle.center, circle.radius) for circle in self.circles]
        x, y = self.center
        largest = arb(0)
        for (a, b), radius in ends:
            largest = arb.max(largest, arb((a - x) ** 2 + (b - y) ** 2).sqrt() + radius)
        return largest

    @cached_property
    def is_even(self) -> bool:
        """Whether the support equals its mirror image in the x axis."""
        return self._loads(1) == self._loads(-1)

    def _loads(self, flip: int) -> dict[tuple[Any, ...], fmpq]:
        def reflect(point: Position) -> tuple[str, str]:
            return str(point[0]), str(flip * point[1])

        shares: list[tuple[tuple[Any, ...], fmpq]] = [
            (reflect(p.position), p.share) for p in self.points
        ]
        shares += [((c.profile, reflect(c.center), str(c.radius)), c.share) for c in self.circles]
        for line in self.lines:  # a reflection reverses an edge
            ends = reflect(line.start), reflect(line.end)
            first, last = sorted(ends)
            side = -flip if line.plate and ends != (first, last) else flip if line.plate else 1
            shares.append(((line.plate, first, last), line.share * side))
        loads: dict[tuple[Any, ...], fmpq] = {}
        for key, share in shares:
            loads[key] = loads.get(key, ZERO) + share
        return {key: load for key, load in loads.items() if load}

    @cached_property
    def ends(self) -> tuple[Position, Position] | None:
        """Ends of a support that lies on a line, or None."""
        if self.circles or any(line.plate for line in self.lines):
            return None
        positions = [point.position for point in self.points]
        positions += [end for line in self.lines for end in (line.start, line.end)]
        first, last = min(positions, key=_key), max(positions, key=_key)
        along = last[0] - first[0], last[1] - first[1]
        offsets = (along[0] * (y - first[1]) - along[1] * (x - first[0]) for x, y in positions)
        return None if first == last or any(offsets) else (first, last)

    def dgh(self, c: Vector, skip: int = -1) -> Six:
        """D with gradient and Hessian at a center of rotation, without the point with the index `skip`.

        Raises
        ------
        Rim
            If the ball touches a point, or a segment's end; on a rim and within a segment, the Hessian is
            NaN.
        """
        total = [arb(0)] * 6
        for part in self._parts(c, skip):
            total = [a + b for a, b in zip(total, part, strict=True)]
        return total[0], total[1], total[2], total[3], total[4], total[5]

    def _parts(self, c: Vector, skip: int) -> Iterator[Six]:
        yield from (_of_point(point, c) for i, point in enumerate(self.points) if i != skip)
        yield from (_of_circle(circle, c) for circle in self.circles)
        yield from (_of_line(line, c) for line in self.lines)


def _key(point: Position) -> Position:
    return point


def _products(a: Position, b: Position) -> tuple[fmpq, ...]:
    mixed = (a[0] * b[1] + a[1] * b[0]) / 2
    return ONE, (a[0] + b[0]) / 2, (a[1] + b[1]) / 2, a[0] * b[0], mixed, a[1] * b[1]


def _scale(share: fmpq, numbers: Iterable[fmpq]) -> tuple[fmpq, ...]:
    return tuple(share * number for number in numbers)


def _of_point(point: Point, c: Vector) -> Six:
    (x, y), share = point
    dx, dy = c[0] - x, c[1] - y
    square = dx * dx + dy * dy
    if not square > 0:
        raise Rim("a center at a point of the support")
    rho = square.sqrt()
    first, third = share / rho, share / (rho * square)
    return share * rho, first * dx, first * dy, third * dy * dy, -third * dx * dy, third * dx * dx


def _of_circle(circle: Circle, c: Vector) -> Six:
    (x, y), radius, share = circle.center, circle.radius, circle.share
    dx, dy = (c[0] - x) / radius, (c[1] - y) / radius
    square = dx * dx + dy * dy
    inside = square < 1 or square > 1
    distance, slope, bend = (
        circle.profile(square) if inside else _across_rim(circle.profile, square)
    )
    first, second = share * slope / radius, 2 * share * bend / radius
    return (
        share * radius * distance, share * slope * dx, share * slope * dy,
        first + second * dx * dx, second * dx * dy, first + second * dy * dy,
    )  # fmt: skip


def _across_rim(profile: Profile, square: arb) -> tuple[arb, arb, arb]:
    """D and g enclosed by the ends of a ball, since D and the gradient increase with the distance."""
    ends, nudge = [], arb(2) ** (-3 * ctx.prec)
    for end, side in ((square.lower(), -1), (square.upper(), 1)):
        with ctx.workprec(4 * ctx.prec):
            beside = end + side * nudge if end == 1 else end
            distance, slope, _ = profile(beside)
            ends.append((distance, slope * beside.sqrt()))
    root = square.lower().sqrt().union(square.upper().sqrt())
    return ends[0][0].union(ends[1][0]), ends[0][1].union(ends[1][1]) / root, arb.nan()


def _of_line(line: Line, c: Vector) -> Six:
    """A segment or an edge, from the integrals of rho and of 1 / rho along it."""
    dx, dy = line.end[0] - line.start[0], line.end[1] - line.start[1]
    length = arb(dx * dx + dy * dy).sqrt()
    tx, ty = dx / length, dy / length  # the normal is (ty, -tx)
    (ax, ay), (bx, by) = ((p[0] - c[0], p[1] - c[1]) for p in (line.start, line.end))
    h, s1, s2 = (
        (ax * dy - ay * dx) / length,
        (ax * dx + ay * dy) / length,
        (bx * dx + by * dy) / length,
    )
    r1, r2 = norm(ax, ay), norm(bx, by)
    log = _log(length, (s1, s2), (r1, r2), h)
    r_change, s_sum = r2 - r1, s1 + s2
    integral = (length * (r1 + r2 + s_sum * s_sum / (r1 + r2)) / 2 + h * log) / 2
    ux, uy = tx * r_change + ty * log, ty * r_change - tx * log  # the integral of the unit vectors
    share = line.share
    if line.plate:
        return (
            share * h * integral / 3, -share * ty * integral, share * tx * integral,
            share * ty * ux, share * (ty * uy - tx * ux) / 2, -share * tx * uy,
        )  # fmt: skip
    rate, tt, tn = share / length, s2 / r2 - s1 / r1, h * (1 / r2 - 1 / r1)
    nn = (log / h if not h.is_zero() else _inverse((s1, s2), (r1, r2))) - tt
    return (
        rate * integral, -rate * ux, -rate * uy,
        rate * (tt * tx * tx + 2 * tn * tx * ty + nn * ty * ty),
        rate * ((tt - nn) * tx * ty + tn * (ty * ty - tx * tx)),
        rate * (tt * ty * ty - 2 * tn * tx * ty + nn * tx * tx),
    )  # fmt: skip


def _inverse(s: Vector, rho: Vector) -> arb:
    """Integral of 1 / rho along a line from a center on it."""
    return arb.pos_inf() if s[0] < 0 < s[1] else abs((rho[1] / rho[0]).log())


def _log(length: arb, s: Vector, rho: Vector, h: arb) -> arb:
    """H times the integral of 1 / rho, ``h log((sigma + l) / (sigma - l))``; zero on the line."""
    if h.is_zero():
        return arb(0)
    sigma = rho[0] + rho[1]
    if 2 * length < sigma:  # far away, where the argument of the logarithm is close to one
        return 2 * h * (length / sigma).atanh()
    if h * h > 0:
        parts = 1 / (rho[0] + abs(s[0])) + 1 / (rho[1] + abs(s[1]))
        rest = h * h * parts if s[0] < 0 < s[1] else sigma - length
        return h * ((sigma + length) / rest).log()
    # As sigma - l is at least h^2 / far, |h L| is at most |h| log(bound / h^2), which increases near zero.
    far = arb.max(rho[0] + abs(s[0]), rho[1] + abs(s[1]))
    bound, size = ((sigma + length) * far).upper(), abs(h).upper()
    if not (bound.is_finite() and size * size * 8 < bound):
        raise Rim("a center next to a line, in a wide ball")
    most = (size * (bound / (size * size)).log()).upper()
    return (-most).union(most)


def friction(k: arb) -> Vector:
    """Force f and torque t of the unit ring at a spin ratio k, over W and W R (Eqs. 2-3)."""
    if k.is_zero():
        return arb(1), arb(0)
    distance, slope, _ = ring(1 / (k * k)) if abs(k) != 1 else _across_rim(ring, arb(1))
    force = slope / abs(k)
    return force, k.sgn() * (distance - force / abs(k))
