"""Figure 14: pulling over time, with the contact kept or lost."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.drawing.canvas.axes import schematic, to_axes
from planar_pushing.drawing.canvas.colors import DARK, GUIDE
from planar_pushing.drawing.canvas.marks import NOTE, Picture
from planar_pushing.drawing.canvas.style import PAGE
from planar_pushing.drawing.motion import add_instant, add_paths, box
from planar_pushing.drawing.over_time import explain, series, strip
from planar_pushing.drawing.scene import add_center_mark
from planar_pushing.drawing.timeline import plotted, rows
from planar_pushing.mechanics.plane import Array
from pulling_by_pushing.figures.captions import number, pusher_motion, values
from pulling_by_pushing.figures.figure import Data, Figure

FIGURE = Figure(
    title="Pulling over time",
    reads=("simulations/figure_14a", "simulations/figure_14b"),
    size=(PAGE, 3.0),
    section="Ours, motion over time",
)
TITLES = {
    "keep-contact": "contact kept",
    "separate": "contact lost",
    "stay-in-mode": "mode kept",
}
STYLES = ("-", "--")
#: Number of instants drawn for each motion, and height of a row title as a fraction of the figure's height.
COUNT, TITLE = 3, 0.055


def caption(data: Data) -> str:
    """Caption with the plotted values."""
    log = data[FIGURE.reads[0]]
    known = values(log, "rod_length", "friction_coefficient", "radius", "weight")
    return (
        "Pulling over time. The fence first pushes; its direction of motion then turns away from "
        "the slider. If the contact is kept (above), the slider is pulled along and turns further; "
        "if it is lost (below), the slider stays behind. Slider, fence and force are shown at the "
        "labeled instants, with the path of the contact up to then; the tick marks the point of "
        "the fence that the contact touched first. Right: rod angle, gap at the contact, and "
        "contact mode. The dark bar marks the times at which more than one mode is possible "
        f"({known}, ψ = {number(float(log.rod_angle[0]))}° at time 0; {pusher_motion(log)})."
    )


def draw(figure: Any, data: Data) -> None:
    """Draw frames of both motions, and their series over time."""
    logs = [data[name] for name in FIGURE.reads]
    times = np.intersect1d(logs[0]["time"].values, logs[1]["time"].values)
    both = [plotted(log.sel(time=times)) for log in logs]
    names = [TITLES[str(log.attrs["on_ambiguity"])] for log in logs]
    _frames(figure, both, names, COUNT, (0.0, 0.0, 0.66, 1.0))
    grid = figure.add_gridspec(
        3, 1, left=0.745, right=0.98, bottom=0.2, top=0.96, hspace=0.3, height_ratios=[1, 1, 0.7]
    )
    angle, gap, modes = (figure.add_subplot(grid[row]) for row in range(3))
    for one, style, name in zip(both, STYLES, names, strict=True):
        series(angle, one, "path_rod_angle", "$\\psi$ (degrees)", linestyle=style)
        series(gap, one, "path_gap", "gap", linestyle=style, label=name)
    gap.legend(loc="upper left")
    for one, bottom in zip(both, (1.0, 0.0), strict=True):
        strip(modes, one, bottom)
    modes.set_yticks([1.45, 0.45], [name.split()[1] for name in names])
    modes.tick_params(axis="y", length=0, pad=1)
    explain(modes, both[0])
    figure.align_ylabels([angle, gap])


def _frames(
    figure: Any, motions: Sequence[xr.Dataset], names: Sequence[str], count: int,
    rect: tuple[float, float, float, float],
) -> None:  # fmt: skip
    """Draw frames in a region of a figure."""
    left, bottom, width, height = rect
    whole = [box(motion) for motion in motions]
    frame = np.array([np.min([b[0] for b in whole], axis=0), np.max([b[1] for b in whole], axis=0)])
    high = height / len(motions)
    for row, (motion, name) in enumerate(zip(motions, names, strict=True)):
        top = bottom + height - row * high
        figure.text(left + 0.012, top - 0.01, name, va="top", color=DARK)
        for column, instant in enumerate(rows(motion, count)):
            place = (left + column * width / count, top - high, width / count, high - TITLE)
            ax = schematic(figure, place)
            to_axes(_frame_picture(motion, instant, frame), ax, frame, 3.0)
            text = f"$t = {motion['time'].values[instant]:.3g}$"
            ax.text(0.5, 0.0, text, transform=ax.transAxes, ha="center", size=NOTE, color=GUIDE)


def _frame_picture(motion: xr.Dataset, row: int, frame: Array) -> Picture:
    """Picture of slider, pusher, force and motion center at an instant, and the contact's path so far."""
    picture = Picture()
    add_paths(picture, motion, frame, row)
    add_instant(picture, motion, row)
    center = motion["path_center"].values[row]
    if np.isfinite(center).all() and np.all((frame[0] < center) & (center < frame[1])):
        add_center_mark(picture, center, size=4.0)
    return picture
