"""Figure 7: velocity cones for infinite friction."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from planar_pushing.figures.parts import arrows, drawing, labels
from planar_pushing.figures.parts.curves import (
    degrees,
    number,
    radius,
    rod_angle,
    rod_lengths,
    titled,
)
from planar_pushing.figures.settings import Settings, Sources
from planar_pushing.figures.style import DARK, MOTION, NOTE_SIZE, SLIP
from planar_pushing.mechanics.plane import Array

#: Narrower sectors are named outside of the cone, degrees.
NARROW = 25.0


def select(sources: Sources, settings: Settings) -> xr.Dataset:
    """Select the cones' edges and the rings of their sliders."""
    grid = sources["motion_cones"]
    cut = grid.sel(
        effects="support_friction",
        rod_angle=rod_angle(grid),
        friction_coefficient=np.inf,
        rod_length=list(rod_lengths(settings, (0.5, 1.0, 2.0, 5.0))),
    )
    data = cut[["motion_cone_right", "motion_cone_left"]].drop_vars(
        ["effects", "friction_coefficient", "friction_angle"]
    )
    data["radius"] = radius(grid)
    return titled(data, "Velocity cones for infinite friction", sources)


def draw(figure: Figure, data: xr.Dataset) -> None:
    """Draw one panel for each rod length, each to its own scale."""
    count = data.sizes["rod_length"]
    for index in range(count):
        one = data.isel(rod_length=index)
        center, ring = float(one.rod_length) * arrows.unit(float(one.rod_angle)), float(one.radius)
        reach = 0.6 * (float(one.rod_length) + ring)
        right = max(center[0] + ring, 1.1 * reach)
        box = (-1.1 * reach, right, min(-0.7 * reach, center[1] - ring), center[1] + ring)
        ax = drawing.schematic(figure, box, rect=(index / count, 0.06, 1 / count, 0.87), pad=17)
        drawing.slider(ax, center, ring, width=1.6)
        drawing.fence(ax, -1.1 * reach, right)
        _cone(ax, one, reach)
        _scale(ax, ring)
        labels.declutter(ax)
        text = f"$l = {number(float(one.rod_length))}$"
        figure.text((index + 0.5) / count, 0.97, text, ha="center", va="top", color=DARK)


def _cone(ax: Axes, one: xr.Dataset, reach: float) -> None:
    """Velocity cone, and the pushes to its left that make the contact slip."""
    right, left = float(one.motion_cone_right), float(one.motion_cone_left)
    drawing.cone(ax, (0, 0), left, 180.0, 0.8 * reach, SLIP, strength=0.35, zorder=0.3)
    drawing.cone(ax, (0, 0), right, left, reach, MOTION)
    note: dict[str, Any] = {"color": MOTION, "size": NOTE_SIZE}
    labels.label(ax, reach * arrows.unit(left), degrees(left), offset=(-8.0, 8.0), **note)
    # Below the edge that it names: without an offset declutter leaves it there.
    below = reach * arrows.unit(right) - [-0.14 * reach, 0.04 * reach]
    labels.label(ax, below, degrees(right), ha="right", va="top", **note)
    for word, start, stop in (("slip", left, 180.0), ("pull", right, 0.0)):
        _name(ax, word, arrows.unit((start + stop) / 2), reach, abs(stop - start))


def _name(ax: Axes, word: str, middle: Array, reach: float, width: float) -> None:
    """Name of a sector about the direction `middle`, with a line to it where it is narrow."""
    if width > NARROW:
        labels.label(ax, 0.62 * reach * middle, word, size=NOTE_SIZE)
        return
    inside = (0.36 if middle[0] > 0 else 0.6) * reach * middle
    outside = np.array([inside[0] - 0.12 * reach, -0.42 * reach])
    drawing.guide(ax, inside, outside, color=DARK, style="-")
    labels.label(ax, outside, word, size=NOTE_SIZE, va="top")


def _scale(ax: Axes, ring: float) -> None:
    """Bar as long as the ring's radius, which all sliders share, below the picture."""
    low, high = ax.get_ylim()
    middle, y = float(np.mean(ax.get_xlim())), low + 0.02 * (high - low)
    ends = np.array([[middle - ring / 2, y], [middle + ring / 2, y]])
    ax.plot(*ends.T, "|-", color=DARK, linewidth=0.7, markersize=4, clip_on=False)
    text = f"${number(ring)}$"
    labels.label(ax, (middle, y - 0.03 * (high - low)), text, size=NOTE_SIZE, va="top")
