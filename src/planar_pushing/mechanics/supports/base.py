"""The interface of a support, and checks of user input."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, Protocol, runtime_checkable

import numpy as np

from planar_pushing.mechanics.pictures import Pictured
from planar_pushing.mechanics.plane import Frame
from planar_pushing.mechanics.pressure.assembly import gather_pieces, measure_support
from planar_pushing.mechanics.pressure.pieces import Array, Pieces
from planar_pushing.mechanics.pressure.support_in_frames import (
    KINDS,
    SupportInFrames,
    flatten_supports,
)
from planar_pushing.terms.declared import NUMBER, PAIR, Read
from planar_pushing.terms.errors import InvalidValue, number_of, require_positive
from planar_pushing.terms.numbers import as_array, require_array
from planar_pushing.terms.options import SPEED

#: Range of sizes whose squares are doubles, and remedy.
LENGTHS = SPEED.minimum, SPEED.maximum
UNIT = "choose another unit of length"
#: Largest relative difference of what a support says of itself.
SAME = 1e-9
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


class InPieces(Pictured):
    """A support of which everything is known by its pieces, measured once."""

    __slots__ = ()

    @property
    def center_of_pressure(self) -> Position:
        x, y = measure_support(self).centers[0].tolist()
        return x, y

    @property
    def extent(self) -> float:
        return float(measure_support(self).extents[0])


def support_in_frame(support: Any, frame: Frame) -> Any:
    """A support expressed in another frame, or in each of an array of frames.

    Raises
    ------
    InvalidValue
        If the support is of a user-defined kind without a method `in_frame`, or is a ring of the slider's
        radius.
    """
    require_in_frame("support", support)
    if not frame.shape:
        return support.in_frame(frame)
    supports = SupportInFrames(support, frame)
    support.in_frame(supports.frames[0])
    return supports


def require_in_frame(name: str, support: Any) -> None:
    """Refuse a support of a user-defined kind that cannot be expressed in another frame."""
    if not hasattr(support, "in_frame"):
        remedy = "add one that returns the support with its positions transformed by frame.point_in"
        if hasattr(support, "moved"):
            remedy = "rename its method moved, the former name, to in_frame"
        raise InvalidValue(name, support, "a support with a method in_frame(frame)", remedy)


def require_support(name: str, value: Any) -> Any:
    """The given support, or `InvalidValue`; one of the user's own class must fulfill `Support`."""
    if type(value) not in KINDS:
        names = ("center_of_pressure", "extent", "pieces")
        if not all(hasattr(type(value), attribute) for attribute in names):
            raise InvalidValue(
                name, value, "a support, such as Disc or Polygon",
                f"construct one, or give your class {', '.join(names[:2])} and {names[2]}()",
            )  # fmt: skip
        _require_pieces(name, value)
    return value


def _require_pieces(name: str, support: Support) -> None:
    """Refuse a support of the user's own class that does not have the pressure that it describes."""
    pieces = support.pieces()
    try:
        group = gather_pieces([pieces])
        share = group.share
    except (TypeError, ValueError, LookupError, AttributeError):
        share = math.nan
    if not abs(share - 1.0) <= SAME:
        raise InvalidValue(
            name, support, "a support whose pieces() are Pieces with shares that add up to 1",
            "return those of a support of the package, for instance Composite(...).pieces()",
        )  # fmt: skip
    described = (*support.center_of_pressure, support.extent)
    measured = (*group.centers[0], group.extents[0])
    if not np.allclose(described, measured, rtol=SAME, atol=SAME * float(group.extents[0])):
        raise InvalidValue(
            name, support,
            "a support whose center_of_pressure and extent are those of its pieces(), here "
            f"({measured[0]:.6g}, {measured[1]:.6g}) and {measured[2]:.6g}",
            "correct these properties",
        )  # fmt: skip


def require_supports(name: str, value: Any) -> Any:
    """The given support, or array of supports, or `InvalidValue`."""
    supports = [value.support] if isinstance(value, SupportInFrames) else flatten_supports(value)
    for support in supports if len(supports) else [value]:
        require_support(name, support)
    return value


def array(
    name: str, value: object, shape: tuple[int | None, ...], allowed: str, remedy: str
) -> Array:
    """Array of finite numbers of a given shape, in which None is any length.

    Raises
    ------
    InvalidValue
        If the shape differs, or an entry is not a finite number.
    """
    numbers = as_array(value)
    if numbers is None:
        for i, entry in enumerate(value if isinstance(value, (list, tuple)) else ()):
            if as_array(entry) is None:
                raise InvalidValue(f"{name}[{i}]", entry, "finite numbers", remedy)
        numbers = require_array(name, value, allowed, remedy)
    fits = numbers.ndim == len(shape) and all(
        length in (None, actual) for length, actual in zip(shape, numbers.shape, strict=True)
    )
    if not fits:
        raise InvalidValue(name, value, allowed, remedy)
    require_all(name, numbers, np.isfinite, "finite numbers", "give each number")
    return numbers


def require_all(
    name: str, numbers: Array, allows: Callable[[Array], Any], allowed: str, remedy: str
) -> None:
    """Refuse numbers for which `allows` is false; the message shows the first one and its index."""
    right = allows(numbers)
    if not right.all():
        index = tuple(map(int, np.argwhere(~right)[0]))
        label = "".join(f"[{i}]" for i in index)
        raise InvalidValue(name + label, float(numbers[index]), allowed, remedy)


def coordinates(
    name: str, value: object, shape: tuple[int | None, ...], allowed: str, remedy: str
) -> Array:
    """Array of coordinates whose squares do not overflow; errors as in `array`."""
    numbers = array(name, value, shape, allowed, remedy)
    require_all(name, numbers, lambda x: np.abs(x) <= LENGTHS[1], f"at most {LENGTHS[1]:g}", UNIT)
    return numbers


def require_size(name: str, size: float) -> None:
    """Refuse a size whose square underflows or overflows."""
    low, high = LENGTHS
    if not low <= size <= high:
        raise InvalidValue(name, size, f"a size in [{low:g}, {high:g}]", UNIT)


def length(name: str, value: object, remedy: str) -> float:
    """A positive length whose square neither underflows nor overflows."""
    size = require_positive(name, value, remedy)
    require_size(name, size)
    return size


def position(name: str, value: object) -> Position:
    """A position in the plane."""
    remedy = "give x and y in the body frame"
    x, y = coordinates(name, value, (2,), "two finite numbers", remedy).tolist()
    return x, y


def positions(
    name: str, value: object, remedy: str = "give x and y of each in the body frame"
) -> tuple[Position, ...]:
    """Positions in the plane."""
    entries: Any = value if isinstance(value, (list, tuple)) else None
    if entries is not None and not entries:
        raise InvalidValue(name, value, "at least one point", remedy)
    pairs = as_array(value)
    if pairs is None or pairs.ndim != 2 or pairs.shape[1] != 2:
        for i, entry in enumerate(entries or ()):
            pair = as_array(entry)
            if pair is None or pair.shape != (2,):
                raise InvalidValue(f"{name}[{i}]", entry, "two finite numbers", remedy)
    places = coordinates(name, value, (None, 2), "pairs of finite numbers", remedy)
    if not len(places):
        raise InvalidValue(name, value, "at least one point", remedy)
    if span := float(np.ptp(places, axis=0).max()):
        require_size(name, span)
    return tuple((x, y) for x, y in places.tolist())


def weights(name: str, value: object) -> tuple[float, ...]:
    """Positive weights, whose sum is finite."""
    loads = array(name, value, (None,), "positive numbers", "give one weight for each")
    require_all(name, loads, lambda x: x > 0, "a number > 0", "leave out what carries no weight")
    if loads.max(initial=0.0) > np.finfo(float).max / max(len(loads), 1):
        allowed = "numbers with a finite sum"
        raise InvalidValue(name, float(loads.max()), allowed, "choose another unit")
    return tuple(loads.tolist())


def require_count(name: str, value: Any, count: int, noun: str) -> None:
    """Refuse a sequence that does not have one entry for each of several things."""
    if len(value) != count:
        raise InvalidValue(name, value, number_of(count, noun), f"give one {noun} for each point")


PLACES = {"type": "array", "minItems": 1, "items": PAIR}
#: Declarations of parameters: a support, a support or an array of them, a position, positions, weights.
SUPPORT = Read(require_support, "a support", {})
SUPPORTS = Read(require_supports, "a support", {})
POSITION = Read(position, "two finite numbers, [x, y] in the body frame", PAIR)
POSITIONS = Read(positions, "pairs of finite numbers, [x, y] in the body frame", PLACES)
WEIGHTS = Read(
    weights, "positive numbers", {"type": "array", "minItems": 1, "items": NUMBER | {"exclusiveMinimum": 0}}
)  # fmt: skip


def a_length(remedy: str) -> Read:
    """Declaration of a length."""
    return Read(lambda name, value: length(name, value, remedy), "a finite number > 0",
                NUMBER | {"exclusiveMinimum": 0})  # fmt: skip
