"""Outlines over a fence: how far a corner may be below it, and the refusal of one that begins there."""

from __future__ import annotations

import numpy as np

from planar_pushing.mechanics.outline import Corners, size
from planar_pushing.mechanics.scene import Slider
from planar_pushing.terms.domain import Number
from planar_pushing.terms.errors import InvalidValue

#: How far a corner may be below the fence, in extents of the outline: far more than rounding, so that a
#: side that lies on the fence does not end a run that moves it without rotation.
TOLERANCE = 1e-9


def tolerance(outline: Corners) -> float:
    """How far a corner may be below the fence, in the outline's unit."""
    return TOLERANCE * size(np.array(outline))


def require_above(slider: Slider, gap: Number) -> None:
    """Reject an outline that begins through the fence.

    Raises
    ------
    InvalidValue
        With the height of the lowest corner, of one slider at least.
    """
    if slider.outline is None:
        return
    try:
        lowest = min(_height(slider, gap, corner) for corner in slider.outline)
    except ValueError:  # shapes that do not match, which a batch refuses by themselves
        return
    # A run ends at the whole of the tolerance; what begins within half of it is away from that.
    if lowest < -tolerance(slider.outline) / 2:
        raise InvalidValue(
            "outline", f"a corner {-lowest:.6g} below the fence", "corners on the fence or above it",
            "turn the slider, start higher by gap, or give the contact as a point of the outline",
        )  # fmt: skip


def _height(slider: Slider, gap: Number, corner: tuple[float, float]) -> float:
    """Height of a corner over the fence, the least of several sliders."""
    x, y = corner
    c, s = np.cos(slider.rod_angle), np.sin(slider.rod_angle)
    return float(np.min(np.asarray(gap + (slider.rod_length + x) * s + y * c)))
