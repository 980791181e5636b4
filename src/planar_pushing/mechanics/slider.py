"""The slider: a body with a rod, the side that is pushed and an outline, with their declarations."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Annotated, Any, NamedTuple

import numpy as np

from planar_pushing.mechanics.kernels.arrays import same
from planar_pushing.mechanics.outline import (
    KEPT,
    Corners,
    Outline,
    outline_of_corners,
    put_on_line,
)
from planar_pushing.mechanics.outline.chains import BETA0, BETA1, RHO, X, Y, wrap
from planar_pushing.mechanics.outline.entries import OUTLINE
from planar_pushing.mechanics.plane import Frame
from planar_pushing.terms.caches import cache_results
from planar_pushing.terms.declared import (
    NUMBER,
    PAIR,
    Declaration,
    Degrees,
    Read,
    Within,
    nonnegative,
    positive,
    replace_checked,
    require_declared,
)
from planar_pushing.terms.domain import Number, require_ratio
from planar_pushing.terms.errors import InvalidValue, require_flag
from planar_pushing.terms.numbers import pair_of

#: The angle of the rod; the slider's center is above the fence.
ROD_ANGLE = Degrees(
    lambda x: (x > 0) & (x < math.pi), "radians in the open interval (0, pi)",
    "keep the slider above the fence; convert degrees to radians with np.deg2rad",
    degrees=Within(
        lambda x: 0 < x < 180, "degrees in the open interval (0, 180)",
        "keep the slider above the fence",
        {"type": "number", "exclusiveMinimum": 0, "exclusiveMaximum": 180},
    ),
)  # fmt: skip
RADIUS = positive("give it in the unit of the rod length")
ENDS = (
    "(start, end) with start <= 0 <= end, infinite for a side without an end",
    "measure both ends along the side from the contact, which is between them, the one toward -x first",
)
START, END = Within(lambda x: x <= 0, *ENDS), Within(lambda x: x >= 0, *ENDS)


class SideEnds(Declaration):
    """Ends of a side, measured along it from the contact, which is between them."""

    words = ENDS[0]
    schema = PAIR | {"items": {"anyOf": [NUMBER, {"enum": ["inf", "-inf"]}]}}

    def require(self, name: str, value: Any) -> tuple[Number, Number]:
        pair = pair_of(value)
        if pair is None:
            raise InvalidValue(name, value, *ENDS)
        ends = START.require(name, pair[0]), END.require(name, pair[1])
        if any(type(end) is not float and 0 in np.shape(end) for end in ends):
            raise InvalidValue(name, value, *ENDS)
        return ends

    def read(self, entry: Any) -> tuple[float, float]:
        start, end = pair_of(entry) or (None, None)
        try:
            return START.read(start), END.read(end)
        except InvalidValue:
            raise InvalidValue("", entry, *ENDS) from None

    def to_file(self, value: tuple[Number, Number]) -> list[float] | None:
        ends = [float(end) for end in value]
        return ends if any(map(math.isfinite, ends)) else None


class InnerCorner(NamedTuple):
    """An inner corner of an outline: position, direction between its sides, and half of their angle."""

    x: float
    y: float
    middle: float
    half: float


SIDE = SideEnds()
FLAG = Read(require_flag, "true or false", {"type": "boolean"})
#: Largest angle, in radians, between a given normal and that of its place on the outline.
ALIGNED = 1e-3
#: The body frame is that of the outline.
SAME = Frame((0.0, 0.0), (1.0, 0.0))


def _is_long(side: tuple[Number, Number]) -> bool:
    """Whether the ends of a side are finite and apart."""
    if not all(bool(np.all(np.isfinite(end))) for end in side):
        return False
    start, end = map(np.asarray, side)
    # Other shapes are refused where all parameters are known.
    is_comparable = start.shape == end.shape or not (start.ndim and end.ndim)
    return not is_comparable or bool((end > start).all())


@dataclass(frozen=True, slots=True, kw_only=True)
class Slider:
    """A body with a massless rod, pushed at the rod's free end (Fig. 1).

    Parameters
    ----------
    rod_length : float or array
        l >= 0, from the contact to the slider's center, at most a million radii.
    rod_angle : float or array
        psi between the fence and the rod, radians, in (0, pi).
    radius : float or array, optional
        R > 0; all lengths share one arbitrary unit. By default a scene sets it to the largest distance of
        its support from the center of pressure, or to 1 for a ring.
    side : (start, end), of floats or arrays
        Ends of the flat side that a finger pushes, measured from the contact along the side, which at time
        0 is along the fence; 0 at a corner. They have no effect on a fence, unless the side lies on it.
    flush : bool
        Whether the side lies on the fence: the contact is the whole side, between its ends, which must be
        finite. Its place, from which the rod goes, is then only the origin of the ends.
    outline : sequence of pairs, Polygon, Disc or Outline, optional
        The outline of the slider, in the object's frame. By default it is unknown. In a simulation a
        fence touches every corner and side of the outline, and a finger goes round it. With inertia, the
        simulation ends where a finger touches the outline at two places.
    outline_frame : Frame, optional
        Origin and direction of the x axis of the body frame in the object's frame, of floats or arrays; by
        default both frames are the same.

    Raises
    ------
    InvalidValue
        If a parameter is out of range, the side does not contain the contact, the ends of a flush side are
        not finite or not apart, the outline is not a simple polygon, or the contact is at an inner corner
        and its normal, at the rod's angle, is not the bisector of those of both sides.
    """

    rod_length: Annotated[
        Number, nonnegative("give the distance from the contact to the slider's center")
    ]
    rod_angle: Annotated[Number, ROD_ANGLE]
    radius: Annotated[Number, RADIUS] = None
    side: Annotated[tuple[Number, Number], SIDE] = (-math.inf, math.inf)
    flush: Annotated[bool, FLAG] = False
    outline: Annotated[Any, OUTLINE] = None
    outline_frame: Frame = SAME

    def __post_init__(self) -> None:
        require_declared(self)
        if self.flush and not _is_long(self.side):
            raise InvalidValue(
                "side", self.side, "two finite ends (start, end) of a side that lies on the fence",
                "measure both ends along the fence, or leave flush out",
            )  # fmt: skip
        if self.outline is not None:
            self._require_bisector()
        if self.radius is not None:
            _ = self.length_ratio

    def __eq__(self, other: object) -> Any:
        """Whether all numbers are the same, and the outlines in the body frames."""
        if not isinstance(other, Slider):
            return NotImplemented
        if self.outline is None or other.outline is None or self._is_array or other._is_array:
            return same(self, other)
        one, two = (
            replace_checked(slider, outline=slider.outline_in_body(), outline_frame=SAME)
            for slider in (self, other)
        )
        return same(one, two)

    @property
    def _is_array(self) -> bool:
        """Whether the body frame is an array of frames."""
        frame = self.outline_frame
        return bool(np.ndim(frame.origin[0]) or np.ndim(frame.axis[0]))

    @property
    def pocket(self) -> Number:
        """At an inner corner of the outline, half of the angle between its sides' normals; otherwise 0."""
        pocket: Number = 0.0
        for corner, near in self._near_inner_corners():
            pocket = pocket + near * corner.half
        return float(pocket) if np.ndim(pocket) == 0 else pocket

    def _near_inner_corners(self) -> Iterator[tuple[InnerCorner, Any]]:
        """The inner corners at contacts, and at which contacts each is."""
        if self.outline is None or self.flush:
            return
        corners, tolerance = inner_corners(self.outline), self.outline.tolerance
        (x, y), (c, s) = self.outline_frame
        end_x, end_y = x - self.rod_length * c, y - self.rod_length * s
        if type(end_x) is type(end_y) is float:
            corners = [corner for corner in corners if abs(corner.x - end_x) <= tolerance]
        for corner in corners:
            near = np.hypot(end_x - corner.x, end_y - corner.y) <= tolerance
            if np.any(np.asarray(near)):
                yield corner, near

    def _require_bisector(self) -> None:
        """Refuse a contact at an inner corner whose normal is not the bisector of those of both sides."""
        c, s = self.outline_frame.axis
        for corner, near in self._near_inner_corners():
            direction = np.arctan2(s, c) - self.rod_angle
            lean = np.abs(wrap(np.asarray(direction - corner.middle, dtype=float)))
            if np.any(np.asarray(near) & (lean > ALIGNED)):
                n_x, n_y = -math.sin(corner.middle), math.cos(corner.middle)
                raise InvalidValue(
                    "normal", "another one at an inner corner",
                    f"the bisector of the normals of both sides, ({n_x:.6g}, {n_y:.6g})",
                    "a point there touches two sides; leave the normal out",
                )  # fmt: skip

    def outline_in_body(self) -> Outline | None:
        """The outline of one slider in its body frame; None without an outline.

        Corners within a millionth of the outline's size of the fence are on it.

        Raises
        ------
        InvalidValue
            If the body frame is an array of frames.
        """
        if self.outline is None:
            return None
        if self._is_array:
            raise InvalidValue(
                "slider", "an array of body frames", "one body frame",
                "take the scenes one by one: the outline is the same, in the object's frame",
            )  # fmt: skip
        frame = self.outline_frame
        moved = self.outline if frame == SAME else self.outline.in_frame(frame)
        if moved.corners is None or np.ndim(self.rod_length) or np.ndim(self.rod_angle):
            return moved  # type: ignore[no-any-return]
        return _put_on_fence(moved.corners, float(self.rod_length), float(self.rod_angle))

    def with_radius(self, radius: Number) -> Slider:
        """The slider with its radius, which a scene fills in."""
        required = RADIUS.require("radius", radius)
        slider = replace_checked(self, radius=required)
        _ = slider.length_ratio
        return slider

    @property
    def length_ratio(self) -> Number:
        """Rod length in units of the radius, l / R."""
        if self.radius is None:
            raise InvalidValue(
                "radius", None, "a number, given or filled in by a scene", "ask the slider of a scene",
            )  # fmt: skip
        return require_ratio("length_ratio", self.rod_length / self.radius)


@cache_results(KEPT)
def inner_corners(outline: Outline) -> list[InnerCorner]:
    """The inner corners of an outline."""
    pieces = outline.pieces
    is_inner = (pieces[:, RHO] == 0.0) & (pieces[:, BETA1] < pieces[:, BETA0])
    return [
        InnerCorner(x, y, (first + last) / 2.0, (first - last) / 2.0)
        for x, y, first, last in pieces[is_inner][:, [X, Y, BETA0, BETA1]].tolist()
    ]


@cache_results(KEPT)
def _put_on_fence(corners: Corners, length: float, angle: float) -> Outline:
    """An outline in the body frame with the corners on the fence that are drawn on it."""
    normal = np.array([math.sin(angle), math.cos(angle)])
    return outline_of_corners(
        put_on_line(np.array(corners), np.array([-length, 0.0]), normal) or corners
    )
