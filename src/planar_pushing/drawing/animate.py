"""A motion over time as an animated picture."""

from __future__ import annotations

import base64
import io
import json
import math
import shutil
import subprocess
from collections.abc import Iterator, Sequence
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
from planar_pushing.drawing.canvas.colors import DARK, MODES, PUSHER
from planar_pushing.drawing.canvas.marks import Picture, Sheet
from planar_pushing.drawing.canvas.style import paper_style
from planar_pushing.drawing.motion import box, frame_picture, pose
from planar_pushing.drawing.timeline import (
    announce_end,
    is_pivot,
    path_data,
    pusher_action,
    touched_side,
    touching_wall,
)
from planar_pushing.mechanics.plane import Array
from planar_pushing.terms.errors import InvalidFile, InvalidValue, require_number, require_path
from planar_pushing.terms.replacing import PathLike, replacing

#: Size of a picture in inches, its pixels per inch, and the padding around the drawing in points.
SIZE, DPI, PAD = (4.8, 3.6), 120, 10.0
#: Height of the words above the drawing, inches, and their sizes, points.
WORDS, ACTION, STATUS = 0.5, 12.0, 9.5
#: Number of colors in the animation: enough for smooth edges, few enough for a small file.
COLORS = 64
#: A color with larger values of red, green and blue becomes white.
NEAR_WHITE = 246
FRAMES = "a whole number from 2 to 1000"


@dataclass(frozen=True, slots=True)
class Animation:
    """An animated picture that notebooks display."""

    gif: bytes
    frames: int

    def save(self, path: PathLike) -> None:
        """Write the animation to a file, completely or not at all.

        Parameters
        ----------
        path : path
            Its name ends in .gif or, where the program ffmpeg is installed, in .mp4.

        Raises
        ------
        InvalidValue
            If the name has another ending, or ffmpeg is not found.
        InvalidFile
            If the file cannot be written.
        """
        ending = _required_ending(path)
        with replacing(path) as temporary:
            if ending == ".gif":
                temporary.write_bytes(self.gif)
            else:
                _write_video(self.gif, temporary, path)

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
    """Draw a log as an animated GIF, whose bytes depend only on the log, or as a video.

    Parameters
    ----------
    log : xarray.Dataset
        Returned by `simulate`. For the log of a run that did not finish, the package's logger says where
        the log ends.
    path : path, optional
        File to write, as by `Animation.save`: its name ends in .gif or, where the program ffmpeg is
        installed, in .mp4.
    frames : int
        Number of frames, evenly spaced over the duration of the log, 2 to 1000.
    frames_per_second : float
        In (0, 50]; the format stores time in hundredths of a second.

    Returns
    -------
    Animation
        Displayed by notebooks; `save` writes it to a file.

    Raises
    ------
    InvalidValue
        If the file name has another ending, ffmpeg is not found, or a number is not allowed.
    InvalidFile
        If the dataset is not a log.
    """
    if path is not None:
        _required_ending(path)
    require_number(
        "frames", frames, lambda n: 2 <= n <= 1000 and n == int(n), FRAMES, "choose another number"
    )
    require_number(
        "frames_per_second", frames_per_second, lambda x: 0 < x <= 50, "a number in (0, 50]",
        "slow it down",
    )  # fmt: skip
    data = path_data(log)
    announce_end(log)
    animation = Animation(_gif(resample(data, frames), frames_per_second), frames)
    if path is not None:
        animation.save(path)
    return animation


def _required_ending(path: PathLike) -> str:
    """The ending of a file name, .gif or, where ffmpeg is installed, .mp4."""
    ending = Path(require_path("path", path)).suffix.lower()
    if ending not in (".gif", ".mp4"):
        allowed = "a name ending in .gif or, with the program ffmpeg, in .mp4"
        raise InvalidValue("output", str(path), allowed, "rename the file")
    if ending == ".mp4" and shutil.which("ffmpeg") is None:
        raise InvalidValue(
            "output", str(path), "a name ending in .gif, since the program ffmpeg is not found",
            "install ffmpeg, or rename the file",
        )  # fmt: skip
    return ending


def _write_video(gif: bytes, file: Path, name: PathLike) -> None:
    """Convert an animation to a video in a file; a message says the file's final name."""
    command = ["ffmpeg", "-loglevel", "error", "-y", "-f", "gif", "-i", "pipe:0"]
    options = ["-pix_fmt", "yuv420p", "-movflags", "+faststart", "-f", "mp4", str(file)]
    ended = subprocess.run([*command, *options], input=gif, capture_output=True, check=False)
    if ended.returncode:
        messages = ended.stderr.decode(errors="replace").strip().splitlines()
        reason = messages[-1] if messages else f"exit code {ended.returncode}"
        raise InvalidFile(f"{name}: ffmpeg: {reason}; update ffmpeg, or give a name ending in .gif")


def _gif(motion: xr.Dataset, rate: float) -> bytes:
    count = motion.sizes["time"]
    with paper_style():
        pictures = list(tqdm(_pictures(motion), "drawing", count, disable=None, leave=False))
    return encode(pictures, rate)


def encode(pictures: Sequence[Image.Image], rate: float, rest: float = 0.0) -> bytes:
    """Encode pictures, with their rate per second, as a GIF; the last stays for `rest` seconds more."""
    palette = _palette(pictures[len(pictures) // 2])
    flat = [picture.quantize(palette=palette, dither=Image.Dither.NONE) for picture in pictures]
    duration = max(2, math.floor(100 / rate + 0.5)) * 10
    durations = [duration] * len(flat)
    durations[-1] += round(100 * rest) * 10
    file = io.BytesIO()
    flat[0].save(
        file, format="GIF", save_all=True, append_images=flat[1:], duration=durations, loop=0,
        optimize=False,
    )  # fmt: skip
    return file.getvalue()


def _palette(picture: Image.Image) -> Image.Image:
    """Colors of a picture, with white for those that are close to it: the background stays white."""
    reduced = picture.quantize(COLORS, dither=Image.Dither.NONE)
    colors = np.reshape(reduced.getpalette() or [], (-1, 3))
    colors[colors.min(axis=1) > NEAR_WHITE] = 255
    reduced.putpalette(colors.ravel().tolist())
    return reduced


def resample(data: xr.Dataset, count: int) -> xr.Dataset:
    """Motion at evenly spaced times: positions interpolated, discontinuous values from the row before."""
    time = data["time"].values
    times = np.linspace(time[0], time[-1], count)
    before = np.clip(np.searchsorted(time, times, side="right") - 1, 0, len(time) - 1)
    motion = data.isel(time=before).assign_coords(time=times)
    if "path_flush" in data:
        motion["path_contact_position"] = ("time", _force_positions(data, times, before))
    names = ("path_position", "path_pusher", "path_rod_angle", "path_gap", "path_slip", "path_side")
    for name in filter(data.__contains__, names):
        values = data[name].values.reshape(len(time), -1)
        columns = [np.interp(times, time, column) for column in values.T]
        motion[name] = (data[name].dims, np.stack(columns, axis=-1).reshape(motion[name].shape))
    entry = json.loads(data.attrs["scene"])["slider"].get("outline")
    if "path_side" in data and entry is not None:
        motion["path_side"] = touched_side(motion, entry)
    return motion


def _force_positions(data: xr.Dataset, times: Array, before: Any) -> Array:
    """Positions of the force along the fence, interpolated between rows with one contact."""
    along, point = data["path_contact_position"].values, touching_wall(data)
    after = np.minimum(before + 1, len(along) - 1)
    between = np.interp(times, data["time"].values, along)
    smooth = (point[before] == point[after]) & np.isfinite(along[before] + along[after])
    return np.asarray(np.where(smooth, between, along[before]))


def _pictures(data: xr.Dataset) -> Iterator[Image.Image]:
    """Yield one picture for each time."""
    limits, rect = box(data), (0.0, 0.0, 1.0, 1.0 - WORDS / SIZE[1])
    size = 72 * np.array(SIZE) * rect[2:]
    frame = Sheet.around(limits, size, PAD).box
    for row in range(data.sizes["time"]):
        figure = Figure(figsize=SIZE, dpi=DPI)
        to_axes(instant_picture(data, row, frame), schematic(figure, rect), limits, PAD)
        _write(figure, data, row)
        canvas: Any = FigureCanvasAgg(figure)
        canvas.draw()
        yield Image.fromarray(np.asarray(canvas.buffer_rgba())[..., :3].copy())


def _write(figure: Figure, data: xr.Dataset, row: int) -> None:
    """Write time, action of the pusher and contact mode above a picture, each in the color of its marks."""
    mode = MODES[int(data["path_mode"].values[row])]
    time = f"$t = {data['time'].values[row]:.2f}$"
    figure.text(0.02, 0.975, pusher_action(data, row), size=ACTION, color=PUSHER, va="top")
    figure.text(0.98, 0.975, time, size=ACTION, color=DARK, va="top", ha="right")
    text = f"contact: {status(data, row)}"
    figure.text(0.02, 0.905, text, size=STATUS, color=mode.ink, va="top")


def instant_picture(data: xr.Dataset, row: int, frame: Any) -> Picture:
    """Picture of a frame of an animation; the first one names the centers of pressure and mass."""
    picture = frame_picture(data, row, frame)
    if row == 0:
        name_centers(picture, body_in(data), pose(data, row))
    return picture


def status(data: xr.Dataset, row: int) -> str:
    """Contact mode in words, with a note if the slider pivots or if there was a choice."""
    mode = MODES[int(data["path_mode"].values[row])].name
    pivots = ", pivots" if is_pivot(data, row) else ""
    flush = ", flush" if "path_flush" in data and data["path_flush"].values[row] else ""
    several = " (one of several)" if data["path_solutions"].values[row] > 1 else ""
    return f"{mode}{flush}{pivots}{several}"
