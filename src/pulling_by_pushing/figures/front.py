"""Pictures of README and of the report's first page: pulling, slip, and a box. `make front` stores them.

Rendered text moves between versions of matplotlib, so the comparison is meaningful only with the locked
versions.
"""

from __future__ import annotations

import argparse
import io
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import xarray as xr
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from PIL import Image

from planar_pushing.drawing.animate import encode, resample
from planar_pushing.drawing.body import add_body, body_in
from planar_pushing.drawing.canvas.axes import schematic, to_axes
from planar_pushing.drawing.canvas.colors import DARK, LIGHT, MODES, PUSHER
from planar_pushing.drawing.canvas.marks import Picture, corners
from planar_pushing.drawing.canvas.style import paper_style
from planar_pushing.drawing.motion import (
    add_first_pusher,
    add_instant,
    add_velocity,
    box,
    pose,
    span,
    velocity_arrow,
)
from planar_pushing.drawing.supports import Ink
from planar_pushing.drawing.timeline import contact, path_data, rod_end
from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.mechanics.plane import Array
from planar_pushing.scenes.files import load_scene_file
from planar_pushing.scenes.simulate import simulate_file
from planar_pushing.terms.errors import InvalidFile
from planar_pushing.terms.replacing import replacing
from pulling_by_pushing.figures.front_box import box_picture
from pulling_by_pushing.study.running.jobs import run_command

#: Where the animation and the picture of the box are stored, and the number of colors of the latter.
ANIMATION = Path("paper/manual/pictures/pulling_and_slip.gif")
BOX, COLORS = Path("paper/manual/pictures/box.png"), 64
#: Where the last instants of both motions are stored for the report, and their pixels per inch.
LAST, FINE = Path("paper/pictures/pulling_and_slip.png"), 220
#: Size of a frame in inches, its pixels per inch, and the padding around a drawing in points.
SIZE, DPI, PAD = (7.4, 3.0), 110, 8.0
#: Height of the words above the drawings, inches, and their sizes, points.
WORDS, TITLE, NOTE = 0.58, 12.0, 9.5
#: Distances of the measuring arrows from the contact, in units of the span.
RETREAT, SLIP_BELOW = 0.17, 0.17
#: Shortest measured length, and the shortest beside which its words fit, in units of the span.
MEASURED, NAMED = 0.02, 0.11
#: Number of frames, frames per second, and the rest at the end in seconds.
FRAMES, RATE, REST = 43, 12.0, 1.5
#: Largest root mean square difference of two frames' color levels, 0 to 255: text moves a little.
LEVEL_TOLERANCE = 4.0


class Panel(NamedTuple):
    """A motion, its title, and what its arrow measures."""

    scene: Path
    title: str
    note: str
    mode: ContactMode


PULLING = Panel(
    Path("workflow/scenes/steep_retreat.yaml"),
    "Pulling with friction 5",
    "The fence moves away, and the ring follows.",
    ContactMode.STICK,
)
SLIP = Panel(
    Path("workflow/scenes/slipping.yaml"),
    "Slip with infinite friction",
    "The fence pushes, and the contact slips.",
    ContactMode.SLIP_RIGHT,
)


def motion_of(panel: Panel, frames: int = FRAMES) -> xr.Dataset:
    """Motion of a panel at evenly spaced times.

    Raises
    ------
    InvalidFile
        If the contact is not always in the mode of the panel, which its words describe.
    """
    log = simulate_file(load_scene_file(panel.scene))
    modes = {ContactMode(int(mode)) for mode in log["mode"].values}
    if modes != {panel.mode}:
        names = ", ".join(sorted(mode.name for mode in modes))
        raise InvalidFile(f"{panel.scene}: {names}; allowed: {panel.mode.name}; correct the scene")
    return resample(path_data(log), frames)


def panel_picture(data: xr.Dataset, row: int) -> Picture:
    """Picture of a motion at a row, with the slider at time 0 in gray and the length that grows."""
    picture = Picture()
    first = pose(data, 0)
    add_body(picture, body_in(data), first, contact=rod_end(data)[0], ink=Ink(LIGHT, 1.2))
    add_instant(picture, data, row)
    if int(data["path_mode"].values[row]) == ContactMode.STICK:
        add_velocity(picture, data, row)
        add_first_pusher(picture, data, row)
        add_retreat(picture, data, row)
    else:
        tail, tip = velocity_arrow(data, row)
        picture.motion(tail, tip - tail, color=PUSHER, head=9.0, width=1.2)
        name, middle = r"$\mathbf{v}_p$", (tail + tip) / 2
        picture.label(middle, name, color=PUSHER, offset=(-2.0, -9.0), held=True)
        add_slip(picture, data, row)
    return picture


def add_retreat(picture: Picture, data: xr.Dataset, row: int) -> None:
    """Add how far the fence is below its first line."""
    touch, size, color = contact(data)[row], span(data), MODES[ContactMode.STICK].ink
    away = -float(data["path_pusher"].values[row, 1])
    if away > MEASURED * size:
        tail = np.array([touch[0] - RETREAT * size, 0.0])
        picture.arrow(tail, (0.0, -away), color=color, filled=False, width=1.4, head=9.0)
    if away > NAMED * size:
        text, place = f"away by\n{away:.1f}", tail - [0.0, away / 2]
        picture.label(place, text, color=color, size=NOTE, offset=(-24.0, 0.0), held=True)


def add_slip(picture: Picture, data: xr.Dataset, row: int) -> None:
    """Add how far the contact is from the point of the fence that it touched first."""
    (x, y), size, color = contact(data)[row], span(data), MODES[ContactMode.SLIP_RIGHT].ink
    slipped, low = float(data["path_slip"].values[row]), y - SLIP_BELOW * size
    if slipped > MEASURED * size:
        for end in (x - slipped, x):
            picture.guide((end, y), (end, low), color)
        tail = x - slipped, low
        picture.arrow(tail, (slipped, 0.0), color=color, filled=False, width=1.4, head=9.0)
        text = f"slipped by {slipped:.1f}"
        picture.label((x, low), text, color=color, size=NOTE, offset=(40.0, -5.0), held=True)


def _low_end(data: xr.Dataset) -> Array:
    """Position below the contact of a slip, for its words."""
    return np.asarray(contact(data) - [0.0, (SLIP_BELOW + 0.04) * span(data)])


def pictures(
    motions: list[xr.Dataset], rows: Sequence[int], dpi: int = DPI
) -> Iterator[Image.Image]:
    """Yield one picture for each of some times, with the motions side by side at one scale."""
    boxes = [corners([box(data), _low_end(data)]) for data in motions]
    widths = [float(np.ptp(each[:, 0])) for each in boxes]
    shares = np.cumsum([0.0, *widths]) / sum(widths)
    high = 1.0 - WORDS / SIZE[1]
    for row in rows:
        figure = Figure(figsize=SIZE, dpi=dpi)
        for data, panel, limits, left, right in zip(
            motions, (PULLING, SLIP), boxes, shares[:-1], shares[1:], strict=True
        ):
            axes = schematic(figure, (left, 0.0, right - left, high))
            to_axes(panel_picture(data, row), axes, limits, PAD)
            figure.text(left + 0.02, 0.97, panel.title, size=TITLE, color=DARK, va="top")
            figure.text(left + 0.02, 0.885, panel.note, size=NOTE, color=PUSHER, va="top")
        canvas: Any = FigureCanvasAgg(figure)
        canvas.draw()
        yield Image.fromarray(np.asarray(canvas.buffer_rgba())[..., :3].copy())


def animation() -> bytes:
    """The animation as a GIF."""
    motions = [motion_of(panel) for panel in (PULLING, SLIP)]
    with paper_style():
        return encode(list(pictures(motions, range(FRAMES))), RATE, REST)


def last_png() -> bytes:
    """The last instants of both motions as a PNG."""
    motions = [motion_of(panel, 2) for panel in (PULLING, SLIP)]
    with paper_style():
        (picture,) = pictures(motions, [1], FINE)
    return png(picture)


def frames(picture: bytes) -> Iterator[Array]:
    """Yield every picture of an animation, as color levels."""
    with Image.open(io.BytesIO(picture)) as image:
        for number in range(getattr(image, "n_frames", 1)):
            image.seek(number)
            yield np.asarray(image.convert("RGB"), dtype=float)


def difference(new: bytes, stored: bytes) -> float:
    """Largest root mean square difference of two frames; infinite if sizes or numbers of frames differ."""
    ours, theirs = list(frames(new)), list(frames(stored))
    if [each.shape for each in ours] != [each.shape for each in theirs]:
        return np.inf
    pairs = zip(ours, theirs, strict=True)
    return max(float(np.sqrt(np.mean((one - other) ** 2))) for one, other in pairs)


def png(picture: Image.Image) -> bytes:
    """A picture with few colors as a PNG."""
    file = io.BytesIO()
    picture.quantize(COLORS).save(file, format="PNG", optimize=True)
    return file.getvalue()


def box_png() -> bytes:
    """The picture of the box as a PNG."""
    return png(box_picture())


#: Files, and the functions that make them.
FILES = {ANIMATION: animation, LAST: last_png, BOX: box_png}


def main(arguments: list[str] | None = None) -> int:
    """Print how the pictures differ from the stored ones; return 1 if any differs or is stored."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--write", action="store_true", help="store the pictures that differ")
    args = parser.parse_args(arguments)
    changed = 0
    for path, make in FILES.items():
        new = make()
        gap = difference(new, path.read_bytes()) if path.is_file() else np.inf
        same = gap <= LEVEL_TOLERANCE
        print(f"{path}: {'unchanged' if same else 'differs'}, {gap:.2f} color levels")
        changed += not same
        if args.write and not same:
            with replacing(path) as temporary:
                temporary.write_bytes(new)
    return 1 if changed else 0


if __name__ == "__main__":
    sys.exit(run_command(main))
