"""The slider: a body with a rod, the side that is pushed and an outline, with their declarations."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Annotated, Any

import numpy as np

from planar_pushing.mechanics.kernels.arrays import same
from planar_pushing.mechanics.outline import (
    DRAWN,
    ROUNDING,
    Corners,
    is_at_inner_corner,
    put_on_line,
    require_outline,
)
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
#: Number of corners up to which floats are compared faster than arrays.
FEW = 32
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


SIDE = SideEnds()
FLAG = Read(require_flag, "true or false", {"type": "boolean"})
OUTLINE = Read(
    lambda name, value: require_outline(value, name), "the corners of a simple polygon, in order",
    {"type": "array", "minItems": 3, "items": PAIR},
)  # fmt: skip


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
    outline : sequence of pairs, optional
        Corners of the slider in the body frame, in order, exact to a millionth of the outline's size: those
        that close to the fence are put on it. By default the outline is unknown. In a
        simulation a fence touches every corner and side of the outline. Under a finger, the simulation ends
        when another point of the outline meets the finger, or when this reaches the end of its side.

    Raises
    ------
    InvalidValue
        If a parameter is out of range, the side does not contain the contact, the ends of a flush side are
        not finite or not apart, the outline is not a simple polygon, or the contact is at an inner corner.
    """

    rod_length: Annotated[
        Number, nonnegative("give the distance from the contact to the slider's center")
    ]
    rod_angle: Annotated[Number, ROD_ANGLE]
    radius: Annotated[Number, RADIUS] = None
    side: Annotated[tuple[Number, Number], SIDE] = (-math.inf, math.inf)
    flush: Annotated[bool, FLAG] = False
    outline: Annotated[Any, OUTLINE] = None

    def __post_init__(self) -> None:
        require_declared(self)
        if self.flush and not _is_long(self.side):
            raise InvalidValue(
                "side", self.side, "two finite ends (start, end) of a side that lies on the fence",
                "measure both ends along the fence, or leave flush out",
            )  # fmt: skip
        if self.outline is not None:
            object.__setattr__(self, "outline", self._outline_on_fence())
        if self.radius is not None:
            _ = self.length_ratio

    def __eq__(self, other: object) -> Any:
        return same(self, other)

    def _outline_on_fence(self) -> Corners:
        """The outline with the corners on the line of the fence that are drawn on it.

        At an inner corner a contact is refused, because a pusher would touch two sides there.
        """
        corners: Corners = self.outline
        if self._is_apart(corners):
            return corners
        vertices = np.array(corners)
        if not self.flush and is_at_inner_corner(vertices, np.ravel(self.rod_length)):
            raise InvalidValue(
                "outline", "an inner corner at the contact", "one whose inner corners are elsewhere",
                "a pusher there touches two sides; move the contact off the corner",
            )  # fmt: skip
        if np.ndim(self.rod_length) or np.ndim(self.rod_angle):
            return corners
        normal = np.array([math.sin(self.rod_angle), math.cos(self.rod_angle)])
        return put_on_line(vertices, np.array([-self.rod_length, 0.0]), normal) or corners

    def _is_apart(self, corners: Corners) -> bool:
        """Whether no corner is at the contact or has to be moved onto the fence, by comparisons of floats.

        It is said of corners that are clearly so, and of few of them, for which this is faster.
        """
        length, angle = self.rod_length, self.rod_angle
        if len(corners) > FEW or not type(length) is type(angle) is float:
            return False
        x, y = zip(*corners, strict=True)
        near = 2.0 * DRAWN * max(max(x) - min(x), max(y) - min(y))
        n_x, n_y = math.sin(angle), math.cos(angle)
        exact = 0.5 * ROUNDING * (max(map(abs, (*x, *y))) + length)
        for p, q in zip(x, y, strict=True):
            height = abs((p + length) * n_x + q * n_y)
            if exact < height < near or (abs(p + length) < near and abs(q) < near):
                return False
        return True

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
