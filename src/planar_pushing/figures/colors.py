"""One color for each meaning, in every figure, animation and page.

Marks and letters have a contrast of 4.5 to 1 on white. For a deuteranope they differ by more than the
hue of red and green: forces have filled heads, motions open ones, and a slip is dashed. Fills of contact
modes differ in gray or by their hatch.
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
    """How a contact mode, or a set of them, is named and drawn: an area with its hatch, a line in `ink`."""

    name: str
    fill: str
    ink: str
    hatch: str = ""


SEPARATE, STICK, RIGHT, LEFT = ContactMode
#: Contact modes; -1 is none.
MODES: dict[int, Look] = {
    SEPARATE: Look("separate", "#D4D4D4", GRAY),
    STICK: Look("stick", "#FFFFFF", PUSHER),
    LEFT: Look("slip left", "#9CD0F0", "#1C6EA4", "\\\\\\"),
    RIGHT: Look("slip right", "#F2C14E", "#8F6400", "///"),
    -1: Look("no solution", DARK, DARK),
}
#: Sets of consistent modes by their code, two to the power of each mode's value, added.
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

#: Energies over time.
ENERGIES = {
    "work": DARK,
    "support friction": FORCE,
    "contact friction": "#AA4499",
    "kinetic energy": MOTION,
}


def look_of(code: int) -> Look:
    """Look of a set of consistent modes; one that has no entry is named by its members."""
    if code in MODE_SETS:
        return MODE_SETS[code]
    names = [MODES[mode].name for mode in ContactMode if code >> mode & 1]
    return Look(f"{', '.join(names[:-1])} or {names[-1]}", "#BFA8A8", DARK, "xx..")


#: Names of supports that studies use for the paper's questions, and their colors.
_SUPPORTS = {
    "ring": GRAY,
    "disc": "#0072B2",
    "square": "#C24F00",
    "rectangle_2_1": "#1B7837",
    "rectangle_4_1": "#AA4499",
    "l_shape": "#8F6400",
    "pressure_map": "#222222",
    "tripod": "#00838F",
    "quadruped": "#882255",
    "segment_across": "#332288",
    "segment_along": "#B5485A",
}


def support_colors(names: Iterable[str]) -> dict[str, str]:
    """A color of its own for each support, by name; one that the table lacks takes one that is free."""
    listed = list(names)
    free = [color for name, color in _SUPPORTS.items() if name not in listed] or [DARK]
    others = [name for name in listed if name not in _SUPPORTS]
    return {name: _SUPPORTS.get(name) or free[others.index(name) % len(free)] for name in listed}


def rod_color(rod_length: float) -> str:
    """Color of a rod length in radii: dark for no rod, lighter the longer, an infinite rod last."""
    from matplotlib import colormaps
    from matplotlib.colors import to_hex

    part = 1.0 if math.isinf(rod_length) else rod_length / (1.0 + rod_length)
    return str(to_hex(colormaps["viridis"](0.58 * part)))


def tint(color: str, strength: float) -> str:
    """Color mixed with white: opaque, so that two areas never add up to a third color."""
    parts = [int(color[i : i + 2], 16) for i in (1, 3, 5)]
    return "#" + "".join(f"{round(255 - strength * (255 - each)):02x}" for each in parts)
