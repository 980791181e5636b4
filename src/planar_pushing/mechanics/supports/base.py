"""The interface of a support, and checks of user input."""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache
from typing import Any, Protocol, runtime_checkable

import numpy as np

from planar_pushing.mechanics.frames import Frame
from planar_pushing.mechanics.pressure.pieces import Array, Pieces
from planar_pushing.mechanics.pressure.support_in_frames import SupportInFrames
from planar_pushing.terms.errors import InvalidValue, number_of, require_positive
from planar_pushing.terms.numbers import required_array
from planar_pushing.terms.options import SPEED

#: Range of sizes whose squares are doubles, and remedy.
LENGTHS = SPEED.least, SPEED.most
UNIT = "choose another unit of length"
#: A position in the body frame: origin at the slider's center, x along the rod and away from the contact.
Position = tuple[float, float]


@runtime_checkable
class Support(Protocol):
    """A unit pressure distribution of the slider on the plane, in its body frame."""

    @property
    def center_of_pressure(self) -> Position:
        """Mean position of the pressure."""
        ...

    @property
    def extent(self) -> float:
        """Largest distance of the support from its center of pressure."""
        ...

    def pieces(self) -> Pieces:
        """The support's pieces, whose shares add up to 1."""
        ...


def moved_support(support: Any, frame: Frame) -> Any:
    """A support expressed in another frame, or in each of an array of frames.

    Raises
    ------
    InvalidValue
        If the support is of a user-defined kind without a method `moved`, or cannot be moved.
    """
    if not hasattr(support, "moved"):
        raise InvalidValue(
            "support", support, "a support with a method moved(frame)",
            "add one that returns the support with its positions transformed by frame.point_in",
        )  # fmt: skip
    if not frame.shape:
        return support.moved(frame)
    moved = SupportInFrames(support, frame)
    support.moved(moved.frames[0])
    return moved


@lru_cache
def is_kind(kind: type) -> bool:
    """Whether the instances of a class are supports; testing an instance would compute its properties."""
    return all(hasattr(kind, name) for name in ("center_of_pressure", "extent", "pieces"))


def array(
    name: str, given: object, shape: tuple[int | None, ...], allowed: str, remedy: str
) -> Array:
    """Array of finite numbers of a given shape, in which None is any length.

    Raises
    ------
    InvalidValue
        If the shape differs, or an entry is not a finite number.
    """
    numbers = required_array(name, given, allowed, remedy)
    fits = numbers.ndim == len(shape) and all(
        length in (None, actual) for length, actual in zip(shape, numbers.shape, strict=True)
    )
    if not fits:
        raise InvalidValue(name, given, allowed, remedy)
    require_all(name, numbers, np.isfinite, "finite numbers", "give each number")
    return numbers


def require_all(
    name: str, numbers: Array, allows: Callable[[Array], Any], allowed: str, remedy: str
) -> None:
    """Refuse numbers for which `allows` is false; the message shows the first one and its index."""
    right = allows(numbers)
    if not right.all():
        place = tuple(map(int, np.argwhere(~right)[0]))
        shown = "".join(f"[{i}]" for i in place)
        raise InvalidValue(name + shown, float(numbers[place]), allowed, remedy)


def coordinates(
    name: str, given: object, shape: tuple[int | None, ...], allowed: str, remedy: str
) -> Array:
    """Array of coordinates whose squares do not overflow; errors as in `array`."""
    numbers = array(name, given, shape, allowed, remedy)
    require_all(name, numbers, lambda x: np.abs(x) <= LENGTHS[1], f"at most {LENGTHS[1]:g}", UNIT)
    return numbers


def require_size(name: str, size: float) -> None:
    """Refuse a size whose square underflows or overflows."""
    low, high = LENGTHS
    if not low <= size <= high:
        raise InvalidValue(name, size, f"a size in [{low:g}, {high:g}]", UNIT)


def length(name: str, given: object, remedy: str) -> float:
    """A positive length whose square neither underflows nor overflows."""
    size = require_positive(name, given, remedy)
    require_size(name, size)
    return size


def position(name: str, given: object) -> Position:
    """A position in the plane."""
    remedy = "give x and y in the body frame"
    x, y = coordinates(name, given, (2,), "two finite numbers", remedy).tolist()
    return x, y


def positions(name: str, given: object, remedy: str) -> tuple[Position, ...]:
    """Positions in the plane."""
    places = coordinates(name, given, (None, 2), "pairs of finite numbers", remedy)
    if len(places) and (span := float(np.ptp(places, axis=0).max())):
        require_size(name, span)
    return tuple((x, y) for x, y in places.tolist())


def weights(name: str, given: object, count: int, remedy: str) -> tuple[float, ...]:
    """Positive weights, one per member, whose sum is finite."""
    loads = array(name, given, (count,), number_of(count, "positive number"), remedy)
    require_all(name, loads, lambda x: x > 0, "a number > 0", "leave out what carries no weight")
    if loads.max(initial=0.0) > np.finfo(float).max / count:
        allowed = "numbers with a finite sum"
        raise InvalidValue(name, float(loads.max()), allowed, "choose another unit")
    return tuple(loads.tolist())
