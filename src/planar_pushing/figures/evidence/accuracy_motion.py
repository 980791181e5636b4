"""What accuracy costs over time: both integrators, a panel for each scene."""

from __future__ import annotations

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from planar_pushing.figures.evidence.work_precision import handles, methods, work_precision
from planar_pushing.figures.style import GREY, NOTE_SIZE

LIMITS = (1e-14, 1e1)
TITLES = {
    "slipping": "slipping with infinite friction, one mode",
    "pulling": "pulling, the fence turns on its way",
}
#: What a setting is, and on which side of the markers it stands.
NAMED = {"event-driven": ("tolerance {:g}", -1), "time-stepping": ("{:g} steps", 1)}


def draw(figure: Figure, data: xr.Dataset) -> None:
    """Draw the work-precision diagram of each scene, with one legend."""
    axes = figure.subplots(1, data.sizes["scene"], sharey=True)
    figure.subplots_adjust(left=0.085, right=0.985, bottom=0.14, top=0.82, wspace=0.08)
    for ax, scene in zip(axes, data.scene.values, strict=True):
        one = data.sel(scene=scene)
        work_precision(ax, one.method.values, one.motion_seconds, one.motion_error.values, LIMITS)
        ax.set(xlim=(3e-4, 3e0), yticks=10.0 ** np.arange(-14, 2, 4), title=TITLES[str(scene)])
        ax.set_xlabel("time for a run, seconds")
        _settings(ax, one)
    axes[0].set_ylabel("error of the last rod angle, degrees")
    figure.legend(handles=handles(methods(data)), loc="upper center", ncols=2, fontsize=8)


def _settings(ax: Axes, data: xr.Dataset) -> None:
    """Name the ends of each line by their settings."""
    for name, (text, side) in NAMED.items():
        rows = np.flatnonzero(data.method.values == name)
        for row in rows[[0, -1]]:
            times = data.motion_seconds[row]
            beside = times.median() if side > 0 else times.min()
            at = float(beside), float(data.motion_error[row])
            words = text.format(float(data.setting[row]))
            ax.annotate(
                words, at, (8 * side, 0), textcoords="offset points", va="center",
                ha="left" if side > 0 else "right", color=GREY, fontsize=NOTE_SIZE - 1,
            )  # fmt: skip
