"""What accuracy costs: time, memory and error of a whole grid of limit curves."""

from __future__ import annotations

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from planar_pushing.figures.evidence.work_precision import best, note
from planar_pushing.figures.style import BLUE, GREEN, GREY, VERMILION

#: Bytes of the two numbers that a point of the grid has.
STORED = 16


def draw(figure: Figure, data: xr.Dataset) -> None:
    """Draw time and memory against the size of the grid and of the block, and errors against size."""
    axes = figure.subplots(2, 2)
    figure.subplots_adjust(left=0.085, right=0.985, bottom=0.1, top=0.945, hspace=0.5, wspace=0.25)
    size, block = data["size"].values.astype(float), data.block.values.astype(float)
    _time(axes[0, 0], size, data.size_seconds, size)
    _time(axes[0, 1], block, data.block_seconds, np.full(block.shape, 1e6))
    axes[0, 0].set(
        title="past a fixed cost, every point costs the same", xlabel="points of the grid"
    )
    axes[0, 1].set(title="small blocks pay for their calls", xlabel="points in a block")
    _memory(axes[1, 0], data, size, block)
    _errors(axes[1, 1], data, size)
    for ax in axes.flat:
        ax.set_xscale("log")
        ax.minorticks_off()
        ax.grid(True)
        ax.set_axisbelow(True)


def _time(ax: Axes, x: np.ndarray, times: xr.DataArray, points: np.ndarray) -> None:
    low, middle = best(times) / points * 1e9, times.median("repeat").values / points * 1e9
    ax.vlines(x, low, middle, color=VERMILION, linewidth=0.6)
    ax.plot(x, low, "o-", color=VERMILION)
    ax.set(yscale="log", ylabel="time per point, ns")
    decades = np.log10([low.min(), middle.max()])
    ax.set_ylim(10.0 ** np.floor(decades[0]), 10.0 ** np.ceil(decades[1]))


def _memory(ax: Axes, data: xr.Dataset, size: np.ndarray, block: np.ndarray) -> None:
    ax.plot(size, STORED * size / 1e6, "--", color=GREY, label="numbers that the grid holds")
    ax.plot(size, data.size_memory.values / 1e6, "o-", color=BLUE, label="held, blocks of $2^{16}$")
    ax.plot(
        block,
        data.block_memory.values / 1e6,
        "s-",
        color=GREEN,
        label="held, by block, $10^6$ points",
    )
    ax.set(yscale="log", title="memory is bounded by the block", ylabel="largest memory, megabytes")
    ax.set_xlabel("points of the grid, or of a block")
    ax.margins(y=0.1)
    low, high = ax.get_ylim()
    ax.set_ylim(low, 100 * high)  # room for the legend
    ax.legend(loc="upper left")


def _errors(ax: Axes, data: xr.Dataset, size: np.ndarray) -> None:
    ax.plot(size, data.interpolation_error.values, "o-", color=BLUE)
    ax.plot(size, data.point_error.values, "s-", color=VERMILION)
    note(ax, size[2] * 1.5, 1e-2, "interpolated half way\nbetween points", va="center")
    note(ax, size[2], 1e-12, "at the points of the grid", va="center", ha="center")
    ax.set(yscale="log", title="error of the motion angle", ylabel="largest error, degrees")
    ax.set(xlabel="points of the grid", ylim=(1e-15, 1e2), yticks=10.0 ** np.arange(-14, 3, 4))
