"""The interface of the pusher shapes: at an instant, a fence and a finger pose the same problem.

Quantities are in the contact frame, with +y along the normal at the contact. Each shape is a module with
the functions named below, whose first argument is the shape, a named tuple of numbers. Functions are
selected by its kind, so that the equations for a fence contain no code for a finger.
"""

from __future__ import annotations

from typing import Any

from planar_pushing.simulation.legacy.compiled import by_kind

#: Module of each kind of shape.
SHAPES: dict[type, Any] = {}
#: Shape with the numbers of a scene: shape, l / R and rod angle at time 0, start and end of the side, and
#: radius of the finger.
made = by_kind(SHAPES, "made")
#: Angle of body x in the contact frame: shape, rod angle.
frame_angle = by_kind(SHAPES, "frame_angle")
#: The `Pose`: shape, body, direction of body x, and position of the contact along and across.
pose = by_kind(SHAPES, "pose")
#: Transformations of a vector from the world to the contact frame, and back: shape, rod angle, x, y.
seen = by_kind(SHAPES, "seen")
shown = by_kind(SHAPES, "shown")
#: Rate of the contact's position along the pusher; a finger also rolls: shape, slip, spin.
travel = by_kind(SHAPES, "travel")
#: Rates of the contact's velocity relative to the pusher, from its relative acceleration. They include the
#: Coriolis term of a rotating frame, and a term for the travel of a rolling contact: shape, spin, slip,
#: rise, and the acceleration along and across.
relative = by_kind(SHAPES, "relative")
#: Acceleration of the slider's point at a contact that sticks, from the pusher's: shape, spin, x, y.
pinned = by_kind(SHAPES, "pinned")
#: Position of the slider's center: shape, rod angle, pose, contact along and across, pusher's position.
center = by_kind(SHAPES, "center")
#: Position of the contact after a flight, along and across: shape, pose, its position before, displacements
#: of the slider's center and of the pusher, and the rotation.
flown = by_kind(SHAPES, "flown")
#: Whether the pusher's motion is constant in the contact frame while the slider moves: shape, span.
steady = by_kind(SHAPES, "steady")
#: Height of the contact above the pusher, infinite if the contact has ended permanently: shape, body, gap.
clearance = by_kind(SHAPES, "clearance")
#: Height of the slider's center above the pusher, relative to the rod; NaN if not limited: shape, body,
#: angle, gap.
upright = by_kind(SHAPES, "upright")
#: Store the part of the side on which a finger meets no other point of the outline, about the contact:
#: shape, body, corners, contact along.
confine = by_kind(SHAPES, "confine")
#: Distance of the outline from the pusher in units of its tolerance, positive until another point than the
#: contact is as deep as the tolerance; for a finger in contact, the distance along the side to such a
#: meeting. NaN without an outline: shape, body, corners, angle, contact along, gap, whether it touches.
height = by_kind(SHAPES, "height")
#: Longest step of a free pusher that cannot pass through a part of the outline: shape, body, height, speed
#: relative to the slider.
stride = by_kind(SHAPES, "stride")
#: Distance from the contact to the nearer end of the side, negative beyond it, NaN for a side without ends.
room = by_kind(SHAPES, "room")
