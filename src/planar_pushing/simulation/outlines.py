"""Outlines above a fence: the tolerance for penetration, and the check of the initial position."""

from __future__ import annotations

import numpy as np

from planar_pushing.mechanics.outline import Corners, size
from planar_pushing.mechanics.scene import Slider
from planar_pushing.terms.domain import Number
from planar_pushing.terms.errors import InvalidValue

#: Allowed depth of a corner below the fence, in extents of the outline. It is far above rounding error, so
#: that a side lying on the fence does not end a run without rotation.
TOLERANCE = 1e-9


def tolerance(outline: Corners) -> float:
    """Allowed depth of a corner below the fence, in the outline's unit."""
    return TOLERANCE * size(np.array(outline))


def require_above(slider: Slider, gap: Number) -> None:
    """Reject an outline that initially penetrates the fence.

    Raises
    ------
    InvalidValue
        If a corner of at least one slider is below the fence; the message gives its depth.
    """
    if slider.outline is None:
        return
    try:
        lowest = min(_height(slider, gap, corner) for corner in slider.outline)
    except ValueError:  # mismatched shapes, which the batch rejects itself
        return
    # A run ends at the full tolerance; the initial position must be within half of it.
    if lowest < -tolerance(slider.outline) / 2:
        raise InvalidValue(
            "outline", f"a corner {-lowest:.6g} below the fence", "corners on the fence or above it",
            "rotate the slider, raise it by gap, or put the contact on the outline",
        )  # fmt: skip


def _height(slider: Slider, gap: Number, corner: tuple[float, float]) -> float:
    """Height of a corner above the fence, the minimum over several sliders."""
    x, y = corner
    c, s = np.cos(slider.rod_angle), np.sin(slider.rod_angle)
    return float(np.min(np.asarray(gap + (slider.rod_length + x) * s + y * c)))
