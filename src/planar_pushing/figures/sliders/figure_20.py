"""Figure 20: what the ellipsoid in a support's place costs."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from planar_pushing.figures.parts.curves import titled
from planar_pushing.figures.settings import Sources
from planar_pushing.figures.sliders.over_rods import keep_ticks_inside
from planar_pushing.figures.style import DARK, FORCE, MOTION
from planar_pushing.mechanics.plane import Array
from planar_pushing.study.datasets.base import words
from planar_pushing.study.files.study_model import SliderEntry

#: What the errors are of: title, and color.
ERRORS = {"force": ("force direction", FORCE), "motion": ("motion direction", MOTION)}
#: Widths of the panels.
WIDTHS = [0.8, 1.0, 1.0]


def select(sources: Sources, settings: SliderEntry) -> xr.Dataset:
    """Select the integration constants and the ellipsoids' errors."""
    grid = sources["supports"]
    names = [f"{size}_{what}_error" for what in ERRORS for size in ("mean", "worst")]
    data = grid[["integration_constant", *names]].drop_vars("description")
    return titled(data, "What the ellipsoid in a support's place costs", sources)


def draw(figure: Figure, data: xr.Dataset) -> None:
    """Draw a row for each support: its constant, and mean and worst errors."""
    grid = figure.add_gridspec(
        1, 3, left=0.145, right=0.985, bottom=0.16, top=0.985, wspace=0.08, width_ratios=WIDTHS
    )
    place = np.arange(data.sizes["support"], dtype=float)[::-1]
    panels = [figure.add_subplot(grid[0, column]) for column in range(3)]
    for ax in panels:
        ax.hlines(place, 0, 1, transform=ax.get_yaxis_transform(), color="#DDDDDD", linewidth=0.5)
        ax.set(ylim=(-0.6, len(place) - 0.4), yticks=[])
    panels[0].set_yticks(place, [words(str(name)) for name in data.support.values])
    constant = data.integration_constant
    panels[0].plot(constant, place, "D", color=DARK, markersize=4.0)
    panels[0].set(xlabel="integration constant", xlim=(0.95 * float(constant.min()), 1.04))
    for ax, what in zip(panels[1:], ERRORS, strict=True):
        _errors(ax, data, what, place)
    for ax in panels:
        keep_ticks_inside(ax.xaxis)


def _errors(ax: Axes, data: xr.Dataset, what: str, place: Array) -> None:
    """Mean and worst error of the forces or of the motions, a row for each support."""
    text, color = ERRORS[what]
    mean, worst = (data[f"{size}_{what}_error"].values for size in ("mean", "worst"))
    ends: dict[str, Any] = {"linestyle": "none", "color": color, "zorder": 3}
    ax.hlines(place, mean, worst, color=color, linewidth=1.0, zorder=2)
    ax.plot(mean, place, marker="o", label="mean", **ends)
    ax.plot(worst, place, marker="|", markersize=9, markeredgewidth=1.6, label="worst", **ends)
    ax.set(xlim=(0.0, 1.08 * worst.max()), xlabel=f"error of the {text} (degrees)")
    ax.legend(loc="upper right", frameon=True, edgecolor="none", framealpha=1.0)
