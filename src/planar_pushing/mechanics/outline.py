"""The outline of an object: its corners in order, and its sides."""

from __future__ import annotations

from typing import Any

import numpy as np

from planar_pushing.mechanics.frames import Placement
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.supports.polygon import counterclockwise, simple_ring
from planar_pushing.terms.errors import InvalidValue

Corners = tuple[tuple[float, float], ...]
#: A point closer to a side than this, relative to the outline's size, is on it: drawings are less precise.
ON = 1e-6
#: A distance below this is rounding. A point farther away is moved onto the side, because a corner below
#: the fence ends a simulation.
EXACT = 1e-12
#: Largest angle, in radians, between a given normal and that of its side.
ALIGNED = 1e-3


def required_outline(given: Any) -> Corners:
    """Corners of a simple polygon, counterclockwise, without those inside a straight side.

    Raises
    ------
    InvalidValue
        If the outline is not a simple polygon.
    """
    corners = counterclockwise(simple_ring("outline", given))
    before, behind = corners - np.roll(corners, 1, axis=0), np.roll(corners, -1, axis=0) - corners
    cross = before[:, 0] * behind[:, 1] - before[:, 1] * behind[:, 0]
    turns = np.abs(cross) > 1e-12 * np.hypot(*before.T) * np.hypot(*behind.T)
    return tuple((float(a), float(b)) for a, b in corners[turns])


def size(corners: Array) -> float:
    """Largest extent of an outline along x or y."""
    return float(np.ptp(corners, axis=0).max())


def placed(
    point: Any, normal: Any, corners: Corners
) -> tuple[Placement, tuple[float, float] | None]:
    """The placement at a point of an outline, and the ends of its side from there; None at a corner.

    A normal within a thousandth of a radian of that of the side is replaced by it. A point closer to the
    side than a millionth of the outline's size is moved onto it.

    Raises
    ------
    InvalidValue
        If the point is not on the outline, or a fence with this normal would pass through the object.
    """
    given = None if normal is None else Placement(point, normal)
    place = np.array(Placement(point, (0.0, 1.0)).point)
    every, scale = np.array(corners), size(np.array(corners))
    starts, ends = every, np.roll(every, -1, axis=0)
    sides = ends - starts
    lengths = np.hypot(*sides.T)
    along = ((place - starts) * sides).sum(axis=1) / lengths
    across = (sides[:, 0] * (place - starts)[:, 1] - sides[:, 1] * (place - starts)[:, 0]) / lengths
    reach = np.hypot(across, np.maximum(np.maximum(-along, along - lengths), 0.0))
    side = int(reach.argmin())
    nearest = starts[side] + np.clip(along[side], 0.0, lengths[side]) * sides[side] / lengths[side]
    if reach[side] > ON * scale:
        raise InvalidValue(
            "point", point, "a point on the outline",
            f"the nearest one is ({nearest[0]:.6g}, {nearest[1]:.6g})",
        )  # fmt: skip
    corner = [k for k in range(len(every)) if np.hypot(*(every[k] - place)) <= ON * scale]
    if corner:
        own = _at_corner(point, given, every, corner[0])
        return Placement(_moved(place, every[corner[0]], scale), own.normal), None
    inward = 0.0 - sides[side, 1] / lengths[side], sides[side, 0] / lengths[side] + 0.0
    if given is not None and np.hypot(*np.subtract(given.normal, inward)) > ALIGNED:
        raise InvalidValue(
            "normal", normal, f"the inward normal of the side, ({inward[0]:.6g}, {inward[1]:.6g})",
            "with another one the fence would pass through the object; leave the normal out",
        )  # fmt: skip
    return Placement(_moved(place, nearest, scale), inward), (
        -float(along[side]),
        float(lengths[side] - along[side]),
    )


def _moved(place: Array, onto: Array, scale: float) -> tuple[float, float]:
    """A point, or the nearest place on the outline if they differ by more than rounding."""
    x, y = place if np.hypot(*(onto - place)) <= EXACT * scale else onto
    return float(x), float(y)


def _at_corner(point: Any, given: Placement | None, every: Array, corner: int) -> Placement:
    """The placement at a corner; both of its sides must be on the object's side of the fence."""
    if given is None:
        raise InvalidValue(
            "normal", None, "the normal of the fence at a corner",
            "give it: a corner touches a fence at any angle between those of its sides",
        )  # fmt: skip
    beside = every[[corner - 1, (corner + 1) % len(every)]] - every[corner]
    beside /= np.hypot(*beside.T)[:, None]
    (a, b), (c, d) = beside
    # At a reflex corner a finger can push one of the sides.
    own = np.array([(b, -a), (-d, c)]) @ np.array(given.normal)
    reflex = a * d - b * c > 0.0 and own.max() > 1.0 - ALIGNED**2
    if (beside @ np.array(given.normal)).min() < -ALIGNED and not reflex:
        raise InvalidValue(
            "normal", given.normal, "a normal between those of the corner's sides",
            "with this one the fence would pass through the object",
        )  # fmt: skip
    return given
