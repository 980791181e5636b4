"""Drawing primitives: slider, fence, cones, angles and centers.

Positions and vectors are in data coordinates, angles in degrees from +x, offsets and widths in
points.
"""

from __future__ import annotations

from typing import cast

import numpy as np
import numpy.typing as npt
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.colors import to_hex, to_rgb
from matplotlib.figure import Figure
from matplotlib.patches import Circle, Wedge

from planar_pushing.figures.parts.arrows import unit
from planar_pushing.figures.parts.labels import label
from planar_pushing.figures.style import ABOVE, CENTER, FENCE, GUIDE, SLIDER


def schematic(
    figure: Figure,
    box: tuple[float, float, float, float],
    *,
    rect: tuple[float, float, float, float] = (0.0, 0.0, 1.0, 1.0),
    pad: float = 12.0,
) -> Axes:
    """Axes without a frame, of equal aspect, that show `box` with at least `pad` points around it.

    Parameters
    ----------
    box : tuple
        xmin, xmax, ymin, ymax.
    rect : tuple
        Left, bottom, width and height in the figure, fractions.
    pad : float
        Margin for labels, points.
    """
    ax = figure.add_axes(rect)
    ax.set_axis_off()
    fit(ax, box, pad=pad)
    return ax


def fit(ax: Axes, box: tuple[float, float, float, float], *, pad: float = 12.0) -> None:
    """Set limits of equal aspect that show `box`, centered, with at least `pad` points around it."""
    xmin, xmax, ymin, ymax = box
    figure = cast(Figure, ax.get_figure(root=True))
    place = ax.get_position(original=True)
    size = figure.get_size_inches() * [place.width, place.height]
    room = np.maximum(size - 2 * pad / 72, 0.1 * size)
    per_inch = max((xmax - xmin) / room[0], (ymax - ymin) / room[1])
    x, y = (xmin + xmax) / 2, (ymin + ymax) / 2
    half = per_inch * size / 2
    ax.set_xlim(x - half[0], x + half[0])
    ax.set_ylim(y - half[1], y + half[1])
    ax.set_aspect("equal", adjustable="datalim")


def tint(color: str, strength: float) -> str:
    """Color mixed with white: opaque, so that two areas never add up to a third color."""
    red, green, blue = (1 - strength * (1 - part) for part in to_rgb(color))
    return to_hex((red, green, blue))


def slider(
    ax: Axes,
    center: npt.ArrayLike,
    radius: float,
    *,
    contact: npt.ArrayLike = (0.0, 0.0),
    width: float = 2.2,
    color: str = SLIDER,
) -> None:
    """Ring, its center, the rod from the ring center to the contact and the contact's dot."""
    middle = tuple(np.asarray(center, dtype=float))
    ring = Circle(middle, radius, fill=False, linewidth=width, edgecolor=color, zorder=3)
    ax.add_patch(ring)
    rod(ax, center, contact=contact, width=width, color=color)


def rod(
    ax: Axes,
    center: npt.ArrayLike,
    *,
    contact: npt.ArrayLike = (0.0, 0.0),
    width: float = 2.2,
    color: str = SLIDER,
) -> None:
    """Slider's center, the rod from there to the contact, and the contact's dot."""
    middle, end = np.asarray(center, dtype=float), np.asarray(contact, dtype=float)
    ax.plot(*np.stack([end, middle], axis=1), color=color, linewidth=0.6 * width, zorder=3)
    ax.plot(*middle, "o", color=color, markersize=2.2, zorder=4)
    dot(ax, end, color=color)


def dot(ax: Axes, xy: npt.ArrayLike, *, color: str = SLIDER, size: float = 4.0) -> None:
    """Mark the contact."""
    ax.plot(*np.asarray(xy, dtype=float), "o", color=color, markersize=size, zorder=ABOVE + 1)


def fence(
    ax: Axes, xmin: float, xmax: float, *, depth: float | None = None, color: str = FENCE
) -> None:
    """Fence along y = 0, hatched on the side away from the slider; `depth` is the strip's."""
    strokes = hatching(xmin, xmax, 0.03 * (xmax - xmin) if depth is None else depth)
    ax.add_collection(LineCollection(strokes, colors=color, linewidths=0.5, zorder=1))
    ax.plot([xmin, xmax], [0, 0], color=color, linewidth=1.2, solid_capstyle="butt", zorder=2)


def hatching(
    xmin: float, xmax: float, depth: float, y: float = 0.0
) -> list[list[tuple[float, float]]]:
    """Strokes of a strip of a depth below a fence along `y`."""
    starts = np.arange(xmin + depth, xmax + 1e-9 * depth, 0.8 * depth)
    return [[(float(x), y), (float(x) - depth, y - depth)] for x in starts]


def cone(
    ax: Axes,
    apex: npt.ArrayLike,
    right_deg: float,
    left_deg: float,
    radius: float,
    color: str,
    *,
    strength: float = 0.16,
    zorder: float = 0.5,
) -> Wedge:
    """Cone of directions counter-clockwise from right to left; a single direction is a line.

    It covers the cones that were drawn before, so the largest comes first.
    """
    origin = np.asarray(apex, dtype=float)
    whole = left_deg - right_deg >= 360
    ends = (0.0, 360.0) if whole else (right_deg, left_deg)
    wedge = Wedge(tuple(origin), radius, *ends, facecolor=tint(color, strength), linewidth=0)
    wedge.set_zorder(zorder)
    ax.add_patch(wedge)
    if not whole:
        for edge in (right_deg, left_deg):
            line = np.stack([origin, origin + radius * unit(edge)], axis=1)
            ax.plot(*line, color=color, linewidth=0.7, zorder=zorder + 0.1)
    return wedge


def angle_arc(
    ax: Axes,
    vertex: npt.ArrayLike,
    start_deg: float,
    stop_deg: float,
    radius: float,
    text: str = "",
    *,
    color: str = GUIDE,
    offset: float = 6.0,
    at: float = 0.5,
) -> None:
    """Arc of an angle, labeled `offset` points outside of it, at a fraction `at` of the angle."""
    origin = np.asarray(vertex, dtype=float)
    angles = np.linspace(start_deg, stop_deg, 2 + int(abs(stop_deg - start_deg)))
    arc = origin[:, None] + radius * np.stack([unit(each) for each in angles], axis=1)
    ax.plot(*arc, color=color, linewidth=0.7, zorder=2)
    if text:
        ahead = unit(start_deg + at * (stop_deg - start_deg))
        shift = (offset * float(ahead[0]), offset * float(ahead[1]))
        label(ax, origin + radius * ahead, text, offset=shift, color=color)


def center_mark(
    ax: Axes,
    xy: npt.ArrayLike,
    text: str = "",
    *,
    offset: tuple[float, float] = (9.0, 0.0),
    color: str = CENTER,
    size: float = 5.5,
) -> None:
    """Motion center: a circle with a dot."""
    at = np.asarray(xy, dtype=float)
    ax.plot(*at, "o", color=color, markersize=size, mfc="white", mew=1.0, zorder=ABOVE + 1)
    ax.plot(*at, "o", color=color, markersize=0.3 * size, zorder=ABOVE + 2)
    if text:
        label(ax, at, text, offset=offset, color=color)


def pivot_mark(ax: Axes, xy: npt.ArrayLike, *, size: float = 5.5) -> None:
    """Support point about which the slider pivots: a motion center with a wide circle around it."""
    at = np.asarray(xy, dtype=float)
    ax.plot(*at, "o", color=CENTER, markersize=2.3 * size, mfc="none", mew=1.2, zorder=ABOVE + 1)
    center_mark(ax, at, size=size)


def guide(
    ax: Axes, start: npt.ArrayLike, stop: npt.ArrayLike, *, color: str = GUIDE, style: str = "--"
) -> None:
    """Thin line for construction: a line of force, of centers, of measure."""
    ends = np.stack([np.asarray(start, dtype=float), np.asarray(stop, dtype=float)], axis=1)
    ax.plot(*ends, style, color=color, linewidth=0.7, zorder=2)
