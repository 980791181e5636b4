"""Moments of a support by their defining integrals, rigorously, with `acb.integral`.

This route shares nothing with the closed forms. A uniform plate is integrated in polar coordinates
about the center of rotation: along the radius the integrands are powers, and ``R^2 dtheta`` is ``r' x
dr'`` on its border.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable

from flint import acb, arb

from planar_pushing.certified.balls import Undecided
from planar_pushing.certified.supports.pressure.pieces import Circle, Line, Pieces

Vector = tuple[arb, arb]
Means = tuple[arb, arb, arb]
#: r' at a parameter of a curve.
Curve = Callable[[acb], tuple[acb, acb]]
#: Twice the area swept about the center of rotation, per parameter; 1 for means along the curve.
Swept = Callable[[acb, acb], acb]


def printed(support: Pieces, c: Vector) -> Means:
    """D and G at an exact center of rotation.

    Raises
    ------
    Undecided
        If the center is on a line or a rim of the support.
    """
    total = [arb(0)] * 3
    for part in _parts(support, c):
        total = [whole + each for whole, each in zip(total, part, strict=True)]
    if not all(each.is_finite() for each in total):
        raise Undecided(f"no integrals at {c}")
    return total[0], total[1], total[2]


def _parts(support: Pieces, c: Vector) -> Iterable[Means]:
    for point in support.points:
        x, y = point.place[0] - c[0], point.place[1] - c[1]
        if x.is_zero() and y.is_zero():
            continue  # it has no direction
        rho = (x * x + y * y).sqrt()
        yield point.share * rho, point.share * x / rho, point.share * y / rho
    yield from (_along_line(each, c) for each in support.segments)
    yield from (_under_line(each, c) for each in support.edges)
    yield from (_along_rim(each, c) for each in support.rings)
    yield from (_under_rim(each, c) for each in support.discs)


def _along_line(line: Line, c: Vector) -> Means:
    """A segment: means over its length; from a center on its line the integrands are |s| and its sign."""
    d_x, d_y = line.along
    x, y = line.start[0] - c[0], line.start[1] - c[1]
    if (x * d_y - y * d_x).is_zero():
        whole = d_x**2 + d_y**2
        start = (x * d_x + y * d_y) / whole
        end, length = start + 1, arb(whole).sqrt()
        slope = (abs(end) - abs(start)) * line.share / length
        distance = (end * abs(end) - start * abs(start)) * length * line.share / 2
        return distance, slope * d_x, slope * d_y
    found = _integrals(_on_line(line, c), 0, arb(1), lambda *_: acb(1))
    return _scaled(found, (arb(line.share), arb(line.share)))


def _under_line(line: Line, c: Vector) -> Means:
    """Integrals over the triangle between the center of rotation and an edge of a plate."""
    d_x, d_y = line.along
    swept = (line.start[0] - c[0]) * d_y - (line.start[1] - c[1]) * d_x
    if swept.is_zero():
        return arb(0), arb(0), arb(0)
    found = _integrals(_on_line(line, c), 0, arb(1), lambda *_: acb(swept))
    return _scaled(found, (arb(line.share) / 3, arb(line.share) / 2))


def _on_line(line: Line, c: Vector) -> Curve:
    (a, b), (d_x, d_y) = line.start, line.along
    return lambda w: (a - c[0] + w * d_x, b - c[1] + w * d_y)


def _along_rim(circle: Circle, c: Vector) -> Means:
    """A ring: means over its circle."""
    found = _integrals(_on_rim(circle, c), -1, arb.pi(), lambda *_: acb(1))
    rate = circle.share / (2 * arb.pi())
    return _scaled(found, (rate, rate))


def _under_rim(circle: Circle, c: Vector) -> Means:
    """A disc, by its rim."""
    middle = circle.center[0] - c[0], circle.center[1] - c[1]

    def swept(x: acb, y: acb) -> acb:
        return x * (x - middle[0]) + y * (y - middle[1])

    found = _integrals(_on_rim(circle, c), -1, arb.pi(), swept)
    density = circle.share / (arb.pi() * circle.radius**2)
    return _scaled(found, (density / 3, density / 2))


def _on_rim(circle: Circle, c: Vector) -> Curve:
    x, y = circle.center[0] - c[0], circle.center[1] - c[1]
    return lambda w: (x + circle.radius * w.cos(), y + circle.radius * w.sin())


def _scaled(found: Means, factors: tuple[arb, arb]) -> Means:
    return factors[0] * found[0], factors[1] * found[1], factors[1] * found[2]


def _integrals(curve: Curve, start: int, end: arb, swept: Swept) -> Means:
    """Integrals of rho and of r' / rho times the swept area, from `start * end` to `end`."""

    def integrand(part: int) -> Callable[[acb, bool], acb]:
        def value(w: acb, analytic: bool) -> acb:
            x, y = curve(w)
            rho = (x * x + y * y).sqrt(analytic=analytic)
            return swept(x, y) * (rho, x / rho, y / rho)[part]

        return value

    first, second, third = (
        acb.integral(integrand(part), start * end, end).real for part in range(3)
    )
    return first, second, third
