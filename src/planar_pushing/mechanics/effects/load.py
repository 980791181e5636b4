"""A load in the plane: gravity on a tilted table, for instance."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

from planar_pushing.mechanics.arrays import same
from planar_pushing.mechanics.frames import Frame, components, moved_place
from planar_pushing.terms.domain import Number, required
from planar_pushing.terms.errors import InvalidValue
from planar_pushing.terms.numbers import pair_of


@dataclass(frozen=True, slots=True, kw_only=True)
class Load:
    """A constant force at a point of the slider: potential ``-g . v``, with v the point's velocity.

    Parameters
    ----------
    force : (x, y), of floats or arrays
        g, along and normal to the fence at time 0; its direction in the world is constant.
    center : (x, y), of floats or arrays, optional
        The point in the body frame; by default the center of mass, or without inertia the slider's center.

    Raises
    ------
    InvalidValue
        If the force or the center is not two finite numbers.
    """

    force: tuple[Number, Number]
    center: tuple[Number, Number] | None = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "force", _pair("force", self.force))
        if self.center is not None:
            object.__setattr__(self, "center", _pair("center", self.center))

    def __eq__(self, other: object) -> Any:
        return same(self, other)

    def moved(self, body: Frame, fence: Frame) -> Load:
        """The same effect, with force in the fence frame and center in the body frame."""
        force = components(fence.vector_in(self.force), fence)
        center = None if self.center is None else moved_place(self.center, body)
        return replace(self, force=force, center=center)

    @property
    def degree(self) -> int:
        return 1


def _pair(name: str, given: Any) -> tuple[Number, Number]:
    pair = pair_of(given)
    if pair is None:
        raise InvalidValue(name, given, "two finite numbers", "give its components along x and y")
    x, y = (required(f"load_{name}", each) for each in pair)
    return x, y
