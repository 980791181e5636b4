"""The drawing of a polygon: its corners and sides, exact to a millionth of its size.

A drawing has vertices that are no corners: doubled ones, those on a straight side, and those of a curve
that is finer than the drawing is exact. `corners_of_drawing` leaves them out, so that every vertex is
within the tolerance of the outline that remains. Corners on the line of another side, as of the legs of a
table, are put on it.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.supports.polygon import (
    Polygon,
    counterclockwise,
    require_simple,
    ring_of,
)
from planar_pushing.terms.caches import cache_results
from planar_pushing.terms.errors import InvalidValue

#: Exactness of a drawing relative to its size: what is closer than this is at one place. It holds for
#: doubled vertices, for vertices on a straight side, for corners on the line of a fence, and for contacts
#: on the outline.
DRAWN = 1e-6
#: Number of drawings that are kept.
KEPT = 64
#: A direction in which the extreme vertices of a drawing are corners, unless a side is perpendicular to it.
SLANTED = np.array([0.5403023058681398, 0.8414709848078965])
#: Rounding error of a height above a line, relative to the coordinates.
ROUNDING = 64.0 * float(np.finfo(float).eps)


class Corners(tuple[tuple[float, float], ...]):
    """Corners of a polygon, counterclockwise, that were read from a drawing and are not read again."""

    __slots__ = ()

    @classmethod
    def of(cls, vertices: Array) -> Corners:
        """Corners from an array of shape (n, 2)."""
        return cls((x, y) for x, y in vertices.tolist())


class Drawing(NamedTuple):
    """A drawing of an outline.

    Attributes
    ----------
    vertices : ndarray, shape (n, 2)
        As drawn.
    corners : Corners
    vertex : ndarray of int, shape (corners,)
        The number of the vertex that is each corner.
    side : ndarray of int, shape (n,)
        For each edge of the drawing, from the vertex with its number to the next one, the side of the
        outline that it is a part of. Side k goes from corner k to the next one.
    """

    vertices: Array
    corners: Corners
    vertex: npt.NDArray[np.intp]
    side: npt.NDArray[np.intp]


def read_drawing(value: Any, name: str = "outline") -> Drawing:
    """The drawing of a polygon, whose corners are counterclockwise; its holes are left out.

    Raises
    ------
    InvalidValue
        If it is not a simple polygon.
    """
    if isinstance(value, (Corners, Polygon)):
        ring = value.vertices if isinstance(value, Polygon) else tuple(value)
    else:
        ring = _drawn_ring(value) or tuple(map(tuple, ring_of(name, value).tolist()))
    return _read_drawing(ring, isinstance(value, Corners), name)


def _drawn_ring(value: Any) -> tuple[tuple[float, float], ...] | None:
    """The ring of an outline of plain pairs of numbers that was drawn before, or can be; None otherwise."""
    if type(value) not in (list, tuple) or not {*map(type, value)} <= {list, tuple}:
        return None
    pairs = tuple(map(tuple, value))
    if {*map(len, pairs)} != {2} or {type(number) for pair in pairs for number in pair} != {float}:
        return None
    try:
        return _ring_of_pairs(pairs)
    except InvalidValue:
        return None


@cache_results(KEPT)
def _ring_of_pairs(pairs: tuple[tuple[float, float], ...]) -> tuple[tuple[float, float], ...]:
    """The ring of pairs; errors as in `ring_of`."""
    return tuple(map(tuple, ring_of("outline", pairs).tolist()))


@cache_results(KEPT)
def _read_drawing(ring: tuple[tuple[float, float], ...], is_read: bool, name: str) -> Drawing:
    """The drawing of a closed ring of vertices, which can be the corners of an outline that was read."""
    vertices = np.array(ring)
    corner_numbers = np.arange(len(vertices))
    if not is_read:
        corner_numbers = corners_of_drawing(vertices)
        if len(corner_numbers) < 3:
            raise InvalidValue(
                name, vertices.tolist(), "a polygon whose area is not zero",
                "an outline is exact to a millionth of its size; draw one that is wider than that",
            )  # fmt: skip
        require_simple(name, vertices[corner_numbers], corner_numbers)
    drawn = vertices[corner_numbers]
    if not is_read:
        aligned = _put_on_sides(drawn)
        still = (
            corners_of_drawing(aligned) if aligned is not drawn else np.arange(len(corner_numbers))
        )
        # Corners that are now doubled, or on a straight side, are none.
        corner_numbers, drawn = corner_numbers[still], aligned[still]
    edges = np.arange(len(vertices))
    side = (np.searchsorted(corner_numbers, edges, side="right") - 1) % len(corner_numbers)
    corners = counterclockwise(drawn)
    if (corners[0] != drawn[0]).any():  # clockwise: corner k is the last but k
        corner_numbers, side = (
            corner_numbers[::-1],
            (len(corner_numbers) - 2 - side) % len(corner_numbers),
        )
    return Drawing(vertices, Corners.of(corners), corner_numbers, side)


def _put_on_sides(corners: Array) -> Array:
    """Corners, of which those within the tolerance of the line of an outer side are moved onto it.

    A fence along such a side, with all corners on one side of its line, touches all of them. Longer sides
    come first. Nothing is moved that is exact to rounding.
    """
    along = np.roll(corners, -1, axis=0) - corners
    length = np.hypot(along[:, 0], along[:, 1])
    normal = np.stack([-along[:, 1], along[:, 0]], axis=-1) / length[:, None]
    if (counterclockwise(corners)[0] != corners[0]).any():
        normal = -normal
    heights = corners @ normal.T - (corners * normal).sum(axis=1)
    tolerance, rounding = DRAWN * size(corners), 2.0 * ROUNDING * float(np.abs(corners).max())
    is_outer = heights.min(axis=0) >= -tolerance
    is_off = (np.abs(heights) > rounding) & (np.abs(heights) <= tolerance) & is_outer
    sides = np.flatnonzero(is_off.any(axis=0))
    if not len(sides):
        return corners
    aligned, is_free = corners.copy(), np.ones(len(corners), dtype=bool)
    for side in sides[np.argsort(-length[sides], kind="stable")]:
        ends = [side, (side + 1) % len(corners)]
        if is_free[ends].all():
            aligns = is_off[:, side] & is_free
            aligned[aligns] -= heights[aligns, side][:, None] * normal[side]
            is_free[aligns] = False
            is_free[ends] = False
    return aligned


def size(corners: Array) -> float:
    """Largest extent of an outline along x or y."""
    return float((corners.max(axis=0) - corners.min(axis=0)).max())


def corners_of_drawing(vertices: Array) -> npt.NDArray[np.intp]:
    """Numbers of the vertices of a closed drawing that are corners, in order.

    Every vertex is within the tolerance of the polygon of the corners. A chain of vertices is divided at
    the one farthest from its chord until all are that close (Douglas and Peucker). Then each corner is left
    out whose absence moves no vertex out of the tolerance: the first two can be inside a straight side,
    and the farthest from a chord parallel to a side, too.
    """
    tolerance, count = DRAWN * size(vertices), len(vertices)
    before, behind = np.roll(vertices, 1, axis=0), np.roll(vertices, -1, axis=0)
    # Where every vertex is far from the chord of its neighbors, none is near a longer chord.
    if (_distances(vertices, before, behind) > 2.0 * tolerance).all():
        return np.arange(count)
    heights = vertices @ SLANTED
    first, opposite = int(heights.argmin()), int(heights.argmax())
    ring = np.roll(vertices, -first, axis=0)
    ring = np.concatenate([ring, ring[:1]])
    middle = (opposite - first) % count
    inner = divide_chains(ring, [(0, middle), (middle, count)], tolerance)
    corners = _without_needless(ring[:-1], sorted([0, middle, *inner]), tolerance)
    return np.sort((np.array(corners) + first) % count)


def divide_chains(vertices: Array, chains: list[tuple[int, int]], tolerance: float) -> list[int]:
    """Numbers of the vertices that are corners between the ends of chains, each a start and an end."""
    corners, chains = [], list(chains)
    while chains:
        start, end = chains.pop()
        if end - start < 2:
            continue
        distances = _distances(vertices[start + 1 : end], vertices[start], vertices[end])
        farthest = int(distances.argmax())
        if distances[farthest] > tolerance:
            corner = start + 1 + farthest
            corners.append(corner)
            chains += [(start, corner), (corner, end)]
    return corners


def _without_needless(ring: Array, numbers: list[int], tolerance: float) -> list[int]:
    """Numbers of the corners without those whose absence moves no vertex out of the tolerance."""
    corners = ring[numbers]
    chords = np.roll(corners, 1, axis=0), np.roll(corners, -1, axis=0)
    doubtful = np.flatnonzero(_distances(corners, *chords) <= tolerance)
    remaining = list(numbers)
    for corner in (numbers[i] for i in doubtful):
        i, count = remaining.index(corner), len(remaining)
        if count <= 2:
            break
        start, end = remaining[i - 1], remaining[(i + 1) % count]
        between = ring[np.arange(start + 1, end + (len(ring) if end <= start else 0)) % len(ring)]
        if (_distances(between, ring[start], ring[end]) <= tolerance).all():
            del remaining[i]
    return remaining


def _distances(points: Array, starts: Array, ends: Array) -> Array:
    """Distances of points from line segments, shape (n,)."""
    along, away = ends - starts, points - starts
    square = (along * along).sum(axis=-1)
    part = (away * along).sum(axis=-1) / np.where(square > 0.0, square, 1.0)
    apart = away - np.clip(part, 0.0, 1.0)[..., None] * along
    return np.asarray(np.hypot(apart[..., 0], apart[..., 1]))


def put_on_line(vertices: Array, point: Array, normal: Array) -> Corners | None:
    """Corners, of which those within the tolerance of the line through a point are moved onto it.

    The core takes corners for exact, and a run ends where one is below the fence. None if all are exact.
    """
    heights = (vertices - point) @ normal
    rounding = ROUNDING * float(np.abs(vertices).max() + np.abs(point).max())
    is_off = (np.abs(heights) > rounding) & (np.abs(heights) <= DRAWN * size(vertices))
    if not is_off.any():
        return None
    aligned = vertices - np.where(is_off, heights, 0.0)[:, None] * normal
    # Corners that are now doubled, or on a straight side, are none.
    return Corners.of(aligned[corners_of_drawing(aligned)])
