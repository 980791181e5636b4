"""The points of a slider that can touch a fence, and the one that is its contact.

They are the corners of the outline and the rod's end, or both ends of a side that lies on the fence. The
contact is a body point that changes: where another point reaches the fence, the contact is the left end of
the side between them, and the other end is known, too. Points below the fence by less than the tolerance of
the outline are on it.
"""

from __future__ import annotations

from math import atan2, cos, fabs, sin
from typing import NamedTuple

from planar_pushing.core.instant.directions import nearest_integer
from planar_pushing.core.motion.system import (
    ELSEWHERE,
    RunState,
    System,
    candidate_of,
    copy_numbers,
    is_massive,
    vector_of,
)
from planar_pushing.core.numbers import INFINITY
from planar_pushing.core.supports.rows import NO_POINT, Position
from planar_pushing.core.supports.tolerances import RESOLUTION, SLACK

#: Tolerance of a side without an outline, in lengths of the side.
DEPTH_OF_SIDE = 1e-9
#: Two right angles.
HALF_TURN = 3.141592653589793


class Lowest(NamedTuple):
    """A point that can touch the fence, and its height above the fence."""

    point: int
    height: float


def count_points(system: System) -> int:
    """Number of the points that can touch a fence, 0 if only the rod's end can, and for a finger."""
    scene = system.scene
    if scene.finger:
        return 0
    corners = scene.corners
    if scene.flush:
        return corners + 2
    return corners + 1 if corners > 0 else 0


def point_position(system: System, point: int) -> Position:
    """A point in the body frame: the corners, then both ends of a flush side, or the rod's end."""
    scene, run = system.scene, system.run
    number = point - scene.corners
    if number < 0:
        corner = system.data[scene.corners_place + 2 * point :]
        return Position(corner[0] / scene.fine, corner[1] / scene.fine)
    along = 0.0
    if scene.flush:
        along = scene.side_start if number == 0 else scene.side_end
    return Position(along * run.rod.x - scene.length, -(along * run.rod.y))


def touch_tolerance(system: System) -> float:
    """Distance from the fence within which a point is on it."""
    scene = system.scene
    if scene.corners > 0:
        return 1.0 / scene.fine
    return DEPTH_OF_SIDE * (scene.side_end - scene.side_start)


def offset_of(system: System, state: RunState, point: int) -> Position:
    """Vector from the contact to a point, in the fence frame."""
    position, c, s = point_position(system, point), cos(state.angle), sin(state.angle)
    x, y = position.x - system.run.contact.x, position.y - system.run.contact.y
    return Position(x * c - y * s, x * s + y * c)


def lowest_point(system: System, state: RunState, others: bool) -> Lowest:
    """The lowest point, or the lowest of those apart from the contact; infinitely high without any."""
    run, slack = system.run, touch_tolerance(system)
    c, s = cos(state.angle), sin(state.angle)
    lowest, height = NO_POINT, INFINITY
    for point in range(count_points(system)):
        position = point_position(system, point)
        x, y = position.x - run.contact.x, position.y - run.contact.y
        counts: bool = not others or fabs(x) > slack or fabs(y) > slack
        if counts and x * s + y * c < height:
            lowest, height = point, x * s + y * c
    return Lowest(lowest, state.gap + height)


def height_above_pusher(system: System, state: RunState) -> float:
    """Height of the contact above the pusher; of several points that can touch, that of the lowest."""
    if count_points(system) == 0:
        return state.gap
    return lowest_point(system, state, False).height


def is_flush(system: System) -> bool:
    """Whether the contact is a side, from the contact's point to its other end."""
    return system.run.other_end >= 0


def side_length(system: System, state: RunState) -> float:
    """Place of the other end of the side that is the contact, along the fence; 0 at a point."""
    if not is_flush(system):
        return 0.0
    return offset_of(system, state, system.run.other_end).x


def move_contact(system: System, state: RunState, point: int) -> None:
    """Make a point the contact; the state is that of the same motion."""
    if point == system.run.point:
        return
    offset = offset_of(system, state, point)
    state.along += offset.x
    state.gap += offset.y
    if is_massive(system):
        state.slip_speed -= state.spin * offset.y
        state.normal_speed += state.spin * offset.x
    put_contact(system, point, NO_POINT)


def put_contact(system: System, point: int, other_end: int) -> None:
    """Store the contact and its other end, but not the state there; without a point, the rod's end."""
    run, position = system.run, Position(-system.scene.length, 0.0)
    if point >= 0:
        position = point_position(system, point)
    run.contact.x, run.contact.y = position.x, position.y
    run.point, run.other_end = point, other_end


def hold_contact(system: System, state: RunState, point: int, other_end: int) -> None:
    """Make a point on the fence, or a side from it to its other end, the contact."""
    if point != system.run.point:
        move_contact(system, state, point)
        state.gap = 0.0
    system.run.other_end = other_end


def hold_candidate(system: System, state: RunState, index: int) -> None:
    """Make the contact of a candidate mode the contact."""
    candidate = candidate_of(system, index)
    if count_points(system) > 0:
        hold_contact(system, state, candidate.point, candidate.other_end)


def leave_side(system: System, index: int) -> None:
    """Let a candidate mode have its point as the contact, without a side."""
    candidate = candidate_of(system, index)
    candidate.other_end = NO_POINT


def name_contact(system: System, state: RunState) -> None:
    """Let the contact at time 0 be one of the points: the rod's end, or the start of a side."""
    if count_points(system) > 0:
        move_contact(system, state, system.scene.corners)
        state.gap = system.scene.gap


def state_at_candidate(system: System, state: RunState, index: int) -> RunState:
    """The state at the contact of a candidate mode, which becomes the contact; the state is not changed."""
    if count_points(system) == 0:
        return state
    elsewhere = vector_of(system, ELSEWHERE)
    copy_numbers(elsewhere, state, system.entries)
    hold_candidate(system, elsewhere, index)
    return elsewhere


def take_lowest_point(system: System, state: RunState) -> None:
    """Make the lowest of the points that can touch the contact, unless the contact touches."""
    if state.gap > SLACK and count_points(system) > 0:
        move_contact(system, state, lowest_point(system, state, False).point)


def land_on_fence(system: System, state: RunState) -> None:
    """Close the contact, at the lowest point."""
    take_lowest_point(system, state)
    state.gap = 0.0


def settle_on_fence(system: System, state: RunState, slack: float) -> None:
    """Make a side that lies on the fence the contact, and set it exactly on the fence.

    With inertia it lies there if the normal speeds of its ends are at most `slack`, in units of the typical
    speed; a side that arrives has collided before.
    """
    run = system.run
    run.other_end, run.floor = NO_POINT, 0.0
    if count_points(system) == 0:
        return
    lowest = lowest_point(system, state, False).height
    if lowest <= SLACK:
        if state.gap > SLACK:
            land_on_fence(system, state)
        left, right = side_on_fence(system, state)
        if left >= 0 and _rests_on_side(system, state, left, right, slack):
            _level_side(system, state, left, right)
    run.floor = min(lowest_point(system, state, False).height, 0.0)


def side_on_fence(system: System, state: RunState) -> tuple[int, int]:
    """The first and the last of the points on the fence, -1 if they are one point."""
    left, right, first, last = NO_POINT, NO_POINT, INFINITY, -INFINITY
    slack = touch_tolerance(system)
    for point in range(count_points(system)):
        offset = offset_of(system, state, point)
        if fabs(state.gap + offset.y) <= slack:
            if offset.x < first:
                left, first = point, offset.x
            if offset.x > last:
                right, last = point, offset.x
    if last - first > 2.0 * slack:
        return left, right
    return NO_POINT, NO_POINT


def approach_of(system: System, state: RunState) -> float:
    """Smallest normal velocity, relative to the fence, of the points on it, with inertia."""
    left, right = side_on_fence(system, state)
    if left < 0:
        return state.normal_speed
    start, end = offset_of(system, state, left).x, offset_of(system, state, right).x
    return state.normal_speed + min(state.spin * start, state.spin * end)


def _rests_on_side(system: System, state: RunState, left: int, right: int, slack: float) -> bool:
    """Whether a side on the fence stays there: without inertia, or if both of its ends move along it."""
    if not is_massive(system):
        return True
    start, end = offset_of(system, state, left).x, offset_of(system, state, right).x
    first, last = state.normal_speed + state.spin * start, state.normal_speed + state.spin * end
    return max(fabs(first), fabs(last)) <= slack * system.run.speed


def _level_side(system: System, state: RunState, left: int, right: int) -> None:
    """Make a side the contact, exactly parallel to the fence and without rotation."""
    hold_contact(system, state, left, right)
    start, end = point_position(system, left), point_position(system, right)
    angle = -atan2(end.y - start.y, end.x - start.x)
    angle += 2.0 * HALF_TURN * nearest_integer((state.angle - angle) / (2.0 * HALF_TURN))
    # An angle that is exact to rounding stays as it is.
    if fabs(angle - state.angle) > RESOLUTION * (1.0 + fabs(angle)):
        state.angle = angle
    state.gap = 0.0
    if is_massive(system):
        state.normal_speed, state.spin = 0.0, 0.0
