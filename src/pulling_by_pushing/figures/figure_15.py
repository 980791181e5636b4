"""Figure 15: slip with infinite friction over time."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.drawing.canvas.axes import schematic, to_axes
from planar_pushing.drawing.canvas.style import COLUMN, PAGE
from planar_pushing.drawing.motion import box, snapshots
from planar_pushing.drawing.over_time import series, strip
from planar_pushing.drawing.timeline import plotted
from pulling_by_pushing.figures.figure import Figure, Settings, Sources
from pulling_by_pushing.figures.parts.data import named, number, titled, values
from pulling_by_pushing.figures.parts.pushes import told

FIGURE = Figure(
    title="Slip with infinite friction over time",
    reads=("simulations/figure_15",),
    size=(PAGE, 2.7),
    column=(COLUMN, 4.4),
    section="Ours, motion over time",
)
#: Number of instants drawn in the page and the column variant.
COUNTS = 5, 3


def select(sources: Sources, settings: Settings) -> xr.Dataset:
    """Select the motion over time and the sine of the rod angle."""
    data = plotted(sources["simulations/figure_15"])
    sine = np.sin(np.deg2rad(data["path_rod_angle"].values))
    data["sine"] = named("time", sine, "1", "sine of the rod angle")
    return titled(data, "Slip with infinite friction over time", sources)


def caption(data: xr.Dataset) -> str:
    """Caption with the plotted values."""
    known = values(data, "rod_length", "friction_coefficient", "radius", "weight")
    start = number(float(data.path_rod_angle.values[0]))
    return (
        "Slip with infinite friction over time. The force stays along the fence, so that the "
        "ring's center keeps its height while the fence rises; the rod tilts more and more, and "
        "the contact slips to the right. Slider, fence and force are shown at the labeled instants; "
        "the tick on each fence marks the point that the contact touched first. Right: sin ψ "
        "decreases linearly with the distance that the fence has traveled "
        f"({known}, ψ = {start}° at time 0; "
        f"{told(data)})."
    )


def draw(figure: Any, data: xr.Dataset) -> None:
    """Draw the trajectory, the sine of the rod angle, and the contact mode."""
    wide = figure.get_figwidth() > COLUMN + 1
    ax = schematic(figure, (0.0, 0.0, 0.66, 1.0) if wide else (0.0, 0.42, 1.0, 0.58))
    frame = box(data)
    to_axes(snapshots(data, frame, COUNTS[0 if wide else 1]), ax, frame, 10.0)
    edges = (
        {"left": 0.75, "bottom": 0.19, "top": 0.95}
        if wide
        else {"left": 0.17, "bottom": 0.11, "top": 0.4}
    )
    grid = figure.add_gridspec(2, 1, right=0.98, hspace=0.25, height_ratios=[1.0, 0.25], **edges)
    series(figure.add_subplot(grid[0]), data, "sine", r"$\sin \psi$")
    strip(figure.add_subplot(grid[1]), data)
