"""Limit curves of several rod lengths, as points and as labeled lines."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from planar_pushing.drawing.canvas.colors import rod_color
from planar_pushing.drawing.canvas.marks import Label, Picture, unit
from pulling_by_pushing.figures.captions import mathematical

if TYPE_CHECKING:
    import xarray as xr

    from planar_pushing.mechanics.plane import Array

#: Size of small letters in points.
SMALL = 8.0


def points(curve: xr.Dataset) -> Array:
    """Forces on a curve, with their components last."""
    return np.stack([curve.force_x, curve.force_y], axis=-1)


def add_curves(
    picture: Picture, curves: xr.Dataset, angle: float, bold: float | None = None
) -> None:
    """Draw the force curves of several rod lengths, labeled with the length at a force angle in degrees.

    The label of the first curve includes the symbol and is outside this outermost curve; those of the
    others interrupt their curves. `bold` is the rod length of a curve to draw heavier.
    """
    right, up = unit(angle)
    outside: dict[str, Any] = {
        "offset": (4.0 * right, 5.0 * up),
        "align": "right" if right < 0 else "left",
    }
    for length in curves.rod_length.values:
        curve = curves.sel(rod_length=length)
        width = 1.2 if bold is None else (1.8 if length == bold else 0.9)
        picture.line(points(curve), rod_color(float(length)), width=width, order=3.0)
        first = length == curves.rod_length[0]
        text = f"$l = {mathematical(length)}$" if first else f"${mathematical(length)}$"
        tip = points(curve.sel(force_angle=angle, method="nearest"))
        label = Label(tip, text, size=SMALL, held=True, **(outside if first else {}))
        if not first:
            picture.dot(tip, max(label.extent), "white", order=3.1)
        picture.add(label)
