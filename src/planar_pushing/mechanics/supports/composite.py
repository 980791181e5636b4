"""Several supports that share the weight."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from planar_pushing.mechanics.frames import Frame
from planar_pushing.mechanics.pictures import Pictured
from planar_pushing.mechanics.pressure.assembly import (
    center,
    extent,
    joined,
    shared,
)
from planar_pushing.mechanics.pressure.pieces import Pieces
from planar_pushing.mechanics.supports.base import Position, is_kind, moved_support, weights
from planar_pushing.mechanics.supports.even_ring import Ring
from planar_pushing.terms.errors import InvalidValue


@dataclass(frozen=True, slots=True)
class Composite(Pictured):
    """Support made of other supports in one body frame.

    Parameters
    ----------
    members : sequence of (share, support)
        Each support with its share of the weight, > 0, in any unit.

    Raises
    ------
    InvalidValue
        If there is no member, a share is not positive, a member is not a support, or a ring has no radius.
    """

    members: Any

    def __post_init__(self) -> None:
        try:
            pairs = tuple((share, support) for share, support in self.members)
        except (TypeError, ValueError):
            pairs = ()
        kinds: list[Any] = [type(support) for _, support in pairs]
        if not pairs or not all(map(is_kind, kinds)):
            raise InvalidValue(
                "members", self.members, "at least one pair of a share and a support",
                "give for instance [(0.5, Disc(1.0)), (0.5, Points([(2.0, 0.0)], [1.0]))]",
            )  # fmt: skip
        if any(isinstance(each, Ring) and each.radius is None for _, each in pairs):
            raise InvalidValue(
                "members", Ring(), "a ring with a radius", "give the radius, as in Ring(1.0)"
            )
        shares = weights("share", [share for share, _ in pairs], len(pairs), "give one for each")
        members = tuple((share, support) for share, (_, support) in zip(shares, pairs, strict=True))
        object.__setattr__(self, "members", members)

    @property
    def center_of_pressure(self) -> Position:
        return center(self.pieces())

    @property
    def extent(self) -> float:
        return extent(self.pieces())

    def moved(self, frame: Frame) -> Composite:
        """The same supports expressed in another frame."""
        return Composite([(share, moved_support(each, frame)) for share, each in self.members])

    def pieces(self) -> Pieces:
        whole = sum(share for share, _ in self.members)
        return joined([shared(support.pieces(), share / whole) for share, support in self.members])
