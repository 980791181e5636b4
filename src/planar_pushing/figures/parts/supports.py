"""Where a slider presses on the plane: each kind of support drawn in its place."""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.patches import Circle, PathPatch, Polygon
from matplotlib.path import Path

from planar_pushing.figures.parts.drawing import tint
from planar_pushing.figures.style import SLIDER
from planar_pushing.mechanics import supports
from planar_pushing.mechanics.plane import Array, direction

#: How much of the slider's color an even area has, the highest pressure of a map, and a support point.
AREA, HIGHEST, POINT = 0.1, 0.62, 0.5
#: Diameter of the heaviest support point, least diameter of any, and line width of a segment: points, for
#: outlines of the default width.
HEAVIEST, LIGHTEST, BAR = 8.5, 2.5, 5.0
#: Areas lie below cones, lines above.
BELOW, LINES, DOTS = 0.2, 3.0, 3.5


class Pose(NamedTuple):
    """Origin of the body frame, angle of its x axis in radians, and length of its unit."""

    origin: npt.ArrayLike
    angle: float
    scale: float = 1.0

    def at(self, points: npt.ArrayLike) -> Array:
        """Points of the body, shape S + (2,), in the plane."""
        x, y = self.scale * direction(self.angle)
        turned = np.asarray(points, dtype=float) @ np.array([[x, y], [-y, x]])
        return np.asarray(np.asarray(self.origin, dtype=float) + turned)


class Ink(NamedTuple):
    """Color, and width of outlines in points."""

    color: str = SLIDER
    width: float = 2.2

    @property
    def part(self) -> float:
        """Ratio of the width to the default."""
        return self.width / Ink().width


def draw_support(ax: Axes, support: Any, pose: Pose, ink: Ink) -> None:
    """Draw a support; a ring has a radius of its own."""
    DRAWN[type(support)](ax, support, pose, ink)


def extents(support: Any, pose: Pose) -> Array:
    """Corners of the smallest upright box around a support, shape (2, 2)."""
    ends, circles = _rim(support)
    middles, radii = pose.at(circles[:, :2]), pose.scale * circles[:, 2:]
    every = np.concatenate([pose.at(ends), middles - radii, middles + radii])
    return np.array([every.min(axis=0), every.max(axis=0)])


@lru_cache(maxsize=16)
def _rim(support: Any) -> tuple[Array, Array]:
    """Points and ends of edges of a support, and its circles: x, y and radius."""
    pieces = support.pieces()
    edges = [each[:, :4].reshape(-1, 2) for each in (pieces.segments, *pieces.plates)]
    ends = np.concatenate([pieces.atoms[:, :2], *edges])
    return ends, np.concatenate([pieces.rings, pieces.discs])[:, :3]


def _circle(ax: Axes, middle: Array, radius: float, ink: Ink) -> None:
    circle = Circle(tuple(middle), radius, fill=False, linewidth=ink.width, edgecolor=ink.color)
    circle.set_zorder(LINES)
    ax.add_patch(circle)


def _ring(ax: Axes, ring: supports.Ring, pose: Pose, ink: Ink) -> None:
    _circle(ax, pose.at((0.0, 0.0)), pose.scale * ring.extent, ink)


def _disc(ax: Axes, disc: supports.Disc, pose: Pose, ink: Ink) -> None:
    middle, radius = pose.at(disc.center), pose.scale * disc.radius
    shade = Circle(tuple(middle), radius, facecolor=tint(ink.color, AREA), linewidth=0)
    shade.set_zorder(BELOW)
    ax.add_patch(shade)
    _circle(ax, middle, radius, ink)


def _annulus(ax: Axes, annulus: supports.Annulus, pose: Pose, ink: Ink) -> None:
    middle, circle = pose.at(annulus.center), Path.unit_circle()
    inner, outer = pose.scale * annulus.inner, pose.scale * annulus.outer
    turns = np.asarray(circle.vertices)
    rims = [Path(middle + outer * turns, circle.codes)]
    rims.append(Path(middle + inner * turns * [1.0, -1.0], circle.codes))
    shade = PathPatch(Path.make_compound_path(*rims), facecolor=tint(ink.color, AREA), linewidth=0)
    shade.set_zorder(BELOW)
    ax.add_patch(shade)
    for radius in (inner, outer):
        _circle(ax, middle, radius, ink)


def _polygon(ax: Axes, polygon: supports.Polygon, pose: Pose, ink: Ink) -> None:
    corners = pose.at(polygon.vertices)
    ax.add_patch(Polygon(corners, facecolor=tint(ink.color, AREA), linewidth=0, zorder=BELOW))
    ax.add_patch(_outline(corners, ink))


def _outline(corners: Array, ink: Ink) -> Polygon:
    line = Polygon(corners, fill=False, linewidth=ink.width, edgecolor=ink.color, zorder=LINES)
    line.set_joinstyle("miter")
    return line


def _pressure_map(ax: Axes, given: supports.PressureMap, pose: Pose, ink: Ink) -> None:
    """Cells, darker the higher their pressure, and the thin outline of the map."""
    x, y, pressure = (np.array(each) for each in (given.x, given.y, given.pressure))
    low, high = slice(None, -1), slice(1, None)
    corners = [
        np.stack(np.meshgrid(x[i], y[j]), axis=-1)
        for i, j in ((low, low), (high, low), (high, high), (low, high))
    ]
    cells = pose.at(np.stack(corners, axis=-2).reshape(-1, 4, 2))
    parts = pressure.ravel() / pressure.max()
    shades = [tint(ink.color, HIGHEST * part) for part in parts[parts > 0]]
    pixels = PolyCollection(list(cells[parts > 0]), facecolors=shades, edgecolors=shades)
    pixels.set(linewidth=0.2, zorder=BELOW)
    ax.add_collection(pixels, autolim=False)
    box = [(x[0], y[0]), (x[-1], y[0]), (x[-1], y[-1]), (x[0], y[-1])]
    ax.add_patch(_outline(pose.at(box), ink._replace(width=0.4 * ink.width)))


def _segment(ax: Axes, segment: supports.Segment, pose: Pose, ink: Ink) -> None:
    ends = pose.at([segment.start, segment.end])
    ax.plot(*ends.T, color=ink.color, linewidth=BAR * ink.part, solid_capstyle="butt", zorder=LINES)


def _points(ax: Axes, points: supports.Points, pose: Pose, ink: Ink) -> None:
    """Dots whose areas are in the ratio of the weights, on thin legs from the center of pressure."""
    heaviest, places = max(points.weights), pose.at(points.positions)
    middle = pose.at(points.center_of_pressure)
    for place, weight in zip(places, points.weights, strict=True):
        _leg(ax, middle, place, ink)
        size = ink.part * max(HEAVIEST * float(np.sqrt(weight / heaviest)), LIGHTEST)
        face = tint(ink.color, POINT)
        ax.plot(*place, "o", markersize=size, mfc=face, mec=ink.color, mew=0.8, zorder=DOTS)


def _leg(ax: Axes, start: Array, end: Array, ink: Ink) -> None:
    """Thin line between what belongs to one body."""
    ax.plot(*np.stack([start, end], axis=1), color=tint(ink.color, POINT), linewidth=0.6, zorder=1)


def _composite(ax: Axes, composite: supports.Composite, pose: Pose, ink: Ink) -> None:
    """The members, on thin legs from their common center of pressure."""
    middle = pose.at(composite.center_of_pressure)
    for _, member in composite.members:
        _leg(ax, middle, pose.at(member.center_of_pressure), ink)
        draw_support(ax, member, pose, ink)


#: How each kind of support is drawn.
DRAWN: dict[type, Callable[..., None]] = {
    supports.Annulus: _annulus,
    supports.Composite: _composite,
    supports.Disc: _disc,
    supports.Points: _points,
    supports.Polygon: _polygon,
    supports.PressureMap: _pressure_map,
    supports.Ring: _ring,
    supports.Segment: _segment,
}
