"""Whether a flat side stays on a fence that moves and rotates, for every pressure with a given center."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.contact import ContactLaw
from planar_pushing.mechanics.outline import require_corners
from planar_pushing.mechanics.plane import Array, Frame
from planar_pushing.objects.on_outline import side_on_fence
from planar_pushing.stability.any_pressure import cone_sides
from planar_pushing.stability.base_region import base_at
from planar_pushing.stability.certificates import Bound, proved_maximum
from planar_pushing.stability.linear_program import Candidates, largest
from planar_pushing.terms.errors import InvalidValue
from planar_pushing.terms.numbers import as_array, require_array

#: Force, relative to weight and size, by which a load may leave the cone of a side: rounding.
EDGE = 1e-9
#: Accuracy of the linear programs.
FINE = 1e-11
REMEDY = "give (v_x, v_y, omega) of the fence in the frame of the region"


class FlatSide(NamedTuple):
    """A side on the fence: its ends, the object on the left from start to end, and the fence frame."""

    start: Array
    end: Array
    fence: Frame


def stable_for_any_pressure(
    region: Any,
    center_of_pressure: npt.ArrayLike,
    twist: npt.ArrayLike,
    *,
    side: Any,
    contact: ContactLaw,
) -> Any:
    """Whether a flat side stays on a fence that moves and rotates, for every pressure with a given center.

    Parameters
    ----------
    region : sequence of pairs, an object with `coords` or `exterior`, or a support
        The base, as in `any_pressure`.
    center_of_pressure : (x, y)
        In the frame of the region.
    twist : array_like, shape S + (3,)
        (v_x, v_y, omega) of the fence, omega in radians per unit of time and 0 for a translation: about the
        origin of the frame of the region. If the push is stable, it is that of the object, too.
    side : int, or pair of points
        The side on the fence: k for the side from corner k of an outline to the next, counted from 0 in the
        order given; or its ends (start, end), with the object on the left when going from start to end.
    contact : ContactLaw

    Returns
    -------
    bool, or ndarray of bool of shape S
        True is proved, up to a share of 1e-9 of the weight. False means that some pressure makes the push
        unstable, or comes this close to it.

    Raises
    ------
    InvalidValue
        If the outline has no such side or the fence would pass through it, the side is not a pair of
        different points, a twist is not three finite numbers or is zero, the contact is not a law, or as in
        `any_pressure`.

    Notes
    -----
    A push is stable if the load of the twist is in the cone of forces at the two ends of the side (Lynch
    and Mason, "Stable pushing: mechanics, controllability, and planning", IJRR 15(6), 1996). This cone is
    bounded by four planes: the force is on an edge of the law's cone, or its line of action passes through
    an end. The largest distance beyond each plane over all pressures is a linear program.
    """
    flat = _required_side(region, side)
    sides = cone_sides(flat.fence, contact)
    twists = _required_twists(twist)
    rows = twists.reshape(-1, 3)
    opens = not np.all(contact.force_angles.closed)
    base_at(region, center_of_pressure, flat.start, (1.0, 0.0))
    if sides is None:
        are_stable = np.ones(len(rows), dtype=bool)
    else:
        are_stable = np.array([
            _is_stable(region, center_of_pressure, row, flat, sides, opens) for row in rows
        ], dtype=bool)  # fmt: skip
    return are_stable.reshape(twists.shape[:-1]) if twists.ndim > 1 else bool(are_stable[0])


def _required_twists(value: Any) -> Array:
    twists = require_array("twist", value, "finite numbers of shape S + (3,)", REMEDY)
    if twists.shape[-1:] != (3,) or not np.isfinite(twists).all():
        raise InvalidValue("twist", value, "finite numbers of shape S + (3,)", REMEDY)
    if not twists.any(axis=-1).all():
        raise InvalidValue("twist", value, "twists that are not zero", "give a motion of the fence")
    return twists


def _required_side(region: Any, value: Any) -> FlatSide:
    """The ends of a side, with the object on the left, or `InvalidValue`."""
    numbers = as_array(value)
    if numbers is not None and numbers.shape == (2, 2) and np.isfinite(numbers).all():
        start, end = numbers
        length = math.hypot(*(end - start))
        if not length:
            raise InvalidValue("side", value, "two different points", "give the ends of the side")
        x, y = ((end - start) / length).tolist()
        return FlatSide(start, end, Frame((0.0, 0.0), (x, y)))
    if numbers is None or numbers.ndim:
        raise InvalidValue(
            "side", value, "a whole number, or two points",
            "give the number of a side of the outline, or its start and end with the object on the left",
        )  # fmt: skip
    try:
        require_corners(region)
    except InvalidValue:
        raise InvalidValue(
            "side", value, "the two ends of the side for a region that is not an outline",
            "give its start and end, with the object on the left",
        ) from None  # fmt: skip
    placement, ends, _ = side_on_fence(value, region)
    start, end = placement.fence.point_out(np.column_stack([ends, (0.0, 0.0)]))
    return FlatSide(start, end, placement.fence)


def _is_stable(
    region: Any, center: Any, twist: Array, flat: FlatSide, sides: tuple[Array, Array], opens: bool
) -> bool:
    """Whether the load of a twist is in the cone of the side for every pressure."""
    ends = np.array([flat.start, flat.end])
    velocities = twist[:2] + twist[2] * np.stack([-ends[:, 1], ends[:, 0]], axis=-1)
    # The end that is farther from the center of rotation, so that it moves.
    speeds = np.hypot(velocities[:, 0], velocities[:, 1])
    pivot = int(speeds.argmax())
    base = base_at(region, center, ends[pivot], velocities[pivot])
    eta = math.atan(float(twist[2]) / base.rate)
    (a_x, a_y), (b_x, b_y) = (ends - ends[pivot]) / base.size
    planes = [
        (sides[0], 0.0), (sides[1], 0.0),
        # The torque about the start is not negative, and that about the end is not positive.
        (np.array([-a_y, a_x]), -1.0), (np.array([b_y, -b_x]), 1.0),
    ]  # fmt: skip
    candidates = Candidates.of(base)
    limit = -EDGE if opens else EDGE
    return all(_stays_within(candidates, eta, outward, torque, limit) for outward, torque in planes)


def _stays_within(
    candidates: Candidates, eta: float, outward: Array, torque: float, limit: float
) -> bool:
    """Whether the loads of all pressures are proved to be on one side of a plane."""
    optimum = largest(candidates, eta, outward, torque, FINE)
    if optimum.exact and optimum.value > limit:
        return False
    row = optimum.multiplier
    return proved_maximum(candidates.base, Bound(eta, eta, row, row, outward), FINE) <= limit
