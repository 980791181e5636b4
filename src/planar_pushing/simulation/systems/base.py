"""The parts of a simulation: a system, its state, and modes that last while margins are positive.

Each kind of system is a separate named tuple. Functions that differ between systems are selected by this
kind, so that an integrator contains no code for effects that its scene does not list.
"""

from __future__ import annotations

from math import inf, sqrt
from typing import Any, NamedTuple

import numpy as np

from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.simulation import fence
from planar_pushing.simulation.fence import Span
from planar_pushing.simulation.legacy.compiled import by_kind, compiled
from planar_pushing.simulation.systems.drag import load_at
from planar_pushing.simulation.systems.frame import (
    center_motion,
    contact_motion,
    frame_of,
    size_of,
    to_body,
)
from planar_pushing.simulation.systems.shapes import base as shapes
from planar_pushing.terms.options import Event

#: Entries of the state: position of the contact relative to the pusher, rod angle, accumulated slip, energy
#: dissipated at the contact, and work of the pusher. A system with inertia adds the velocity of the contact
#: relative to the pusher and the angular velocity. The last entries are the energies dissipated by each
#: effect.
ALONG, GAP, ANGLE, SLIP, LOST, WORK, OVER, RISE, SPIN = range(9)
#: Number of entries of the state without and with inertia, before those of the effects.
STILL, MOVING = OVER, SPIN + 1
#: Kinds of modes: the contact modes, of which `SEPARATE` is a flight; and rest clear of the fence, on the
#: fence without a force, and on the fence with a force.
SEPARATE, STICK = int(ContactMode.SEPARATE), int(ContactMode.STICK)
SLIP_RIGHT, SLIP_LEFT = int(ContactMode.SLIP_RIGHT), int(ContactMode.SLIP_LEFT)
CLEAR, HELD, PROPPED = 4, 5, 6
#: Contact modes that the policies prefer, in the order of `Policy`, with markers for none and the current
#: one.
NONE, SO_FAR = -1, -2
PREFERRED = NONE, SEPARATE, SO_FAR, STICK, SLIP_RIGHT, SLIP_LEFT

#: A dimensionless margin this far below zero ends a mode; rounding errors are smaller.
SLACK = 1e-11
#: The fence pushes a slider at rest above this fraction of the typical speed.
PUSHES = 2e-10
#: Below this fraction of the typical speed friction holds the slider.
AT_REST = 1e-9

#: Reasons why a mode ends or the modes are enumerated again (`Event`); of simultaneous ones, the first
#: counts.
CAUSES = len(Event) - 1
LEAVES_CONE, SLIP_ENDS = int(Event.LEAVES_CONE), int(Event.SLIP_ENDS)
FORCE_ENDS, TOUCHES, PUSH_STARTS = map(int, (Event.FORCE_ENDS, Event.TOUCHES, Event.PUSH_STARTS))
SEPARATION_CHANGES, PIVOT_YIELDS = int(Event.SEPARATION_CHANGES), int(Event.PIVOT_YIELDS)
CENTER_REACHES_FENCE = int(Event.SLIDER_CENTER_REACHES_FENCE)
SLIDER_STOPS, CENTER_AT_POINT = int(Event.SLIDER_STOPS), int(Event.MOTION_CENTER_AT_POINT)
NORMAL_REVERSES = int(Event.NORMAL_VELOCITY_REVERSES)
TANGENTIAL_REVERSES = int(Event.TANGENTIAL_VELOCITY_REVERSES)
KINK, END_OF_SIDE, PENETRATES = map(int, (Event.KINK, Event.END_OF_SIDE, Event.PENETRATES))
#: Watches, whose change of sign is an event. The others are margins, which are positive while a mode lasts.
WATCHED = (
    SEPARATION_CHANGES, SLIDER_STOPS, CENTER_AT_POINT, KINK, NORMAL_REVERSES, TANGENTIAL_REVERSES,
    END_OF_SIDE,
)  # fmt: skip
WATCHES = tuple(cause in WATCHED for cause in range(CAUSES))

#: Constants of a scene: l / R; edges of the friction cone, their angles, and whether the law allows slip
#: and forces on the edges; friction in a translation, mass, and moment m (rho / R)^2, zero without such an
#: effect; center of mass in the body frame; loads; typical speed and force, to which slacks are relative;
#: initial gap; and the slider's radius in tolerances of its outline. Variables: the number of evaluations
#: of the motion, whether the contact has ended permanently, and the positions of a finger's contact between
#: which no other point of the outline meets the finger.
BODY = np.dtype(
    [
        ("length", "f8"), ("right", "f8", (2,)), ("left", "f8", (2,)), ("right_angle", "f8"),
        ("left_angle", "f8"), ("slips", "b1"), ("closed", "b1"), ("rough", "b1"),
        ("weight", "f8"), ("mass", "f8"), ("moment", "f8"), ("center", "f8", (2,)),
        ("load", "f8", (4,)), ("start_angle", "f8"), ("speed", "f8"), ("force", "f8"), ("gap", "f8"),
        ("fine", "f8"), ("evaluations", "i8"), ("parted", "b1"), ("low", "f8"), ("high", "f8"),
    ],
    align=True,
)  # fmt: skip


class Room(NamedTuple):
    """Work arrays, and the corners of the outline in units of its tolerance, empty without an outline."""

    scratch: Any
    solutions: Any
    kinds: Any
    feet: Any
    hinged: Any
    starts: Any
    rates: Any
    corners: Any


class QuasiStatic(NamedTuple):
    """The system of a scene without inertia; `body` is a record of `BODY`.

    `effects` contains `friction` and `films`, which is viscous friction. `loads` contains a wrench if the
    scene has loads. `fence` is the motion of the pusher, and `shape` its shape.
    """

    effects: tuple[Any, ...]
    friction: tuple[Any, ...]
    films: tuple[Any, ...]
    loads: tuple[Any, ...]
    body: Any
    fence: Any
    shape: Any
    room: Any


class Inertial(NamedTuple):
    """The system of a scene with inertia."""

    effects: tuple[Any, ...]
    friction: tuple[Any, ...]
    films: tuple[Any, ...]
    loads: tuple[Any, ...]
    body: Any
    fence: Any
    shape: Any
    room: Any


class Mode(NamedTuple):
    """A possible continuation of the motion during a span of the fence.

    Attributes
    ----------
    kind : int
        A contact mode, `CLEAR`, `HELD` or `PROPPED`.
    foot : int
        Number of the support point at the center of rotation, -1 if there is none.
    hinged : bool
        Whether friction holds this point like a hinge.
    x, y, spin : float
        Acceleration of a slider that starts from rest, or the force in the mode `PROPPED`, or the contact's
        motion along the fence in a slip without inertia; otherwise zero.
    during : Span
    """

    kind: int
    foot: int
    hinged: bool
    x: float
    y: float
    spin: float
    during: Span


#: Module of the equations of each kind of system, with the functions below; their first argument is the
#: system.
SYSTEMS: dict[type, Any] = {}
#: Change the state when the fence starts the motion of a span: index of the span, state, contact mode,
#: policy. Returns 0, or the `Stop` that says why there is no consistent state.
enter = by_kind(SYSTEMS, "enter")
#: Store the candidate modes: span, time, state, kinds, feet, hinged, starts. Returns their number.
modes = by_kind(SYSTEMS, "modes")
#: Change the state just after an event: cause, mode, time, state, policy. Returns the time and a `Stop`.
after = by_kind(SYSTEMS, "after")
#: The `Motion` at an instant: mode, time, state.
motion = by_kind(SYSTEMS, "motion")
#: Store the slip of a completed step in its mode: time, state, mode, start of the mode.
remember = by_kind(SYSTEMS, "remember")
#: Store the margins and watches that end a contact: mode, state, motion, found.
guard_contact = by_kind(SYSTEMS, "guard_contact")


@compiled
def pose(system, state):
    """Pose of the slider in the contact frame."""
    angle = shapes.frame_angle(system.shape, state[ANGLE])
    return pose_in(system, frame_of(angle), state)


@compiled
def pose_in(system, frame, state):
    """As `pose`, for a known frame."""
    return shapes.pose(system.shape, system.body, frame, state[ALONG], state[GAP])


@compiled
def velocity(system, during, time, state):
    """Velocity of the pusher in the contact frame."""
    x, y = fence.velocity(system.fence, during, time)
    return shapes.seen(system.shape, state[ANGLE], x, y)


@compiled
def acceleration(system, during, time, state):
    """Acceleration of the pusher along the axes of the contact frame."""
    x, y = fence.acceleration(system.fence, during, time)
    return shapes.seen(system.shape, state[ANGLE], x, y)


@compiled
def clearance(system, state):
    """Height of the contact above the pusher, infinite if the contact has ended permanently."""
    return shapes.clearance(system.shape, system.body, state[GAP])


@compiled
def confine(system, state):
    """Store the part of the side on which a finger meets no other point of the outline."""
    shapes.confine(system.shape, system.body, system.room.corners, state[ALONG])


@compiled
def height(system, state, touching):
    """Distance of the outline from the pusher in units of its tolerance; NaN without an outline."""
    body, corners = system.body, system.room.corners
    along, gap = state[ALONG], state[GAP]
    return shapes.height(system.shape, body, corners, state[ANGLE], along, gap, touching)


@compiled
def stride(system, mode, height, speed):
    """Longest step of a pusher that is free of the slider, from its distance and its present speed."""
    if contact_mode(mode.kind) != SEPARATE:
        return inf
    # The speed is constant while the slider rests and the pusher's velocity is constant.
    if mode.kind == SEPARATE or not mode.during.constant:
        speed += system.body.speed
    return shapes.stride(system.shape, system.body, height, speed)


@compiled
def initial(system, angle, gap, twist, state):
    """Store the state at time 0."""
    state[:] = 0.0
    state[GAP], state[ANGLE] = gap, angle
    if len(state) >= MOVING + len(system.effects):
        now = pose(system, state)
        state[OVER], state[RISE] = contact_motion(now, twist[0], twist[1], twist[2])
        state[SPIN] = twist[2]


@compiled
def scales(system, found):
    """Store typical magnitudes of the state, for the tolerance near zero."""
    length = max(1.0, system.body.length)
    found[:] = system.body.force * length
    found[:LOST] = length
    found[ANGLE] = 1.0
    if len(found) >= MOVING + len(system.effects):
        found[OVER:MOVING] = 0.01 * system.body.speed


@compiled
def center_velocity(system, during, time, state):
    """Velocity of the slider's center, for systems with the twist in the state."""
    fence_x, fence_y = velocity(system, during, time, state)
    now = pose(system, state)
    return center_motion(now, fence_x + state[OVER], fence_y + state[RISE], state[SPIN])


@compiled
def pace(system, during, time):
    """Time in which the slider moves about one length, or friction stops it."""
    body, (x, y) = system.body, fence.velocity(system.fence, during, time)
    speed = body.speed if body.mass > 0.0 else sqrt(x * x + y * y)
    along = max(1.0, body.length) / speed if speed > 0.0 else inf
    return min(along, speed * body.mass / body.weight) if body.mass * body.weight > 0.0 else along


@compiled
def contact_mode(kind):
    """Contact mode for a kind of mode."""
    if kind == PROPPED:
        return STICK
    return kind if kind < CLEAR else SEPARATE


@compiled
def rank(policy, previous, kind):
    """Rank of a contact mode in the order of preference of a policy."""
    preferred = PREFERRED[policy]
    if kind == (previous if preferred == SO_FAR else preferred):
        return SEPARATE
    return SLIP_LEFT + 1 if kind == SEPARATE else kind


@compiled
def is_slow(system, v_x, v_y, spin):
    """Whether a twist is so slow that friction holds the slider."""
    return size_of(v_x, v_y, spin) <= AT_REST * system.body.speed


@compiled
def load_power(system, now, state, v_x, v_y, spin):
    """Power of the loads."""
    x, y = to_body(now.frame, v_x, v_y)
    pull = load_at(system.body, state[ANGLE])
    return pull.x * x + pull.y * y + pull.torque * spin
