"""Figure 13: the contact-mode map, every consistent mode over friction and the pusher's angle."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Patch

from planar_pushing.figures.curves import ROD_ANGLE, named, titled
from planar_pushing.figures.style import DARK, GREY, LIGHT, NOTE_SIZE
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
#: Each set of consistent modes: how it is told and painted; hatched where the modes are several.
SEPARATE, STICK, RIGHT, LEFT = (1 << mode for mode in ContactMode)
STYLES: dict[int, tuple[str, str, str]] = {
    SEPARATE: ("separate", "#E6E6E6", ""),
    LEFT: ("slip left", "#56B4E9", ""),
    STICK: ("stick", "#FFFFFF", ""),
    RIGHT: ("slip right", "#E69F00", ""),
    SEPARATE | STICK | LEFT: ("separate, stick or slip left", "#CC79A7", "////"),
    SEPARATE | STICK: ("separate or stick", "#D9C2D0", "...."),
    SEPARATE | LEFT: ("separate or slip left", "#A5C6DB", "xxxx"),
    0: ("no solution", "#333333", ""),
}
TITLES = {
    "support_friction": "support friction",
    "inertia": "inertia",
    "support_friction+inertia": "both",
}
#: Coefficients of friction that the axis names, and the range of the pusher's angle, degrees.
TICKS = (0.0, 0.5, 1.0, 2.0, 5.0, np.inf)
LOWEST = -60.0
#: Where the strips of the other laws stand on the axis of friction angles, and their width.
STRIPS = {"infinite_friction_none": 97.0, "perfectly_rough": 109.0}
STRIP_WIDTH = 8.0


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


def draw(figure: Figure, data: xr.Dataset) -> None:
    """Draw one map for each set of effects, over one legend."""
    axes = figure.subplots(1, data.sizes["effects"], sharey=True)
    figure.subplots_adjust(left=0.075, right=0.995, bottom=0.3, top=0.93, wspace=0.07)
    found: set[int] = set()
    for ax, (name, one) in zip(axes, data.groupby("effects", squeeze=True), strict=True):
        found |= _map(ax, one)
        ax.set_title(TITLES[str(name)])
    axes[0].set_ylabel("pusher angle (degrees)")
    handles = [_patch(code) for code in STYLES if code in found]
    figure.legend(handles=handles, loc="lower center", ncols=4)
