"""One number of every support over rod length and over rod angle: its values, and four panels of them."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.axis import Axis
from matplotlib.figure import Figure

from planar_pushing.figures.parts.curves import named
from planar_pushing.figures.sliders.gallery import (
    RING,
    described_supports,
    families,
    scene,
    styled,
    supports,
)
from planar_pushing.figures.style import DARK, GREY
from planar_pushing.mechanics.contact import ContactLaw
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.scene import Scene
from planar_pushing.study.datasets.base import words
from planar_pushing.study.files.study_model import SliderEntry

#: Rod lengths and rod angles, in degrees, of the curves; rounded, for powers differ between processors.
LENGTHS = np.round(np.geomspace(0.1, 10.0, 121), 12)
#: How far from an upright rod, where the curves are steep, the denser angles lie.
BESIDE = np.round(np.geomspace(1e-3, 5.0, 80), 9)
ANGLES = np.unique([*np.linspace(1.0, 179.0, 357), *(90.0 - BESIDE), *(90.0 + BESIDE)])
AXES = ("rod_length", "rod_angle")
#: The line of the ring lies behind the others, and is wider.
BEHIND: dict[str, Any] = {"color": GREY, "linewidth": 2.8, "alpha": 0.55}


def over_rods(
    grid: xr.Dataset,
    rod: SliderEntry,
    law: ContactLaw,
    function: Callable[[Scene], xr.DataArray],
    long_name: str,
) -> xr.Dataset:
    """A function of scenes for every support and for the ring, along each axis through the study's rod."""
    data = described_supports(grid, rod).rename({name: f"cut_{name}" for name in AXES})
    found = supports(grid)
    length, angle = (_axis(*each) for each in zip(AXES, (LENGTHS, ANGLES), strict=True))
    rods = {"rod_length": (length, rod.rod_angle), "rod_angle": (rod.rod_length, angle)}
    for axis, values in rods.items():
        every = function(scene(found, *values, law)).transpose("support", axis)
        ring = function(scene({"ring": RING}, *values, law)).squeeze("support")
        data[f"over_{axis}"] = named(("support", axis), every.values, "1", long_name)
        data[f"ring_over_{axis}"] = named(axis, ring.values, "1", f"{long_name}; of the ring")
    text = "rod length, from the contact to the slider's center"
    return data.assign_coords(
        rod_length=named("rod_length", LENGTHS, "length", text),
        rod_angle=named("rod_angle", ANGLES, "degree", "rod angle"),
    )


def _axis(name: str, values: Array) -> xr.DataArray:
    return xr.DataArray(values, dims=name, coords={name: values})


def panels(
    figure: Figure, data: xr.Dataset, drawn: Callable[[xr.DataArray], Array]
) -> Iterator[tuple[Axes, str]]:
    """Supports on areas above, on points and lines below; over rod length and over rod angle, and which.

    `drawn` turns values into heights in the panel.
    """
    grid = figure.add_gridspec(
        2, 2, left=0.085, right=0.985, bottom=0.09, top=0.98, hspace=0.1, wspace=0.17
    )
    for row, names in enumerate(families(supports(data))):
        for column, axis in enumerate(AXES):
            ax = figure.add_subplot(grid[row, column])
            x = data[axis].values
            ax.plot(x, drawn(data[f"ring_over_{axis}"]), label="ring", **BEHIND)
            for name, color, dash in styled(names):
                y = drawn(data[f"over_{axis}"].sel(support=name))
                ax.plot(x, y, color=color, linestyle=dash, label=words(name))
            _frame(ax, data, axis)
            if row == 0:
                ax.tick_params(axis="x", labelbottom=False)
                ax.set_xlabel("")
            yield ax, axis


def _frame(ax: Axes, data: xr.Dataset, axis: str) -> None:
    if axis == "rod_length":
        ax.set_xscale("log")
        ax.set_xlim(LENGTHS[0], LENGTHS[-1])
        ticks = [0.1, 0.2, 0.5, 1, 2, 5, 10]
        ax.set_xticks(ticks, [f"{each:g}" for each in ticks])
        ax.set_xticks([], minor=True)
        cut = rf"$\psi = {float(data.cut_rod_angle):g}^\circ$"
        ax.set_xlabel(f"rod length $l$, at {cut}", color=DARK)
    else:
        ax.set(xlim=(0.0, 180.0), xticks=range(0, 181, 45))
        cut = f"$l = {float(data.cut_rod_length):g}$"
        ax.set_xlabel(rf"rod angle $\psi$ (degrees), at {cut}", color=DARK)


def keep_ticks_inside(axis: Axis) -> None:
    """Fix the ticks of an axis to those that show."""
    low, high = axis.get_view_interval()
    axis.set_ticks([each for each in axis.get_ticklocs() if low <= each <= high])
