"""Frames of the plane, and the place of an object at its contact.

Three frames take part. The *object's frame* is the user's own. The *fence frame* has its origin at the
contact and +y along the inward normal there. The *body frame* has its origin at the slider's center and x
along the rod, away from the contact.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Literal, NamedTuple

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.plane import Array
from planar_pushing.terms.domain import Number
from planar_pushing.terms.errors import InvalidValue, as_floats

#: What a vector of numbers stands for, which decides how it changes with the frame.
Kind = Literal["vector", "point", "twist", "wrench"]
#: Rounding of the length of a unit vector.
UNIT = 4e-16
#: How many numbers each kind has.
SIZES: dict[str, int] = {"vector": 2, "point": 2, "twist": 3, "wrench": 3}


class Frame(NamedTuple):
    """A frame: its origin and the direction of its x axis, in the frame in which both are given."""

    origin: tuple[Number, Number]
    axis: tuple[Number, Number]

    def vector_in(self, vector: npt.ArrayLike) -> Array:
        """A vector of shape S + (2,) in this frame."""
        x, y = np.moveaxis(np.asarray(vector, dtype=float), -1, 0)
        a, b = self.axis
        return np.stack(np.broadcast_arrays(x * a + y * b, y * a - x * b), axis=-1)

    def vector_out(self, vector: npt.ArrayLike) -> Array:
        """A vector of this frame, shape S + (2,), in the other one."""
        x, y = np.moveaxis(np.asarray(vector, dtype=float), -1, 0)
        a, b = self.axis
        return np.stack(np.broadcast_arrays(x * a - y * b, y * a + x * b), axis=-1)

    def point_in(self, point: npt.ArrayLike) -> Array:
        """A point of shape S + (2,) in this frame."""
        return self.vector_in(np.asarray(point, dtype=float) - self._origin)

    def point_out(self, point: npt.ArrayLike) -> Array:
        """A point of this frame, shape S + (2,), in the other one."""
        return self.vector_out(point) + self._origin

    @property
    def _origin(self) -> Array:
        return np.stack(np.broadcast_arrays(*self.origin), axis=-1)

    @property
    def inverse(self) -> Frame:
        """The other frame, as this one sees it."""
        x, y = self.point_in((0.0, 0.0)).T
        a, b = self.axis
        return Frame((x.T, y.T), (a, -b))


def moved_place(place: tuple[float, float], frame: Frame) -> tuple[float, float]:
    """A position as another frame has it."""
    x, y = frame.point_in(place).tolist()
    return x + 0.0, y + 0.0


@dataclass(frozen=True, slots=True)
class Placement:
    """Where an object is pushed: the fence frame in the object's frame.

    Parameters
    ----------
    point : (x, y)
        The contact in the object's frame.
    normal : (n_x, n_y)
        Inward normal there, in the object's frame; of any length, and of length 1 afterwards.

    Raises
    ------
    InvalidValue
        Where one of them is not two finite numbers, or the normal has no length.
    """

    point: tuple[float, float]
    normal: tuple[float, float]

    def __post_init__(self) -> None:
        point, normal = as_floats(self.point), as_floats(self.normal)
        for name, given in (("point", point), ("normal", normal)):
            if len(given) != 2 or not all(map(math.isfinite, given)):
                raise InvalidValue(
                    name,
                    getattr(self, name),
                    "two finite numbers",
                    "give x and y in the object's frame",
                )
        length = math.hypot(*normal)
        if not 0.0 < length < math.inf:
            raise InvalidValue(
                "normal", self.normal, "a vector that is not zero",
                "give the direction from the contact into the object",
            )  # fmt: skip
        if abs(length - 1.0) <= UNIT:  # a unit vector stays what it is
            length = 1.0
        object.__setattr__(self, "point", point)
        object.__setattr__(self, "normal", (normal[0] / length + 0.0, normal[1] / length + 0.0))

    @property
    def fence(self) -> Frame:
        """The fence frame in the object's: +y is the normal, +x the normal turned by -90 degrees."""
        x, y = self.normal
        return Frame(self.point, (y, -x))


def changed(value: npt.ArrayLike, kind: str, to: Frame, center: Array, into: bool) -> Array:
    """Numbers of the fence frame in an object's frame, or back.

    Parameters
    ----------
    value : array_like, shape S + (2,) or S + (3,)
    kind : {"vector", "point", "twist", "wrench"}
    to : Frame
        The object's frame in the fence frame.
    center : ndarray, shape (2,)
        The slider's center in the fence frame: twists and wrenches of that frame are about it, those of the
        object's frame about its origin.
    into : bool
        Whether the numbers go into the object's frame.
    """
    numbers = _numbers(value, kind)
    if kind == "vector":
        return to.vector_in(numbers) if into else to.vector_out(numbers)
    if kind == "point":
        return to.point_in(numbers) if into else to.point_out(numbers)
    lever = to._origin - center
    plane, last = numbers[..., :2], numbers[..., 2]
    if not into:
        plane = to.vector_out(plane)
        lever = -lever
    if kind == "twist":
        plane = plane + last[..., None] * np.stack([-lever[..., 1], lever[..., 0]], axis=-1)
    else:
        last = last - (lever[..., 0] * plane[..., 1] - lever[..., 1] * plane[..., 0])
    plane = to.vector_in(plane) if into else plane
    return np.concatenate([plane, np.broadcast_to(last, plane.shape[:-1])[..., None]], axis=-1)


def _numbers(value: Any, kind: str) -> Array:
    """Numbers of a kind, or `InvalidValue`."""
    if kind not in SIZES:
        raise InvalidValue("kind", kind, ", ".join(SIZES), "name one of these kinds")
    try:
        numbers = np.asarray(value, dtype=float)
    except (TypeError, ValueError):
        numbers = np.empty(0)
    if numbers.shape[-1:] != (SIZES[kind],):
        raise InvalidValue(
            kind,
            value,
            f"numbers of shape S + ({SIZES[kind]},)",
            "give the components along the last axis",
        )
    return numbers
