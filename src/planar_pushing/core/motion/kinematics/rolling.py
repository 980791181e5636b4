"""The contact of two circles: slider and pusher at the contact, each with a radius of curvature.

The slider's outline has the radius rho there: infinite on a side, 0 at a corner. A finger has the radius r,
0 for a point, and a fence is a line. Place and normal of the contact follow from the motion of the
slider's material point at the contact relative to the pusher, with the slip s along +x and the angular
velocity w of the slider. The contact frame, with +y along the normal into the slider, turns at

    w - (s + r w) / (rho + r + h)    for a finger at a distance h,    and 0    for a fence.

In other words, the center of a finger moves on the outline grown by r, whose pieces have the radius
rho + r, and a fence touches an arc where the arc is parallel to it. The position along the grown outline,
toward -x, is an entry of the state, `along`; that of a fence is the position of the contact along it. On a
corner under a point finger the grown outline has no length, so that there the unit of `along` is an angle.
"""

from __future__ import annotations

from planar_pushing.core.motion.kinematics.run import Wall
from planar_pushing.core.motion.kinematics.system import RunState, System, is_massive
from planar_pushing.core.numbers import INFINITY


def has_finger(system: System) -> bool:
    """Whether the pusher is a finger."""
    return system.scene.finger


def follows_chain(system: System) -> bool:
    """Whether a finger follows the pieces of an outline."""
    return system.scene.finger and system.scene.chain > 0


def is_sharp(system: System) -> bool:
    """Whether a point is at a corner."""
    return follows_chain(system) and system.run.wall.radius + system.scene.radius == 0.0


def enters_pockets(system: System) -> bool:
    """Whether the pusher can be in an inner corner: a point, without inertia."""
    return system.scene.radius == 0.0 and not is_massive(system)


def is_in_pocket(system: System) -> bool:
    """Whether a point is in an inner corner."""
    return system.run.wall.pocket > 0.0


def is_straight(wall: Wall) -> bool:
    """Whether a wall is a side, or the tangent of the outline at a contact that is open."""
    return wall.radius == INFINITY


def unit_of_place(system: System) -> float:
    """Length along the grown outline on which its tangent turns by one radian."""
    reach = system.run.wall.radius + system.scene.radius
    return reach if reach != 0.0 else 1.0


def frame_angle(system: System, state: RunState) -> float:
    """Angle of body x in the contact frame."""
    wall = system.run.wall
    if not has_finger(system):
        return state.angle
    if is_straight(wall):
        return wall.angle
    return wall.angle + (state.along - wall.base) / unit_of_place(system)


def travel_rate(system: System, gap: float, slip: float, spin: float) -> float:
    """Rate of the contact's position along the pusher, or along the outline grown by a finger."""
    wall = system.run.wall
    if not has_finger(system):
        return slip - wall.radius * spin if wall.radius != 0.0 else slip
    rate = slip + system.scene.radius * spin
    if is_straight(wall):
        return rate
    reach = wall.radius + system.scene.radius + gap
    if reach == 0.0:
        # A point that sticks at a corner keeps the direction of its normal in the world.
        return spin * unit_of_place(system)
    return rate * unit_of_place(system) / reach


def frame_spin(system: System, gap: float, slip: float, spin: float) -> float:
    """Angular velocity of the contact frame."""
    if not has_finger(system):
        return 0.0
    if is_straight(system.run.wall):
        return spin
    return spin - travel_rate(system, gap, slip, spin) / unit_of_place(system)


def rates_of_contact(
    system: System,
    gap: float,
    spin: float,
    slip: float,
    normal_speed: float,
    a_x: float,
    a_y: float,
) -> tuple[float, float]:
    """Rates of the contact's velocity relative to the pusher, from its relative acceleration.

    They include the Coriolis term of a rotating frame, and a term for the travel of a rolling contact.
    """
    wall = system.run.wall
    if not has_finger(system):
        return a_x, a_y - wall.radius * spin * spin if wall.radius != 0.0 else a_y
    turn = frame_spin(system, gap, slip, spin)
    both, rolling = spin + turn, system.scene.radius * spin * turn
    return a_x + both * normal_speed, a_y - both * slip - rolling


def sticking_acceleration(
    system: System, spin: float, a_x: float, a_y: float
) -> tuple[float, float]:
    """Acceleration of the slider's point at a contact that sticks, from the pusher's."""
    wall = system.run.wall
    if not has_finger(system):
        return a_x, a_y + wall.radius * spin * spin if wall.radius != 0.0 else a_y
    return a_x, a_y + system.scene.radius * spin * frame_spin(system, 0.0, 0.0, spin)


def contact_in_body(system: System, state: RunState, x: float, y: float) -> tuple[float, float]:
    """The contact in the body frame, for the direction (x, y) of body x in the contact frame."""
    run, wall = system.run, system.run.wall
    if not has_finger(system):
        if wall.radius == 0.0:
            return run.contact.x, run.contact.y
        return run.contact.x - wall.radius * y, run.contact.y - wall.radius * x
    if is_straight(wall):
        along, gap = state.along - wall.base, state.gap
        return wall.anchor.x - (along * x + gap * y), wall.anchor.y + (along * y - gap * x)
    depth = wall.radius + state.gap
    return wall.anchor.x - depth * y, wall.anchor.y - depth * x
