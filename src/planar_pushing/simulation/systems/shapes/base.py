"""The interface of what pushes: at an instant a fence and a finger are one problem.

It is seen in the frame whose +y is the normal at the contact. A member is a module
of functions by the names below, whose first argument is the shape, a named tuple of numbers. The functions
choose by its kind, so a fence's equations hold nothing of a finger's.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from planar_pushing.mechanics.compiled import by_kind
from planar_pushing.mechanics.plane import Rod


class Pose(NamedTuple):
    """The slider as the contact sees it.

    Effects in the frame of the rod; the line from the contact to the slider's centre as a rod, and that to
    the centre of mass; and the way from the one centre to the other.
    """

    effects: Any
    own: Rod
    arm: Rod
    x: float
    y: float


#: Of each kind of shape, its module.
SHAPES: dict[type, Any] = {}
#: The shape with the numbers of a scene: shape, rod at time 0, start and end of the side.
made = by_kind(SHAPES, "made")
#: The `Pose`: shape, effects, body, rod, and place of the contact along and across.
pose = by_kind(SHAPES, "pose")
#: A vector of the world in the contact's frame, and back: shape, rod angle, x, y.
seen = by_kind(SHAPES, "seen")
shown = by_kind(SHAPES, "shown")
#: Rates of the contact's motion over the pusher, from its acceleration there; a frame that turns takes
#: Coriolis' part: shape, spin, slip, rise, and the acceleration along and across.
relative = by_kind(SHAPES, "relative")
#: Place of the slider's centre: shape, rod, rod angle, contact along and across, place of the pusher.
center = by_kind(SHAPES, "center")
#: Where a flight takes the contact, along and across: shape, rod, its place before, the ways of the
#: slider's centre and of the pusher, and the turn.
flown = by_kind(SHAPES, "flown")
#: Whether the pusher's motion is constant in the contact's frame while the slider moves: shape, span.
steady = by_kind(SHAPES, "steady")
#: Height of the contact over the pusher, infinite where the contact has ended for good: shape, body, gap.
clearance = by_kind(SHAPES, "clearance")
#: Margin of a slider that does not lie on the pusher, NaN where it never does: shape, body, angle, gap.
upright = by_kind(SHAPES, "upright")
#: Way from the contact to the nearer end of the side, negative beyond it, NaN without one: shape, along.
room = by_kind(SHAPES, "room")
