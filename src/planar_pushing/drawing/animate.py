"""A motion over time as an animated picture."""

from __future__ import annotations

import base64
import io
import math
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from PIL import Image
from tqdm import tqdm

from planar_pushing.drawing.body import body_in, name_centers
from planar_pushing.drawing.canvas.axes import schematic, to_axes
from planar_pushing.drawing.canvas.colors import GUIDE, MODES
from planar_pushing.drawing.canvas.marks import NOTE, Picture, Sheet
from planar_pushing.drawing.canvas.style import paper_style
from planar_pushing.drawing.motion import add_instant, add_paths, box, pose
from planar_pushing.drawing.scene import add_center_mark
from planar_pushing.drawing.timeline import announce_end, plotted, touching
from planar_pushing.mechanics.plane import Array
from planar_pushing.terms.errors import InvalidValue, require_number, require_path
from planar_pushing.terms.replacing import PathLike, replacing

#: Size of a picture in inches, its pixels per inch, and the padding around the drawing in points.
SIZE, DPI, PAD = (4.2, 3.2), 120, 16.0
#: Number of colors in the animation: enough for smooth edges, few enough for a small file.
COLORS = 64
FRAMES = "a whole number from 2 to 1000"


@dataclass(frozen=True, slots=True)
class Animation:
    """An animated picture that notebooks display."""

    gif: bytes
    frames: int

    def _repr_html_(self) -> str:
        data = base64.b64encode(self.gif).decode()
        return f'<img alt="motion over time" src="data:image/gif;base64,{data}">'


def animate(
    log: xr.Dataset,
    path: PathLike | None = None,
    *,
    frames: int = 75,
    frames_per_second: float = 25.0,
) -> Animation:
    """Draw a log as an animated GIF; its bytes depend only on the log.

    Parameters
    ----------
    log : xarray.Dataset
        Returned by `simulate`. For the log of a run that did not finish, the package's logger says where
        the log ends.
    path : path, optional
        File to write, completely or not at all; its name ends in .gif.
    frames : int
        Number of frames, evenly spaced over the duration of the log, 2 to 1000.
    frames_per_second : float
        In (0, 50]; the format stores time in hundredths of a second.

    Returns
    -------
    Animation
        Displayed by notebooks.

    Raises
    ------
    InvalidValue
        If the file name has another ending or a number is not allowed.
    InvalidFile
        If the dataset is not a log.
    """
    if path is not None and Path(require_path("path", path)).suffix.lower() != ".gif":
        raise InvalidValue("output", str(path), "a name ending in .gif", "rename the file")
    require_number(
        "frames", frames, lambda n: 2 <= n <= 1000 and n == int(n), FRAMES, "choose another number"
    )
    require_number(
        "frames_per_second", frames_per_second, lambda x: 0 < x <= 50, "a number in (0, 50]",
        "slow it down",
    )  # fmt: skip
    data = plotted(log)
    announce_end(log)
    found = Animation(_gif(resampled(data, frames), frames_per_second), frames)
    if path is not None:
        with replacing(path) as temporary:
            temporary.write_bytes(found.gif)
    return found


def _gif(motion: xr.Dataset, rate: float) -> bytes:
    count = motion.sizes["time"]
    with paper_style():
        pictures = list(tqdm(_pictures(motion), "drawing", count, disable=None, leave=False))
    palette = pictures[len(pictures) // 2].quantize(COLORS, dither=Image.Dither.NONE)
    flat = [each.quantize(palette=palette, dither=Image.Dither.NONE) for each in pictures]
    duration = max(2, math.floor(100 / rate + 0.5)) * 10
    file = io.BytesIO()
    flat[0].save(
        file, format="GIF", save_all=True, append_images=flat[1:], duration=duration, loop=0,
        optimize=False,
    )  # fmt: skip
    return file.getvalue()


def resampled(data: xr.Dataset, count: int) -> xr.Dataset:
    """Motion at evenly spaced times: positions interpolated, discontinuous values from the row before."""
    time = data["time"].values
    wanted = np.linspace(time[0], time[-1], count)
    before = np.clip(np.searchsorted(time, wanted, side="right") - 1, 0, len(time) - 1)
    found = data.isel(time=before).assign_coords(time=wanted)
    if "path_flush" in data:
        found["path_contact_position"] = ("time", _places_of_force(data, wanted, before))
    names = ("path_position", "path_pusher", "path_rod_angle", "path_gap", "path_slip", "path_side")
    for name in (each for each in names if each in data):
        values = data[name].values.reshape(len(time), -1)
        columns = [np.interp(wanted, time, column) for column in values.T]
        found[name] = (data[name].dims, np.stack(columns, axis=-1).reshape(found[name].shape))
    return found


def _places_of_force(data: xr.Dataset, wanted: Array, before: Any) -> Array:
    """Places of the force along the fence, interpolated between rows with one contact."""
    along, point = data["path_contact_position"].values, touching(data)
    after = np.minimum(before + 1, len(along) - 1)
    between = np.interp(wanted, data["time"].values, along)
    smooth = (point[before] == point[after]) & np.isfinite(along[before] + along[after])
    return np.asarray(np.where(smooth, between, along[before]))


def _pictures(data: xr.Dataset) -> Iterator[Image.Image]:
    """Yield one picture for each time."""
    limits = box(data)
    frame = Sheet.around(limits, 72 * np.array(SIZE), PAD).box  # type: ignore[arg-type]
    for row in range(data.sizes["time"]):
        figure = Figure(figsize=SIZE, dpi=DPI)
        to_axes(instant_picture(data, row, frame), schematic(figure), limits, PAD)
        text = f"t = {data['time'].values[row]:.2f}   {status(data, row)}"
        figure.text(0.02, 0.96, text, size=NOTE, color=GUIDE, va="top")
        canvas: Any = FigureCanvasAgg(figure)
        canvas.draw()
        yield Image.fromarray(np.asarray(canvas.buffer_rgba())[..., :3].copy())


def instant_picture(data: xr.Dataset, row: int, frame: Any) -> Picture:
    """Picture of the slider, the pusher and the motion center at a row, with the paths up to it."""
    picture = Picture()
    add_paths(picture, data, frame, row)
    add_instant(picture, data, row)
    center = data["path_center"].values[row]
    if np.isfinite(center).all():
        add_center_mark(picture, center, size=4.5, pivot=_pivots(data, row))
    if row == 0:
        name_centers(picture, body_in(data), pose(data, row))
    return picture


def _pivots(data: xr.Dataset, row: int) -> bool:
    return "path_pivot" in data and bool(data["path_pivot"].values[row] >= 0)


def status(data: xr.Dataset, row: int) -> str:
    """Contact mode in words, with a note if the slider pivots or if there was a choice."""
    mode = MODES[int(data["path_mode"].values[row])].name
    pivots = ", pivots" if _pivots(data, row) else ""
    flush = ", flush" if "path_flush" in data and data["path_flush"].values[row] else ""
    several = " (one of several)" if data["path_solutions"].values[row] > 1 else ""
    return f"{mode}{flush}{pivots}{several}"
