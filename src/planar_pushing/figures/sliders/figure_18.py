"""Figure 18: slip with infinite friction over the gallery."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr
from matplotlib.figure import Figure

from planar_pushing.figures.parts.curves import named, titled
from planar_pushing.figures.settings import Sources
from planar_pushing.figures.sliders.gallery import families, styled, supports
from planar_pushing.figures.sliders.over_rods import AXES, keep_ticks_inside, over_rods, panels
from planar_pushing.mechanics.cones import motion_cone
from planar_pushing.mechanics.contact import InfiniteFriction
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.scene import Scene
from planar_pushing.study.files.study_model import SliderEntry

PART = "part of the pushes into the slider, from 0 to 180 degrees, that slip"


def slipping_part(right: xr.DataArray, left: xr.DataArray) -> xr.DataArray:
    """Part of the pushes, from 0 to 180 degrees, outside of a motion cone with these edges in degrees."""
    held: xr.DataArray = left.clip(max=180.0) - right.clip(min=0.0)
    return 1 - held / 180.0


def _computed(scenes: Scene) -> xr.DataArray:
    cone = motion_cone(scenes)
    return slipping_part(np.rad2deg(cone.right), np.rad2deg(cone.left))


def select(sources: Sources, settings: SliderEntry) -> xr.Dataset:
    """Compute the slipping part over rod length and over rod angle; that of the grid's cones with it."""
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
        values = cut.transpose("support", axis).values
        data[f"grid_over_{axis}"] = named(("support", f"grid_{axis}"), values, "1", PART)
    return titled(data, "Slip with infinite friction", sources)


def draw(figure: Figure, data: xr.Dataset) -> None:
    """Draw the slipping part in percent; dots are the cones of the study's grid."""
    rows = [names for names in families(supports(data)) for _ in AXES]
    for (ax, axis), names in zip(panels(figure, data, _percent), rows, strict=True):
        for name, color, _ in styled(names):
            y = _percent(data[f"grid_over_{axis}"].sel(support=name))
            style: dict[str, Any] = {"color": color, "markersize": 3.0, "clip_on": False}
            ax.plot(data[f"grid_{axis}"], y, "o", **style)
        ax.set_ylim(0.0, None)
        keep_ticks_inside(ax.yaxis)
        if axis == "rod_length":
            ax.set_ylabel("slipping pushes (percent)")
            ax.legend(loc="lower right")


def _percent(part: xr.DataArray) -> Array:
    return np.asarray(100.0 * part.values)
