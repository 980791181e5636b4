"""Figure 14: pulling over time, with the contact kept and lost."""

from __future__ import annotations

import numpy as np
import xarray as xr
from matplotlib.figure import Figure

from planar_pushing.figures.motion.over_time import ribbon, series
from planar_pushing.figures.motion.timeline import plotted
from planar_pushing.figures.motion.trajectory import Box, box, snapshots
from planar_pushing.figures.parts.curves import titled
from planar_pushing.figures.settings import Settings, Sources

COUNT = 4
NAMES = ("simulations/figure_14a", "simulations/figure_14b")
TITLES = {
    "keep-contact": "contact kept",
    "separate": "contact lost",
    "stay-in-mode": "mode kept",
}
STYLES = ("-", "--")


def select(sources: Sources, settings: Settings) -> xr.Dataset:
    """Select the motion under both policies, at the instants that both logs have."""
    logs = [sources[name] for name in NAMES]
    policies = xr.Variable("policy", [str(log.attrs["on_ambiguity"]) for log in logs])
    times = np.intersect1d(logs[0]["time"].values, logs[1]["time"].values)
    motions = [plotted(log.sel(time=times)) for log in logs]
    sizes = motions[0][["radius", "rod_length"]]
    moving = [motion.drop_vars(list(sizes)) for motion in motions]
    data = xr.concat(moving, policies, join="exact", combine_attrs="override").merge(sizes)
    names = {"units": "1", "long_name": "which mode is taken where several are consistent"}
    data["policy"].attrs = names
    return titled(data, "Pulling over time", sources)


def draw(figure: Figure, data: xr.Dataset) -> None:
    """Draw both motions on the left, and both over time on the right."""
    both = [data.isel(policy=number) for number in (0, 1)]
    limits = _union(*map(box, both))
    for number, one in enumerate(both):
        ax = snapshots(figure, one, (0.33 * number, 0.0, 0.33, 0.9), limits, COUNT)
        ax.set_title(TITLES[str(one["policy"].values)], pad=4.0)
    grid = figure.add_gridspec(
        3, 1, left=0.735, right=0.98, bottom=0.16, top=0.97, hspace=0.3, height_ratios=[1, 1, 0.5]
    )
    angle, gap, modes = (figure.add_subplot(grid[place]) for place in range(3))
    for one, style in zip(both, STYLES, strict=True):
        series(angle, one, "path_rod_angle", "rod angle $\\psi$\n(degrees)", linestyle=style)
        label = TITLES[str(one["policy"].values)]
        series(gap, one, "path_gap", "gap", linestyle=style, label=label)
    gap.legend(loc="upper left")
    for one, bottom in zip(both, (1.0, 0.0), strict=True):
        ribbon(modes, one, bottom)
    modes.set_yticks([1.45, 0.45], [TITLES[str(one["policy"].values)] for one in both])
    modes.tick_params(axis="y", length=0, pad=1)
    figure.align_ylabels()


def _union(first: Box, second: Box) -> Box:
    return (
        min(first[0], second[0]), max(first[1], second[1]),
        min(first[2], second[2]), max(first[3], second[3]),
    )  # fmt: skip
