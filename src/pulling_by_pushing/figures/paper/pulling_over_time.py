"""Pulling over time, with the contact kept or lost."""

from __future__ import annotations

from typing import Any

import numpy as np

from planar_pushing.drawing.canvas.colors import DARK
from planar_pushing.drawing.canvas.style import PAGE
from planar_pushing.drawing.motion import box
from planar_pushing.drawing.over_time import draw_frames, explain, series, strip
from planar_pushing.drawing.timeline import path_data, rows_at
from planar_pushing.mechanics.contact import ContactMode
from pulling_by_pushing.figures.captions import number, pusher_motion, values
from pulling_by_pushing.figures.figure import Data, Figure

FIGURE = Figure(
    title="Pulling over time",
    reads=("simulations/pulling", "simulations/pulling_lost"),
    size=(PAGE, 2.9),
    section="Ours, motion over time",
)
NAMES = {"keep-contact": "contact kept", "separate": "contact lost"}
STYLES = ("-", "--")
#: Instants of the frames, in units of the duration.
INSTANTS = (0.0, 0.8, 1.0)
#: Width of the names of the motions and of the region of the frames, as fractions.
NAME, FRAMES = 0.03, 0.745


def caption(data: Data) -> str:
    """Caption with the plotted values."""
    log = data[FIGURE.reads[0]]
    known = values(log, "rod_length", "friction_coefficient", "radius", "weight")
    part = float(log.time[np.flatnonzero(log["mode"] == ContactMode.SEPARATE)[0]])
    return (
        "Pulling over time. The fence first pushes and then retreats. If the contact is kept (above), the "
        "ring is pulled and turns until the direction of the fence leaves the motion cone, where the "
        f"contact parts (t = {number(part)}); if it is lost when it can be (below), the ring stays behind. "
        "Frames: fence with its velocity vₚ, first position (dashed) and the point that was touched first "
        "(tick); force f; path of the contact (thick). Right: dark bar where more than one mode is "
        f"possible ({known}, ψ = {number(float(log.rod_angle[0]))}° at time 0; {pusher_motion(log)})."
    )


def draw(figure: Any, data: Data) -> None:
    """Draw frames of both motions, and their series over time."""
    logs = [data[name] for name in FIGURE.reads]
    motions = [path_data(log) for log in logs]
    names = [NAMES[str(log.attrs["on_ambiguity"])] for log in logs]
    corners = np.array([box(motion) for motion in motions])
    frame = np.array([corners[:, 0].min(axis=0), corners[:, 1].max(axis=0)])
    height = 1.0 / len(logs)
    for index, (motion, name) in enumerate(zip(motions, names, strict=True)):
        low = 1.0 - (index + 1) * height
        beside: dict[str, Any] = {"rotation": 90, "ha": "center", "va": "center"}
        figure.text(0.5 * NAME, low + 0.5 * height, name, color=DARK, **beside)
        instants = rows_at(motion, np.multiply(INSTANTS, float(motion["time"][-1])))
        region = (NAME, low, FRAMES - NAME, height)
        draw_frames(figure, motion, instants, frame, region, center=False)
    grid = figure.add_gridspec(
        3, 1, left=FRAMES + 0.06, right=0.985, bottom=0.21, top=0.97, hspace=0.35,
        height_ratios=[1, 1, 0.9],
    )  # fmt: skip
    angle, gap, modes = (figure.add_subplot(grid[row]) for row in range(3))
    for motion, style, name in zip(motions, STYLES, names, strict=True):
        series(angle, motion, "path_rod_angle", "$\\psi$ (degrees)", linestyle=style)
        series(gap, motion, "path_gap", "gap", linestyle=style, label=name.split()[1])
    gap.legend(loc="upper left")
    for motion, bottom in zip(motions, (1.0, 0.0), strict=True):
        strip(modes, motion, bottom)
    modes.set_yticks([1.45, 0.45], [name.split()[1] for name in names])
    modes.tick_params(axis="y", length=0, pad=1)
    for ax in (angle, gap):
        ax.set_xlabel("")
        ax.tick_params(axis="x", labelbottom=False)
    figure.align_ylabels([angle, gap])
    explain(figure, motions[0])
