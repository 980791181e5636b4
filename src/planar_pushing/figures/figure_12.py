"""Figure 12: possible acceleration centres and accelerations with support friction and inertia."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import xarray as xr

from planar_pushing.figures.curves import named, titled
from planar_pushing.study.models import FigureEntry

SOURCES = ("acceleration_centers", "scenes/figure_12")
SIZE = (7.0, 3.2)
CAPTION = (
    "Slip with infinite friction, support friction and inertia. Possible acceleration centres and "
    "accelerations of the contact: the paper's bound from the geometry of the line of force (light), "
    "and the exact set (dark), which narrows to a point where the line of force touches the ring. A "
    "fence that accelerates at an angle between the cone and 180 degrees makes the contact slip, "
    "whatever its magnitude."
)
SCENE = (
    "rod_length rod_angle radius ring_center pusher_angle pusher_motion contact_motion force "
    "friction_cone_right friction_cone_left"
)


def sectors(rod_length: float, rod_angle: float, radius: float) -> xr.Dataset:
    """Sectors of acceleration centres about the ring centre, by the paper's cases (Sec. 4).

    The centre lies opposite the line of force, a quarter turn from it: inside the ring where the line
    passes outside of it, outside where the line passes through it.
    """
    lean = np.rad2deg(np.arcsin(min(1.0, radius / rod_length))) if rod_length else 90.0
    right, left = max(rod_angle - lean, 0.0), min(rod_angle + lean, 180.0)
    start = [90.0, right + 90, rod_angle - 90, left - 90]
    stop = [right + 90, rod_angle + 90, left - 90, 90.0]
    return xr.Dataset(
        {
            "sector_start": named("sector", start, "degree", "right end of the sector of centres"),
            "sector_stop": named("sector", stop, "degree", "left end of the sector of centres"),
            "sector_outside": named(
                "sector",
                np.array([0, 1, 1, 0], np.int8),
                "1",
                "whether the sector is outside the ring",
            ),
        }
    )


def exact_centers(grid: xr.Dataset, ring_center: xr.DataArray) -> xr.Dataset:
    """Boundaries of the exact set of centres, under friction alone and under inertia alone.

    Force angles whose centre is at infinity, a translation, are left out.
    """
    ends = grid.sel(inertia_share=[0.0, 1.0])
    finite = np.isfinite(ends.center_x) & np.isfinite(ends.center_y)
    ends = ends.isel(force_angle=finite.all("inertia_share").values)
    x, y = (ends[name] + float(ring_center.sel(xy=name[-1])) for name in ("center_x", "center_y"))
    x.attrs = {"units": "length", "long_name": "acceleration centre relative to the contact, x"}
    y.attrs = {"units": "length", "long_name": "acceleration centre relative to the contact, y"}
    return xr.Dataset({"exact_center_x": x, "exact_center_y": y})


def select(sources: Mapping[str, xr.Dataset], settings: FigureEntry) -> xr.Dataset:
    """Select the scene, both sets of centres and both cones."""
    scene = sources["scenes/figure_12"]
    given = settings.rod_length
    length = float(scene.rod_length) if given is None else float(np.ravel(given)[0])
    grid = sources["acceleration_centers"].sel(rod_length=length).drop_vars("rod_length")
    data = scene[SCENE.split()].isel(solution=0)
    data = data.merge(exact_centers(grid, scene.ring_center))
    data = data.merge(sectors(length, float(scene.rod_angle), float(scene.radius)))
    for kind in ("conservative", "exact"):
        for side in ("right", "left"):
            data[f"{kind}_cone_{side}"] = grid[f"{kind}_cone_{side}"]
    return titled(data, "Possible acceleration centres and accelerations", sources)
