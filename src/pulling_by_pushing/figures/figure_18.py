"""Figure 18: slip with infinite friction for the gallery of supports."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.drawing.canvas.style import COLUMN, PAGE
from planar_pushing.mechanics.contact import InfiniteFriction
from planar_pushing.mechanics.force.cones import motion_cone
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.scene import Scene
from pulling_by_pushing.figures.figure import Figure, Settings, Sources
from pulling_by_pushing.figures.parts.data import named, number, titled
from pulling_by_pushing.figures.parts.gallery import SECTION
from pulling_by_pushing.figures.parts.rods import over_rods, panels

FIGURE = Figure(
    title="Slip with infinite friction, any slider",
    reads=("supports", "support_cones"),
    takes=("rod_length",),
    at={"friction_coefficient": np.inf},
    size=(PAGE, 4.9),
    column=(COLUMN, 9.0),
    section=SECTION,
)
PART = "fraction of the pushes into the slider, from 0 to 180 degrees, that slip"
#: Upper end of the axis of fractions in all panels, percent.
HIGHEST = 41.0


def slipping_part(right: xr.DataArray, left: xr.DataArray) -> xr.DataArray:
    """Fraction of the pushes from 0 to 180 degrees outside a motion cone with these edges, in degrees."""
    held: xr.DataArray = left.clip(max=180.0) - right.clip(min=0.0)
    return 1 - held / 180.0


def _computed(scenes: Scene) -> xr.DataArray:
    cone = motion_cone(scenes)
    return slipping_part(np.rad2deg(cone.right), np.rad2deg(cone.left))


def select(sources: Sources, settings: Settings) -> xr.Dataset:
    """Compute the slipping fraction over rod length and rod angle, and that of the grid's cones."""
    data = over_rods(sources["supports"], settings, InfiniteFriction(), _computed, PART)
    cones = sources["support_cones"].sel(friction_coefficient=np.inf)
    part = slipping_part(*(cones.motion_angle.sel(edge=edge) for edge in ("right", "left")))
    cuts = {
        "rod_length": part.sel(rod_angle=settings.rod_angle),
        "rod_angle": part.sel(rod_length=settings.rod_length),
    }
    for axis, cut in cuts.items():
        attrs = cones[axis].attrs
        data = data.assign_coords({f"grid_{axis}": (f"grid_{axis}", cones[axis].values, attrs)})
        given = cut.transpose("support", axis).values
        data[f"grid_over_{axis}"] = named(("support", f"grid_{axis}"), given, "1", PART)
    return titled(data, "Slip with infinite friction", sources)


def caption(data: xr.Dataset) -> str:
    """Caption with the plotted values."""
    length, angle = number(float(data.cut_rod_length)), number(float(data.cut_rod_angle))
    return (
        "Slip with infinite friction: the fraction of push directions between 0° and 180° that "
        "slip, for supports on areas (a, b) and on points and lines (c, d), over the rod length "
        f"(a, c; ψ = {angle}°) and the rod angle (b, d; l = {length}). Where the force along "
        "the fence has one motion, the motion cone spans 180 degrees, and the fraction is its tilt from "
        "the friction cone divided by 180 degrees. Dots are from the motion cones of the dataset; gray "
        "is a ring of the same extent, "
        f"of radius {number(float(data.ring_extent))} (μ = ∞)."
    )


def draw(figure: Any, data: xr.Dataset) -> None:
    """Draw the slipping fraction in percent, with dots for the cones of the study's grid."""
    for ax, axis, looks in panels(figure, data, lambda part, axis: _percent(part)):
        for name, color, _ in looks:
            y = _percent(data[f"grid_over_{axis}"].sel(support=name))
            style: dict[str, Any] = {
                "markersize": 3.2,
                "markerfacecolor": "white",
                "clip_on": False,
            }
            ax.plot(data[f"grid_{axis}"], y, "o", color=color, markeredgewidth=0.8, **style)
        ax.set_ylim(0.0, HIGHEST)
        if axis == "rod_length":
            ax.set_ylabel("pushes that slip (percent)")
            ax.legend(loc="upper left", ncols=2, labelspacing=0.2)


def _percent(part: xr.DataArray) -> Array:
    return np.asarray(100.0 * part.values)
