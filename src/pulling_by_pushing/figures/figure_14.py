"""Figure 14: pulling over time, with the contact kept or lost."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.drawing.canvas.style import COLUMN, PAGE
from planar_pushing.drawing.over_time import explain, series, strip
from planar_pushing.drawing.timeline import plotted
from pulling_by_pushing.figures.figure import Figure, Settings, Sources
from pulling_by_pushing.figures.parts.data import number, titled, values
from pulling_by_pushing.figures.parts.frames import add_frames
from pulling_by_pushing.figures.parts.pushes import told

FIGURE = Figure(
    title="Pulling over time",
    reads=("simulations/figure_14a", "simulations/figure_14b"),
    size=(PAGE, 3.0),
    column=(COLUMN, 5.6),
    section="Ours, motion over time",
)
TITLES = {
    "keep-contact": "contact kept",
    "separate": "contact lost",
    "stay-in-mode": "mode kept",
}
STYLES = ("-", "--")
#: Number of instants drawn for each motion.
COUNT = 3


def select(sources: Sources, settings: Settings) -> xr.Dataset:
    """Select the motion under both policies at the instants common to both logs."""
    logs = [sources[name] for name in FIGURE.reads]
    policies = xr.Variable("policy", [str(log.attrs["on_ambiguity"]) for log in logs])
    times = np.intersect1d(logs[0]["time"].values, logs[1]["time"].values)
    motions = [plotted(log.sel(time=times)) for log in logs]
    sizes = motions[0][["radius", "rod_length"]]
    moving = [motion.drop_vars(list(sizes)) for motion in motions]
    data = xr.concat(moving, policies, join="exact", combine_attrs="override").merge(sizes)
    names = {"units": "1", "long_name": "mode that is chosen if several are consistent"}
    data["policy"].attrs = names
    return titled(data, "Pulling over time", sources)


def caption(data: xr.Dataset) -> str:
    """Caption with the plotted values."""
    known = values(data, "rod_length", "friction_coefficient", "radius", "weight")
    start = number(float(data.path_rod_angle.values[0, 0]))
    return (
        "Pulling over time. The fence first pushes; its direction of motion then turns away from "
        "the slider. If the contact is kept (above), the slider is pulled along and turns further; "
        "if it is lost (below), the slider stays behind. Slider, fence and force are shown at the "
        "labeled instants, with the path of the contact up to then; the tick marks the point of "
        "the fence that the contact touched first. Right: rod angle, gap at the contact, and "
        "contact mode. The dark bar marks the times at which more than one mode is possible "
        f"({known}, ψ = {start}° at time 0; "
        f"{told(data)})."
    )


def draw(figure: Any, data: xr.Dataset) -> None:
    """Draw frames of both motions, and their series over time."""
    both = [data.isel(policy=number) for number in range(data.sizes["policy"])]
    names = [TITLES[str(one["policy"].values)] for one in both]
    wide = figure.get_figwidth() > COLUMN + 1
    add_frames(
        figure, both, names, COUNT, (0.0, 0.0, 0.66, 1.0) if wide else (0.0, 0.55, 1.0, 0.45)
    )
    edges = (
        {"left": 0.745, "bottom": 0.2, "top": 0.96}
        if wide
        else {"left": 0.2, "bottom": 0.12, "top": 0.53}
    )
    grid = figure.add_gridspec(3, 1, right=0.98, hspace=0.3, height_ratios=[1, 1, 0.7], **edges)
    angle, gap, modes = (figure.add_subplot(grid[place]) for place in range(3))
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
