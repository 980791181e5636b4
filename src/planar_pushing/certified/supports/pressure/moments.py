"""Mean distance, mean unit vector, torque and second derivatives of a support, enclosed.

With r' = r - c from a center of rotation c, and rho = |r'|, D is the mean of rho, G is the mean of r' /
rho, and the second derivatives of D by c are the mean of ``(1 - r' r'^T / rho^2) / rho``.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import lru_cache
from typing import NamedTuple

from flint import arb, fmpq

from planar_pushing.certified.balls import Undecided, norm, unit
from planar_pushing.certified.supports.pressure.circles import disc, ring
from planar_pushing.certified.supports.pressure.lines import edge, segment
from planar_pushing.certified.supports.pressure.pieces import Circle, Pieces, Point

Vector = tuple[arb, arb]
#: D, G_x, G_y, and the second derivatives xx, xy, yy of one piece.
Part = tuple[arb, arb, arb, arb, arb, arb]
#: Evaluates D and G at an exact center of rotation; a process uses the closed forms until `use`.
Route = Callable[[Pieces, Vector], tuple[arb, arb, arb]]
_route: Route | None = None


class Moments(NamedTuple):
    """Moments of a support's pressure about a motion center, from which friction follows.

    Attributes
    ----------
    distance : arb
        D.
    x, y : arb
        G. A point at the center contributes zero here and to the second derivatives.
    xx, xy, yy : arb
        Second derivatives of D by the center; infinite or NaN where they do not exist.
    """

    distance: arb
    x: arb
    y: arb
    xx: arb
    xy: arb
    yy: arb

    def torque(self, c: Vector, about: tuple[arb | fmpq, arb | fmpq]) -> arb:
        """Torque about a place, for counter-clockwise rotation: ``D + (c - place) . G``."""
        return self.distance + (c[0] - about[0]) * self.x + (c[1] - about[1]) * self.y


def moments(support: Pieces, c: Vector) -> Moments:
    """Moments at a center of rotation, exact or a ball.

    Raises
    ------
    Undecided
        If a ball does not bound D or G: next to a point of the support, or to a rim.
    """
    total = [arb(0)] * 6
    for part in _parts(support, c):
        total = [whole + each for whole, each in zip(total, part, strict=True)]
    found = Moments(*total)
    if _route is not None:
        found = _by(_route, support, c, found)
    if not all(each.is_finite() for each in found[:3]):
        raise Undecided(f"no moments at {c}")
    return found


def _by(route: Route, support: Pieces, c: Vector, known: Moments) -> Moments:
    """D and G by a route at the middle of a ball, and over the ball by their derivatives if they exist."""
    middle = c[0].mid(), c[1].mid()
    distance, x, y = route(support, middle)
    d_x, d_y = c[0] - middle[0], c[1] - middle[1]
    if not (d_x.is_zero() and d_y.is_zero()):
        distance -= known.x * d_x + known.y * d_y
        x -= known.xx * d_x + known.xy * d_y
        y -= known.xy * d_x + known.yy * d_y
    if not (distance.is_finite() and x.is_finite() and y.is_finite()):
        return known
    return known._replace(distance=distance, x=x, y=y)


def use(route: Route) -> None:
    """Evaluate D and G at exact centers by this route from now on; call it first in a process."""
    global _route
    _route = lru_cache(maxsize=16)(
        route
    )  # forces and derivatives are evaluated one after the other


def _parts(support: Pieces, c: Vector) -> Iterable[Part]:
    yield from (_point(each, c) for each in support.points)
    yield from (segment(each, c) for each in support.segments)
    yield from (edge(each, c) for each in support.edges)
    for profile, circles in ((ring, support.rings), (disc, support.discs)):
        yield from (_turned(each, c, profile(distance(each, c), each.radius)) for each in circles)


def _point(point: Point, c: Vector) -> Part:
    x, y = point.place[0] - c[0], point.place[1] - c[1]
    if x.is_zero() and y.is_zero():
        return (arb(0),) * 6
    rho, share = norm(x, y), point.share
    e_x, e_y, rate = unit(x / rho), unit(y / rho), share / rho
    second = rate * e_y * e_y, -rate * e_x * e_y, rate * e_x * e_x
    return share * rho, share * e_x, share * e_y, *second


def distance(circle: Circle, c: Vector) -> arb:
    """Distance of a center of rotation from that of a circle."""
    x, y = c[0] - circle.center[0], c[1] - circle.center[1]
    return norm(x, y)


def _turned(circle: Circle, c: Vector, radial: tuple[arb, arb, arb, arb]) -> Part:
    """A radial piece from D, its slope and its curvatures along and across the radius."""
    whole, slope, along, across = (circle.share * each for each in radial)
    x, y, size = c[0] - circle.center[0], c[1] - circle.center[1], distance(circle, c)
    if size.is_zero():
        return whole, arb(0), arb(0), across, arb(0), across
    e_x, e_y = unit(x / size), unit(y / size)
    second = (
        along * e_x * e_x + across * e_y * e_y,
        (along - across) * e_x * e_y,
        along * e_y * e_y + across * e_x * e_x,
    )
    return whole, -slope * e_x, -slope * e_y, *second
