"""Supports on one line: segments and points, which leave some motions open."""

from __future__ import annotations

from flint import arb

from planar_pushing.certified.potential.push import Push, ball
from planar_pushing.certified.supports.pressure.moments import Vector
from planar_pushing.certified.supports.pressure.pieces import Pieces, Place


def line_ends(support: Pieces) -> tuple[Place, Place] | None:
    """Ends of a support that is on one line; None of others and of a single point."""
    if support.rings or support.discs or support.edges:
        return None
    places = [each.place for each in support.points]
    places += [end for each in support.segments for end in (each.start, each.end)]
    first, last = (extreme(places, key=tuple) for extreme in (min, max))
    run = last[0] - first[0], last[1] - first[1]
    apart = (run[0] * (y - first[1]) - run[1] * (x - first[0]) for x, y in places)
    return None if first == last or any(apart) else (first, last)


def crossed(push: Push) -> tuple[Place, Place] | None:
    """Ends of a support on one line that the force meets at a right angle."""
    ends = line_ends(push.support)
    if ends is None:
        return None
    (a, b), (c, d) = ends
    return None if push.along((c - a, d - b)) else ends


def center_beyond(push: Push) -> Vector | None:
    """Center of rotation of a contact that moves along t, where it is on the support's line at a corner.

    It is the place across t from the contact, if that is not between the support's ends.
    """
    ends = line_ends(push.support)
    if ends is None:
        return None
    (a, b), (c, d) = ends
    x, y = push.support.center
    if (x + push.length) * (c - a) + y * (d - b) != 0:
        return None
    sides = [push.along((end[0] + push.length, end[1])) for end in ends]
    if sides[0] * sides[1] < 0 or sides == [0, 0]:
        return None
    near, far = push.reach(ball(ends[0])), push.reach(ball(ends[1]))
    part = arb(1 - (sides[0] == 0)) if 0 in sides else near / (near - far)
    return a + part * (c - a), b + part * (d - b)
