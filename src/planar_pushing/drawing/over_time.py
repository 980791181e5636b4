"""A log over time: time series, and the contact mode as a strip."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.patches import Patch, Rectangle
from matplotlib.patheffects import withStroke

from planar_pushing.drawing.canvas.colors import CENTER, DARK, IMPACT, MODES
from planar_pushing.drawing.canvas.marks import NOTE
from planar_pushing.drawing.timeline import pivots, runs

#: Heights on the strip of the bars that mark a pivot or a flush side (bottom) and a choice (top).
PIVOT, FLUSH, CHOICE = 0.2, 0.22, 0.14
#: Style of the bar of a flush side, which has no color of its own.
BARRED: dict[str, Any] = {
    "facecolor": "white",
    "edgecolor": DARK,
    "hatch": "|||||",
    "linewidth": 0.6,
}
#: Smallest fraction of the duration over which a run's label fits.
NAMED = 0.2


def series(ax: Axes, data: xr.Dataset, name: str, text: str, **style: Any) -> None:
    """Draw one variable over time."""
    ax.plot(data["time"], data[name], **{"color": DARK} | style)
    ax.set_ylabel(text)
    ax.set_xlim(float(data["time"][0]), float(data["time"][-1]))
    ax.tick_params(axis="x", labelbottom=False)


def strip(ax: Axes, data: xr.Dataset, bottom: float = 0.0) -> None:
    """Draw the contact mode over time as a strip, with bars for choices, pivots, and flush sides."""
    time = data["time"].values
    for run in runs(data):
        start, stop = time[run.start], time[run.stop]
        look = MODES[run.mode]
        area = Rectangle(
            (start, bottom), stop - start, 0.9, facecolor=look.fill, edgecolor=look.ink
        )
        area.set(linewidth=0.6, hatch=look.hatch)
        ax.add_patch(area)
        if run.several:
            _bar(ax, start, stop, bottom + 0.9 - CHOICE, CHOICE, DARK)
        if run.flush:
            low = Rectangle((start, bottom), stop - start, FLUSH, **BARRED)
            ax.add_patch(low)
        if stop - start > NAMED * (time[-1] - time[0]):
            white = withStroke(linewidth=2.5, foreground=look.fill)
            note: dict[str, Any] = {"ha": "center", "va": "center", "path_effects": [white]}
            color = "white" if run.mode < 0 else DARK
            ax.annotate(
                look.name,
                ((start + stop) / 2, bottom + (0.53 if run.flush else 0.42)),
                size=NOTE,
                color=color,
                **note,
            )
    for run in pivots(data):
        _bar(ax, time[run.start], time[run.stop], bottom, PIVOT, CENTER)
    ax.set(xlim=(time[0], time[-1]), ylim=(0, max(ax.get_ylim()[1], bottom + 0.9)), yticks=[])
    ax.spines["left"].set_visible(False)
    ax.set_xlabel("time")


def _bar(ax: Axes, start: float, stop: float, low: float, height: float, color: str) -> None:
    bar = Rectangle((start, low), stop - start, height, facecolor=color, edgecolor="white")
    bar.set_linewidth(0.4)
    ax.add_patch(bar)


def explain(ax: Axes, data: xr.Dataset) -> None:
    """Add a legend for the bars below the strip."""
    found = []
    if any(run.several for run in runs(data)):
        found.append(Patch(facecolor=DARK, label="more than one mode possible"))
    if any(pivots(data)):
        found.append(Patch(facecolor=CENTER, label="pivots about a support point"))
    if any(run.flush for run in runs(data)):
        found.append(Patch(**BARRED, label="a side flush on the fence"))
    if found:
        high = 72 * ax.get_position().height * ax.get_figure(root=True).get_figheight()  # type: ignore[union-attr]
        place = (1.02, -26.0 / high)
        ax.legend(handles=found, loc="upper right", bbox_to_anchor=place, ncols=2)


def mark_time(ax: Axes, data: xr.Dataset, row: int) -> None:
    """Draw a line at the time of an impact."""
    ax.axvline(float(data["time"][row]), color=IMPACT, linewidth=0.9, linestyle=":", zorder=4)


def varying(data: xr.Dataset, names: Any) -> list[str]:
    """Names of the given variables that change over time."""
    return [name for name in names if np.ptp(data[name].values) > 0]
