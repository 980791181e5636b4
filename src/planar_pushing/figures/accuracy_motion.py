"""Accuracy against time of both integrators, with a panel for each scene."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.figures.figure import PAGE, Figure
from planar_pushing.figures.parts.methods import (
    handles,
    methods,
    name_ends,
    work_precision,
)

FIGURE = Figure(
    title="Motion over time",
    reads=("accuracy/motion",),
    size=(PAGE, 3.3),
)
LIMITS = (1e-14, 1e1)
TITLES = {
    "slipping": "slipping with infinite friction, one mode",
    "pulling": "pulling, the fence turns on its way",
}
#: Format and alignment of the labels of a method's settings.
NAMED = {"event-driven": ("tolerance {}", "right"), "time-stepping": ("{} steps", "left")}


def draw(figure: Any, data: xr.Dataset) -> None:
    """Draw the work-precision diagram of each scene with one legend."""
    axes = figure.subplots(1, data.sizes["scene"], sharey=True)
    figure.subplots_adjust(left=0.085, right=0.985, bottom=0.14, top=0.82, wspace=0.08)
    for ax, scene in zip(axes, data.scene.values, strict=True):
        one = data.sel(scene=scene)
        work_precision(ax, one.method.values, one.motion_seconds, one.motion_error.values, LIMITS)
        ax.margins(x=0.35)  # room for the labels of settings
        ax.set(yticks=10.0 ** np.arange(-14, 2, 4), title=TITLES[str(scene)])
        ax.set_xlabel("time for a run, seconds")
        name_ends(ax, one, "motion", NAMED)
    axes[0].set_ylabel("error of the last rod angle, degrees")
    figure.legend(handles=handles(methods(data)), loc="upper center", ncols=2, fontsize=8)
