"""Whether a support is symmetric about the rod."""

from __future__ import annotations

from typing import Any

from flint import fmpq

from planar_pushing.certified.supports.pressure.pieces import Pieces, Place


def is_mirrored(support: Pieces) -> bool:
    """Whether a support equals its mirror image in the x axis."""
    return _loads(support) == _loads(support, flip=-1)


def _loads(support: Pieces, flip: int = 1) -> dict[tuple[Any, ...], fmpq]:
    """Shares by the kinds and places of the pieces, with y times `flip`.

    An edge counts in the direction that has the pressure on its left; a reflection reverses it.
    """

    def at(place: Place) -> tuple[str, str]:
        return str(place[0]), str(flip * place[1])

    found: dict[tuple[Any, ...], fmpq] = {
        ("point", at(each.place)): each.share for each in support.points
    }
    for kind, circles in (("ring", support.rings), ("disc", support.discs)):
        found |= {(kind, at(each.center), str(each.radius)): each.share for each in circles}
    for line in support.segments:
        found["segment", *sorted((at(line.start), at(line.end)))] = line.share
    for line in support.edges:
        ends = at(line.start), at(line.end)
        first, last = sorted(ends)
        found["edge", first, last] = line.share * (1 if ends == (first, last) else -1) * flip
    return found
