"""Marks of supports of each kind at a pose, and the boxes around them."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from planar_pushing.drawing.canvas.colors import SLIDER, tint
from planar_pushing.drawing.canvas.marks import AREAS, LINES, Picture, Positions, arc
from planar_pushing.mechanics import supports
from planar_pushing.mechanics.plane import Array, direction
from planar_pushing.terms.caches import cache_results

#: Strength of the color of a uniform area, of a map's highest pressure, and of a support point.
EVEN, HIGHEST, POINT = 0.1, 0.62, 0.5
#: Diameter of the heaviest support point, smallest diameter, and line width of a segment, in points, for
#: outlines of the default width.
HEAVIEST, LIGHTEST, BAR = 8.5, 2.5, 5.0
#: Drawing orders: areas are below cones, outlines above cones, and support points above outlines.
BELOW, OUTLINE, FEET = AREAS + 0.2, LINES + 1.0, LINES + 1.5


class Pose(NamedTuple):
    """Origin of the body frame, angle of its x axis in radians, and its unit of length."""

    origin: Positions
    angle: float
    scale: float = 1.0

    def to_plane(self, points: Positions) -> Array:
        """Points of the body, shape S + (2,), in the plane."""
        x, y = self.scale * direction(self.angle)
        turned = np.asarray(points, dtype=float) @ np.array([[x, y], [-y, x]])
        return np.asarray(np.asarray(self.origin, dtype=float) + turned)


class Ink(NamedTuple):
    """Color, and line width of outlines in points."""

    color: str = SLIDER
    width: float = 2.2

    @property
    def part(self) -> float:
        """Ratio of the line width to the default."""
        return self.width / Ink().width


def extents(support: Any, pose: Pose) -> Array:
    """Corners of the smallest upright box around a support, shape (2, 2)."""
    ends, circles = _rim(support)
    middles, radii = pose.to_plane(circles[:, :2]), pose.scale * circles[:, 2:]
    points = np.concatenate([pose.to_plane(ends), middles - radii, middles + radii])
    return np.array([points.min(axis=0), points.max(axis=0)])


@cache_results(32)
def _rim(support: Any) -> tuple[Array, Array]:
    """Points and vertices of a support, and its circles as x, y and radius."""
    if isinstance(support, supports.Composite):
        parts = [_rim(member) for _, member in support.members]
        return np.concatenate([part[0] for part in parts]), np.concatenate(
            [part[1] for part in parts]
        )
    if isinstance(support, supports.PressureMap):
        return _corners(support), np.empty((0, 3))
    pieces = support.pieces()
    edges = [piece[:, :4].reshape(-1, 2) for piece in (pieces.segments, *pieces.plates)]
    ends = np.concatenate([pieces.atoms[:, :2], *edges])
    return ends, np.concatenate([pieces.rings, pieces.discs])[:, :3]


def add_support(picture: Picture, support: Any, pose: Pose, ink: Ink) -> None:
    """Add a support at a pose; one of a user-defined kind as its pieces."""
    draw: Callable[..., None] = DRAWERS.get(type(support), _pieces)
    draw(picture, support, pose, ink)


def _circle(pose: Pose, center: Positions, radius: float) -> Array:
    return np.asarray(pose.to_plane(center) + pose.scale * radius * arc(0.0, 2 * np.pi))


def _fill(picture: Picture, rings: list[Array], ink: Ink, strength: float = EVEN) -> None:
    """Add an area with its outlines."""
    picture.area(*rings, color=tint(ink.color, strength), order=BELOW)
    for ring in rings:
        _outline(picture, ring, ink)


def _outline(picture: Picture, ring: Array, ink: Ink) -> None:
    """Add a closed line, which starts within an edge so that all corners are mitered."""
    start = (ring[0] + ring[-1]) / 2
    points = np.vstack([start, ring, start])
    picture.line(points, ink.color, width=ink.width, order=OUTLINE)


def _ring(picture: Picture, ring: supports.Ring, pose: Pose, ink: Ink) -> None:
    _outline(picture, _circle(pose, ring.center_of_pressure, ring.extent), ink)


def _disc(picture: Picture, disc: supports.Disc, pose: Pose, ink: Ink) -> None:
    _fill(picture, [_circle(pose, disc.center, disc.radius)], ink)


def _annulus(picture: Picture, annulus: supports.Annulus, pose: Pose, ink: Ink) -> None:
    radii = annulus.outer, annulus.inner
    _fill(picture, [_circle(pose, annulus.center, radius) for radius in radii], ink)


def _polygon(picture: Picture, polygon: supports.Polygon, pose: Pose, ink: Ink) -> None:
    _fill(picture, [pose.to_plane(ring) for ring in (polygon.vertices, *polygon.holes)], ink)


def _pressure_map(picture: Picture, grid: supports.PressureMap, pose: Pose, ink: Ink) -> None:
    """Add the cells, darker at higher pressure, and the thin outline of the map."""
    x, y, pressure = (np.array(values) for values in (grid.x, grid.y, grid.pressure))
    for j, i in np.argwhere(pressure > 0):
        box = [(x[i], y[j]), (x[i + 1], y[j]), (x[i + 1], y[j + 1]), (x[i], y[j + 1])]
        part = float(pressure[j, i] / pressure.max())
        picture.area(
            pose.to_plane(grid.frame.point_out(box)),
            color=tint(ink.color, HIGHEST * part),
            order=BELOW,
        )
    _outline(picture, pose.to_plane(_corners(grid)), ink._replace(width=0.4 * ink.width))


def _corners(grid: supports.PressureMap) -> Array:
    """Corners of the grid of a map; its outer cells can be empty."""
    (left, *_, right), (low, *_, high) = grid.x, grid.y
    return grid.frame.point_out([(left, low), (right, low), (right, high), (left, high)])


def _segment(picture: Picture, segment: supports.Segment, pose: Pose, ink: Ink) -> None:
    ends = pose.to_plane([segment.start, segment.end])
    picture.line(ends, ink.color, width=BAR * ink.part, order=OUTLINE)


def _points(picture: Picture, points: supports.Points, pose: Pose, ink: Ink) -> None:
    """Add dots with areas proportional to the weights, on thin legs from the center of pressure."""
    heaviest, positions = max(points.weights), pose.to_plane(points.positions)
    middle = pose.to_plane(points.center_of_pressure)
    for position, weight in zip(positions, points.weights, strict=True):
        _leg(picture, middle, position, ink)
        size = ink.part * max(HEAVIEST * float(np.sqrt(weight / heaviest)), LIGHTEST)
        face = tint(ink.color, POINT)
        picture.dot(position, size, face, edge=ink.color, width=0.8, order=FEET)


def _leg(picture: Picture, start: Array, end: Array, ink: Ink) -> None:
    """Add a thin line that connects points of one body."""
    picture.line([start, end], tint(ink.color, POINT), width=0.6, order=LINES)


def _composite(picture: Picture, composite: supports.Composite, pose: Pose, ink: Ink) -> None:
    """Add the members, on thin legs from their common center of pressure."""
    middle = pose.to_plane(composite.center_of_pressure)
    for _, member in composite.members:
        _leg(picture, middle, pose.to_plane(member.center_of_pressure), ink)
        add_support(picture, member, pose, ink)


def _pieces(picture: Picture, support: Any, pose: Pose, ink: Ink) -> None:
    """Add the pieces of a support of a user-defined kind."""
    atoms, segments, rings, discs, plates = support.pieces()
    if len(atoms):
        _points(picture, supports.Points(atoms[:, :2], atoms[:, 2]), pose, ink)
    for a, b, c, d, _ in segments:
        _segment(picture, supports.Segment((a, b), (c, d)), pose, ink)
    for x, y, radius, _ in rings:
        _outline(picture, _circle(pose, (x, y), radius), ink)
    holes = discs[discs[:, 3] < 0]
    for x, y, radius, _ in discs[discs[:, 3] > 0]:
        inside = holes[np.hypot(*(holes[:, :2] - (x, y)).T) < radius]
        circles = [(x, y, radius), *inside[:, :3].tolist()]
        _fill(picture, [_circle(pose, (a, b), size) for a, b, size in circles], ink)
    for edges in plates:
        _plate(picture, edges, pose, ink)


def _plate(picture: Picture, edges: Array, pose: Pose, ink: Ink) -> None:
    """Add the area between the edges of a plate, or thin edges if they do not follow each other around."""
    follows = (edges[1:, :2] == edges[:-1, 2:4]).all(axis=1)
    rings = np.split(edges, np.flatnonzero(~follows) + 1)
    if all((ring[0, :2] == ring[-1, 2:4]).all() for ring in rings):
        _fill(picture, [pose.to_plane(ring[:, :2]) for ring in rings], ink)
        return
    for line in edges[:, :4].reshape(-1, 2, 2):
        picture.line(pose.to_plane(line), ink.color, width=0.4 * ink.width, order=OUTLINE)


#: Drawing function of each kind of support.
DRAWERS: dict[type, Callable[..., None]] = {
    supports.Annulus: _annulus,
    supports.Composite: _composite,
    supports.Disc: _disc,
    supports.Points: _points,
    supports.Polygon: _polygon,
    supports.PressureMap: _pressure_map,
    supports.Ring: _ring,
    supports.Segment: _segment,
}
