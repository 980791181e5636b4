"""The points of a slider that can touch a fence, and the one that is its contact.

They are the corners of the outline and the rod's end, or both ends of a side that lies on the fence. The
contact is a body point that changes: where another point reaches the fence, the contact is the left end of
the side between them, and the other end is known, too. Points below the fence by less than the tolerance of
the outline are on it.
"""

from __future__ import annotations

from math import atan2, cos, fabs, sin
from typing import NamedTuple

from planar_pushing.core.directions import nearest_integer
from planar_pushing.core.numbers import INFINITY, Numbers
from planar_pushing.core.rows import NO_POINT, Position
from planar_pushing.core.run import (
    IN_CORNERS,
    IN_CORNERS_PLACE,
    IN_FINE,
    IN_FINGER,
    IN_FLUSH,
    IN_GAP,
    IN_LENGTH,
    IN_SIDE_END,
    IN_SIDE_START,
    RUN_CONTACT,
    RUN_FLOOR,
    RUN_OTHER_END,
    RUN_POINT,
    RUN_ROD,
    RUN_SPEED,
)
from planar_pushing.core.system import (
    ALONG,
    ANGLE,
    CANDIDATE,
    ELSEWHERE,
    GAP,
    NORMAL_SPEED,
    SLIP_SPEED,
    SPIN,
    System,
    copy_numbers,
    is_massive,
    vector_of,
)
from planar_pushing.core.tolerances import RESOLUTION, SLACK

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
    if scene[IN_FINGER] != 0.0:
        return 0
    corners = int(scene[IN_CORNERS])
    if scene[IN_FLUSH] != 0.0:
        return corners + 2
    return corners + 1 if corners > 0 else 0


def point_position(system: System, point: int) -> Position:
    """A point in the body frame: the corners, then both ends of a flush side, or the rod's end."""
    scene, run = system.scene, system.run
    number = point - int(scene[IN_CORNERS])
    if number < 0:
        corner = system.data[int(scene[IN_CORNERS_PLACE]) + 2 * point :]
        return Position(corner[0] / scene[IN_FINE], corner[1] / scene[IN_FINE])
    along = 0.0
    if scene[IN_FLUSH] != 0.0:
        along = scene[IN_SIDE_START] if number == 0 else scene[IN_SIDE_END]
    return Position(along * run[RUN_ROD] - scene[IN_LENGTH], -(along * run[RUN_ROD + 1]))


def touch_tolerance(system: System) -> float:
    """Distance from the fence within which a point is on it."""
    scene = system.scene
    if scene[IN_CORNERS] > 0.0:
        return 1.0 / scene[IN_FINE]
    return DEPTH_OF_SIDE * (scene[IN_SIDE_END] - scene[IN_SIDE_START])


def offset_of(system: System, state: Numbers, point: int) -> Position:
    """Vector from the contact to a point, in the fence frame."""
    position, c, s = point_position(system, point), cos(state[ANGLE]), sin(state[ANGLE])
    x, y = position.x - system.run[RUN_CONTACT], position.y - system.run[RUN_CONTACT + 1]
    return Position(x * c - y * s, x * s + y * c)


def lowest_point(system: System, state: Numbers, others: bool) -> Lowest:
    """The lowest point, or the lowest of those apart from the contact; infinitely high without any."""
    run, slack = system.run, touch_tolerance(system)
    c, s = cos(state[ANGLE]), sin(state[ANGLE])
    lowest, height = NO_POINT, INFINITY
    for point in range(count_points(system)):
        position = point_position(system, point)
        x, y = position.x - run[RUN_CONTACT], position.y - run[RUN_CONTACT + 1]
        counts: bool = not others or fabs(x) > slack or fabs(y) > slack
        if counts and x * s + y * c < height:
            lowest, height = point, x * s + y * c
    return Lowest(lowest, state[GAP] + height)


def height_above_pusher(system: System, state: Numbers) -> float:
    """Height of the contact above the pusher; of several points that can touch, that of the lowest."""
    if count_points(system) == 0:
        return state[GAP]
    return lowest_point(system, state, False).height


def is_flush(system: System) -> bool:
    """Whether the contact is a side, from the contact's point to its other end."""
    return system.run[RUN_OTHER_END] >= 0.0


def side_length(system: System, state: Numbers) -> float:
    """Place of the other end of the side that is the contact, along the fence; 0 at a point."""
    if not is_flush(system):
        return 0.0
    return offset_of(system, state, int(system.run[RUN_OTHER_END])).x


def move_contact(system: System, state: Numbers, point: int) -> None:
    """Make a point the contact; the state is that of the same motion."""
    if float(point) == system.run[RUN_POINT]:
        return
    offset = offset_of(system, state, point)
    state[ALONG] += offset.x
    state[GAP] += offset.y
    if is_massive(system):
        state[SLIP_SPEED] -= state[SPIN] * offset.y
        state[NORMAL_SPEED] += state[SPIN] * offset.x
    put_contact(system, point, NO_POINT)


def put_contact(system: System, point: int, other_end: int) -> None:
    """Store the contact and its other end, but not the state there; without a point, the rod's end."""
    run, position = system.run, Position(-system.scene[IN_LENGTH], 0.0)
    if point >= 0:
        position = point_position(system, point)
    run[RUN_CONTACT], run[RUN_CONTACT + 1] = position.x, position.y
    run[RUN_POINT], run[RUN_OTHER_END] = float(point), float(other_end)


def hold_contact(system: System, state: Numbers, point: int, other_end: int) -> None:
    """Make a point on the fence, or a side from it to its other end, the contact."""
    if float(point) != system.run[RUN_POINT]:
        move_contact(system, state, point)
        state[GAP] = 0.0
    system.run[RUN_OTHER_END] = float(other_end)


def hold_candidate(system: System, state: Numbers, index: int) -> None:
    """Make the contact of a candidate mode the contact."""
    numbers = system.candidates[index * CANDIDATE :]
    if count_points(system) > 0:
        hold_contact(system, state, int(numbers[7]), int(numbers[8]))


def leave_side(system: System, index: int) -> None:
    """Let a candidate mode have its point as the contact, without a side."""
    numbers = system.candidates[index * CANDIDATE :]
    numbers[8] = float(NO_POINT)


def name_contact(system: System, state: Numbers) -> None:
    """Let the contact at time 0 be one of the points: the rod's end, or the start of a side."""
    if count_points(system) > 0:
        move_contact(system, state, int(system.scene[IN_CORNERS]))
        state[GAP] = system.scene[IN_GAP]


def state_at_candidate(system: System, state: Numbers, index: int) -> Numbers:
    """The state at the contact of a candidate mode, which becomes the contact; the state is not changed."""
    if count_points(system) == 0:
        return state
    elsewhere = vector_of(system, ELSEWHERE)
    copy_numbers(elsewhere, state, system.entries)
    hold_candidate(system, elsewhere, index)
    return elsewhere


def take_lowest_point(system: System, state: Numbers) -> None:
    """Make the lowest of the points that can touch the contact, unless the contact touches."""
    if state[GAP] > SLACK and count_points(system) > 0:
        move_contact(system, state, lowest_point(system, state, False).point)


def land_on_fence(system: System, state: Numbers) -> None:
    """Close the contact, at the lowest point."""
    take_lowest_point(system, state)
    state[GAP] = 0.0


def settle_on_fence(system: System, state: Numbers, slack: float) -> None:
    """Make a side that lies on the fence the contact, and set it exactly on the fence.

    With inertia it lies there if the normal speeds of its ends are at most `slack`, in units of the typical
    speed; a side that arrives has collided before.
    """
    run = system.run
    run[RUN_OTHER_END], run[RUN_FLOOR] = float(NO_POINT), 0.0
    if count_points(system) == 0:
        return
    lowest = lowest_point(system, state, False).height
    if lowest <= SLACK:
        if state[GAP] > SLACK:
            land_on_fence(system, state)
        left, right = side_on_fence(system, state)
        if left >= 0 and _rests_on_side(system, state, left, right, slack):
            _level_side(system, state, left, right)
    run[RUN_FLOOR] = min(lowest_point(system, state, False).height, 0.0)


def side_on_fence(system: System, state: Numbers) -> tuple[int, int]:
    """The first and the last of the points on the fence, -1 if they are one point."""
    left, right, first, last = NO_POINT, NO_POINT, INFINITY, -INFINITY
    slack = touch_tolerance(system)
    for point in range(count_points(system)):
        offset = offset_of(system, state, point)
        if fabs(state[GAP] + offset.y) <= slack:
            if offset.x < first:
                left, first = point, offset.x
            if offset.x > last:
                right, last = point, offset.x
    if last - first > 2.0 * slack:
        return left, right
    return NO_POINT, NO_POINT


def approach_of(system: System, state: Numbers) -> float:
    """Smallest normal velocity, relative to the fence, of the points on it, with inertia."""
    left, right = side_on_fence(system, state)
    if left < 0:
        return state[NORMAL_SPEED]
    start, end = offset_of(system, state, left).x, offset_of(system, state, right).x
    return state[NORMAL_SPEED] + min(state[SPIN] * start, state[SPIN] * end)


def _rests_on_side(system: System, state: Numbers, left: int, right: int, slack: float) -> bool:
    """Whether a side on the fence stays there: without inertia, or if both of its ends move along it."""
    if not is_massive(system):
        return True
    start, end = offset_of(system, state, left).x, offset_of(system, state, right).x
    first, last = state[NORMAL_SPEED] + state[SPIN] * start, state[NORMAL_SPEED] + state[SPIN] * end
    return max(fabs(first), fabs(last)) <= slack * system.run[RUN_SPEED]


def _level_side(system: System, state: Numbers, left: int, right: int) -> None:
    """Make a side the contact, exactly parallel to the fence and without rotation."""
    hold_contact(system, state, left, right)
    start, end = point_position(system, left), point_position(system, right)
    angle = -atan2(end.y - start.y, end.x - start.x)
    angle += 2.0 * HALF_TURN * nearest_integer((state[ANGLE] - angle) / (2.0 * HALF_TURN))
    # An angle that is exact to rounding stays as it is.
    if fabs(angle - state[ANGLE]) > RESOLUTION * (1.0 + fabs(angle)):
        state[ANGLE] = angle
    state[GAP] = 0.0
    if is_massive(system):
        state[NORMAL_SPEED], state[SPIN] = 0.0, 0.0
