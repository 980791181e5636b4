"""Drawing of motion over time: slider and fence at some instants, paths, and time series."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.colors import to_hex, to_rgb
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle

from planar_pushing.figures.motion.timeline import MODES, contact, rows, runs
from planar_pushing.figures.parts import arrows, drawing
from planar_pushing.figures.style import CENTER, DARK, FENCE, FORCE, MOTION, NOTE_SIZE, SLIDER, SLIP
from planar_pushing.mechanics.plane import Array

Box = tuple[float, float, float, float]
Rect = tuple[float, float, float, float]

#: How much of its colour the first of the snapshots keeps.
PALEST = 0.22
#: Length of the drawn force and width of the fence on either side, in units of the slider's span.
FORCE_LENGTH, FENCE_HALF = 0.42, 0.45


def faded(color: str, strength: float) -> str:
    """Colour mixed with white."""
    red, green, blue = (1 - strength * (1 - part) for part in to_rgb(color))
    return to_hex((red, green, blue))


def span(data: xr.Dataset) -> float:
    """Extent of the slider."""
    return float(data["rod_length"]) + float(data["radius"])


def box(data: xr.Dataset) -> Box:
    """xmin, xmax, ymin, ymax of slider and fence over all the motion, and of its last centre if near."""
    ring, radius, half = (
        data["path_position"].values,
        float(data["radius"]),
        FENCE_HALF * span(data),
    )
    points = [*(ring - radius), *(ring + radius), *contact(data), *last_center(data)]
    ends = np.array([[-half, -0.1 * half], [half, 0.0]])
    points += [each + end for each in data["path_fence"].values for end in ends]
    low, high = np.min(points, axis=0), np.max(points, axis=0)
    return float(low[0]), float(high[0]), float(low[1]), float(high[1])


def last_center(data: xr.Dataset) -> list[Array]:
    """Last motion centre, or nothing where it is far away or the slider never turns."""
    centers, ring = data["path_center"].values, data["path_position"].values
    turning = np.flatnonzero(np.isfinite(centers).all(axis=-1))
    if not turning.size:
        return []
    found = centers[turning[-1]]
    return [found] if np.hypot(*(found - ring[turning[-1]])) < span(data) else []


def scene(ax: Axes, data: xr.Dataset, row: int, strength: float = 1.0) -> None:
    """Fence, slider and force at one row."""
    ring, touch = data["path_position"].values[row], contact(data)[row]
    half, paint = FENCE_HALF * span(data), faded(FENCE, strength)
    fence(ax, data["path_fence"].values[row], half, paint, hatch=strength == 1)
    color = faded(SLIDER, strength)
    drawing.slider(ax, ring, float(data["radius"]), contact=touch, width=1.5, color=color)
    force = data["path_force"].values[row]
    if np.any(force):
        along = FORCE_LENGTH * span(data) * force / np.hypot(*force)
        arrows.force_arrow(ax, touch, along, color=faded(FORCE, strength), head=9.0, width=1.0)


def fence(ax: Axes, middle: Array, half: float, color: str, *, hatch: bool) -> None:
    """Piece of the fence, with a tick at its point that the contact touched first."""
    x, y = middle
    strip = 0.09 * half
    if hatch:
        starts = np.arange(x - half + strip, x + half, 0.9 * strip)
        strokes = [[(each, y), (each - strip, y - strip)] for each in starts]
        ax.add_collection(LineCollection(strokes, colors=[color], linewidths=0.4, zorder=1))
    ax.plot([x - half, x + half], [y, y], color=color, linewidth=1.0, zorder=2)
    ax.plot([x, x], [y - strip, y], color=color, linewidth=2.0, zorder=2)


def paths(ax: Axes, data: xr.Dataset, last: int | None = None) -> None:
    """Path of the contact, coloured by mode, and that of the motion centre, up to a row."""
    touch, end = contact(data), len(data["time"]) if last is None else last + 1
    center = data["path_center"].values[:end]
    ax.plot(*center.T, color=CENTER, linewidth=0.9, dashes=(3, 1.5), zorder=2.5)
    for run in runs(data):
        part = touch[run.start : min(run.stop + 1, end)]
        ax.plot(*part.T, color=MODES[run.mode][0], linewidth=2.2, zorder=4.5)


def snapshots(figure: Figure, data: xr.Dataset, rect: Rect, limits: Box, count: int) -> Axes:
    """Axes with slider and fence at some instants, paler the earlier, and the paths."""
    ax = drawing.schematic(figure, limits, rect=rect, pad=3.0)
    chosen = rows(data, count)
    for strength, row in zip(np.linspace(PALEST, 1.0, len(chosen)), chosen, strict=True):
        scene(ax, data, row, float(strength))
    paths(ax, data)
    for each in last_center(data):
        drawing.center_mark(ax, each, size=4.5)
    return ax


def series(ax: Axes, data: xr.Dataset, name: str, text: str, **style: Any) -> None:
    """One variable over time, its axis in the variable's colour."""
    color = {"path_rod_angle": MOTION, "path_slip": SLIP}.get(name, DARK)
    ax.plot(data["time"], data[name], color=color, **style)
    ax.set_ylabel(text, color=color)
    ax.set_xlim(float(data["time"][0]), float(data["time"][-1]))
    ax.tick_params(axis="x", labelbottom=False)


def ribbon(ax: Axes, data: xr.Dataset, bottom: float = 0.0) -> None:
    """Contact mode over time as a coloured strip of unit height; hatched where there was a choice."""
    time = data["time"].values
    whole = time[-1] - time[0]
    for run in runs(data):
        start, stop = time[run.start], time[run.stop]
        color, name = MODES[run.mode]
        strip = Rectangle((start, bottom), stop - start, 0.9, facecolor=color, edgecolor="white")
        strip.set(linewidth=0.4, hatch="////" if run.several else "")
        ax.add_patch(strip)
        if stop - start > 0.2 * whole:
            middle = ((start + stop) / 2, bottom + 0.42)
            back = {"boxstyle": "square,pad=0.1", "facecolor": color, "linewidth": 0}
            note: dict[str, Any] = {"ha": "center", "va": "center", "color": "white", "bbox": back}
            ax.annotate(name, middle, size=NOTE_SIZE, **note)
    ax.set(xlim=(time[0], time[-1]), ylim=(0, max(ax.get_ylim()[1], bottom + 0.9)), yticks=[])
    ax.spines["left"].set_visible(False)
    ax.set_xlabel("time")
