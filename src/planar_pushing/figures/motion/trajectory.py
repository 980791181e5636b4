"""Drawing of motion over time: slider and fence at some instants, paths, and time series."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure

from planar_pushing.figures.motion.side import draw_side
from planar_pushing.figures.motion.timeline import MODES, contact, pivots, rod_end, rows, runs
from planar_pushing.figures.parts import arrows, drawing, labels
from planar_pushing.figures.parts.bodies import body_of, draw_body, explain_centers
from planar_pushing.figures.parts.supports import Ink, Pose
from planar_pushing.figures.style import (
    CENTER,
    FENCE,
    FORCE,
    IMPACT,
    NOTE_SIZE,
    SLIDER,
)
from planar_pushing.mechanics.plane import Array

Box = tuple[float, float, float, float]
Rect = tuple[float, float, float, float]

#: How much of its color the first of the snapshots keeps.
PALEST = 0.22
#: A longer step of the motion center between two rows is a jump, in units of the slider's span.
JUMP = 0.5
#: Room for the legend of the centers, points.
LEGEND = 14.0
#: Length of the drawn force and width of the fence on either side, in units of the slider's span.
FORCE_LENGTH, FENCE_HALF = 0.42, 0.45


def pose(data: xr.Dataset, row: int) -> Pose:
    """Where the slider is at a row."""
    angle = float(np.deg2rad(data["path_rod_angle"].values[row]))
    return Pose(data["path_position"].values[row], angle)


def span(data: xr.Dataset) -> float:
    """Extent of the slider, from the contact."""
    body = body_of(data)
    x, y = body.middle
    return float(np.hypot(x + float(data["rod_length"]), y)) + body.half


def box(data: xr.Dataset) -> Box:
    """xmin, xmax, ymin, ymax of slider and fence over all the motion, and of its last center if near."""
    body, half = body_of(data), FENCE_HALF * span(data)
    points = [*contact(data), *last_center(data), *data["path_position"].values]
    points += [each for row in range(data.sizes["time"]) for each in body.box(pose(data, row))]
    ends = np.array([[-half, -0.1 * half], [half, 0.0]])
    if "path_side" in data:
        points += [*data["path_side"].values.reshape(-1, 2)]
    else:
        points += [each + end for each in data["path_fence"].values for end in ends]
    low, high = np.min(points, axis=0), np.max(points, axis=0)
    return float(low[0]), float(high[0]), float(low[1]), float(high[1])


def last_center(data: xr.Dataset) -> list[Array]:
    """Last motion center, or nothing where it is far away or the slider never turns."""
    centers, ring = data["path_center"].values, data["path_position"].values
    turning = np.flatnonzero(np.isfinite(centers).all(axis=-1))
    if not turning.size:
        return []
    found = centers[turning[-1]]
    return [found] if np.hypot(*(found - ring[turning[-1]])) < span(data) else []


def scene(ax: Axes, data: xr.Dataset, row: int, strength: float = 1.0) -> None:
    """Fence or finger, slider and force at one row."""
    touch, ink = contact(data)[row], Ink(drawing.tint(SLIDER, strength), 1.5)
    half, paint = FENCE_HALF * span(data), drawing.tint(FENCE, strength)
    if "path_side" in data:
        draw_side(ax, data["path_side"].values[row], touch, ink.color, strength)
    else:
        fence(ax, data["path_fence"].values[row], half, paint, hatch=strength == 1)
    draw_body(ax, body_of(data), pose(data, row), contact=rod_end(data)[row], ink=ink)
    force = data["path_force"].values[row]
    if np.any(force):
        along = FORCE_LENGTH * span(data) * force / np.hypot(*force)
        arrows.force_arrow(
            ax, touch, along, color=drawing.tint(FORCE, strength), head=9.0, width=1.0
        )


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
    """Path of the contact, colored by mode, and that of the motion center, up to a row."""
    touch, end = contact(data), len(data["time"]) if last is None else last + 1
    _path_of_center(ax, data["path_center"].values[:end], span(data))
    for run in runs(data):
        part = touch[run.start : min(run.stop + 1, end)]
        ax.plot(*part.T, color=MODES[run.mode][0], linewidth=2.2, zorder=4.5)


def _path_of_center(ax: Axes, center: Array, size: float) -> None:
    """Path of the motion center inside the picture; an arrowhead where it leaves or enters it.

    A jump, as at a change of mode, is no part of the path.
    """
    (left, right), (low, high) = ax.get_xlim(), ax.get_ylim()
    half = np.array([right - left, high - low]) / 2
    middle = np.array([right + left, high + low]) / 2
    inside = np.asarray(np.all(np.abs(center - middle) < 0.97 * half, axis=-1))
    near = np.hypot(*np.diff(center, axis=0).T) < JUMP * size
    shown = np.where(inside[:, None], center, np.nan)
    for part in np.split(shown, np.flatnonzero(~near) + 1):
        ax.plot(*part.T, color=CENTER, linewidth=0.9, dashes=(3, 1.5), zorder=2.5)
    for step in (1, -1):
        for here in np.flatnonzero(inside & ~np.roll(inside, -step)):
            there = here + step
            if 0 <= there < len(center) and near[min(here, there)]:
                _head(ax, center[here], center[there] - center[here])


def _head(ax: Axes, tip: Array, along: Array) -> None:
    """Open arrowhead at the end of a path."""
    stub = 1e-3 * along / np.hypot(*along)
    arrows.arrow(ax, tip - stub, stub, style=arrows.OPEN_HEAD, color=CENTER, width=0.9, head=7)


def snapshots(
    figure: Figure, data: xr.Dataset, rect: Rect, limits: Box, count: int, more: Sequence[int] = ()
) -> Axes:
    """Axes with slider and fence at some instants and rows, paler the earlier, and the paths."""
    body = body_of(data)
    ax = drawing.schematic(figure, limits, rect=rect, pad=LEGEND if body.centers else 3.0)
    chosen = sorted({*rows(data, count), *more})
    for strength, row in zip(np.linspace(PALEST, 1.0, len(chosen)), chosen, strict=True):
        scene(ax, data, row, float(strength))
    paths(ax, data)
    for each in last_center(data):
        drawing.center_mark(ax, each, size=4.5)
    for run in pivots(data):
        place = data["path_center"].values[run.start]
        drawing.pivot_mark(ax, place, size=4.5)
        labels.label(ax, place, "pivot", offset=(0.0, -12.0), color=CENTER, size=NOTE_SIZE)
    explain_centers(ax, body)
    return ax


def mark_impact(ax: Axes, data: xr.Dataset, row: int) -> None:
    """Burst at the contact where the fence strikes it."""
    place = contact(data)[row]
    ax.plot(*place, marker=(8, 1, 0), color=IMPACT, markersize=13, mec="white", mew=0.6, zorder=9)
    back = {"boxstyle": "square,pad=0.15", "facecolor": "white", "linewidth": 0}
    note: dict[str, Any] = {"color": IMPACT, "size": NOTE_SIZE, "bbox": back}
    labels.label(ax, place, "impact", offset=(26.0, -5.0), **note)
