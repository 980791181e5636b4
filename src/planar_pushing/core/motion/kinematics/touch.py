"""The points of a slider that can touch a fence, and the one that is its contact.

They are the corners and the arcs of the outline, and the rod's end or both ends of a side that lies on the
fence, unless these are places of the outline. The point of an arc is the one at which it is parallel to the
fence, or else the end of a side beside it. The contact is a point that changes: where another point reaches
the fence, the contact is the left end of the side between them, and the other end is known, too. Points
below the fence by less than the tolerance of the outline are on it.
"""

from __future__ import annotations

from math import atan2, cos, fabs, sin
from typing import NamedTuple

from planar_pushing.core.instant.directions import nearest_integer
from planar_pushing.core.motion.kinematics.rolling import contact_in_body
from planar_pushing.core.motion.kinematics.run import Inputs
from planar_pushing.core.motion.kinematics.system import (
    RunState,
    System,
    candidate_of,
    is_massive,
)
from planar_pushing.core.numbers import INFINITY
from planar_pushing.core.supports.chain import (
    FULL_TURN,
    ChainPiece,
    chain_piece,
    is_inner_corner,
    is_side,
)
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
    if scene.flush:
        return scene.chain + 2
    if scene.chain == 0:
        return 0
    return scene.chain if begins_on_round(system) else scene.chain + 1


def begins_on_round(system: System) -> bool:
    """Whether the contact at time 0 is a corner or on an arc of the outline."""
    scene = system.scene
    return scene.wall >= 0 and not scene.flush and _is_round(_piece_of(system, scene.wall))


def _piece_of(system: System, number: int) -> ChainPiece:
    """A piece of the outline."""
    return chain_piece(system.data[system.scene.chain_place :], number)


def _is_round(piece: ChainPiece) -> bool:
    """Whether a piece is an outer corner or an arc that is not hollow."""
    return 0.0 <= piece.radius < INFINITY and not is_inner_corner(piece)


def direction_under(system: System, piece: ChainPiece, state: RunState) -> float:
    """Direction of the tangent at which a piece is parallel to the fence, nearest to its directions."""
    middle = (piece.first + piece.last) / 2.0
    apart = system.scene.turn - state.angle - middle
    return middle + (apart - FULL_TURN * nearest_integer(apart / FULL_TURN))


def direction_on_arc(system: System, piece: ChainPiece, state: RunState) -> float:
    """Direction of the tangent of an arc at its point that can touch the fence."""
    return min(max(direction_under(system, piece, state), piece.first), piece.last)


def can_touch(system: System, point: int, state: RunState) -> bool:
    """Whether a point can touch the fence; a side cannot, and the end of an arc only beside a side."""
    if point >= system.scene.chain:
        return True
    piece = _piece_of(system, point)
    if not _is_round(piece):
        return False
    if piece.radius == 0.0 or piece.next == point:
        return True
    direction = direction_under(system, piece, state)
    if piece.first <= direction <= piece.last:
        return True
    return is_side(_piece_of(system, piece.next if direction > piece.last else piece.before))


def point_position(system: System, point: int, state: RunState) -> Position:
    """A point in the body frame: of the outline, then both ends of a flush side, or the rod's end."""
    scene = system.scene
    number = point - scene.chain
    if number < 0:
        piece = _piece_of(system, point)
        x, y = piece.x, piece.y
        if piece.radius > 0.0:
            direction = direction_on_arc(system, piece, state)
            x, y = x + piece.radius * sin(direction), y - piece.radius * cos(direction)
        return position_in_body(scene, x, y)
    return end_position(system, number)


def end_position(system: System, number: int) -> Position:
    """An end of a flush side, or the rod's end, in the body frame."""
    scene, rod, along = system.scene, system.run.rod, 0.0
    if scene.flush:
        along = scene.side_start if number == 0 else scene.side_end
    return Position(along * rod.x - scene.length, -(along * rod.y))


def position_in_body(scene: Inputs, x: float, y: float) -> Position:
    """A position in the frame of the outline, in units of its tolerance, in the body frame."""
    x, y = x - scene.frame.x, y - scene.frame.y
    return Position(
        (x * scene.axis.x + y * scene.axis.y) / scene.fine,
        (y * scene.axis.x - x * scene.axis.y) / scene.fine,
    )


def touch_tolerance(system: System) -> float:
    """Distance from the fence within which a point is on it."""
    scene = system.scene
    if scene.chain > 0:
        return 1.0 / scene.fine
    return DEPTH_OF_SIDE * (scene.side_end - scene.side_start)


def offset_of(system: System, state: RunState, point: int) -> Position:
    """Vector from the contact to a point, in the fence frame."""
    position, c, s = point_position(system, point, state), cos(state.angle), sin(state.angle)
    c_x, c_y = contact_in_body(system, state, c, s)
    x, y = position.x - c_x, position.y - c_y
    return Position(x * c - y * s, x * s + y * c)


class FenceLine(NamedTuple):
    """The normal of a fence, and the contact, in the frame of the outline and in units of its tolerance."""

    n_x: float
    n_y: float
    x: float
    y: float


def fence_line(system: System, state: RunState) -> FenceLine:
    """The fence in the frame of the outline, so that its pieces need not be moved to the body frame."""
    scene, c, s = system.scene, cos(state.angle), sin(state.angle)
    c_x, c_y = contact_in_body(system, state, c, s)
    a_x, a_y, fine = scene.axis.x, scene.axis.y, scene.fine
    x = scene.frame.x + fine * (c_x * a_x - c_y * a_y)
    y = scene.frame.y + fine * (c_x * a_y + c_y * a_x)
    return FenceLine(s * a_x - c * a_y, s * a_y + c * a_x, x, y)


def offset_over(system: System, fence: FenceLine, point: int, state: RunState) -> Position:
    """As `offset_of`, to rounding, for one of many points over the same fence."""
    scene = system.scene
    if point >= scene.chain:
        return offset_of(system, state, point)
    piece = _piece_of(system, point)
    x, y = piece.x - fence.x, piece.y - fence.y
    if piece.radius > 0.0:
        direction = direction_on_arc(system, piece, state)
        x, y = x + piece.radius * sin(direction), y - piece.radius * cos(direction)
    across, up = x * fence.n_y - y * fence.n_x, x * fence.n_x + y * fence.n_y
    return Position(across / scene.fine, up / scene.fine)


def lowest_point(system: System, state: RunState, others: bool) -> Lowest:
    """The lowest point, or the lowest of those apart from the contact; infinitely high without any."""
    fence, lowest, height = fence_line(system, state), NO_POINT, INFINITY
    count, chain, slack = count_points(system), system.scene.chain, touch_tolerance(system)
    pieces = system.data[system.scene.chain_place :]
    for point in range(min(count, chain)):
        piece = chain_piece(pieces, point)
        if not 0.0 <= piece.radius < INFINITY:
            continue
        x, y = piece.x - fence.x, piece.y - fence.y
        # Most pieces are higher, also if they are parallel to the fence.
        if x * fence.n_x + y * fence.n_y - piece.radius >= height:
            continue
        if not can_touch(system, point, state):
            continue
        if piece.radius > 0.0:
            direction = direction_on_arc(system, piece, state)
            x, y = x + piece.radius * sin(direction), y - piece.radius * cos(direction)
        up = x * fence.n_x + y * fence.n_y
        if up < height and (not others or fabs(x) > 1.0 or fabs(y) > 1.0):
            lowest, height = point, up
    if lowest >= 0:
        height = offset_of(system, state, lowest).y
    for point in range(chain, count):
        offset = offset_of(system, state, point)
        counts: bool = not others or fabs(offset.x) > slack or fabs(offset.y) > slack
        if counts and offset.y < height:
            lowest, height = point, offset.y
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
    hold_end_of_arc(system, state)


def hold_end_of_arc(system: System, state: RunState) -> None:
    """Let the end of an arc be a corner while the arc itself is not parallel to the fence.

    In steps, the far end of a side can touch the fence before the side lies there.
    """
    scene, run = system.scene, system.run
    if scene.finger or run.wall.radius == 0.0 or not 0 <= run.point < scene.chain:
        return
    piece = _piece_of(system, run.point)
    if piece.next == run.point:
        return
    end = direction_on_arc(system, piece, state)
    if piece.radius * fabs(direction_under(system, piece, state) - end) > 1.0:
        x, y = piece.x + piece.radius * sin(end), piece.y - piece.radius * cos(end)
        position = position_in_body(scene, x, y)
        run.contact.x, run.contact.y, run.wall.radius = position.x, position.y, 0.0


def renew_contact(system: System, state: RunState) -> None:
    """Let the contact be its point again, after the motion of a step, without a side."""
    c, s = cos(state.angle), sin(state.angle)
    old_x, old_y = contact_in_body(system, state, c, s)
    put_contact(system, system.run.point, NO_POINT)
    hold_end_of_arc(system, state)
    new_x, new_y = contact_in_body(system, state, c, s)
    state.along += (new_x - old_x) * c - (new_y - old_y) * s


def put_contact(system: System, point: int, other_end: int) -> None:
    """Store the contact and its other end, but not the state there; without a point, the rod's end.

    Of an arc its center and its radius are stored.
    """
    scene, run = system.scene, system.run
    position, radius = Position(-scene.length, 0.0), 0.0
    if 0 <= point < scene.chain:
        piece = _piece_of(system, point)
        position, radius = position_in_body(scene, piece.x, piece.y), piece.radius / scene.fine
    elif point >= 0:
        position = end_position(system, point - scene.chain)
    run.contact.x, run.contact.y = position.x, position.y
    if not scene.finger:
        run.wall.radius = radius
    run.point, run.other_end = point, other_end


def hold_contact(system: System, state: RunState, point: int, other_end: int) -> None:
    """Make a point on the fence, or a side from it to its other end, the contact."""
    if point != system.run.point:
        move_contact(system, state, point)
        state.gap = 0.0
    system.run.other_end = other_end


def leave_side(system: System, index: int) -> None:
    """Let a candidate mode have its point as the contact, without a side."""
    candidate = candidate_of(system, index)
    candidate.other_end = NO_POINT


def name_contact(system: System, state: RunState) -> None:
    """Let the contact at time 0 be one of the points: the rod's end, or the start of a side."""
    if count_points(system) > 0:
        scene = system.scene
        move_contact(system, state, scene.wall if begins_on_round(system) else scene.chain)
        state.gap = system.scene.gap


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
    slack, fence, level = (
        touch_tolerance(system),
        fence_line(system, state),
        state.gap * system.scene.fine,
    )
    chain, pieces = system.scene.chain, system.data[system.scene.chain_place :]
    for point in range(count_points(system)):
        if point < chain:
            piece = chain_piece(pieces, point)
            up = (piece.x - fence.x) * fence.n_x + (piece.y - fence.y) * fence.n_y
            # Sides, and pieces that are higher than the tolerance, and more than rounding, are not on it.
            if is_side(piece) or up - piece.radius + level > 2.0:
                continue
            if not can_touch(system, point, state):
                continue
        # The ends of a given side can be places of the outline, which come first.
        offset, more = offset_of(system, state, point), 0.0 if point < chain else slack
        if fabs(state.gap + offset.y) <= slack:
            if offset.x < first - more:
                left, first = point, offset.x
            if offset.x > last + more:
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
    start, end = point_position(system, left, state), point_position(system, right, state)
    angle = -atan2(end.y - start.y, end.x - start.x)
    angle += 2.0 * HALF_TURN * nearest_integer((state.angle - angle) / (2.0 * HALF_TURN))
    # An angle that is exact to rounding stays as it is.
    if fabs(angle - state.angle) > RESOLUTION * (1.0 + fabs(angle)):
        state.angle = angle
    state.gap = 0.0
    if is_massive(system):
        state.normal_speed, state.spin = 0.0, 0.0
