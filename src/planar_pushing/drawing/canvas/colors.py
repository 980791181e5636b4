"""One color for each meaning in all figures, animations and pages.

Marks and letters have a contrast of at least 4.5 to 1 on white. Readers with red-green color blindness
can distinguish them: forces have filled heads, motions have open heads, and slip is dashed. Fills of
contact modes differ in gray level or in hatching.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import NamedTuple

from planar_pushing.mechanics.contact import ContactMode

DARK, GRAY, LIGHT = "#333333", "#6E6E6E", "#BBBBBB"

FORCE = "#C24F00"
MOTION = "#0072B2"
PUSHER = "#1B7837"
SLIP = "#222222"
CENTER = "#8A3C70"
IMPACT = "#B40F0F"
SLIDER = FENCE = DARK
GUIDE = GRAY


class Look(NamedTuple):
    """Name and style of a contact mode or of a set of modes: fill and hatch of an area, `ink` of a line."""

    name: str
    fill: str
    ink: str
    hatch: str = ""


SEPARATE, STICK, RIGHT, LEFT = ContactMode
#: Styles of contact modes; -1 means no solution.
MODES: dict[int, Look] = {
    SEPARATE: Look("separate", "#D4D4D4", GRAY),
    STICK: Look("stick", "#FFFFFF", PUSHER),
    LEFT: Look("slip left", "#9CD0F0", "#1C6EA4", "\\\\\\"),
    RIGHT: Look("slip right", "#F2C14E", "#8F6400", "///"),
    -1: Look("no solution", DARK, DARK),
}
#: Styles of sets of consistent modes by their code, the sum of 2 ** mode.
MODE_SETS: dict[int, Look] = {
    0: MODES[-1],
    **{1 << mode: MODES[mode] for mode in ContactMode},
    1 << SEPARATE | 1 << STICK | 1 << LEFT: Look(
        "separate, stick or slip left", "#D9A3C4", "#8E3A70", "xxx"
    ),
    1 << SEPARATE | 1 << STICK | 1 << RIGHT: Look(
        "separate, stick or slip right", "#C9B6DC", "#5E4A80", "+++"
    ),
    1 << SEPARATE | 1 << STICK: Look("separate or stick", "#EFDCE7", "#8E3A70", "..."),
    1 << SEPARATE | 1 << LEFT: Look("separate or slip left", "#C3CED6", "#4E6A7C", "\\\\\\..."),
    1 << SEPARATE | 1 << RIGHT: Look("separate or slip right", "#D6CFBB", "#75683F", "///..."),
}

#: Colors of energies over time.
ENERGIES = {
    "work": DARK,
    "support friction": FORCE,
    "contact friction": "#AA4499",
    "kinetic energy": MOTION,
}


def look_of(code: int) -> Look:
    """Style of a set of consistent modes; a set without an entry is named after its members."""
    if code in MODE_SETS:
        return MODE_SETS[code]
    names = [MODES[mode].name for mode in ContactMode if code >> mode & 1]
    return Look(f"{', '.join(names[:-1])} or {names[-1]}", "#BFA8A8", DARK, "xx..")


#: Colors of the supports that the studies use, by name.
_SUPPORTS = {
    "ring": GRAY,
    "disc": "#0072B2",
    "square": "#C24F00",
    "rectangle_2_1": "#8F6400",
    "rectangle_4_1": "#AA4499",
    "l_shape": "#1B7837",
    "pressure_map": "#222222",
    "tripod": "#00838F",
    "quadruped": "#882255",
    "segment_across": "#332288",
    "segment_along": "#B5485A",
}


def support_colors(names: Iterable[str]) -> dict[str, str]:
    """A different color for each support, by name; a support that the table lacks gets an unused color."""
    listed = list(names)
    free = [color for name, color in _SUPPORTS.items() if name not in listed] or [DARK]
    others = [name for name in listed if name not in _SUPPORTS]
    return {name: _SUPPORTS.get(name) or free[others.index(name) % len(free)] for name in listed}


def rod_color(rod_length: float) -> str:
    """Color of a rod length in radii: dark for no rod, lighter with length, an infinite rod last."""
    from matplotlib import colormaps
    from matplotlib.colors import to_hex

    part = 1.0 if math.isinf(rod_length) else rod_length / (1.0 + rod_length)
    return str(to_hex(colormaps["viridis"](0.58 * part)))


def tint(color: str, strength: float) -> str:
    """Color mixed with white; it is opaque, so that overlapping areas do not produce a third color."""
    parts = [int(color[i : i + 2], 16) for i in (1, 3, 5)]
    return "#" + "".join(f"{round(255 - strength * (255 - part)):02x}" for part in parts)
