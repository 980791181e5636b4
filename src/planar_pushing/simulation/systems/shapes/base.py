"""The interface of what pushes: at an instant a fence and a finger are one problem.

It is seen in the frame whose +y is the normal at the contact. A member is a module
of functions by the names below, whose first argument is the shape, a named tuple of numbers. The functions
choose by its kind, so a fence's equations hold nothing of a finger's.
"""

from __future__ import annotations

from typing import Any

from planar_pushing.mechanics.compiled import by_kind

#: Of each kind of shape, its module.
SHAPES: dict[type, Any] = {}
#: The shape with the numbers of a scene: shape, l / R and rod angle at time 0, start and end of the side,
#: and radius of the finger.
made = by_kind(SHAPES, "made")
#: Angle of body x in the contact's frame: shape, rod angle.
frame_angle = by_kind(SHAPES, "frame_angle")
#: The `Pose`: shape, body, direction of body x, and position of the contact along and across.
pose = by_kind(SHAPES, "pose")
#: A vector of the world in the contact's frame, and back: shape, rod angle, x, y.
seen = by_kind(SHAPES, "seen")
shown = by_kind(SHAPES, "shown")
#: Rate of the contact's position along the pusher; a finger also rolls: shape, slip, spin.
travel = by_kind(SHAPES, "travel")
#: Rates of the contact's motion over the pusher, from its acceleration there; a frame that turns takes
#: Coriolis' part, and a contact that rolls on that of its own travel: shape, spin, slip, rise, and the
#: acceleration along and across.
relative = by_kind(SHAPES, "relative")
#: Acceleration of the slider's point at a contact that sticks, from the pusher's: shape, spin, x, y.
pinned = by_kind(SHAPES, "pinned")
#: Position of the slider's center: shape, rod angle, pose, contact along and across, pusher's position.
center = by_kind(SHAPES, "center")
#: Where a flight takes the contact, along and across: shape, pose, its position before, displacements of
#: the slider's center and of the pusher, and the turn.
flown = by_kind(SHAPES, "flown")
#: Whether the pusher's motion is constant in the contact's frame while the slider moves: shape, span.
steady = by_kind(SHAPES, "steady")
#: Height of the contact over the pusher, infinite where the contact has ended for good: shape, body, gap.
clearance = by_kind(SHAPES, "clearance")
#: Margin of a slider that does not lie on the pusher, NaN where it never does: shape, body, angle, gap.
upright = by_kind(SHAPES, "upright")
#: Height of the outline over the pusher, in its tolerances, plus one: positive where it is above it. NaN
#: where there is no outline, or it is not a matter of height: shape, body, corners, angle, gap.
height = by_kind(SHAPES, "height")
#: Distance from the contact to the nearer end of the side, negative beyond it, NaN without one.
room = by_kind(SHAPES, "room")
