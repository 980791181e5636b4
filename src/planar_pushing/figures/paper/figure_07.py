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

#: Sectors are named where the cone leaves this much room, degrees.
WIDE = 155.0


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
        ax = drawing.schematic(figure, box, rect=(index / count, 0.0, 1 / count, 0.95), pad=15)
        drawing.slider(ax, center, ring, width=1.6)
        drawing.fence(ax, -1.1 * reach, right)
        _cone(ax, one, reach)
        labels.declutter(ax)
        text = f"$l = {number(float(one.rod_length))}$"
        figure.text((index + 0.5) / count, 0.97, text, ha="center", va="top", color=DARK)


def _cone(ax: Axes, one: xr.Dataset, reach: float) -> None:
    """Velocity cone, and the pushes to its left that make the contact slip."""
    right, left = float(one.motion_cone_right), float(one.motion_cone_left)
    drawing.cone(ax, (0, 0), left, 180.0, 0.8 * reach, SLIP, alpha=0.35, zorder=0.3)
    drawing.cone(ax, (0, 0), right, left, reach, MOTION)
    note: dict[str, Any] = {"color": MOTION, "size": NOTE_SIZE}
    labels.label(ax, reach * arrows.unit(left), degrees(left), offset=(-8.0, 8.0), **note)
    # Below the edge that it names: without an offset declutter leaves it there.
    below = reach * arrows.unit(right) - [0.0, 0.04 * reach]
    labels.label(ax, below, degrees(right), ha="right", va="top", **note)
    if left < WIDE:
        at = 0.52 * reach * arrows.unit((left + 180) / 2)
        labels.label(ax, at, "slip", size=NOTE_SIZE)
        labels.label(ax, 0.62 * reach * arrows.unit(0.55 * right), "pull", size=NOTE_SIZE)
