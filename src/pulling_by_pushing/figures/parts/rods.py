"""A quantity of every support over rod length and over rod angle: its values, and four panels."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

import numpy as np
import xarray as xr

from planar_pushing.drawing.canvas.axes import is_column
from planar_pushing.drawing.canvas.colors import DARK, GRAY, support_colors
from planar_pushing.mechanics.contact import ContactLaw
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.scene import Scene
from pulling_by_pushing.figures.figure import Settings
from pulling_by_pushing.figures.parts.data import named
from pulling_by_pushing.figures.parts.gallery import (
    described_supports,
    families,
    ring_beside,
    scene,
    supports,
)
from pulling_by_pushing.study.datasets.base import words

#: Rod lengths of the curves, in units of the ring's radius, and rod angles in degrees; rounded because
#: powers differ between processors.
LENGTHS = np.round(np.geomspace(0.1, 10.0, 121), 12)
#: Distances from an upright rod, where the curves are steep, at which the angles are denser.
BESIDE = np.round(np.geomspace(1e-3, 5.0, 80), 9)
ANGLES = np.unique([*np.linspace(1.0, 179.0, 357), *(90.0 - BESIDE), *(90.0 + BESIDE)])
AXES = ("rod_length", "rod_angle")
#: Style of the ring's line, which is behind the others and wider.
BEHIND: dict[str, Any] = {"color": GRAY, "linewidth": 2.8, "alpha": 0.55}
#: Dashes of the supports of a panel, in addition to their colors.
DASHES: tuple[Any, ...] = (
    "-", (0, (5, 1.5)), (0, (2, 1)), (0, (9, 1.5, 2, 1.5)), (0, (5, 1.5, 1, 1.5)), (0, (1, 1)),
)  # fmt: skip


def over_rods(
    grid: xr.Dataset,
    rod: Settings,
    law: ContactLaw,
    function: Callable[[Scene], xr.DataArray],
    long_name: str,
    unit: str = "1",
) -> xr.Dataset:
    """Values of a function of scenes for every support and the ring, along each axis at the study's rod."""
    data = described_supports(grid, rod).rename({name: f"cut_{name}" for name in AXES})
    found = supports(grid)
    ring = ring_beside(found)
    lengths = ring.extent * LENGTHS
    length, angle = (_axis(*each) for each in zip(AXES, (lengths, ANGLES), strict=True))
    rods = {"rod_length": (length, rod.rod_angle), "rod_angle": (rod.rod_length, angle)}
    for axis, given in rods.items():
        every = function(scene(found, *given, law)).transpose("support", axis)
        beside = function(scene({"ring": ring}, *given, law)).squeeze("support")
        data[f"over_{axis}"] = named(("support", axis), every.values, unit, long_name)
        data[f"ring_over_{axis}"] = named(axis, beside.values, unit, f"{long_name}; of the ring")
    text = "rod length, from the contact to the slider's center"
    return data.assign_coords(
        rod_length=named("rod_length", lengths, "length", text),
        rod_angle=named("rod_angle", ANGLES, "degree", "rod angle"),
    )


def _axis(name: str, given: Array) -> xr.DataArray:
    return xr.DataArray(given, dims=name, coords={name: given})


class Part(NamedTuple):
    """A panel: its axes, the quantity on its horizontal axis, and its supports with color and dash."""

    ax: Any
    axis: str
    looks: list[tuple[str, str, Any]]


def panels(
    figure: Any, data: xr.Dataset, drawn: Callable[[xr.DataArray, str], Array]
) -> Iterator[Part]:
    """Draw supports on areas above those on points and lines, over rod length and over rod angle.

    `drawn` turns values into heights in the panel over an axis. In the one-column variant the panels are
    stacked.
    """
    found = supports(data)
    colors, narrow = support_colors(found), is_column(figure)
    edges = {"left": 0.16, "bottom": 0.05, "hspace": 0.36} if narrow else {
        "left": 0.085, "bottom": 0.09, "hspace": 0.16, "wspace": 0.2}  # fmt: skip
    axes = figure.subplots(4, 1, squeeze=False) if narrow else figure.subplots(2, 2)
    figure.subplots_adjust(right=0.965 if narrow else 0.985, top=0.97, **edges)
    for number, ax in enumerate(axes.flat):
        names, axis = families(found)[number // 2], AXES[number % 2]
        looks = [(name, colors[name], DASHES[i % len(DASHES)]) for i, name in enumerate(names)]
        ax.plot(data[axis], drawn(data[f"ring_over_{axis}"], axis), label="ring", **BEHIND)
        for name, color, dash in looks:
            y = drawn(data[f"over_{axis}"].sel(support=name), axis)
            ax.plot(data[axis], y, color=color, linestyle=dash, label=words(name))
        _frame(ax, data, axis, named_axis=narrow or number > 1)
        ax.set_title(f"({'abcd'[number]})", loc="left", pad=2.0, color=DARK)
        yield Part(ax, axis, looks)


def _frame(ax: Any, data: xr.Dataset, axis: str, *, named_axis: bool) -> None:
    if axis == "rod_length":
        ax.set_xscale("log")
        low, high = float(data.rod_length[0]), float(data.rod_length[-1])
        ticks = [part * float(data.ring_extent) for part in (0.1, 0.2, 0.5, 1, 2, 5, 10)]
        ax.set(xlim=(low, high), xticks=ticks, xticklabels=[f"{each:g}" for each in ticks])
        ax.set_xticks([], minor=True)
        text = rf"rod length $l$, at $\psi = {float(data.cut_rod_angle):g}^\circ$"
    else:
        ax.set(xlim=(0.0, 180.0), xticks=range(0, 181, 45))
        text = rf"rod angle $\psi$ (degrees), at $l = {float(data.cut_rod_length):g}$"
    if named_axis:
        ax.set_xlabel(text, color=DARK)
    else:
        ax.tick_params(axis="x", labelbottom=False)
