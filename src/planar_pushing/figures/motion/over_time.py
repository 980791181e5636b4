"""Drawing of a log over time: series, and the contact mode as a colored strip."""

from __future__ import annotations

from typing import Any, cast

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure
from matplotlib.patches import Patch, Rectangle

from planar_pushing.figures.motion.timeline import MODES, pivots, runs
from planar_pushing.figures.style import CENTER, DARK, GREY, IMPACT, MOTION, NOTE_SIZE, SLIP

#: Place of the legend below the strip, points: beside the name of the axis.
BELOW = 13.0
#: Height of the bar on the strip that marks a pivot.
PIVOT = 0.16
#: Relative luminance at which white and dark text are equally readable.
LUMINANCE = 0.245


def series(ax: Axes, data: xr.Dataset, name: str, text: str, **style: Any) -> None:
    """One variable over time, its axis in the variable's color."""
    color = {"path_rod_angle": MOTION, "path_slip": SLIP}.get(name, DARK)
    ax.plot(data["time"], data[name], color=color, **style)
    ax.set_ylabel(text, color=color)
    ax.set_xlim(float(data["time"][0]), float(data["time"][-1]))
    ax.tick_params(axis="x", labelbottom=False)


def ribbon(ax: Axes, data: xr.Dataset, bottom: float = 0.0) -> None:
    """Contact mode over time as a colored strip of unit height; hatched where there was a choice."""
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
            ink = readable_on(color)
            note: dict[str, Any] = {"ha": "center", "va": "center", "color": ink, "bbox": back}
            ax.annotate(name, middle, size=NOTE_SIZE, **note)
    for run in pivots(data):
        start, stop = time[run.start], time[run.stop]
        bar = Rectangle((start, bottom), stop - start, PIVOT, facecolor=CENTER, edgecolor="white")
        ax.add_patch(bar)
    ax.set(xlim=(time[0], time[-1]), ylim=(0, max(ax.get_ylim()[1], bottom + 0.9)), yticks=[])
    ax.spines["left"].set_visible(False)
    ax.set_xlabel("time", loc="left")
    _explain(ax, data)


def _explain(ax: Axes, data: xr.Dataset) -> None:
    """Legend of what the strip marks besides the modes."""
    found: list[Any] = []
    if any(run.several for run in runs(data)):
        found.append(
            Patch(facecolor=GREY, edgecolor="white", hatch="////", label="several consistent")
        )
    if any(pivots(data)):
        found.append(Patch(facecolor=CENTER, label="pivots about a support point"))
    if found:
        place = (1.02, -BELOW / _height(ax))
        ax.legend(handles=found, loc="upper right", bbox_to_anchor=place)


def _height(ax: Axes) -> float:
    """Height of axes, points."""
    figure = cast(Figure, ax.get_figure(root=True))
    return float(72 * ax.get_position().height * figure.get_figheight())


def readable_on(color: str) -> str:
    """White on dark colors, else the color of dark text."""
    return "white" if luminance(color) < LUMINANCE else DARK


def luminance(color: str) -> float:
    """Relative luminance of a color, as WCAG 2 defines it."""
    parts = np.array(to_rgb(color))
    linear = np.where(parts > 0.04045, ((parts + 0.055) / 1.055) ** 2.4, parts / 12.92)
    return float(linear @ (0.2126, 0.7152, 0.0722))


def mark_time(ax: Axes, data: xr.Dataset, row: int) -> None:
    """Line at the time of an impact."""
    ax.axvline(float(data["time"][row]), color=IMPACT, linewidth=0.9, linestyle=":", zorder=4)
