"""Sets of consistent contact modes: their codes, and how each is drawn."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.patches import Patch

from planar_pushing.figures.style import DARK, LIGHT
from planar_pushing.mechanics.contact import ContactMode

#: Each set of consistent modes: its name, color and hatch; hatched where the solutions are several.
SEPARATE, STICK, RIGHT, LEFT = (1 << mode for mode in ContactMode)
STYLES: dict[int, tuple[str, str, str]] = {
    SEPARATE: ("separate", "#E4E4E4", ""),
    STICK: ("stick", "#FFFFFF", ""),
    LEFT: ("slip left", "#8CCBEE", ""),
    RIGHT: ("slip right", "#F2C14E", ""),
    SEPARATE | STICK | LEFT: ("separate, stick or slip left", "#CC79A7", "////"),
    SEPARATE | STICK: ("separate or stick", "#E3C9D6", "...."),
    SEPARATE | LEFT: ("separate or slip left", "#A5C6DB", "xxxx"),
    0: ("no solution", "#333333", ""),
}
OTHER = ("other", LIGHT, "xxxx")


def mode_sets(mode: xr.DataArray) -> xr.DataArray:
    """Code of the set of consistent modes, along `solution`: two to the power of each mode's value, added.

    Several slips of one mode are one mode of the set.
    """
    code = xr.zeros_like(mode.isel(solution=0, drop=True))
    for each in ContactMode:
        code += (mode == each).any("solution").astype(code.dtype) << each
    code.attrs = {
        "units": "1",
        "long_name": "set of consistent contact modes",
        "flag_masks": np.array([1 << each for each in ContactMode], np.int8),
        "flag_meanings": " ".join(each.name for each in ContactMode),
    }
    return code


def patch(code: int) -> Patch:
    """Entry of a legend."""
    name, color, hatch = STYLES[code]
    return Patch(facecolor=color, hatch=hatch, edgecolor=DARK, linewidth=0.5, label=name)


def fill(ax: Axes, x: Any, low: Any, high: Any, code: int, **options: Any) -> None:
    """Fill between two curves with the look of a set."""
    _, color, hatch = STYLES.get(code, OTHER)
    ax.fill_between(
        x, low, high, facecolor=color, hatch=hatch, edgecolor=DARK, linewidth=0, zorder=1, **options
    )
