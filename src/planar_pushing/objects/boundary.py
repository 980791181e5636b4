"""The sides and arcs of an outline, and its places nearest to given points."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.outline import KEPT, Corners, require_outline, size
from planar_pushing.mechanics.outline.chains import BETA0, BETA1, NEXT, RHO, starts_of
from planar_pushing.mechanics.plane import Array
from planar_pushing.terms.caches import cache_results


class OutlineSide(NamedTuple):
    """A side of an outline.

    Attributes
    ----------
    start, end : ndarray, shape (2,)
        Its corners; the object is on the left when going from start to end.
    tangent, normal : ndarray, shape (2,)
        Unit vectors from start to end, and into the object.
    length : float
    """

    start: Array
    end: Array
    tangent: Array
    normal: Array
    length: float

    def frame(self, position: float) -> tuple[Array, Array, Array]:
        """Point, tangent and inward normal at a distance from the start."""
        point = self.end if position == self.length else self.start + position * self.tangent
        return point, self.tangent, self.normal


class OutlineArc(NamedTuple):
    """An arc of an outline.

    Attributes
    ----------
    center : ndarray, shape (2,)
    rho : float
        Radius of curvature, negative for a hollow arc.
    low, high : float
        Least and largest direction of its tangent, in radians.
    """

    center: Array
    rho: float
    low: float
    high: float

    def frame(self, beta: float) -> tuple[Array, Array, Array]:
        """Point, tangent and inward normal where the tangent has a direction."""
        tangent = np.array([np.cos(beta), np.sin(beta)])
        normal = np.array([-tangent[1], tangent[0]]) + 0.0
        return self.center - self.rho * normal, tangent, normal


def sides_and_arcs(outline: Any) -> list[OutlineSide | OutlineArc]:
    """Sides and arcs of an outline and of its holes, in order.

    Adjacent sides on one straight line count as one. Errors are those of `require_outline`.
    """
    rows = require_outline(outline).pieces
    starts, after = starts_of(rows), rows[:, NEXT].astype(int)
    parts: list[OutlineSide | OutlineArc] = []
    for k, row in enumerate(rows):
        if np.isinf(row[RHO]):
            parts.append(_side(starts[k], starts[after[k]]))
        elif row[RHO] != 0.0:
            low, high = sorted(row[[BETA0, BETA1]].tolist())
            parts.append(OutlineArc(row[:2], float(row[RHO]), low, high))
    return parts


def _side(start: Array, end: Array) -> OutlineSide:
    along = end - start
    length = float(np.hypot(*along))
    tangent = along / length
    # Without negative zeros, which would be printed.
    normal = np.array([-tangent[1], tangent[0]]) + 0.0
    return OutlineSide(start, end, tangent, normal, length)


class Sides(NamedTuple):
    """Sides of an outline, as arrays; side k begins at corner k."""

    start: Array
    tangent: Array
    normal: Array
    length: Array
    convex: npt.NDArray[np.bool_]
    scale: float


class Nearest(NamedTuple):
    """Places of an outline nearest to given points, as arrays over the points.

    `position` is the distance from the start of the side, and `gap` the signed distance to the outline,
    negative inside.
    """

    point: Array
    side: npt.NDArray[np.intp]
    position: Array
    gap: Array


@cache_results(KEPT)
def sides_between(outline: Corners) -> Sides:
    """Sides between the corners of an outline; they must not be written to."""
    corners = np.array(outline)
    along = np.roll(corners, -1, axis=0) - corners
    length = np.hypot(*along.T)
    tangent = along / length[:, None]
    normal = np.stack([-tangent[:, 1], tangent[:, 0]], axis=-1) + 0.0
    convex = (np.roll(normal, 1, axis=0) * tangent).sum(axis=1) > 0.0
    return Sides(corners, tangent, normal, length, convex, size(corners))


def nearest(sides: Sides, points: Array) -> Nearest:
    """Places of an outline nearest to points of shape (n, 2)."""
    spot = nearest_unsigned(sides, points)
    return spot._replace(gap=np.where(_inside(sides, points), -1.0, 1.0) * spot.gap)


def nearest_unsigned(sides: Sides, points: Array) -> Nearest:
    """As `nearest`, with distances as gaps, which are positive inside, too."""
    away = points[:, None] - sides.start
    along = np.clip((away * sides.tangent).sum(axis=-1), 0.0, sides.length)
    offset = away - along[..., None] * sides.tangent
    distance = np.hypot(offset[..., 0], offset[..., 1])
    side, rows = distance.argmin(axis=1), np.arange(len(points))
    return Nearest(points - offset[rows, side], side, along[rows, side], distance[rows, side])


def _inside(sides: Sides, points: Array) -> npt.NDArray[np.bool_]:
    """Whether points are inside, by the number of sides that a ray along +x crosses."""
    ends = np.roll(sides.start, -1, axis=0)
    y = points[:, None, 1]
    crosses = (sides.start[:, 1] > y) != (ends[:, 1] > y)
    # The ray meets a rising side if the point is on its left, and a falling side if it is on its right.
    height = ((points[:, None] - sides.start) * sides.normal).sum(axis=-1)
    rises = ends[:, 1] > sides.start[:, 1]
    return np.asarray((crosses & ((height > 0.0) == rises)).sum(axis=1) % 2 == 1)
