"""Supports as they press on the plane: areas, lines and points, and pressure as shade."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import numpy.typing as npt
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.patches import Circle

from planar_pushing.figures.parts.arrows import unit
from planar_pushing.figures.parts.drawing import tint
from planar_pushing.figures.style import SLIDER
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.supports import (
    Annulus,
    Composite,
    Disc,
    Points,
    Polygon,
    PressureMap,
    Ring,
    Segment,
)

#: How much of its colour an area has, and what a cell of the highest pressure has.
AREA, MOST = 0.22, 0.7
#: Area of the dot of the point that carries most, square points.
DOT = 11.0
#: Takes axes, a support, the place of body positions in the picture, the scale, and the colour.
Drawing = Callable[[Axes, Any, Callable[[npt.ArrayLike], Array], float, str], None]


def outline(
    ax: Axes,
    support: Any,
    center: npt.ArrayLike,
    angle: float,
    *,
    scale: float = 1.0,
    color: str = SLIDER,
) -> None:
    """Draw a support whose body frame lies at `center` and is turned by an angle in degrees."""
    along, across = scale * unit(angle), scale * unit(angle + 90.0)

    def placed(body: npt.ArrayLike) -> Array:
        x, y = np.moveaxis(np.asarray(body, dtype=float), -1, 0)
        return np.asarray(center + x[..., None] * along + y[..., None] * across, dtype=float)

    DRAWINGS[type(support)](ax, support, placed, scale, color)


def _circle(ax: Axes, middle: Array, radius: float, color: str, inside: str) -> None:
    ax.add_patch(
        Circle(tuple(middle), radius, facecolor=inside, edgecolor=color, linewidth=0.9, zorder=3)
    )


def _ring(ax: Axes, support: Any, placed: Any, scale: float, color: str) -> None:
    middle, radius = placed((0.0, 0.0)), scale * (support.radius or 1.0)
    ax.add_patch(
        Circle(tuple(middle), radius, fill=False, edgecolor=color, linewidth=1.8, zorder=3)
    )


def _disc(ax: Axes, support: Any, placed: Any, scale: float, color: str) -> None:
    _circle(ax, placed(support.center), scale * support.radius, color, tint(color, AREA))


def _annulus(ax: Axes, support: Any, placed: Any, scale: float, color: str) -> None:
    _circle(ax, placed(support.center), scale * support.outer, color, tint(color, AREA))
    _circle(ax, placed(support.center), scale * support.inner, color, "white")


def _polygon(ax: Axes, support: Any, placed: Any, scale: float, color: str) -> None:
    corners = placed(support.vertices)
    ax.fill(*corners.T, facecolor=tint(color, AREA), edgecolor=color, linewidth=0.9, zorder=3)


def _points(ax: Axes, support: Any, placed: Any, scale: float, color: str) -> None:
    share = np.array(support.weights) / max(support.weights)
    x, y = placed(support.positions).T
    ax.scatter(x, y, s=DOT * share, color=color, linewidths=0, zorder=3)


def _segment(ax: Axes, support: Any, placed: Any, scale: float, color: str) -> None:
    ends = placed([support.start, support.end])
    ax.plot(*ends.T, color=color, linewidth=2.2, solid_capstyle="butt", zorder=3)


def _cells(ax: Axes, support: Any, placed: Any, scale: float, color: str) -> None:
    pressure = np.array(support.pressure)
    shades, squares = [], []
    for (j, i), each in np.ndenumerate(pressure):
        (left, right), (low, high) = support.x[i : i + 2], support.y[j : j + 2]
        squares.append(placed([(left, low), (right, low), (right, high), (left, high)]))
        shades.append(tint(color, MOST * float(each) / float(pressure.max())))
    ax.add_collection(
        PolyCollection(squares, facecolors=shades, edgecolors=color, linewidths=0.3, zorder=3)
    )


def _composite(ax: Axes, support: Any, placed: Any, scale: float, color: str) -> None:
    for _, member in support.members:
        DRAWINGS[type(member)](ax, member, placed, scale, color)


DRAWINGS: dict[type, Drawing] = {
    Annulus: _annulus,
    Composite: _composite,
    Disc: _disc,
    Points: _points,
    Polygon: _polygon,
    PressureMap: _cells,
    Ring: _ring,
    Segment: _segment,
}
