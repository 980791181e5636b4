"""A log over time: frames of the motion, time series, and the contact mode as a strip."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any, cast

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch, Rectangle
from matplotlib.patheffects import withStroke

from planar_pushing.drawing.canvas.axes import schematic, to_axes
from planar_pushing.drawing.canvas.colors import CENTER, DARK, IMPACT, MODES, Look
from planar_pushing.drawing.canvas.marks import NOTE
from planar_pushing.drawing.motion import frame_picture
from planar_pushing.drawing.timeline import Run, pivots, pusher_action, runs
from planar_pushing.mechanics.plane import Array

#: Heights on the strip of the bars that mark a pivot or a flush side (bottom) and a choice (top).
PIVOT, FLUSH, CHOICE = 0.2, 0.22, 0.14
#: Style of the bar of a flush side, which has no color of its own.
BARRED: dict[str, Any] = {
    "facecolor": "white",
    "edgecolor": DARK,
    "hatch": "|||||",
    "linewidth": 0.6,
}
#: Width of a letter in units of the font size, and room of a label beyond its text, points.
LETTER, AROUND = 0.4, 4.0
#: Height and font size of the title of a frame, and padding of its picture, points.
TITLE, WORDS, PAD = 14.0, 8.5, 5.0


def draw_frames(
    figure: Figure, data: xr.Dataset, instants: Sequence[int], frame: Array,
    rect: tuple[float, float, float, float] = (0.0, 0.0, 1.0, 1.0), *,
    impact_rows: Sequence[int] = (), center: bool = True,
) -> list[Axes]:  # fmt: skip
    """Draw pictures of a motion side by side in a region of a figure, with time and action of the pusher.

    Parameters
    ----------
    instants : sequence of int
        Rows of the motion, one for each frame.
    frame : ndarray
        Corners of the region of the plane that all frames show, shape (2, 2).
    rect : tuple of float
        Left, bottom, width and height of the region, as fractions of the figure.
    impact_rows : sequence of int
        Rows with an impact.
    center : bool
        Whether the frames show the motion center.
    """
    left, bottom, width, height = rect
    title = TITLE / 72 / figure.get_figheight()
    axes = []
    for number, row in enumerate(instants):
        corner = left + number * width / len(instants)
        ax = schematic(figure, (corner, bottom, width / len(instants), height - title))
        picture = frame_picture(data, row, frame, center=center, impact=row in impact_rows)
        to_axes(picture, ax, frame, PAD)
        action = "impact" if row in impact_rows else pusher_action(data, row)
        text = f"$t = {data['time'].values[row]:.3g}$   {action}"
        style: dict[str, Any] = {"ha": "center", "va": "bottom", "size": WORDS, "color": DARK}
        ax.text(0.5, 1.0, text, transform=ax.transAxes, **style)
        axes.append(ax)
    return axes


def series(ax: Axes, data: xr.Dataset, name: str, text: str, **style: Any) -> None:
    """Draw one variable over time."""
    ax.plot(data["time"], data[name], **{"color": DARK} | style)
    ax.set_ylabel(text)
    ax.set_xlabel("time")
    ax.set_xlim(_span(data["time"].values))


def strip(ax: Axes, data: xr.Dataset, bottom: float = 0.0) -> None:
    """Draw the contact mode over time as a strip, with bars for choices, pivots, and flush sides.

    A choice at a single instant has no bar.
    """
    time = data["time"].values
    for run in _areas(data):
        start, stop = time[run.start], time[run.stop]
        look = MODES[run.mode]
        area = Rectangle(
            (start, bottom), stop - start, 0.9, facecolor=look.fill, edgecolor=look.ink
        )
        area.set(linewidth=0.6, hatch=look.hatch)
        ax.add_patch(area)
        if run.flush:
            low = Rectangle((start, bottom), stop - start, FLUSH, **BARRED)
            ax.add_patch(low)
    for run in choices(data):
        _bar(ax, time[run.start], time[run.stop], bottom + 0.9 - CHOICE, CHOICE, DARK)
    for run in pivots(data):
        _bar(ax, time[run.start], time[run.stop], bottom, PIVOT, CENTER)
    ax.set(xlim=_span(time), ylim=(0, max(ax.get_ylim()[1], bottom + 0.9)), yticks=[])
    ax.spines["left"].set_visible(False)
    ax.set_xlabel("time")
    for run in _areas(data):
        _name(
            ax, MODES[run.mode], time[[run.start, run.stop]], bottom + (0.53 if run.flush else 0.42)
        )


def _name(ax: Axes, look: Look, ends: Array, y: float) -> None:
    """Name a mode on its area between two times, along the strip or upright, if there is room."""
    extent, figure = ax.get_position(), cast(Figure, ax.get_figure(root=True))
    wide, high = 72 * figure.get_size_inches() * (extent.width, extent.height)
    room, height = wide * np.ptp(ends) / np.ptp(ax.get_xlim()), high * 0.9 / ax.get_ylim()[1]
    length = LETTER * NOTE * len(look.name) + AROUND
    if room < length and (height < length or room < NOTE + AROUND):
        return
    white = withStroke(linewidth=2.5, foreground=look.fill)
    ax.annotate(
        look.name, (ends.mean(), y), size=NOTE, color="white" if look is MODES[-1] else DARK,
        ha="center", va="center", rotation=0.0 if room >= length else 90.0, path_effects=[white],
    )  # fmt: skip


def _areas(data: xr.Dataset) -> Iterator[Run]:
    """Time intervals with one mode, which do not end where a choice begins or ends."""
    joined: list[Run] = []
    for run in runs(data):
        if joined and (joined[-1].mode, joined[-1].flush) == (run.mode, run.flush):
            joined[-1] = joined[-1]._replace(stop=run.stop)
        else:
            joined.append(run)
    yield from joined


def choices(data: xr.Dataset) -> list[Run]:
    """Time intervals, longer than from one row to the next, in which several modes are possible."""
    return [run for run in runs(data) if run.several and run.stop > run.start + 1]


def _bar(ax: Axes, start: float, stop: float, low: float, height: float, color: str) -> None:
    bar = Rectangle((start, low), stop - start, height, facecolor=color, edgecolor="white")
    bar.set_linewidth(0.4)
    ax.add_patch(bar)


def explain(figure: Figure, data: xr.Dataset, impact_rows: Sequence[int] = ()) -> None:
    """Add a legend for the marks of the time series at the bottom of a figure, if there are any."""
    handles: list[Any] = []
    if impact_rows:
        handles.append(Line2D([], [], color=IMPACT, linewidth=0.9, linestyle=":", label="impact"))
    if choices(data):
        handles.append(Patch(facecolor=DARK, label="more than one mode possible"))
    if any(pivots(data)):
        handles.append(Patch(facecolor=CENTER, label="pivots about a support point"))
    if any(run.flush for run in runs(data)):
        handles.append(Patch(**BARRED, label="a side flush on the fence"))
    if handles:
        columns = len(handles) if figure.get_figwidth() > figure.get_figheight() else 1
        figure.legend(handles=handles, loc="lower right", ncols=columns)


def mark_time(ax: Axes, data: xr.Dataset, row: int) -> None:
    """Draw a line at the time of an impact."""
    ax.axvline(float(data["time"][row]), color=IMPACT, linewidth=0.9, linestyle=":", zorder=4)


def varying_names(data: xr.Dataset, names: Any) -> list[str]:
    """Names of the given variables that change over time."""
    return [name for name in names if np.ptp(data[name].values) > 0]


def _span(times: Any) -> tuple[float, float]:
    """First and last of some times; a run that ends at once has an axis of length 1."""
    first, last = float(times[0]), float(times[-1])
    return first, last if last > first else first + 1.0
