"""The interface of a support, and checks of user input."""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache
from typing import Any, Protocol, runtime_checkable

import numpy as np

from planar_pushing.mechanics.frames import Frame
from planar_pushing.mechanics.supports.pressure.record import Array, Pieces
from planar_pushing.terms.errors import InvalidValue

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
    """A support expressed in another frame.

    Raises
    ------
    InvalidValue
        If the support is of a user-defined kind without a method `moved`.
    """
    if not hasattr(support, "moved"):
        raise InvalidValue(
            "support", support, "a support with a method moved(frame)",
            "add one that returns the support with its positions transformed by frame.point_in",
        )  # fmt: skip
    return support.moved(frame)


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
    try:
        numbers = np.array(given, dtype=float)
    except (TypeError, ValueError):
        raise InvalidValue(name, given, allowed, remedy) from None
    fits = numbers.ndim == len(shape) and all(
        length in (None, found) for length, found in zip(shape, numbers.shape, strict=True)
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


def position(name: str, given: object) -> Position:
    """A position in the plane."""
    x, y = array(name, given, (2,), "two finite numbers", "give x and y in the body frame").tolist()
    return x, y


def positions(name: str, given: object, remedy: str) -> tuple[Position, ...]:
    """Positions in the plane."""
    found = array(name, given, (None, 2), "pairs of finite numbers", remedy)
    return tuple((x, y) for x, y in found.tolist())


def weights(name: str, given: object, count: int, remedy: str) -> tuple[float, ...]:
    """Positive weights, one per member."""
    found = array(name, given, (count,), f"{count} positive numbers", remedy)
    require_all(name, found, lambda x: x > 0, "a number > 0", "leave out what carries no weight")
    return tuple(found.tolist())
