"""Slip with infinite friction for the gallery of supports."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from planar_pushing.drawing.canvas.colors import support_colors
from planar_pushing.drawing.canvas.style import PAGE
from planar_pushing.mechanics.plane import Array
from pulling_by_pushing.figures.figure import Data, Figure
from pulling_by_pushing.figures.parts.gallery import SECTION, families, shapes
from pulling_by_pushing.figures.parts.line_labels import label_lines, named_lines
from pulling_by_pushing.figures.parts.rods import AXES, common_value, cuts, panels

if TYPE_CHECKING:
    import xarray as xr

FIGURE = Figure(
    title="Slip with infinite friction, any slider",
    reads=("support_rods", "support_cones", "supports"),
    cuts={"support_cones": {"friction_coefficient": np.inf, "rod_length": None, "rod_angle": None}},
    size=(PAGE, 2.6),
    section=SECTION,
)
#: Upper end of the axis of fractions in all panels, percent.
HIGHEST = 41.0


def caption(data: Data) -> str:
    """Caption with the plotted values."""
    length, angle, ring = cuts(data["support_rods"], data["supports"])
    return (
        "Slip with infinite friction: the fraction of push directions between 0° and 180° that "
        f"slip, over the rod length (a; ψ = {angle}°) and the rod angle (b; l = {length}). Where the "
        "force along the fence has one motion, the motion cone spans 180 degrees, and the fraction is its "
        "tilt from the friction cone divided by 180 degrees. Dots are from the motion cones of the "
        f"dataset; gray is {ring} (μ = ∞)."
    )


def draw(figure: Any, data: Data) -> None:
    """Draw the slipping fraction in percent, with dots for the cones of the study's grid."""
    rods, cones = data["support_rods"], data["support_cones"].stack(rod=AXES)
    supports = shapes(data["supports"])
    names = [name for family in families(supports, float(rods.radius)) for name in family]
    for ax, axis, looks in panels(figure, rods, support_colors(supports), [names], _lines):
        (other,) = {*AXES} - {axis}
        lines = named_lines(ax)
        dots = cones.isel(rod=cones[other].values == common_value(rods, other))
        for name, color, _ in looks:
            style: dict[str, Any] = {
                "markersize": 3.2,
                "markerfacecolor": "white",
                "clip_on": False,
            }
            y = slipping_percent(dots.motion_angle.sel(support=name))
            ax.plot(dots[axis], y, "o", color=color, markeredgewidth=0.8, **style)
        ax.set_ylim(0.0, HIGHEST)
        if axis == "rod_length":
            ax.set_ylabel("pushes that slip (percent)")
        label_lines(ax, lines)


def _lines(rods: xr.Dataset, axis: str, prefix: str) -> Array:
    return slipping_percent(rods[f"{prefix}motion_angle"])


def slipping_percent(edges: xr.DataArray) -> Array:
    """Percentage of the pushes from 0 to 180 degrees outside motion cones with these edges, in degrees."""
    right, left = (edges.sel(edge=edge) for edge in ("right", "left"))
    held: xr.DataArray = left.clip(max=180.0) - right.clip(min=0.0)
    return np.asarray(100.0 * (1 - held / 180.0).values)
