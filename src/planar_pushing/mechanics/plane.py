r"""Geometry of the plane: frame, signs and the kinematics of a pushed slider.

::

                       ring (radius R, center c)
             y'  y   .-'''-.            psi   rod angle
               \ |  /   c   \           l     rod length, from the contact to the slider's center
                \|  \  /    /           phi   force angle: f points along (cos phi, sin phi)
                 |   `/....'            n     outward normal of the fence = +y
                 |   / rod              theta angle of a velocity or an acceleration
                 |  / ) psi             all angles from +x (the fence), counterclockwise
   --------------+-*----------- x
         fence     contact = free end of the rod, origin of all positions; slider above the fence

A twist is ``(v_x, v_y, omega)`` and a wrench ``(f_x, f_y, tau)``, both at the slider's center. `f` is
the force of the pusher on the slider. The moment arm ``h = l sin(psi - phi)`` is the signed distance of
the line of force from the slider's center, and the spin ratio ``k = R omega / v`` compares the rotation
with the center's speed `v` along `f`. "Motion" is velocity in a quasi-static scene and initial
acceleration from rest otherwise. Angles are radians. The core has lengths in units of R.

There are three frames. The *object's frame* is the user's own. The *fence frame* has its origin at the
contact and +y along the inward normal there. The *body frame* has its origin at the slider's center and x
along the rod, away from the contact.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Annotated, Any, Literal, NamedTuple

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.kernels.arrays import same
from planar_pushing.mechanics.kernels.calls import run
from planar_pushing.terms.declared import Pair, finite, require_declared
from planar_pushing.terms.errors import InvalidValue, require_name
from planar_pushing.terms.numbers import Array as Array
from planar_pushing.terms.numbers import Number, as_array


def direction(angle: npt.ArrayLike) -> Array:
    """Unit vectors at `angle` (radians, shape S), shape S + (2,), exact at multiples of 90 degrees.

    A fence that moves along its own line then has exactly zero normal motion.
    """
    angles = np.asarray(angle, dtype=float)
    return run("unit_vectors", (), angles.reshape(-1, 1), 2).reshape(*angles.shape, 2)


#: Kind of a vector of numbers, which determines how it transforms between frames.
Kind = Literal["vector", "point", "twist", "wrench"]
#: Rounding error of the length of a unit vector.
UNIT = 4e-16
#: Number of components of each kind.
SIZES: dict[str, int] = {"vector": 2, "point": 2, "twist": 3, "wrench": 3}


class Frame(NamedTuple):
    """A frame: its origin and the direction of its x axis, in a parent frame."""

    origin: tuple[Number, Number]
    axis: tuple[Number, Number]

    def vector_in(self, vector: npt.ArrayLike) -> Array:
        """Vectors of shape S + (2,) from the parent frame to this frame."""
        vectors = np.asarray(vector, dtype=float)
        (x, y), (a, b) = (vectors[..., 0], vectors[..., 1]), self.axis
        return _vectors(x * a + y * b, y * a - x * b)

    def vector_out(self, vector: npt.ArrayLike) -> Array:
        """Vectors of shape S + (2,) from this frame to the parent frame."""
        vectors = np.asarray(vector, dtype=float)
        (x, y), (a, b) = (vectors[..., 0], vectors[..., 1]), self.axis
        return _vectors(x * a - y * b, y * a + x * b)

    def point_in(self, point: npt.ArrayLike) -> Array:
        """Points of shape S + (2,) from the parent frame to this frame."""
        return self.vector_in(np.asarray(point, dtype=float) - self._origin)

    def point_out(self, point: npt.ArrayLike) -> Array:
        """Points of shape S + (2,) from this frame to the parent frame."""
        return self.vector_out(point) + self._origin

    @property
    def shape(self) -> tuple[int, ...]:
        """Shape of an array of frames."""
        return np.shape(self.axis[0])

    @property
    def _origin(self) -> Array:
        return _vectors(*self.origin)

    @property
    def inverse(self) -> Frame:
        """The parent frame, expressed in this frame."""
        x, y = self.point_in((0.0, 0.0)).T
        a, b = self.axis
        return Frame((x.T, y.T), (a, -b))


def _vectors(x: Number, y: Number) -> Array:
    """Vectors of shape S + (2,) from their components."""
    if type(x) is type(y) is float:
        return np.array((x, y))
    vectors = np.empty((*np.broadcast(x, y).shape, 2))
    vectors[..., 0], vectors[..., 1] = x, y
    return vectors


def position_in_frame(position: tuple[Number, Number], frame: Frame) -> tuple[Number, Number]:
    """A position expressed in another frame; numbers and arrays as in `vector_in_frame`."""
    (x, y), (origin_x, origin_y) = position, frame.origin
    return vector_in_frame((x - origin_x, y - origin_y), frame)


def positions_in_frame(
    positions: Iterable[tuple[float, float]], frame: Frame
) -> tuple[tuple[float, float], ...]:
    """Pairs of numbers, expressed in one other frame; the same numbers as of `position_in_frame`."""
    (origin_x, origin_y), (a, b) = (map(float, pair) for pair in frame)
    return tuple(
        (
            (x - origin_x) * a + (y - origin_y) * b + 0.0,
            (y - origin_y) * a - (x - origin_x) * b + 0.0,
        )
        for x, y in positions
    )


def vector_in_frame(vector: tuple[Number, Number], frame: Frame) -> tuple[Number, Number]:
    """The components of a vector in another frame.

    Components and frame can be arrays, which are broadcast against one another, labeled arrays by name.
    """
    (x, y), (a, b) = vector, frame.axis
    return _plain(x * a + y * b), _plain(y * a - x * b)


def labeled_like(other: Number, numbers: npt.NDArray[Any]) -> Number:
    """An array with the labels of another one of its shape, if that has labels."""
    return other.copy(data=numbers) if hasattr(other, "dims") else numbers


#: Declaration of two numbers in the object's frame.
OBJECT_PAIR = Pair(finite("give x and y in the object's frame"))


@dataclass(frozen=True, slots=True)
class Placement:
    """Contact of an object: the fence frame in the object's frame.

    Parameters
    ----------
    point : (x, y), of floats or arrays
        The contact in the object's frame.
    normal : (n_x, n_y), of floats or arrays
        Inward normal there, in the object's frame; of any length, stored as a unit vector.

    Raises
    ------
    InvalidValue
        If the point or the normal is not two finite numbers, or the normal is zero.
    """

    point: Annotated[tuple[Number, Number], OBJECT_PAIR]
    normal: Annotated[tuple[Number, Number], OBJECT_PAIR]

    def __post_init__(self) -> None:
        normal = self.normal
        if self._is_plain():
            return
        require_declared(self)
        (x, y), (n_x, n_y) = (map(_plain, pair) for pair in (self.point, self.normal))
        with np.errstate(over="ignore"):
            length = np.hypot(n_x, n_y)
        if not ((length > 0.0) & (length < math.inf)).all():
            raise InvalidValue(
                "normal", normal, "a nonzero vector",
                "give the direction from the contact into the object",
            )  # fmt: skip
        # A unit vector is left unchanged.
        length = np.where(abs(length - 1.0) <= UNIT, 1.0, length)[()]
        object.__setattr__(self, "point", (x, y))
        object.__setattr__(self, "normal", (_plain(n_x / length), _plain(n_y / length)))

    def _is_plain(self) -> bool:
        """Whether these are floats and a unit vector, as of most contacts, whose zeros become positive."""
        pairs = self.point, self.normal
        if not all(type(pair) is tuple and len(pair) == 2 for pair in pairs):
            return False
        (x, y), (n_x, n_y) = pairs
        if not type(x) is type(y) is type(n_x) is type(n_y) is float:
            return False
        if not (math.isfinite(x) and math.isfinite(y) and abs(np.hypot(n_x, n_y) - 1.0) <= UNIT):
            return False
        object.__setattr__(self, "point", (x + 0.0, y + 0.0))
        object.__setattr__(self, "normal", (n_x + 0.0, n_y + 0.0))
        return True

    def __eq__(self, other: object) -> Any:
        return same(self, other)

    @property
    def fence(self) -> Frame:
        """The fence frame in the object's: +y is the normal, +x the normal rotated by -90 degrees."""
        x, y = self.normal
        return Frame(self.point, (y, -x))


def _plain(numbers: Number) -> Number:
    """A number or an array without negative zeros."""
    if type(numbers) is float:
        return numbers + 0.0
    return numbers + 0.0 if np.ndim(numbers) else float(numbers) + 0.0


def change_frame(value: npt.ArrayLike, kind: str, to: Frame, center: Array, into: bool) -> Array:
    """Transform numbers from the fence frame to an object's frame, or back.

    Parameters
    ----------
    value : array_like, shape S + (2,) or S + (3,)
    kind : {"vector", "point", "twist", "wrench"}
    to : Frame
        The object's frame in the fence frame.
    center : ndarray, shape (2,)
        The slider's center in the fence frame. Twists and wrenches are about it in the fence frame, and
        about the origin in the object's frame.
    into : bool
        Whether to transform into the object's frame.
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
    require_name("kind", kind, SIZES, "name one of these kinds")
    numbers = as_array(value)
    if numbers is None or numbers.shape[-1:] != (SIZES[kind],):
        raise InvalidValue(
            kind,
            value,
            f"numbers of shape S + ({SIZES[kind]},)",
            "give the components along the last axis",
        )
    return numbers
