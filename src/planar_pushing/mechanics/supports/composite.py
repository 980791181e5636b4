"""Several supports that share the weight."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Any

from planar_pushing.mechanics.plane import Frame
from planar_pushing.mechanics.pressure.assembly import (
    join_pieces,
    scale_shares,
)
from planar_pushing.mechanics.pressure.pieces import Pieces
from planar_pushing.mechanics.supports.base import (
    InPieces,
    require_support,
    support_in_frame,
    weights,
)
from planar_pushing.mechanics.supports.even_ring import Ring
from planar_pushing.terms.declared import Read, replace_checked, require_declared
from planar_pushing.terms.errors import InvalidValue


def _members(name: str, value: Any) -> tuple[tuple[float, Any], ...]:
    """Shares and supports."""
    try:
        pairs = tuple((share, support) for share, support in value)
    except (TypeError, ValueError):
        pairs = ()
    if not pairs:
        raise InvalidValue(
            name, value, "at least one pair of a share and a support",
            "give for instance [(0.5, Disc(1.0)), (0.5, Points([(2.0, 0.0)], [1.0]))]",
        )  # fmt: skip
    for i, (_, support) in enumerate(pairs):
        if isinstance(require_support(f"{name}[{i}]", support), Ring) and support.radius is None:
            raise InvalidValue(
                name, Ring(), "a ring with a radius", "give the radius, as in Ring(1.0)"
            )
    shares = weights("share", [share for share, _ in pairs])
    return tuple((share, support) for share, (_, support) in zip(shares, pairs, strict=True))


MEMBERS = Read(
    _members, "pairs of a share of the weight and a support", {"type": "array", "minItems": 1}
)


@dataclass(frozen=True, slots=True)
class Composite(InPieces):
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

    members: Annotated[Any, MEMBERS]

    def __post_init__(self) -> None:
        require_declared(self)

    def in_frame(self, frame: Frame) -> Composite:
        """The same supports expressed in another frame."""
        members = ((share, support_in_frame(support, frame)) for share, support in self.members)
        return replace_checked(self, members=tuple(members))

    def pieces(self) -> Pieces:
        total = sum(share for share, _ in self.members)
        return join_pieces(
            [scale_shares(support.pieces(), share / total) for share, support in self.members]
        )
