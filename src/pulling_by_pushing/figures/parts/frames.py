"""Frames of motions: a row for each motion and a frame for each instant, all at one scale."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.drawing.canvas.axes import schematic, to_axes
from planar_pushing.drawing.canvas.colors import DARK, GUIDE
from planar_pushing.drawing.canvas.marks import NOTE, Picture
from planar_pushing.drawing.motion import add_instant, add_paths, box
from planar_pushing.drawing.scene import add_center_mark
from planar_pushing.drawing.timeline import rows
from planar_pushing.mechanics.plane import Array

#: Height of a row title as a fraction of the figure's height.
TITLE = 0.055


def add_frames(
    figure: Any, motions: Sequence[xr.Dataset], names: Sequence[str], count: int,
    rect: tuple[float, float, float, float],
) -> None:  # fmt: skip
    """Draw frames in a region of a figure."""
    left, bottom, width, height = rect
    whole = [box(motion) for motion in motions]
    frame = np.array([np.min([b[0] for b in whole], axis=0), np.max([b[1] for b in whole], axis=0)])
    high = height / len(motions)
    for row, (motion, name) in enumerate(zip(motions, names, strict=True)):
        top = bottom + height - row * high
        figure.text(left + 0.012, top - 0.01, name, va="top", color=DARK)
        for column, instant in enumerate(rows(motion, count)):
            place = (left + column * width / count, top - high, width / count, high - TITLE)
            ax = schematic(figure, place)
            to_axes(frame_picture(motion, instant, frame), ax, frame, 3.0)
            text = f"$t = {motion['time'].values[instant]:.3g}$"
            ax.text(0.5, 0.0, text, transform=ax.transAxes, ha="center", size=NOTE, color=GUIDE)


def frame_picture(motion: xr.Dataset, row: int, frame: Array) -> Picture:
    """Picture of slider, pusher, force and motion center at an instant, and the contact's path so far."""
    picture = Picture()
    add_paths(picture, motion, frame, row)
    add_instant(picture, motion, row)
    center = motion["path_center"].values[row]
    if np.isfinite(center).all() and np.all((frame[0] < center) & (center < frame[1])):
        add_center_mark(picture, center, size=4.0)
    return picture
