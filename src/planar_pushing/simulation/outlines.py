"""Outlines and pushers: the tolerance for penetration, distances, and checks of the initial position."""

from __future__ import annotations

from math import inf, sqrt
from typing import Any

import numpy as np

from planar_pushing.mechanics.outline import Corners, size
from planar_pushing.mechanics.scene import Slider
from planar_pushing.simulation.legacy.compiled import compiled
from planar_pushing.terms.domain import Number
from planar_pushing.terms.errors import InvalidValue

#: Allowed depth of the outline in the pusher, in extents of the outline. It is far above rounding error, so
#: that a side lying on the fence does not end a run without rotation.
TOLERANCE = 1e-9


def tolerance(outline: Corners) -> float:
    """Allowed depth of the outline in the pusher, in the outline's unit."""
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


def require_apart(slider: Slider, gap: Number, radius: Number) -> None:
    """Reject an outline that initially overlaps the finger.

    Raises
    ------
    InvalidValue
        If at least one slider overlaps its finger; the message gives the depth.
    """
    if slider.outline is None:
        return
    try:
        across, angle = radius + gap, slider.rod_angle
        x, y = -slider.rod_length - across * np.sin(angle), -across * np.cos(angle)
        least = float(np.min(np.asarray(distance(np.array(slider.outline), x, y) - radius)))
    except ValueError:  # mismatched shapes, which the batch rejects itself
        return
    if least < -tolerance(slider.outline) / 2:
        raise InvalidValue(
            "outline", f"an overlap of {-least:.6g} with the finger", "a finger outside the object",
            "choose a smaller radius, or move the contact onto the outline and away from its other sides",
        )  # fmt: skip


@compiled
def distance(corners: Any, x: Any, y: Any) -> Any:
    """Distance of a point, or of arrays of points, from an outline; negative inside."""
    least, inside = inf + 0.0 * (x + y), x != x
    for k in range(len(corners)):
        start_x, start_y, end_y = corners[k - 1, 0], corners[k - 1, 1], corners[k, 1]
        side_x, side_y = corners[k, 0] - start_x, end_y - start_y
        d_x, d_y = x - start_x, y - start_y
        part = (d_x * side_x + d_y * side_y) / (side_x * side_x + side_y * side_y)
        part = np.minimum(np.maximum(part, 0.0), 1.0)
        least = np.minimum(least, np.hypot(d_x - part * side_x, d_y - part * side_y))
        # The number of sides that a ray along +x crosses is odd inside. It meets a rising side if the point
        # is on its left.
        left = side_x * d_y - side_y * d_x > 0.0
        inside = inside != (((start_y > y) != (end_y > y)) & (left == (end_y > start_y)))
    return least * (1.0 - 2.0 * inside)


@compiled
def free_part(
    corners: Any, x: Any, y: Any, t_x: Any, t_y: Any, radius: Any, depth: Any, place: Any
) -> tuple[Any, Any]:
    """Part of a side, about a place, on which a disc meets no other point of the outline.

    Places are measured from the point (x, y) of the side along its tangent, which is the inward normal
    rotated by -90 degrees. The part ends where an overlap has the given depth.
    """
    low, high = -inf, inf
    if radius <= depth:
        return low, high
    for k in range(len(corners)):
        d_x, d_y = corners[k - 1, 0] - x, corners[k - 1, 1] - y
        e_x, e_y = corners[k, 0] - x, corners[k, 1] - y
        start, end = overlap(
            t_x * d_x + t_y * d_y, t_x * d_y - t_y * d_x, t_x * e_x + t_y * e_y, t_x * e_y - t_y * e_x,
            -radius, radius - depth,
        )  # fmt: skip
        if start <= end and place < (start + end) / 2.0:
            high = min(high, start)
        elif start <= end:
            low = max(low, end)
    return low, high


@compiled
def overlap(x, y, x_after, y_after, height, radius):
    """Least and greatest x of the centers at a height at which a disc overlaps a line segment.

    The least is greater than the other if there are none.
    """
    low, high = inf, -inf
    for c_x, c_y in ((x, y), (x_after, y_after)):
        square = (radius - (c_y - height)) * (radius + (c_y - height))
        if square > 0.0:
            low, high = min(low, c_x - sqrt(square)), max(high, c_x + sqrt(square))
    side_x, side_y = x_after - x, y_after - y
    length = sqrt(side_x * side_x + side_y * side_y)
    side_x, side_y = side_x / length, side_y / length
    if side_y != 0.0:
        for reach in (-radius, radius):
            center = x + ((height - y) * side_x + reach) / side_y
            part = (center - x) * side_x + (height - y) * side_y
            if 0.0 <= part <= length:
                low, high = min(low, center), max(high, center)
    return low, high
