"""D and its gradient by their defining integrals, with `acb.integral`: the second route of golden data.

They are rigorous and share nothing with the closed forms of `support`. A uniform plate is integrated in
polar coordinates about the center of rotation: along the radius the integrands are powers, and on its
border ``R^2 dtheta`` is ``r' x dr'``.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

from flint import acb, arb, fmpq

from pulling_by_pushing.oracle.balls import Undecided, Vector
from pulling_by_pushing.oracle.support import Circle, Line, Support, ring

#: Integrals of rho, and of the components of r' / rho.
Means = tuple[arb, arb, arb]
#: r' at a parameter of a curve.
Curve = Callable[[acb], tuple[acb, acb]]
#: Twice the area swept about the center of rotation, per parameter; 1 for means along the curve.
Swept = Callable[[acb, acb], acb]


def distance_and_gradient(support: Support, c: Vector) -> Means:
    """D and its gradient at an exact center of rotation; a point at the center has no direction.

    Raises
    ------
    Undecided
        If an integral is not finite, as at the end of a line.
    """
    total = [arb(0)] * 3
    for part in _parts(support, c):
        total = [a + b for a, b in zip(total, part, strict=True)]
    if not all(part.is_finite() for part in total):
        raise Undecided(f"no integrals at {c}")
    return total[0], -total[1], -total[2]


def _parts(support: Support, c: Vector) -> Iterator[Means]:
    for point in support.points:
        x, y = point.position[0] - c[0], point.position[1] - c[1]
        if not (x.is_zero() and y.is_zero()):
            rho = (x * x + y * y).sqrt()
            yield point.share * rho, point.share * x / rho, point.share * y / rho
    for line in support.lines:
        yield _triangle_integrals(line, c) if line.plate else _segment_means(line, c)
    for circle in support.circles:
        yield _ring_means(circle, c) if circle.profile is ring else _disc_integrals(circle, c)


def _segment_means(line: Line, c: Vector) -> Means:
    """A segment: means over its length; from a center on its line the integrands are |s| and its sign."""
    dx, dy = line.end[0] - line.start[0], line.end[1] - line.start[1]
    x, y = line.start[0] - c[0], line.start[1] - c[1]
    if (x * dy - y * dx).is_zero():
        square = dx * dx + dy * dy
        start = (x * dx + y * dy) / square
        end, length = start + 1, arb(square).sqrt()
        slope = (abs(end) - abs(start)) * line.share / length
        return (
            (end * abs(end) - start * abs(start)) * length * line.share / 2,
            slope * dx,
            slope * dy,
        )
    return _scale(
        _integrals(_on_line(line, c), 0, arb(1), lambda *_: acb(1)), line.share, line.share
    )


def _triangle_integrals(line: Line, c: Vector) -> Means:
    """Integrals over the triangle between the center of rotation and an edge of a plate."""
    dx, dy = line.end[0] - line.start[0], line.end[1] - line.start[1]
    swept = (line.start[0] - c[0]) * dy - (line.start[1] - c[1]) * dx
    if swept.is_zero():
        return arb(0), arb(0), arb(0)
    integrals = _integrals(_on_line(line, c), 0, arb(1), lambda *_: acb(swept))
    return _scale(integrals, line.share / 3, line.share / 2)


def _on_line(line: Line, c: Vector) -> Curve:
    (a, b), dx, dy = line.start, line.end[0] - line.start[0], line.end[1] - line.start[1]
    return lambda w: (a - c[0] + w * dx, b - c[1] + w * dy)


def _ring_means(circle: Circle, c: Vector) -> Means:
    """Means over a circle, times the share of the ring."""
    integrals = _integrals(_on_rim(circle, c), -1, arb.pi(), lambda *_: acb(1))
    rate = circle.share / (2 * arb.pi())
    return _scale(integrals, rate, rate)


def _disc_integrals(circle: Circle, c: Vector) -> Means:
    """Integrals over a disc, as integrals along its rim."""
    x, y = circle.center[0] - c[0], circle.center[1] - c[1]
    integrals = _integrals(_on_rim(circle, c), -1, arb.pi(), lambda a, b: a * (a - x) + b * (b - y))
    density = circle.share / (arb.pi() * circle.radius**2)
    return _scale(integrals, density / 3, density / 2)


def _on_rim(circle: Circle, c: Vector) -> Curve:
    x, y = circle.center[0] - c[0], circle.center[1] - c[1]
    return lambda w: (x + circle.radius * w.cos(), y + circle.radius * w.sin())


def _scale(integrals: Means, first: arb | fmpq, second: arb | fmpq) -> Means:
    return first * integrals[0], second * integrals[1], second * integrals[2]


def _integrals(curve: Curve, start: int, end: arb, swept: Swept) -> Means:
    """Integrals of rho and of r' / rho times the swept area, from `start * end` to `end`."""

    def integrand(part: int) -> Callable[[acb, bool], acb]:
        def value(w: acb, analytic: bool) -> acb:
            x, y = curve(w)
            rho = (x * x + y * y).sqrt(analytic=analytic)
            return swept(x, y) * (rho, x / rho, y / rho)[part]

        return value

    first, second, third = (acb.integral(integrand(i), start * end, end).real for i in range(3))
    return first, second, third
