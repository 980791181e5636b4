"""Figure 13: the contact-mode map, every consistent mode over friction and the pusher's angle."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import xarray as xr

from planar_pushing.figures.curves import ROD_ANGLE, named, titled
from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.study.models import FigureEntry

SOURCES = ("contact_modes", "motion_cones")
SIZE = (7.0, 3.6)
CAPTION = (
    "Consistent contact modes over the coefficient of friction (linear in its angle) and the angle of "
    "the fence's motion. The strips on the right are infinite friction without tangential force at zero "
    "normal force (definition 2) and perfectly rough contact. Dots are edges of the motion cones; with "
    "both effects the cone covers all magnitudes of the motion, the map is drawn for one."
)


def mode_sets(consistent: xr.DataArray) -> xr.DataArray:
    """Code of the set of consistent modes: the sum of two to the power of each mode's value."""
    bits = np.array([1 << ContactMode[str(name)] for name in consistent["mode"].values])
    weights = xr.DataArray(bits, dims="mode", coords={"mode": consistent["mode"]})
    code = ((consistent > 0) * weights).sum("mode").astype(np.int8)
    code.attrs = {
        "units": "1",
        "long_name": "set of consistent contact modes",
        "flag_masks": bits.astype(np.int8),
        "flag_meanings": " ".join(consistent["mode"].values),
    }
    return code


def select(sources: Mapping[str, xr.Dataset], settings: FigureEntry) -> xr.Dataset:
    """Select the sets of consistent modes and the edges of the motion cones."""
    length = settings.rod_length if isinstance(settings.rod_length, float) else 2.0
    magnitude = settings.pusher_magnitude or 1.0
    modes = sources["contact_modes"].sel(rod_length=length, pusher_magnitude=magnitude)
    cones = sources["motion_cones"].sel(rod_length=length, rod_angle=ROD_ANGLE)
    angle = np.rad2deg(np.arctan(modes.friction_coefficient.values))
    data = xr.Dataset({"modes": mode_sets(modes.consistent)})
    data = data.drop_vars("friction_coefficient")
    data["friction_angle"] = named("contact", angle, "degree", "angle of friction of the contact")
    edge = np.rad2deg(np.arctan(cones.friction_coefficient.values))
    for side in ("right", "left"):
        data[f"motion_cone_{side}"] = cones[f"motion_cone_{side}"].drop_vars("friction_coefficient")
    data["cone_friction_angle"] = named(
        "friction_coefficient", edge, "degree", "angle of friction of the motion cone"
    )
    return titled(data, "Contact modes over friction and the direction of the pusher", sources)
