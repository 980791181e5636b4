"""The piece of the outline at a finger's contact, and how it changes.

A finger goes from piece to piece where the contact reaches an end of one. The contact frame is then the
same; only the radius of curvature changes. While the contact is open, the wall is a straight line, in whose
frame the slider is seen, and the finger can meet any piece. Points at corners are in `corner`.
"""

from __future__ import annotations

from math import cos, fabs, sin

from planar_pushing.core.instant.directions import nearest_integer
from planar_pushing.core.instant.solution import SEPARATE
from planar_pushing.core.motion.kinematics.fence import Span
from planar_pushing.core.motion.kinematics.mode import REST, Mode
from planar_pushing.core.motion.kinematics.rolling import (
    enters_pockets,
    follows_chain,
    frame_angle,
    has_finger,
    is_in_pocket,
    is_sharp,
    is_straight,
    unit_of_place,
)
from planar_pushing.core.motion.kinematics.shapes import (
    center_motion,
    contact_motion,
    from_world,
    pose_of,
    pusher_velocity,
    to_world,
)
from planar_pushing.core.motion.kinematics.system import RunState, System, is_massive
from planar_pushing.core.motion.kinematics.touch import (
    count_points,
    direction_under,
    height_above_pusher,
    is_flush,
    lowest_point,
    position_in_body,
    put_contact,
)
from planar_pushing.core.numbers import INFINITY, UNKNOWN, Numbers
from planar_pushing.core.supports.chain import (
    ChainPiece,
    NearestPlace,
    arc_length_at,
    chain_piece,
    is_inner_corner,
    is_side,
    length_of_chain,
    nearest_on_chain,
    stretch_of_piece,
)
from planar_pushing.core.supports.rows import NO_POINT, Position
from planar_pushing.core.supports.tolerances import SLACK

#: Distance, in tolerances of the outline, that a free finger may move in a step beyond that to the outline;
#: it is a thousandth of the outline's extent.
STRIDE = 1e6


def chain_of(system: System) -> Numbers:
    """The pieces of the outline."""
    return system.data[system.scene.chain_place :]


def put_wall(system: System, number: int, place: float, along: float) -> None:
    """Make a piece the wall, with a position of the contact at a place of it."""
    scene, wall, piece = system.scene, system.run.wall, chain_piece(chain_of(system), number)
    x, y, fine = piece.x, piece.y, scene.fine
    position = position_on_outline(system, along)
    wall.piece, wall.base, wall.place = number, along, place
    wall.position = _position_near(system, piece, place, position)
    wall.radius = INFINITY if is_side(piece) else piece.radius / fine
    wall.pocket = 0.0
    if is_inner_corner(piece):
        wall.pocket = (piece.first - piece.last) / 2.0
        wall.radius, wall.angle = INFINITY, scene.turn - (piece.first + piece.last) / 2.0
        wall.start, wall.end = -INFINITY, INFINITY
    elif is_side(piece):
        x, y = x + place * piece.along_x, y + place * piece.along_y
        wall.angle = scene.turn - piece.first
        wall.start, wall.end = -along - place / fine, -along + (piece.length - place) / fine
    else:
        unit = unit_of_place(system)
        wall.angle = scene.turn - place
        wall.start = -along + unit * (piece.first - place)
        wall.end = -along + unit * (piece.last - place)
        if piece.next == number:  # a whole disc
            wall.start, wall.end = -INFINITY, INFINITY
    anchor = position_in_body(scene, x, y)
    wall.anchor.x, wall.anchor.y = anchor.x, anchor.y
    wall.rod.x, wall.rod.y = cos(wall.angle), sin(wall.angle)
    # The stretch of another piece says nothing about this one.
    system.run.low, system.run.high = -INFINITY, INFINITY


def position_on_outline(system: System, along: float) -> float:
    """Arc length of the outline at the contact, from that at time 0, or along the tangent if it is open."""
    wall, travel = system.run.wall, system.run.wall.base - along
    if not is_straight(wall):
        travel = wall.radius * (travel / unit_of_place(system))
    return wall.position + travel


def _position_near(system: System, piece: ChainPiece, place: float, position: float) -> float:
    """The arc length at a place of a piece, from that at time 0, that is nearest to a position."""
    scene = system.scene
    start = chain_piece(chain_of(system), scene.wall if scene.wall >= 0 else 0)
    length = arc_length_at(piece, place) - arc_length_at(start, scene.place)
    perimeter = length_of_chain(chain_of(system), system.run.wall.piece)
    turns = nearest_integer((scene.fine * position - length) / perimeter)
    return (length + perimeter * turns) / scene.fine


def begin_at_wall(system: System) -> None:
    """Make the piece at the contact at time 0 the wall.

    The frame of a side is that of the slider, to the last bit, as without an outline.
    """
    scene, run, wall = system.scene, system.run, system.run.wall
    if not follows_chain(system) or scene.wall < 0:
        return
    put_wall(system, scene.wall, scene.place, 0.0)
    if is_straight(wall) and fabs(wall.angle - scene.angle) <= SLACK:
        wall.angle, wall.rod.x, wall.rod.y = scene.angle, run.rod.x, run.rod.y
        wall.anchor.x, wall.anchor.y = -scene.length, 0.0


def place_on_wall(system: System, along: float) -> float:
    """The place of the contact on the piece that is the wall."""
    wall = system.run.wall
    unit = 1.0 / system.scene.fine if is_straight(wall) else unit_of_place(system)
    return wall.place + (wall.base - along) / unit


def go_to_next_piece(system: System, state: RunState, joint: float) -> bool:
    """Make the piece after the end that the contact has reached the wall; return whether there is one.

    The pieces join at the position `joint`. There is none at a hollow arc that a disc fills, nor at an
    inner corner, where it would touch both sides; a point goes into the corner without inertia.
    """
    wall = system.run.wall
    forward: bool = wall.end + state.along < -state.along - wall.start
    piece = chain_piece(chain_of(system), wall.piece)
    number = piece.next if forward else piece.before
    neighbor = chain_piece(chain_of(system), number)
    fills: bool = (
        neighbor.radius < 0.0 and neighbor.radius + system.scene.fine * system.scene.radius > -1.0
    )
    if fills or (is_inner_corner(neighbor) and not enters_pockets(system)):
        return False
    put_wall(system, number, place=end_of_piece(neighbor, forward), along=joint)
    return True


def pass_ends(system: System, state: RunState) -> bool:
    """Go to the piece on which the contact is after a step beyond ends; return whether there is one."""
    for _ in range(system.scene.chain):
        if not room_on_piece(system, state) < -SLACK:
            break
        wall = system.run.wall
        if not has_finger(system):
            if not roll_on_to_next(system, state):
                return False
            continue
        forward: bool = wall.end + state.along < -state.along - wall.start
        joint = -wall.end if forward else -wall.start
        if not go_to_next_piece(system, state, joint):
            return False
        if is_sharp(system) or is_in_pocket(system):
            state.along = joint
    return True


def seat_finger(system: System, state: RunState) -> None:
    """Let a finger that is free of the outline face the place nearest to it, or touch it there."""
    if not follows_chain(system) or (system.run.wall.piece >= 0 and state.gap <= SLACK):
        return
    nearest = nearest_wall(system, state)
    put_wall(system, nearest.piece, nearest.place, state.along)
    state.gap = nearest.distance / system.scene.fine - system.scene.radius
    if state.gap <= SLACK:
        state.gap = 0.0
    else:
        open_wall(system, state)


def end_of_piece(piece: ChainPiece, is_start: bool) -> float:
    """The place of a piece at its start or at its end."""
    if is_side(piece):
        return 0.0 if is_start else piece.length
    return piece.first if is_start else piece.last


def piece_at_contact(system: System, state: RunState) -> int:
    """The piece of the outline at the contact, or at the left end of a side on a fence; -1 without one."""
    run, scene = system.run, system.scene
    if scene.finger:
        touches: bool = scene.chain > 0 and is_closed(system, state)
        return run.wall.piece if touches else NO_POINT
    return run.point if run.point < scene.chain else NO_POINT


def open_wall(system: System, state: RunState) -> None:
    """Make the tangent of the outline at the contact the wall, which a finger leaves."""
    wall = system.run.wall
    if not follows_chain(system) or wall.piece < 0:
        return
    pose, angle = pose_of(system, state), frame_angle(system, state)
    wall.position = position_on_outline(system, state.along)
    c, s, gap = pose.rod.x, pose.rod.y, state.gap
    wall.anchor.x, wall.anchor.y = pose.contact.x + gap * s, pose.contact.y + gap * c
    wall.piece, wall.radius, wall.base, wall.angle = NO_POINT, INFINITY, state.along, angle
    wall.pocket = 0.0
    wall.rod.x, wall.rod.y = c, s
    wall.start, wall.end = -INFINITY, INFINITY


def finger_center(system: System, state: RunState) -> Position:
    """The center of a finger in the frame of the outline, in units of its tolerance."""
    scene, pose = system.scene, pose_of(system, state)
    x = scene.fine * (pose.contact.x - scene.radius * pose.rod.y)
    y = scene.fine * (pose.contact.y - scene.radius * pose.rod.x)
    c, s = scene.axis.x, scene.axis.y
    return Position(scene.frame.x + (x * c - y * s), scene.frame.y + (x * s + y * c))


def nearest_wall(system: System, state: RunState) -> NearestPlace:
    """The place of the outline nearest to a finger, and its distance from the center of the finger."""
    center = finger_center(system, state)
    return nearest_on_chain(chain_of(system), system.scene.chain, center.x, center.y)


def gap_of_finger(system: System, state: RunState) -> float:
    """Distance of a finger from the slider's outline, or from the wall without one.

    A finger that goes to the end of the wall touches it there, although it may graze the outline only.
    """
    is_known: bool = system.run.wall.piece >= 0
    if not follows_chain(system) or (is_known and state.gap <= SLACK):
        return state.gap
    distance = nearest_wall(system, state).distance / system.scene.fine - system.scene.radius
    return min(state.gap, distance) if is_known else distance


def move_to_place(
    system: System, during: Span, time: float, state: RunState, number: int, place: float
) -> None:
    """Close the contact at a place of a piece, which becomes the wall; the motion is the same."""
    if not is_massive(system):
        put_wall(system, number, place, state.along)
        state.gap = 0.0
        return
    fence_x, fence_y = pusher_velocity(system, during, time, state)
    u_x, u_y = fence_x + state.slip_speed, fence_y + state.normal_speed
    v_x, v_y = center_motion(pose_of(system, state), u_x, u_y, state.spin)
    v_x, v_y = to_world(system, state, v_x, v_y)
    put_wall(system, number, place, state.along)
    state.gap = 0.0
    v_x, v_y = from_world(system, state, v_x, v_y)
    u_x, u_y = contact_motion(pose_of(system, state), v_x, v_y, state.spin)
    fence_x, fence_y = pusher_velocity(system, during, time, state)
    state.slip_speed, state.normal_speed = u_x - fence_x, u_y - fence_y


def is_closed(system: System, state: RunState) -> bool:
    """Whether a slider touches the pusher, at its contact or as a finger meets its outline."""
    if follows_chain(system) and system.run.wall.piece < 0:
        return gap_of_finger(system, state) <= SLACK
    return state.gap <= SLACK


def land_on_wall(system: System, during: Span, time: float, state: RunState) -> None:
    """Close the contact of a finger, at the wall or at the place of the outline nearest to it."""
    if follows_chain(system) and (system.run.wall.piece < 0 or state.gap > SLACK):
        nearest = nearest_wall(system, state)
        move_to_place(system, during, time, state, nearest.piece, nearest.place)
    state.gap = 0.0


def touch_wall(system: System, during: Span, time: float, state: RunState) -> None:
    """Make the piece that a finger touches the wall, if it is not known."""
    if not follows_chain(system) or system.run.wall.piece >= 0:
        return
    reach = system.scene.fine * (system.scene.radius + SLACK)
    if nearest_wall(system, state).distance <= reach:
        land_on_wall(system, during, time, state)


def confine_finger(system: System, state: RunState) -> None:
    """Store the stretch of the wall on which a finger meets no other piece of the outline."""
    scene, run, wall = system.scene, system.run, system.run.wall
    run.low, run.high = -INFINITY, INFINITY
    if not follows_chain(system) or wall.piece < 0 or scene.radius == 0.0:
        return  # a point meets another piece only at the end of its own
    place, unit = place_on_wall(system, state.along), 1.0 / scene.fine
    if not is_straight(wall):
        unit = unit_of_place(system)
    stretch = stretch_of_piece(
        chain_of(system), scene.chain, wall.piece, scene.fine * scene.radius, place
    )
    run.low = unit * (stretch.low - wall.place) - wall.base
    run.high = unit * (stretch.high - wall.place) - wall.base
    if unit < 0.0:
        run.low, run.high = run.high, run.low


def meets_in_step(system: System, state: RunState) -> bool:
    """Whether a finger has met another piece on its wall, before the end of the wall, in a step.

    The stretch of an arc ends beyond it, where the finger would be in its neighbor.
    """
    run, wall = system.run, system.run.wall
    above: bool = run.high <= wall.end and run.high + state.along <= 0.0
    below: bool = run.low >= wall.start and -state.along - run.low <= 0.0
    return has_finger(system) and (above or below)


def is_in_outline(system: System, state: RunState) -> bool:
    """Whether a finger that touches its wall is in another piece, by more than the tolerance."""
    if not follows_chain(system):
        return False
    reach = system.scene.fine * system.scene.radius
    return nearest_wall(system, state).distance < reach - 1.0


def gap_above_pusher(system: System, state: RunState) -> float:
    """Distance of the slider from the pusher: its height above a fence, or that of its outline."""
    return (
        gap_of_finger(system, state) if has_finger(system) else height_above_pusher(system, state)
    )


def clearance_of(system: System, state: RunState) -> float:
    """Distance of the slider from the pusher, infinite if the contact has ended permanently."""
    return INFINITY if system.run.parted else gap_above_pusher(system, state)


def room_on_piece(system: System, state: RunState) -> float:
    """Distance from the contact to the nearer end of its piece, NaN for a piece without ends.

    A side beside an arc lies down on a fence, where its other end arrives.
    """
    wall = system.run.wall
    room = min(wall.end + state.along, -state.along - wall.start)
    if not has_finger(system):
        room = _room_on_arc(system, state)
    return room if room < INFINITY else UNKNOWN


def _room_on_arc(system: System, state: RunState) -> float:
    """Distance that an arc rolls on a fence until another arc or a corner does; infinite at a point."""
    wall, number = system.run.wall, system.run.point
    if wall.radius == 0.0 or is_flush(system):
        return INFINITY
    piece = chain_piece(chain_of(system), number)
    if piece.next == number:
        return INFINITY
    direction, room = direction_under(system, piece, state), INFINITY
    if not is_side(chain_piece(chain_of(system), piece.next)):
        room = piece.last - direction
    if not is_side(chain_piece(chain_of(system), piece.before)):
        room = min(room, direction - piece.first)
    return wall.radius * room


def roll_on_to_next(system: System, state: RunState) -> bool:
    """Let an arc at whose end the fence touches roll on to its neighbor; return whether there is one."""
    piece = chain_piece(chain_of(system), system.run.point)
    direction = direction_under(system, piece, state)
    forward: bool = piece.last - direction < direction - piece.first
    number = piece.next if forward else piece.before
    neighbor = chain_piece(chain_of(system), number)
    if not 0.0 <= neighbor.radius < INFINITY or is_inner_corner(neighbor):
        return False
    put_contact(system, number, NO_POINT)
    return True


def outline_height(system: System, state: RunState, touching: bool) -> float:
    """Distance of the outline from the pusher, NaN without an outline.

    For a finger, it is in units of the outline's tolerance, and positive until another point than the
    contact is as deep as the tolerance; in contact, it is the distance along the side to such a meeting.
    For a fence, it is the height of the lowest point besides the contact. If both touch at once, the
    contact comes first.
    """
    scene, run = system.scene, system.run
    if not has_finger(system):
        if is_flush(system) or count_points(system) == 0:
            return UNKNOWN
        height = lowest_point(system, state, True).height - run.floor
        if not touching and height > state.gap - SLACK:
            height += SLACK
        return height if height < INFINITY else UNKNOWN
    if not follows_chain(system):
        return UNKNOWN
    if touching:
        room = min(run.high + state.along, -state.along - run.low)
        return scene.fine * room if room < INFINITY else UNKNOWN
    return nearest_wall(system, state).distance - scene.fine * scene.radius + 1.0


def longest_step(system: System, mode: Mode, height: float, speed: float) -> float:
    """Longest step of a finger free of the slider, which cannot pass through a part of the outline.

    The arguments are its distance from the outline and its speed relative to the slider.
    """
    rests: bool = mode.contact == REST and mode.f_x == 0.0 and mode.f_y == 0.0
    if not has_finger(system) or not (mode.contact == SEPARATE or rests):
        return INFINITY
    # The speed is constant while the slider rests and the pusher's velocity is constant.
    if mode.contact == SEPARATE or not mode.during.constant:
        speed += system.run.speed
    if height == height and speed > 0.0:
        return (height + STRIDE) / (system.scene.fine * speed)
    return INFINITY
