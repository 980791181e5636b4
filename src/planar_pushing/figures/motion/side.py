"""The flat side that a finger pushes, in pictures of motion over time: a line fixed to the slider."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes

from planar_pushing.figures.parts import drawing
from planar_pushing.figures.style import PUSHER
from planar_pushing.mechanics.plane import Array
from planar_pushing.terms.quantities import described

#: How far a side without an end is drawn beyond the finger, in units of the slider's span.
BEYOND = 0.45


def side_of(log: xr.Dataset, slider: dict[str, Any]) -> xr.DataArray:
    """Both ends of the side at every instant of a log, those that it has or those that are drawn."""
    along = log["contact_position"].values
    beyond = BEYOND * (slider["rod_length"] + slider["radius"])
    first, last = map(float, slider.get("side", (-np.inf, np.inf)))
    ends = np.array([max(first, along.min() - beyond), min(last, along.max() + beyond)])
    angle = np.deg2rad(log["rod_angle"].values)
    touched = log["position"].values - slider["rod_length"] * _unit(angle)
    tangent = _unit(angle - np.deg2rad(slider["rod_angle"]))
    places = touched[:, None, :] + ends[None, :, None] * tangent[:, None, :]
    return xr.DataArray(
        places, dims=("time", "end", "xy"), attrs=described("length", "ends of the side")
    )


def _unit(angle: Array) -> Array:
    return np.stack([np.cos(angle), np.sin(angle)], axis=-1)


def draw_side(ax: Axes, ends: Array, finger: Array, color: str, strength: float) -> None:
    """The side as a line, and the finger as a point."""
    ax.plot(*ends.T, color=color, linewidth=1.2, zorder=3)
    drawing.dot(ax, finger, color=drawing.tint(PUSHER, strength), size=5.0)
