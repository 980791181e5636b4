"""Limit curves of several rod lengths, as points and as labeled lines."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from planar_pushing.drawing.canvas.colors import rod_color
from planar_pushing.drawing.canvas.marks import NOTE, Picture
from pulling_by_pushing.figures.captions import mathematical

if TYPE_CHECKING:
    import xarray as xr

    from planar_pushing.mechanics.plane import Array


def points(curve: xr.Dataset) -> Array:
    """Forces on a curve, with their components last."""
    return np.stack([curve.force_x, curve.force_y], axis=-1)


def add_curves(
    picture: Picture, curves: xr.Dataset, place: float, side: str, bold: float | None = None
) -> None:
    """Draw the force curves of several rod lengths, labeled with the length at the angle `place`, degrees.

    The label of the first, outermost curve includes the symbol and is aligned to `side`; `bold` is the rod
    length of a curve to draw heavier.
    """
    for length in curves.rod_length.values:
        curve = curves.sel(rod_length=length)
        width = 1.2 if bold is None else (1.8 if length == bold else 0.9)
        picture.line(points(curve), rod_color(float(length)), width=width, order=3.0)
        first = length == curves.rod_length[0]
        text = f"$l = {mathematical(length)}$" if first else f"${mathematical(length)}$"
        tip = points(curve.sel(force_angle=place, method="nearest"))
        picture.label(tip, text, size=NOTE, align=side if first else "center")
