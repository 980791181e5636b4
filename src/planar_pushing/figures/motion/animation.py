"""Motion over time as an animated picture: ring, rod, fence, force, and the paths behind them."""

from __future__ import annotations

import math
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from PIL import Image
from tqdm import tqdm

from planar_pushing.figures.motion.timeline import MODES, plotted
from planar_pushing.figures.motion.trajectory import box, paths, scene
from planar_pushing.figures.parts import drawing
from planar_pushing.figures.parts.bodies import body_of, explain_centers
from planar_pushing.figures.render import PathLike
from planar_pushing.figures.style import GUIDE, NOTE_SIZE, paper_style
from planar_pushing.study.files.replacing import replacing
from planar_pushing.terms.errors import InvalidValue, require_number

#: Size of a picture, inches, and its pixels per inch.
SIZE = (4.2, 3.2)
DPI = 120
#: Colors of the whole animation: enough for smooth edges, and few enough for a small file.
COLORS = 64
FRAMES = "a whole number from 2 to 1000"


def animate(log: xr.Dataset, path: PathLike, *, frames: int = 75, rate: float = 25.0) -> int:
    """Write a log as an animated GIF, whole or not at all; the bytes depend on the log alone.

    Parameters
    ----------
    log : xarray.Dataset
        As `simulate` returns it.
    path : path
        Ends in .gif.
    frames : int
        Number of pictures, evenly spaced over the time of the log, 2 to 1000.
    rate : float
        Pictures per second, in (0, 50]; the format keeps time in hundredths of a second.

    Returns
    -------
    int
        Number of pictures written.

    Raises
    ------
    InvalidValue
        Where the name ends otherwise or a number is not allowed.
    InvalidFile
        Where the dataset is no log.
    """
    if Path(path).suffix.lower() != ".gif":
        raise InvalidValue("output", str(path), "a name ending in .gif", "rename the file")
    require_number(
        "frames", frames, lambda n: 2 <= n <= 1000 and n == int(n), FRAMES, "choose another number"
    )
    require_number(
        "frames_per_second", rate, lambda x: 0 < x <= 50, "a number in (0, 50]", "slow it down"
    )
    motion = resampled(plotted(log), frames)
    with paper_style():
        drawn = tqdm(_pictures(motion), "drawing", frames, disable=None, leave=False)
        pictures = list(drawn)
    palette = pictures[len(pictures) // 2].quantize(COLORS, dither=Image.Dither.NONE)
    flat = [each.quantize(palette=palette, dither=Image.Dither.NONE) for each in pictures]
    duration = max(2, math.floor(100 / rate + 0.5)) * 10
    with replacing(path) as temporary:
        flat[0].save(
            temporary, format="GIF", save_all=True, append_images=flat[1:], duration=duration,
            loop=0, optimize=False,
        )  # fmt: skip
    return len(flat)


def resampled(data: xr.Dataset, count: int) -> xr.Dataset:
    """Motion at evenly spaced times; places are interpolated, what jumps is that of the row before."""
    time = data["time"].values
    wanted = np.linspace(time[0], time[-1], count)
    before = np.clip(np.searchsorted(time, wanted, side="right") - 1, 0, len(time) - 1)
    found = data.isel(time=before).assign_coords(time=wanted)
    names = ("path_position", "path_fence", "path_rod_angle", "path_gap", "path_slip", "path_side")
    for name in (each for each in names if each in data):
        values = data[name].values.reshape(len(time), -1)
        columns = [np.interp(wanted, time, column) for column in values.T]
        found[name] = (data[name].dims, np.stack(columns, axis=-1).reshape(found[name].shape))
    return found


def _pictures(data: xr.Dataset) -> Iterator[Image.Image]:
    """One picture for each time."""
    limits = box(data)
    for row in range(data.sizes["time"]):
        figure = Figure(figsize=SIZE, dpi=DPI)
        ax = drawing.schematic(figure, limits, pad=14.0)
        paths(ax, data, row)
        scene(ax, data, row)
        _center(ax, data, row)
        explain_centers(ax, body_of(data))
        text = f"t = {data['time'].values[row]:.2f}   {_status(data, row)}"
        figure.text(0.02, 0.96, text, size=NOTE_SIZE, color=GUIDE, va="top")
        canvas: Any = FigureCanvasAgg(figure)
        canvas.draw()
        yield Image.fromarray(np.asarray(canvas.buffer_rgba())[..., :3].copy())


def _pivots(data: xr.Dataset, row: int) -> bool:
    return "path_pivot" in data and bool(data["path_pivot"].values[row] >= 0)


def _center(ax: Axes, data: xr.Dataset, row: int) -> None:
    """Motion center, where there is one."""
    center = data["path_center"].values[row]
    if np.isfinite(center).all():
        mark = drawing.pivot_mark if _pivots(data, row) else drawing.center_mark
        mark(ax, center, size=4.5)


def _status(data: xr.Dataset, row: int) -> str:
    """Contact mode, whether the slider pivots, and whether there was a choice."""
    mode = MODES[int(data["path_mode"].values[row])][1]
    pivots = ", pivots" if _pivots(data, row) else ""
    several = " (one of several)" if data["path_solutions"].values[row] > 1 else ""
    return f"{mode}{pivots}{several}"
