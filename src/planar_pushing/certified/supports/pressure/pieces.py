"""A support as exact pieces: points, lines, rings, discs, and plates bounded by lines.

The entries are plain values of a scene file. Doubles are taken as exact, so that shares, areas and the
center of pressure are rational.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import Any

from flint import arb, fmpq

from planar_pushing.certified.balls import rational

Entry = Mapping[str, Any]
Place = tuple[fmpq, fmpq]


@dataclass(frozen=True, slots=True)
class Point:
    """A point and its share."""

    place: Place
    share: fmpq


@dataclass(frozen=True, slots=True)
class Line:
    """A directed line with a share: of a segment, or of the pressure on the left of an edge of plates."""

    start: Place
    end: Place
    share: fmpq

    @property
    def along(self) -> Place:
        """Vector from the start to the end."""
        return self.end[0] - self.start[0], self.end[1] - self.start[1]


@dataclass(frozen=True, slots=True)
class Circle:
    """A ring or a disc with its share, which is negative for the hole of an annulus."""

    center: Place
    radius: fmpq
    share: fmpq


@dataclass(frozen=True)
class Pieces:
    """Pieces whose shares sum to 1."""

    points: tuple[Point, ...] = ()
    segments: tuple[Line, ...] = ()
    rings: tuple[Circle, ...] = ()
    discs: tuple[Circle, ...] = ()
    edges: tuple[Line, ...] = ()

    def __hash__(self) -> int:
        # Hashing every number would take longer than many of the cached computations.
        members = self.points, self.segments, self.rings, self.discs, self.edges
        return hash(tuple(map(len, members)))

    @cached_property
    def center(self) -> Place:
        """Center of pressure."""
        loads = [(each.share, each.place) for each in self.points]
        loads += [(each.share, _middle(each)) for each in self.segments]
        loads += [(each.share, each.center) for each in (*self.rings, *self.discs)]
        loads += [_wedge(each) for each in self.edges]
        x, y = (sum((share * place[i] for share, place in loads), fmpq(0)) for i in (0, 1))
        return x, y

    @cached_property
    def second(self) -> tuple[fmpq, fmpq, fmpq]:
        """Second moments xx, xy, yy about the origin."""
        parts = [(each.share, _square(each.place, each.place)) for each in self.points]
        parts += [(each.share, _line_square(each)) for each in self.segments]
        for part, circles in ((2, self.rings), (4, self.discs)):
            parts += [(each.share, _circle_square(each, part)) for each in circles]
        parts += [
            (_wedge(each)[0] / 2, _line_square(each)) for each in self.edges
        ]  # a triangle from the origin
        xx, xy, yy = (sum((share * each[i] for share, each in parts), fmpq(0)) for i in range(3))
        return xx, xy, yy

    @property
    def spread(self) -> fmpq:
        """Mean square distance from the center of pressure."""
        (x, y), (xx, _, yy) = self.center, self.second
        return xx + yy - x * x - y * y

    @property
    def extent(self) -> arb:
        """Largest distance from the center of pressure."""
        lines = (*self.segments, *self.edges)
        places = [(each.place, fmpq(0)) for each in self.points]
        places += [(end, fmpq(0)) for each in lines for end in (each.start, each.end)]
        places += [(each.center, each.radius) for each in (*self.rings, *self.discs)]
        found, (x, y) = arb(0), self.center
        for place, radius in places:
            square = (place[0] - x) ** 2 + (place[1] - y) ** 2
            found = arb.max(found, arb(square).sqrt() + radius)
        return found


def _middle(line: Line) -> Place:
    return (line.start[0] + line.end[0]) / 2, (line.start[1] + line.end[1]) / 2


def _wedge(line: Line) -> tuple[fmpq, Place]:
    """Load and center of the triangle from the origin to an edge."""
    (a, b), (c, d) = line.start, line.end
    return line.share * (a * d - b * c) / 2, ((a + c) / 3, (b + d) / 3)


def _square(a: Place, b: Place) -> tuple[fmpq, fmpq, fmpq]:
    return a[0] * b[0], (a[0] * b[1] + a[1] * b[0]) / 2, a[1] * b[1]


def _line_square(line: Line) -> tuple[fmpq, fmpq, fmpq]:
    """Mean squares along a line; half of them is the mean over the triangle from the origin."""
    a, b = line.start, line.end
    first, last, mixed = _square(a, a), _square(b, b), _square(a, b)
    xx, xy, yy = ((first[i] + last[i] + mixed[i]) / 3 for i in range(3))
    return xx, xy, yy


def _circle_square(circle: Circle, part: int) -> tuple[fmpq, fmpq, fmpq]:
    xx, xy, yy = _square(circle.center, circle.center)
    own = circle.radius**2 / part
    return xx + own, xy, yy + own


def pieces(entry: Entry) -> Pieces:
    """Pieces of a support from its entry in a scene file."""
    return SHAPES[entry["shape"]](entry)


def _place(given: Sequence[float]) -> Place:
    return rational(given[0]), rational(given[1])


def _points(entry: Entry) -> Pieces:
    loads: dict[Place, fmpq] = {}
    for position, weight in zip(entry["positions"], entry["weights"], strict=True):
        place = _place(position)
        loads[place] = loads.get(place, fmpq(0)) + rational(weight)
    whole = sum(loads.values(), fmpq(0))
    return Pieces(points=tuple(Point(place, load / whole) for place, load in loads.items()))


def _segment(entry: Entry) -> Pieces:
    return Pieces(segments=(Line(_place(entry["start"]), _place(entry["end"]), fmpq(1)),))


def _ring(entry: Entry) -> Pieces:
    radius = entry.get("radius")
    return Pieces(rings=(_circle(entry.get("center") or (0, 0), 1 if radius is None else radius),))


def _disc(entry: Entry) -> Pieces:
    return Pieces(discs=(_circle(entry.get("center", (0, 0)), entry["radius"]),))


def _circle(center: Sequence[float], radius: float, share: fmpq | None = None) -> Circle:
    return Circle(_place(center), rational(radius), fmpq(1) if share is None else share)


def _annulus(entry: Entry) -> Pieces:
    squares = [rational(entry[name]) ** 2 for name in ("outer", "inner")]
    area, center = squares[0] - squares[1], entry.get("center", (0, 0))
    discs = (
        _circle(center, entry["outer"], squares[0] / area),
        _circle(center, entry["inner"], -squares[1] / area),
    )
    return Pieces(discs=discs)


def _polygon(entry: Entry) -> Pieces:
    holes = [side for each in entry.get("holes") or () for side in _boundary(each, -1)]
    return Pieces(edges=_even([*_boundary(entry["vertices"], 1), *holes]))


def _boundary(vertices: Sequence[Sequence[float]], pressure: int) -> list[Line]:
    """Edges of a polygon in which the pressure rises by a number."""
    corners = list(map(_place, vertices))
    sides = [Line(a, b, fmpq(pressure)) for a, b in pairwise([*corners, corners[0]])]
    turns = sum((_wedge(each)[0] for each in sides), fmpq(0)) * pressure
    return [Line(each.start, each.end, each.share * (1 if turns > 0 else -1)) for each in sides]


def _pressure_map(entry: Entry) -> Pieces:
    x, y = (list(map(rational, entry[name])) for name in "xy")
    steps: dict[tuple[Place, Place], fmpq] = {}
    for j, row in enumerate(entry["pressure"]):
        for i, pressure in enumerate(row):
            west, east, south, north = x[i], x[i + 1], y[j], y[j + 1]
            corners = [(west, south), (east, south), (east, north), (west, north), (west, south)]
            for a, b in pairwise(corners):
                _step(steps, a, b, rational(pressure))
    frame = _place(entry.get("origin") or (0, 0)), _place(entry.get("axis") or (1, 0))
    lines = [
        Line(_out_of(frame, a), _out_of(frame, b), step) for (a, b), step in steps.items() if step
    ]
    return Pieces(edges=_even(lines))


def _out_of(frame: tuple[Place, Place], place: Place) -> Place:
    """A place of a map in the body frame; its axis counts as exact and can stretch the map by an ulp."""
    (x, y), (a, b) = frame
    return x + place[0] * a - place[1] * b, y + place[1] * a + place[0] * b


def _step(steps: dict[tuple[Place, Place], fmpq], a: Place, b: Place, pressure: fmpq) -> None:
    """Add the pressure on the left of an edge; the pressure of the cell on its right is subtracted."""
    ends, sign = ((a, b), 1) if a < b else ((b, a), -1)
    steps[ends] = steps.get(ends, fmpq(0)) + sign * pressure


def _even(edges: Iterable[Line]) -> tuple[Line, ...]:
    """Edges of plates that together carry a load of 1."""
    edges = list(edges)
    load = sum((_wedge(each)[0] for each in edges), fmpq(0))
    return tuple(Line(each.start, each.end, each.share / load) for each in edges)


def _composite(entry: Entry) -> Pieces:
    shares = [rational(member["share"]) for member in entry["members"]]
    whole = sum(shares, fmpq(0))
    found = [pieces(member["support"]) for member in entry["members"]]
    return together([(each, share / whole) for each, share in zip(found, shares, strict=True)])


def together(members: Iterable[tuple[Pieces, fmpq]]) -> Pieces:
    """Combine supports that carry shares of one load."""
    parts = [_shared(each, share) for each, share in members]
    return Pieces(
        points=_merged([point for each in parts for point in each.points]),
        segments=tuple(line for each in parts for line in each.segments),
        rings=tuple(ring for each in parts for ring in each.rings),
        discs=tuple(disc for each in parts for disc in each.discs),
        edges=tuple(edge for each in parts for edge in each.edges),
    )


def _shared(whole: Pieces, share: fmpq) -> Pieces:
    """Pieces that together carry a given share."""
    return Pieces(
        points=tuple(Point(each.place, each.share * share) for each in whole.points),
        segments=tuple(Line(each.start, each.end, each.share * share) for each in whole.segments),
        rings=tuple(Circle(each.center, each.radius, each.share * share) for each in whole.rings),
        discs=tuple(Circle(each.center, each.radius, each.share * share) for each in whole.discs),
        edges=tuple(Line(each.start, each.end, each.share * share) for each in whole.edges),
    )


def _merged(points: Sequence[Point]) -> tuple[Point, ...]:
    """Points, with those at the same place merged."""
    loads: dict[Place, fmpq] = {}
    for each in points:
        loads[each.place] = loads.get(each.place, fmpq(0)) + each.share
    return tuple(Point(place, load) for place, load in loads.items())


#: Makes the pieces of each shape.
SHAPES: dict[str, Callable[[Entry], Pieces]] = {
    "points": _points,
    "segment": _segment,
    "ring": _ring,
    "disc": _disc,
    "annulus": _annulus,
    "polygon": _polygon,
    "pressure_map": _pressure_map,
    "composite": _composite,
}
