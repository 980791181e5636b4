"""Figure 15: slip with infinite friction over time."""

from __future__ import annotations

from typing import Any

import numpy as np

from planar_pushing.drawing.canvas.axes import schematic, to_axes
from planar_pushing.drawing.canvas.style import PAGE
from planar_pushing.drawing.motion import box, snapshots
from planar_pushing.drawing.over_time import series, strip
from planar_pushing.drawing.timeline import plotted
from pulling_by_pushing.figures.captions import number, pusher_motion, values
from pulling_by_pushing.figures.figure import Data, Figure

FIGURE = Figure(
    title="Slip with infinite friction over time",
    reads=("simulations/figure_15",),
    size=(PAGE, 2.7),
    section="Ours, motion over time",
)
#: Number of instants drawn.
COUNT = 5


def caption(data: Data) -> str:
    """Caption with the plotted values."""
    (log,) = data.values()
    known = values(log, "rod_length", "friction_coefficient", "radius", "weight")
    return (
        "Slip with infinite friction over time. The force stays along the fence, so that the "
        "ring's center keeps its height while the fence rises; the rod tilts more and more, and "
        "the contact slips to the right. Slider, fence and force are shown at the labeled instants; "
        "the tick on each fence marks the point that the contact touched first. Right: sin ψ "
        "decreases linearly with the distance that the fence has traveled "
        f"({known}, ψ = {number(float(log.rod_angle[0]))}° at time 0; {pusher_motion(log)})."
    )


def draw(figure: Any, data: Data) -> None:
    """Draw the trajectory, the sine of the rod angle, and the contact mode."""
    (log,) = data.values()
    motion = plotted(log)
    motion["sine"] = np.sin(np.deg2rad(log.rod_angle))
    ax, frame = schematic(figure, (0.0, 0.0, 0.66, 1.0)), box(motion)
    to_axes(snapshots(motion, frame, COUNT), ax, frame, 10.0)
    grid = figure.add_gridspec(
        2, 1, left=0.75, right=0.98, bottom=0.19, top=0.95, hspace=0.25, height_ratios=[1.0, 0.25]
    )
    series(figure.add_subplot(grid[0]), motion, "sine", r"$\sin \psi$")
    strip(figure.add_subplot(grid[1]), motion)
