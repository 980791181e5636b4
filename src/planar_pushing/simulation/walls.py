"""Walls at rest, which an object can touch while it is pushed."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from planar_pushing.mechanics.contact import ContactLaw, is_law
from planar_pushing.terms.errors import InvalidValue, as_floats


@dataclass(frozen=True, slots=True)
class Wall:
    """A straight wall at rest, without ends, in the world.

    Parameters
    ----------
    point : (x, y)
        A point of the wall.
    normal : (n_x, n_y)
        Toward the free side, on which the object is; of any length.
    law : ContactLaw
        Between the object and the wall.

    Raises
    ------
    InvalidValue
        If point or normal are not two finite numbers, the normal is zero, or there is no law.
    """

    point: Sequence[float]
    normal: Sequence[float]
    law: ContactLaw

    def __post_init__(self) -> None:
        for name in ("point", "normal"):
            numbers = as_floats(getattr(self, name))
            if len(numbers) != 2 or not all(map(math.isfinite, numbers)):
                raise InvalidValue(
                    name, getattr(self, name), "two finite numbers", "give x and y in the world"
                )
            object.__setattr__(self, name, numbers)
        if math.hypot(*self.normal) == 0.0:
            raise InvalidValue(
                "normal", self.normal, "a nonzero vector", "give the direction toward the free side"
            )
        if not is_law(self.law):
            raise InvalidValue(
                "law", self.law, "Coulomb, InfiniteFriction or PerfectlyRough",
                "construct one of these laws",
            )  # fmt: skip

    @property
    def position(self) -> tuple[float, float]:
        """The point."""
        return self.point[0], self.point[1]

    @property
    def unit_normal(self) -> tuple[float, float]:
        """The normal as a unit vector."""
        size = math.hypot(*self.normal)
        return self.normal[0] / size, self.normal[1] / size


def require_walls(value: Any) -> tuple[Wall, ...]:
    """Walls in a sequence, or `InvalidValue`."""
    walls = tuple(value) if isinstance(value, (list, tuple)) else (value,)
    if not all(isinstance(wall, Wall) for wall in walls):
        raise InvalidValue(
            "walls",
            value,
            "a sequence of Wall",
            "construct them, as in [pp.Wall((0, 0), (0, 1), law)]",
        )
    return walls
