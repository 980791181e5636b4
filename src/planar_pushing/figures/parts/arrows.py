"""Arrows: filled heads for forces, open ones for velocities and accelerations, as in the paper."""

from __future__ import annotations

from functools import partial

import numpy as np
import numpy.typing as npt
from matplotlib.axes import Axes
from matplotlib.patches import FancyArrowPatch
from matplotlib.path import Path
from matplotlib.transforms import Affine2D

from planar_pushing.figures.parts.labels import label
from planar_pushing.figures.style import ABOVE, CENTER, FORCE, GUIDE, MOTION
from planar_pushing.mechanics.plane import Array

FILLED_HEAD = "-|>,head_length=0.42,head_width=0.17"
OPEN_HEAD = "->,head_length=0.42,head_width=0.22"


def unit(angle: float) -> Array:
    """Return the unit vector at an angle in degrees."""
    return np.array([np.cos(np.deg2rad(angle)), np.sin(np.deg2rad(angle))])


def arrow(
    ax: Axes,
    tail: npt.ArrayLike,
    vector: npt.ArrayLike,
    text: str = "",
    *,
    style: str,
    color: str,
    width: float = 1.3,
    head: float = 14.0,
    offset: tuple[float, float] | None = None,
    at: float = 1.0,
    zorder: float = ABOVE,
) -> FancyArrowPatch:
    """Arrow from `tail` to ``tail + vector`` with its label.

    Parameters
    ----------
    width, head : float
        Line width and scale of the head, points.
    offset : tuple, optional
        Of the label, points; by default the label continues the arrow.
    at : float
        Where along the arrow the label is anchored, 0 at the tail and 1 at the tip.
    """
    start, along = np.asarray(tail, dtype=float), np.asarray(vector, dtype=float)
    patch = FancyArrowPatch(
        tuple(start),
        tuple(start + along),
        arrowstyle=style,
        mutation_scale=head,
        shrinkA=0,
        shrinkB=0,
        linewidth=width,
        color=color,
        joinstyle="miter",
        capstyle="butt",
        zorder=zorder,
    )
    ax.add_patch(patch)
    if text:
        length = float(np.hypot(*along)) or 1.0
        ahead = (9.0 * along[0] / length, 8.0 * along[1] / length)
        label(ax, start + at * along, text, offset=offset or ahead, color=color)
    return patch


#: Arrow of a force, with a filled head, and of a velocity or acceleration, with an open one.
force_arrow = partial(arrow, style=FILLED_HEAD, color=FORCE)
motion_arrow = partial(arrow, style=OPEN_HEAD, color=MOTION)


def coordinate_axes(
    ax: Axes,
    origin: npt.ArrayLike,
    angle: float,
    length: float,
    names: tuple[str, str],
    *,
    color: str = GUIDE,
) -> None:
    """Two thin axes, the first at `angle` and the second 90 degrees on."""
    for turn, name in zip((0.0, 90.0), names, strict=True):
        along = length * unit(angle + turn)
        arrow(ax, origin, along, name, style=OPEN_HEAD, color=color, width=0.7, head=8, zorder=2)


def turning(
    ax: Axes, xy: npt.ArrayLike, sense: float, radius: float, *, color: str = CENTER
) -> FancyArrowPatch:
    """Curved motion arrow around a center, counter-clockwise for a positive `sense`."""
    arc = Path.arc(-30, 210)
    path = Path(np.asarray(arc.vertices) * [1.0 if sense > 0 else -1.0, 1.0], arc.codes)
    patch = FancyArrowPatch(
        path=Affine2D().scale(radius).translate(*np.asarray(xy, dtype=float)).transform_path(path),
        arrowstyle=OPEN_HEAD,
        mutation_scale=8,
        linewidth=0.9,
        color=color,
        zorder=ABOVE,
    )
    ax.add_patch(patch)
    return patch
