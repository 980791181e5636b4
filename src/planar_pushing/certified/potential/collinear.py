"""Supports on a line, made of segments and points, for which some motions are not unique."""

from __future__ import annotations

from flint import arb

from planar_pushing.certified.potential.push import Push, ball
from planar_pushing.certified.supports.pressure.moments import Vector
from planar_pushing.certified.supports.pressure.pieces import Pieces, Place


def line_ends(support: Pieces) -> tuple[Place, Place] | None:
    """Ends of a support that lies on a line; None for other supports and for a single point."""
    if support.rings or support.discs or support.edges:
        return None
    places = [each.place for each in support.points]
    places += [end for each in support.segments for end in (each.start, each.end)]
    first, last = (extreme(places, key=tuple) for extreme in (min, max))
    run = last[0] - first[0], last[1] - first[1]
    apart = (run[0] * (y - first[1]) - run[1] * (x - first[0]) for x, y in places)
    return None if first == last or any(apart) else (first, last)


def crossed(push: Push) -> tuple[Place, Place] | None:
    """Ends of a support on a line that the line of force crosses at a right angle."""
    ends = line_ends(push.support)
    if ends is None:
        return None
    (a, b), (c, d) = ends
    return None if push.along((c - a, d - b)) else ends


def center_beyond(push: Push) -> Vector | None:
    """Center of rotation if the contact moves along t and the center is on the support's line at a corner.

    It is the point across t from the contact, provided that it is not between the ends of the support.
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
