"""An even polygon: the flat base of a box."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from planar_pushing.mechanics.compiled import inlined
from planar_pushing.mechanics.supports.base import Position, positions
from planar_pushing.mechanics.supports.pressure.assembly import assembled, center, extent
from planar_pushing.mechanics.supports.pressure.multipole import far
from planar_pushing.mechanics.supports.pressure.plate import FAR, near
from planar_pushing.mechanics.supports.pressure.record import Array, Pieces, Pressure
from planar_pushing.mechanics.supports.pressure.sums import added
from planar_pushing.terms.errors import InvalidValue

#: Least area over the square of the polygon's size; a smaller one is rounding.
THINNEST = 1e-12


@dataclass(frozen=True, slots=True)
class Polygon:
    """Support on a simple polygon, its pressure even.

    Parameters
    ----------
    vertices : sequence of pairs
        At least three, in the body frame, in either direction of turning; the polygon need not be convex.

    Raises
    ------
    InvalidValue
        Where there are fewer than three vertices, a number is not finite, two edges cross or touch, or the
        area is zero.
    """

    vertices: Any

    def __post_init__(self) -> None:
        remedy = "give x and y of each vertex in the body frame, in order"
        found = positions("vertices", self.vertices, remedy)
        if len(found) < 3:
            raise InvalidValue("vertices", self.vertices, "at least three vertices", remedy)
        _require_simple(np.array(found))
        object.__setattr__(self, "vertices", found)

    @property
    def center_of_pressure(self) -> Position:
        return center(self.pieces())

    @property
    def extent(self) -> float:
        return extent(self.pieces())

    def pieces(self) -> Pieces:
        vertices = np.array(self.vertices)
        area = _area(vertices)
        start = vertices if area > 0 else vertices[::-1]
        rest = np.full(len(start), 1.0 / abs(area))
        return Pieces(plates=(np.column_stack([start, np.roll(start, -1, axis=0), rest]),))

    def record(self, radius: float) -> Pressure:
        return assembled(self.pieces(), radius)


def _area(vertices: Array) -> float:
    """Area, positive where the vertices turn counter-clockwise."""
    x, y = (vertices - vertices[0]).T
    return float(np.sum(x * np.roll(y, -1) - y * np.roll(x, -1)) / 2)


def _require_simple(vertices: Array) -> None:
    """Refuse a polygon whose edges meet elsewhere than at their common vertices, or without area."""
    count = len(vertices)
    after = np.roll(vertices, -1, axis=0)
    for i in range(count - 1):
        others = np.arange(i + 1, count)
        meets = _meet(vertices[i], after[i], vertices[others], after[others])
        meets[0] = _folds(vertices[i], after[i], after[i + 1])
        if i == 0:
            meets[-1] = _folds(vertices[-1], vertices[0], after[0])
        if meets.any():
            raise InvalidValue(
                "vertices", _edges(vertices, i, int(others[meets][0])),
                "a simple polygon, whose edges do not cross or touch",
                "order the vertices along the boundary, each once",
            )  # fmt: skip
    size = np.ptp(vertices, axis=0).max()
    if abs(_area(vertices)) <= THINNEST * size**2:
        raise InvalidValue(
            "vertices", vertices.tolist(), "a polygon whose area is not zero",
            "use Segment for a support on a line",
        )  # fmt: skip


def _edges(vertices: Array, i: int, j: int) -> str:
    """Two edges in a message: their numbers first, which a long message keeps."""
    ends = [(vertices[each], vertices[(each + 1) % len(vertices)]) for each in (i, j)]
    one, other = (
        f"from ({start[0]:.4g}, {start[1]:.4g}) to ({end[0]:.4g}, {end[1]:.4g})"
        for start, end in ends
    )
    return f"edges {i} and {j}, {one} and {other}"


def _side(start: Array, end: Array, points: Array) -> Array:
    """On which side of a line points are: 1 on the left, -1 on the right, 0 on it."""
    (along, across), offset = (end - start).T, points - start
    return np.asarray(np.sign(along * offset[..., 1] - across * offset[..., 0]))


def _meet(start: Array, end: Array, starts: Array, stops: Array) -> Array:
    """Which of several edges have a point in common with an edge."""
    splits = _side(start, end, starts) * _side(start, end, stops) <= 0
    split = _side(starts, stops, start) * _side(starts, stops, end) <= 0
    low, high = np.minimum(start, end), np.maximum(start, end)
    boxes = (np.minimum(starts, stops) <= high) & (np.maximum(starts, stops) >= low)
    return np.asarray(splits & split & boxes.all(axis=-1))


def _folds(first: Array, corner: Array, last: Array) -> bool:
    """Whether an edge runs back along the one before it, or has no length."""
    before, after = corner - first, last - corner
    turn = before[0] * after[1] - before[1] * after[0]
    return bool(turn == 0 and before @ after <= 0)


@inlined
def of_plates(total, plates, first, edges, multipoles, x, y, p_x, p_y):
    """Totals, their torque about p, with the polygons and the cells of pressure maps."""
    for i in range(len(plates)):
        q_x, q_y, radius = plates[i, 0], plates[i, 1], plates[i, 2]
        share = plates[i, 3]
        r_x, r_y = x - q_x, y - q_y
        if r_x * r_x + r_y * r_y < (FAR * radius) ** 2:
            piece = near(edges, first[i], first[i + 1], r_x, r_y)
        else:
            piece = far(multipoles, i, r_x, r_y, radius)
        total = added(total, share, piece, q_x - p_x, q_y - p_y)
    return total
