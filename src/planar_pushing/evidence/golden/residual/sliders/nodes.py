"""Supports as nodes and weights of Gauss's and the trapezoidal rule."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np

from planar_pushing.certified.doubled.numbers import Floats
from planar_pushing.certified.supports.pressure.pieces import Circle, Line, Pieces, Place

#: Nodes along a line or a radius, and around a circle: seen from eight extents away they err by 1e-18.
LINE, TURN = 10, 24

Nodes = tuple[Any, Any, Any]


def doubles(place: Place) -> tuple[float, float]:
    """A place in doubles."""
    x, y = (int(each.p) / int(each.q) for each in place)
    return x, y


def nodes(support: Pieces) -> Nodes:
    """Coordinates and weights, which add to 1."""
    x, y, weight = (np.concatenate(each) for each in zip(*_parts(support), strict=True))
    return x, y, weight


def _parts(support: Pieces) -> Iterable[Nodes]:
    for point in support.points:
        x, y = doubles(point.place)
        yield np.array([x]), np.array([y]), np.array([share(point)])
    yield from map(_on_line, support.segments)
    yield from map(_under_line, support.edges)
    yield from map(_on_rim, support.rings)
    yield from map(_under_rim, support.discs)


def share(piece: Any) -> float:
    """A piece's share in doubles."""
    return int(piece.share.p) / int(piece.share.q)


def _unit() -> tuple[Floats, Floats]:
    """Gauss's rule on the unit interval."""
    at, weight = np.polynomial.legendre.leggauss(LINE)
    return (at + 1) / 2, weight / 2


def _on_line(line: Line) -> Nodes:
    (a, b), (c, d), (at, weight) = doubles(line.start), doubles(line.end), _unit()
    return a + at * (c - a), b + at * (d - b), share(line) * weight


def _under_line(line: Line) -> Nodes:
    """The triangle from the origin, which counts negative where it turns clockwise."""
    (a, b), (c, d), (at, weight) = doubles(line.start), doubles(line.end), _unit()
    out, along = (each.ravel() for each in np.meshgrid(at, at, indexing="ij"))
    load = share(line) * (a * d - b * c)
    both = np.outer(weight * at, weight).ravel()
    return out * (a + along * (c - a)), out * (b + along * (d - b)), load * both


def _on_rim(circle: Circle) -> Nodes:
    (a, b), turn = doubles(circle.center), 2 * np.pi * np.arange(TURN) / TURN
    radius = int(circle.radius.p) / int(circle.radius.q)
    weight = np.full(TURN, share(circle) / TURN)
    return a + radius * np.cos(turn), b + radius * np.sin(turn), weight


def _under_rim(circle: Circle) -> Nodes:
    (a, b), (at, weight) = doubles(circle.center), _unit()
    x, y, even = _on_rim(circle)
    out = 2 * np.outer(at * weight, even).ravel()
    return a + np.outer(at, x - a).ravel(), b + np.outer(at, y - b).ravel(), out
