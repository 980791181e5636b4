"""Slip with infinite friction over time."""

from __future__ import annotations

from typing import Any

import numpy as np

from planar_pushing.drawing.canvas.style import PAGE
from planar_pushing.drawing.motion import box
from planar_pushing.drawing.over_time import draw_frames, series
from planar_pushing.drawing.timeline import path_data, rows
from pulling_by_pushing.figures.captions import number, pusher_motion, values
from pulling_by_pushing.figures.figure import Data, Figure

FIGURE = Figure(
    title="Slip with infinite friction over time",
    reads=("simulations/slipping",),
    size=(PAGE, 2.45),
    section="Ours, motion over time",
)
#: Number of frames, and height of the region of the time series.
COUNT, SERIES = 3, 0.38


def caption(data: Data) -> str:
    """Caption with the plotted values."""
    (log,) = data.values()
    known = values(log, "rod_length", "friction_coefficient", "radius", "weight")
    return (
        "Slip with infinite friction over time. The force f stays along the fence and is drawn beside it: "
        "the ring's center keeps its height while the fence rises, the rod tilts, and the contact slips to "
        "the right. Frames: fence with its velocity vₚ, first position (dashed) and the point that was "
        "touched first (tick); path of the contact (thick). Below: slip along the fence, and sin ψ, which "
        "decreases linearly with the distance that the fence has traveled "
        f"({known}, ψ = {number(float(log.rod_angle[0]))}° at time 0; {pusher_motion(log)})."
    )


def draw(figure: Any, data: Data) -> None:
    """Draw frames of the motion, the slip, and the sine of the rod angle."""
    (log,) = data.values()
    motion = path_data(log)
    motion["sine"] = np.sin(np.deg2rad(log.rod_angle))
    region = (0.0, SERIES, 1.0, 1.0 - SERIES)
    draw_frames(figure, motion, rows(motion, COUNT), box(motion), region, center=False)
    grid = figure.add_gridspec(1, 2, left=0.08, right=0.98, bottom=0.165, top=SERIES, wspace=0.25)
    for column, (name, text) in enumerate((("path_slip", "slip"), ("sine", r"$\sin \psi$"))):
        series(figure.add_subplot(grid[column]), motion, name, text)
