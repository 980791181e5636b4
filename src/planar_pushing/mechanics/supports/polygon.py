"""A uniform polygon: the flat base of a box."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Any

import numpy as np

from planar_pushing.core.supports.polygons import EdgePair, PolygonPair, PolygonRow
from planar_pushing.mechanics.kernels.calls import run
from planar_pushing.mechanics.kernels.columns import row_of
from planar_pushing.mechanics.plane import Frame, positions_in_frame
from planar_pushing.mechanics.pressure.pieces import Array, Pieces
from planar_pushing.mechanics.supports.base import (
    PLACES,
    POSITION,
    POSITIONS,
    InPieces,
    Position,
    positions,
)
from planar_pushing.mechanics.supports.layouts import (
    COUNT,
    HEIGHT,
    RADIUS,
    TURN,
    WIDTH,
    placed_corners,
    rectangle_corners,
    regular_corners,
)
from planar_pushing.terms.declared import Read, replace_checked
from planar_pushing.terms.errors import InvalidValue

#: Smallest area, relative to the square of the polygon's size; a smaller one is rounding error.
THINNEST = 1e-12


def _rings(name: str, value: Any) -> tuple[tuple[Position, ...], ...]:
    """Vertices of at least one hole."""
    if not isinstance(value, (list, tuple)) or not value:
        raise InvalidValue(name, value, "a sequence of rings", "give the vertices of each hole")
    return tuple(positions(f"{name}[{i}]", ring) for i, ring in enumerate(value))


HOLES = Read(_rings, "the vertices of each hole", {"type": "array", "minItems": 1, "items": PLACES})


@dataclass(frozen=True, slots=True)
class Polygon(InPieces):
    """Support on a simple polygon, with or without holes, with uniform pressure.

    Parameters
    ----------
    vertices : sequence of pairs, or an object with `coords` or `exterior`
        At least three, in the body frame, clockwise or counterclockwise; the polygon need not be convex.
        The first may be repeated at the end, as in the rings of GeoJSON and shapely.
    holes : sequence of the same, optional
        Areas without pressure, each a simple polygon inside of the first and apart from the other holes.
        The `interiors` of a polygon of shapely are holes, too.

    Raises
    ------
    InvalidValue
        If there are fewer than three vertices, a number is not finite, two edges cross or touch, a hole is
        not inside of the polygon, the area is zero, or the object has several parts.
    """

    vertices: Annotated[Any, POSITIONS]
    holes: Annotated[Any, HOLES] = ()

    def __post_init__(self) -> None:
        outer = simple_ring("vertices", self.vertices)
        inner = [simple_ring(f"holes[{i}]", hole) for i, hole in enumerate(self._inner())]
        _require_holes(outer, inner)
        object.__setattr__(self, "vertices", _pairs(outer))
        object.__setattr__(self, "holes", tuple(map(_pairs, inner)))

    def _inner(self) -> list[Any]:
        """The holes that the given vertices have themselves, and those given with them."""
        interiors = getattr(self.vertices, "interiors", getattr(self.vertices, "holes", ()))
        try:
            return [*interiors, *self.holes]
        except TypeError:
            raise InvalidValue(
                "holes", self.holes, "a sequence of rings", "give the vertices of each hole"
            ) from None

    @classmethod
    def rectangle(
        cls, width: Annotated[float, WIDTH], height: Annotated[float, HEIGHT],
        center: Annotated[Any, POSITION] = (0.0, 0.0), angle: Annotated[float, TURN] = 0.0,
    ) -> Polygon:  # fmt: skip
        """A rectangle about a center, whose width is at an angle from x, in radians."""
        return cls(placed_corners(rectangle_corners(width, height), center, angle))

    @classmethod
    def regular(
        cls, count: Annotated[int, COUNT], radius: Annotated[float, RADIUS],
        center: Annotated[Any, POSITION] = (0.0, 0.0), angle: Annotated[float, TURN] = 0.0,
    ) -> Polygon:  # fmt: skip
        """A regular polygon with `count` corners at a radius, the first at an angle from x, in radians."""
        return cls(placed_corners(regular_corners(count, radius), center, angle))

    def in_frame(self, frame: Frame) -> Polygon:
        """The same polygon expressed in another frame."""
        vertices, *holes = (
            positions_in_frame(ring, frame) for ring in (self.vertices, *self.holes)
        )
        # A polygon that is moved rigidly remains simple.
        return replace_checked(self, vertices=vertices, holes=tuple(holes))

    def pieces(self) -> Pieces:
        outer, *inner = map(np.array, (self.vertices, *self.holes))
        area = _area(outer)
        edges = _sides(outer if area > 0 else outer[::-1])
        if inner:
            rings = [counterclockwise(hole)[::-1] for hole in inner]
            edges = np.concatenate([edges, *(_sides(ring) for ring in rings)])
            area = _net_area(outer, inner)
        edges[:, 4] = 1.0 / abs(area)
        return Pieces(plates=(edges,))


def counterclockwise(vertices: Array) -> Array:
    """Vertices in counterclockwise order."""
    return vertices if _area(vertices) > 0 else vertices[::-1]


def _sides(vertices: Array) -> Array:
    """Sides of a polygon, with a free fifth column."""
    edges = np.empty((len(vertices), 5))
    edges[:, :2], edges[:-1, 2:4], edges[-1, 2:4] = vertices, vertices[1:], vertices[0]
    return edges


def _pairs(vertices: Array) -> tuple[Position, ...]:
    return tuple((x, y) for x, y in vertices.tolist())


def _net_area(outer: Array, inner: list[Array]) -> float:
    """Area of a polygon without its holes."""
    return float(abs(_area(outer)) - sum(abs(_area(hole)) for hole in inner))


def _area(vertices: Array) -> float:
    """Area, positive where the vertices turn counterclockwise; also far from the origin."""
    row = row_of(PolygonRow, first=0, count=len(vertices))
    return float(run("polygon_area", vertices, [row], 1)[0, 0])


def simple_ring(name: str, value: Any) -> Array:
    """Vertices of a simple polygon, shape (n, 2), each once.

    Raises
    ------
    InvalidValue
        Under this name, if there are fewer than three vertices, a number is not finite, edges cross or
        touch, the area is zero, or the object has several parts.
    """
    vertices = ring_of(name, value)
    require_simple(name, vertices)
    return vertices


def ring_of(name: str, value: Any) -> Array:
    """Vertices of a closed chain of edges, shape (n, 2); errors as in `simple_ring`, but edges may meet."""
    remedy = "give x and y of each vertex in order"
    if callable(getattr(value, "vertices", None)):
        value = _corners_of_outline(name, value)
    value = getattr(value, "exterior", value)
    if hasattr(value, "geoms"):
        raise InvalidValue(
            name, value, "one polygon, not an object of several",
            "as a support give Composite([(each.area, Polygon(each)) for each in shape.geoms]), and as an "
            "outline the part that is pushed",
        )  # fmt: skip
    ring = getattr(value, "coords", getattr(value, "vertices", value))
    vertices = np.array(positions(name, list(ring) if ring is not value else ring, remedy)).reshape(
        -1, 2
    )
    if len(vertices) > 1 and (vertices[0] == vertices[-1]).all():
        vertices = vertices[:-1]
    if len(vertices) < 3:
        raise InvalidValue(name, value, "at least three vertices", remedy)
    return vertices


def _corners_of_outline(name: str, outline: Any) -> Any:
    """The corners of an `Outline` of straight sides without holes, or `InvalidValue`."""
    if getattr(outline, "corners", None) is None:
        raise InvalidValue(
            name, outline, "an outline of straight sides without holes",
            "give outline.vertices(tolerance) of one with arcs, and the vertices of each hole as holes",
        )  # fmt: skip
    return outline.corners


def _require_holes(outer: Array, inner: list[Array]) -> None:
    """Refuse holes that are not inside of a polygon, or not apart from one another."""
    for i, hole in enumerate(inner):
        others = inner[:i]
        for other in (outer, *others):
            j, k = _touching_edges(hole, other)
            if j >= 0:
                _refuse_hole(i, f"{_edge(hole, j)}, which meets {_edge(other, k)}")
        beside = any(
            _contains(a, b[0])
            for neighbor in others
            for a, b in ((neighbor, hole), (hole, neighbor))
        )
        if beside or not _contains(outer, hole[0]):
            _refuse_hole(i, hole.tolist())
    if _net_area(outer, inner) <= THINNEST * _size(outer) ** 2:
        raise InvalidValue(
            "holes", [ring.tolist() for ring in inner], "holes that leave an area",
            "use Segment for a support on lines, joined by Composite",
        )  # fmt: skip


def _refuse_hole(number: int, value: Any) -> None:
    raise InvalidValue(
        f"holes[{number}]", value, "a hole inside of the polygon and apart from the other holes",
        "move its vertices, or give the parts around it as a Composite of polygons",
    )  # fmt: skip


def _contains(vertices: Array, point: Array) -> bool:
    """Whether a polygon contains a position that is not on its edges."""
    (x, y), (a, b) = (vertices - point).T, (np.roll(vertices, -1, axis=0) - point).T
    spans = (y > 0) != (b > 0)
    x, y, a, b = x[spans], y[spans], a[spans], b[spans]
    return bool(np.count_nonzero((x * b > a * y) == (b > y)) % 2)


def _size(vertices: Array) -> float:
    return float((vertices.max(axis=0) - vertices.min(axis=0)).max())


def require_simple(name: str, vertices: Array, numbers: Any = None) -> None:
    """Refuse a polygon without area, or with edges that meet anywhere but at common vertices.

    The vertices have these numbers in messages, by default 0, 1, 2 and so on.
    """
    i, j = _crossing_edges(vertices)
    if i >= 0:
        named = (i, j) if numbers is None else (int(numbers[i]), int(numbers[j]))
        raise InvalidValue(
            name,
            f"edges {named[0]} and {named[1]}, {_edge(vertices, i)} and {_edge(vertices, j)}",
            "a simple polygon, whose edges do not cross or touch",
            "order the vertices along the boundary, each once",
        )
    if abs(_area(vertices)) <= THINNEST * _size(vertices) ** 2:
        raise InvalidValue(
            name, vertices.tolist(), "a polygon whose area is not zero",
            "use Segment for a support on a line",
        )  # fmt: skip


def _edge(vertices: Array, i: int) -> str:
    """Text for an edge."""
    (a, b), (c, d) = vertices[i], vertices[(i + 1) % len(vertices)]
    return f"from ({a:.4g}, {b:.4g}) to ({c:.4g}, {d:.4g})"


def _crossing_edges(vertices: Array) -> tuple[int, int]:
    """Numbers of two edges that meet anywhere but at a common vertex, or -1."""
    row = row_of(PolygonRow, first=0, count=len(vertices))
    i, j = run("crossing_edges", vertices, [row], EdgePair.size)[0]
    return int(i), int(j)


def _touching_edges(one: Array, other: Array) -> tuple[int, int]:
    """Numbers of an edge of one polygon and one of another that have a point in common, or -1."""
    row = row_of(PolygonPair, first=0, count=len(one), other_first=len(one), other_count=len(other))
    i, j = run("touching_edges", np.concatenate([one, other]), [row], EdgePair.size)[0]
    return int(i), int(j)
