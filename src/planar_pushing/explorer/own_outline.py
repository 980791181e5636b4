"""An outline that is entered on the page: a box, a disc, or corners as text."""

from __future__ import annotations

import math
from typing import Any

from planar_pushing.explorer.lengths import factor
from planar_pushing.explorer.objects import object_of, with_outline, without_outline
from planar_pushing.explorer.state import ROUNDING, State
from planar_pushing.mechanics.outline import Outline
from planar_pushing.mechanics.outline.outline import require_outline
from planar_pushing.mechanics.outline.plate import bounds
from planar_pushing.mechanics.supports import Disc
from planar_pushing.terms.errors import InvalidValue

#: Kinds of outlines on the page; the last one has arcs or holes and can only be read from a file.
NONE, BOX, DISC, CORNERS, FILE = (
    "none: a point on a rod", "box", "disc", "polygon", "from the scene file",
)  # fmt: skip
KINDS = NONE, BOX, DISC, CORNERS
#: Largest number of corners that the page takes.
MOST = 200
#: Range of a length that is entered, and the most that one side of a box can be longer than the other.
LENGTHS, SLENDER = (1e-9, 1e9), 1e4
#: Digits of a length on the page.
DIGITS = 6
#: Height of a first box for a width of 1.
FLAT = 0.5
#: Part of half a box that stays beside the part that a first polygon, an L, leaves out.
CUT = 0.3


def kind_of(state: State) -> str:
    """Kind of the outline of a state."""
    if not state.has_outline:
        return NONE
    outline = object_of(state).outline
    if len(outline.pieces) == 1:
        return DISC
    if outline.corners is None:
        return FILE
    return BOX if _is_box(outline) else CORNERS


def _is_box(outline: Outline) -> bool:
    """Whether an outline is a rectangle with sides along the axes."""
    corners = outline.corners or ()
    low, high = extent(outline)
    at_ends = all(
        min(abs(part - low[i]), abs(part - high[i])) <= outline.tolerance
        for corner in corners
        for i, part in enumerate(corner)
    )
    return len(corners) == 4 and at_ends


def extent(outline: Outline) -> tuple[tuple[float, float], tuple[float, float]]:
    """Lower left and upper right corner of the box around an outline."""
    (x0, y0), (x1, y1) = (corner.tolist() for corner in bounds(outline.pieces))
    return (x0, y0), (x1, y1)


def sides_of(state: State) -> tuple[float, float]:
    """Width and height of the object in the unit of the page; those of its support without an outline."""
    width, height = 2.0 * state.size, 2.0 * FLAT * state.size
    if state.has_outline:
        (x0, y0), (x1, y1) = extent(object_of(state).outline)
        width, height = x1 - x0, y1 - y0
    return _round(width * factor(state)), _round(height * factor(state))


def _round(value: float) -> float:
    return float(f"{value:.{DIGITS}g}")


def with_kind(state: State, kind: str) -> State:
    """State whose object has an outline of a kind and of about its size now."""
    if kind == kind_of(state) or kind == FILE:
        return state
    if kind == NONE:
        return without_outline(state)
    width, height = sides_of(state)
    if kind == DISC:
        return with_diameter(state, max(width, height))
    if kind == BOX:
        return with_box(state, width, height)
    # Not a box again, which would be shown with width and height.
    return with_outline(state, _box(state, width, height, cut=CUT))


def with_box(state: State, width: Any, height: Any) -> State:
    """State with a box of a width and a height in the unit of the page, about its center."""
    _require_length("Width", width)
    _require_length("Height", height)
    if not 1.0 / SLENDER <= width / height <= SLENDER:
        allowed = (
            f"from {height / SLENDER:.6g} to {height * SLENDER:.6g} for a height of {height:.6g}"
        )
        raise InvalidValue("Width", width, allowed, "give a box that is less slender")
    return with_outline(state, _box(state, width, height))


def _box(state: State, width: float, height: float, cut: float | None = None) -> Outline:
    """A box about the center of the outline, or an L with a part of it cut out."""
    x, y = width / factor(state) / 2.0, height / factor(state) / 2.0
    corners = [(-x, -y), (x, -y), (x, y), (-x, y)]
    if cut is not None:
        corners[2:3] = [(x, cut * y), (cut * x, cut * y), (cut * x, y)]
    middle = _middle(state)
    return Outline([(middle[0] + a, middle[1] + b) for a, b in corners])


def _middle(state: State) -> tuple[float, float]:
    """Middle of the box around the outline, in the object's frame; the origin without an outline."""
    if not state.has_outline:
        return 0.0, 0.0
    (x0, y0), (x1, y1) = extent(object_of(state).outline)
    return (x0 + x1) / 2.0, (y0 + y1) / 2.0


def with_diameter(state: State, diameter: Any) -> State:
    """State with a disc of a diameter in the unit of the page, about its center."""
    _require_length("Diameter", diameter)
    return with_outline(state, Outline(Disc(diameter / factor(state) / 2.0, center=_middle(state))))


def _require_length(name: str, value: Any) -> None:
    """Refuse what is not a number in the range of lengths."""
    is_number = isinstance(value, (int, float)) and not isinstance(value, bool)
    low, high = LENGTHS
    if not (is_number and low <= value <= high):
        shown = "nothing" if value is None else value
        raise InvalidValue(name, shown, f"a number from {low:g} to {high:g}", "give a length")


def corners_text(state: State) -> str:
    """Corners of the object, a line each, in its own frame and in the unit of the page."""
    if not state.has_outline:
        return ""
    outline = object_of(state).outline
    smallest, scale = ROUNDING * outline.size, factor(state)
    lines = [
        [f"{x * scale:.{DIGITS}g}" if abs(x) > smallest else "0" for x in corner]
        for corner in outline.corners or ()
    ]
    return "\n".join(map(", ".join, lines))


def with_corners(state: State, text: str) -> State:
    """State with an outline of the corners in a text."""
    scale = factor(state)
    corners = [(x / scale, y / scale) for x, y in parse_corners(text)]
    return with_outline(state, require_outline(corners, "Corners"))


def parse_corners(text: str) -> list[tuple[float, float]]:
    """Corners in a text: two numbers a line, or between semicolons.

    Raises
    ------
    InvalidValue
        If an entry is not two finite numbers, or there are too few or too many.
    """
    entries = [entry for line in text.splitlines() for entry in line.split(";") if entry.strip()]
    corners = [_parse_corner(number, entry) for number, entry in enumerate(entries, start=1)]
    if not 3 <= len(corners) <= MOST:
        raise InvalidValue(
            "Corners", len(corners), f"3 to {MOST} corners, in order around the object",
            "give x and y of each, one corner per line",
        )  # fmt: skip
    return corners


def _parse_corner(number: int, entry: str) -> tuple[float, float]:
    """The numbers of one corner."""
    words = entry.strip().strip("()[]").replace(",", " ").split()
    try:
        x, y = map(float, words)
    except ValueError:
        x = y = math.nan
    if not (math.isfinite(x) and math.isfinite(y)):
        raise InvalidValue(
            f"Corners: corner {number}", entry.strip()[:40], "two finite numbers, x and y",
            "write them as in 0.15, -0.1",
        )  # fmt: skip
    return x, y
