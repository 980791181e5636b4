"""Shapes of scene files as exact pieces of a support."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from itertools import pairwise
from typing import Any

from flint import fmpq

from pulling_by_pushing.oracle.balls import Position, rational, rational_pair
from pulling_by_pushing.oracle.support import ONE, Circle, Line, Point, Profile, Support, disc, ring

#: A support in the form of a scene file.
SupportEntry = Mapping[str, Any]


def support(entry: SupportEntry) -> Support:
    """The support of an entry in a scene file, with a ring's radius 1 if it states none."""
    return _SHAPES[entry["shape"]](entry)


def _points(entry: SupportEntry) -> Support:
    loads: dict[Position, fmpq] = {}
    for point, weight in zip(map(rational_pair, entry["positions"]), entry["weights"], strict=True):
        loads[point] = loads.get(point, fmpq(0)) + rational(weight)
    total = sum(loads.values(), fmpq(0))
    return Support(points=tuple(Point(point, load / total) for point, load in loads.items()))


def _circle(profile: Profile, entry: SupportEntry, radius: Any, share: fmpq = ONE) -> Circle:
    return Circle(profile, rational_pair(entry.get("center") or (0, 0)), rational(radius), share)


def _ring(entry: SupportEntry) -> Support:
    radius = entry.get("radius")
    return Support(circles=(_circle(ring, entry, 1 if radius is None else radius),))


def _disc(entry: SupportEntry) -> Support:
    return Support(circles=(_circle(disc, entry, entry["radius"]),))


def _annulus(entry: SupportEntry) -> Support:
    outer, inner = (rational(entry[name]) ** 2 for name in ("outer", "inner"))
    shares = (("outer", outer / (outer - inner)), ("inner", -inner / (outer - inner)))
    return Support(
        circles=tuple(_circle(disc, entry, entry[name], share) for name, share in shares)
    )


def _segment(entry: SupportEntry) -> Support:
    return Support(
        lines=(Line(rational_pair(entry["start"]), rational_pair(entry["end"]), ONE, plate=False),)
    )


def _polygon(entry: SupportEntry) -> Support:
    holes = [line for hole in entry.get("holes") or () for line in _boundary(hole, -1)]
    return Support(lines=_plates([*_boundary(entry["vertices"], 1), *holes]))


def _boundary(vertices: Sequence[Sequence[float]], pressure: int) -> list[Line]:
    """Edges of a polygon inside which the pressure rises by a number, in either order of vertices."""
    corners = list(map(rational_pair, vertices))
    edges = [Line(a, b, fmpq(pressure), plate=True) for a, b in pairwise([*corners, corners[0]])]
    sense = 1 if sum(map(_load, edges), fmpq(0)) * pressure > 0 else -1
    return [line._replace(share=line.share * sense) for line in edges]


def _pressure_map(entry: SupportEntry) -> Support:
    x, y = (list(map(rational, entry[name])) for name in "xy")
    steps: dict[tuple[Position, Position], fmpq] = {}
    for j, row in enumerate(entry["pressure"]):
        for i, pressure in enumerate(row):
            corners = [(x[i], y[j]), (x[i + 1], y[j]), (x[i + 1], y[j + 1]), (x[i], y[j + 1])]
            for a, b in pairwise([*corners, corners[0]]):
                ends, side = ((a, b), 1) if a < b else ((b, a), -1)
                steps[ends] = steps.get(ends, fmpq(0)) + side * rational(pressure)
    (ox, oy), (ax, ay) = (
        rational_pair(entry.get("origin") or (0, 0)),
        rational_pair(entry.get("axis") or (1, 0)),
    )

    def to_body(p: Position) -> Position:
        return ox + p[0] * ax - p[1] * ay, oy + p[1] * ax + p[0] * ay

    lines = [
        Line(to_body(a), to_body(b), step, plate=True) for (a, b), step in steps.items() if step
    ]
    return Support(lines=_plates(lines))


def _load(line: Line) -> fmpq:
    (a, b), (c, d) = line.start, line.end
    return line.share * (a * d - b * c) / 2


def _plates(edges: Sequence[Line]) -> tuple[Line, ...]:
    """Edges of plates that together carry a load of 1."""
    load = sum(map(_load, edges), fmpq(0))
    return tuple(line._replace(share=line.share / load) for line in edges)


def _composite(entry: SupportEntry) -> Support:
    members = [
        (support(member["support"]), rational(member["share"])) for member in entry["members"]
    ]
    load = sum((share for _, share in members), fmpq(0))
    return together([(member, share / load) for member, share in members])


def together(members: Iterable[tuple[Support, fmpq]]) -> Support:
    """Supports that carry shares of one load."""
    points: dict[Position, fmpq] = {}
    circles: list[Circle] = []
    lines: list[Line] = []
    for member, share in members:
        for point in member.points:
            points[point.position] = points.get(point.position, fmpq(0)) + share * point.share
        circles += [circle._replace(share=share * circle.share) for circle in member.circles]
        lines += [line._replace(share=share * line.share) for line in member.lines]
    return Support(tuple(Point(*item) for item in points.items()), tuple(circles), tuple(lines))


_SHAPES: Mapping[str, Callable[[SupportEntry], Support]] = {
    "points": _points,
    "segment": _segment,
    "ring": _ring,
    "disc": _disc,
    "annulus": _annulus,
    "polygon": _polygon,
    "pressure_map": _pressure_map,
    "composite": _composite,
}
