"""The parts of a simulation: a system, its state, and modes that last while margins are positive.

A system is a named tuple of a kind of its own. Where systems differ the functions choose by that kind, so
that what a scene does not list is not compiled into its integrators.
"""

from __future__ import annotations

from math import inf, sqrt
from typing import Any, NamedTuple

import numpy as np

from planar_pushing.mechanics.compiled import by_kind, compiled
from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.simulation import fence
from planar_pushing.simulation.fence import Span
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

#: Entries of the state: position of the contact relative to the pusher, rod angle, slip accumulated, energy
#: dissipated at the contact, and work of the fence. A system with inertia adds the velocity of the contact
#: over the fence and the rotation. The last entries are the energies that each effect dissipates.
ALONG, GAP, ANGLE, SLIP, LOST, WORK, OVER, RISE, SPIN = range(9)
#: Entries of the state without and with inertia, before those of the effects.
STILL, MOVING = OVER, SPIN + 1
#: What the slider does: the contact modes, of which `SEPARATE` is a flight, and rests clear of the fence,
#: on it, and on it under a force of the fence.
SEPARATE, STICK = int(ContactMode.SEPARATE), int(ContactMode.STICK)
SLIP_RIGHT, SLIP_LEFT = int(ContactMode.SLIP_RIGHT), int(ContactMode.SLIP_LEFT)
CLEAR, HELD, PROPPED = 4, 5, 6
#: The contact modes that the policies prefer, in the order of `Policy`; none, and the mode so far.
NONE, SO_FAR = -1, -2
PREFERRED = NONE, SEPARATE, SO_FAR, STICK, SLIP_RIGHT, SLIP_LEFT

#: A margin (dimensionless) this far below zero ends a mode; rounding stays above it.
SLACK = 1e-11
#: The fence pushes a slider at rest from this fraction of the typical speed on.
PUSHES = 2e-10
#: Below this fraction of the typical speed friction holds the slider.
AT_REST = 1e-9

#: Why a mode ends, or why the modes are enumerated anew (`Event`); of two at once the first counts.
CAUSES = len(Event) - 1
LEAVES_CONE, SLIP_ENDS = int(Event.LEAVES_CONE), int(Event.SLIP_ENDS)
FORCE_ENDS, TOUCHES, STARTS = int(Event.FORCE_ENDS), int(Event.TOUCHES), int(Event.STARTS)
HINGE_YIELDS, LIES, LIFTS = int(Event.HINGE_YIELDS), int(Event.LIES), int(Event.LIFTS)
STOPS, ARRIVES, KINK = int(Event.STOPS), int(Event.ARRIVES), int(Event.KINK)
TURNS, TURNS_ALONG = int(Event.TURNS), int(Event.TURNS_ALONG)
END_OF_SIDE, PENETRATES = int(Event.END_OF_SIDE), int(Event.PENETRATES)
#: Some are watches: their change of sign is an event. The others are margins, positive while a mode lasts.
WATCHED = LIFTS, STOPS, ARRIVES, KINK, TURNS, TURNS_ALONG, END_OF_SIDE
WATCHES = tuple(cause in WATCHED for cause in range(CAUSES))

#: Constants of a scene: l / R; edges of the friction cone and their angles, and what the law allows there;
#: friction in a translation, mass and moment m (rho / R)^2, zero where there is no such effect; center of
#: mass in the body frame; loads; typical speed and force, to which slacks are relative; initial gap; the
#: slider's radius in tolerances of its outline. And what changes: how often the motion was evaluated, and
#: whether the contact has ended for good.
BODY = np.dtype(
    [
        ("length", "f8"), ("right", "f8", (2,)), ("left", "f8", (2,)), ("right_angle", "f8"),
        ("left_angle", "f8"), ("slips", "b1"), ("closed", "b1"), ("rough", "b1"),
        ("weight", "f8"), ("mass", "f8"), ("moment", "f8"), ("center", "f8", (2,)),
        ("load", "f8", (4,)), ("start_angle", "f8"), ("speed", "f8"), ("force", "f8"), ("gap", "f8"),
        ("fine", "f8"), ("evaluations", "i8"), ("parted", "b1"),
    ],
    align=True,
)  # fmt: skip


class Room(NamedTuple):
    """Arrays on which functions work, and the corners of the outline in tolerances, none without one."""

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

    `effects` are friction and viscous friction, `friction` and `films` the one and the other, and `loads` a
    wrench where the scene has loads. `fence` is the motion of the pusher, whose kind is that of `shape`.
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
    """One way in which the slider moves on, during a span of the fence.

    Attributes
    ----------
    kind : int
        A contact mode, `CLEAR`, `HELD` or `PROPPED`.
    foot : int
        Number of the support point at the center of rotation, -1 without one.
    hinged : bool
        Whether friction holds that point like a hinge.
    x, y, spin : float
        Acceleration with which the slider starts from rest, zero otherwise; the force of a slider that is
        propped; the contact's motion along the fence in a slip of a scene without inertia.
    during : Span
    """

    kind: int
    foot: int
    hinged: bool
    x: float
    y: float
    spin: float
    during: Span


#: Of each kind of system, the module of its equations, with the functions below; the first argument of all
#: is the system.
SYSTEMS: dict[type, Any] = {}
#: Change the state where the fence takes up the motion of a span: index of the span, state, contact mode,
#: policy. Returns 0, or the `Stop` that says why there is no such state.
enter = by_kind(SYSTEMS, "enter")
#: Write down the modes that may be: span, time, state, kinds, feet, hinged, starts. Their number.
modes = by_kind(SYSTEMS, "modes")
#: Change the state just after an event: cause, mode, time, state, policy. Returns the time and a `Stop`.
after = by_kind(SYSTEMS, "after")
#: The `Motion` at an instant: mode, time, state.
motion = by_kind(SYSTEMS, "motion")
#: Note the slip of a step that was taken in its mode: time, state, mode, start of the mode.
remember = by_kind(SYSTEMS, "remember")
#: Write down what ends a contact: mode, state, motion, found.
guard_contact = by_kind(SYSTEMS, "guard_contact")


@compiled
def pose(system, state):
    """The slider as the contact sees it."""
    angle = shapes.frame_angle(system.shape, state[ANGLE])
    return pose_in(system, frame_of(angle), state)


@compiled
def pose_in(system, frame, state):
    """As `pose`, of a frame that is known."""
    return shapes.pose(system.shape, system.body, frame, state[ALONG], state[GAP])


@compiled
def velocity(system, during, time, state):
    """Velocity of the pusher in the contact's frame."""
    x, y = fence.velocity(system.fence, during, time)
    return shapes.seen(system.shape, state[ANGLE], x, y)


@compiled
def acceleration(system, during, time, state):
    """Acceleration of the pusher along the axes of the contact's frame."""
    x, y = fence.acceleration(system.fence, during, time)
    return shapes.seen(system.shape, state[ANGLE], x, y)


@compiled
def clearance(system, state):
    """Height of the contact over the pusher, infinite where the contact has ended for good."""
    return shapes.clearance(system.shape, system.body, state[GAP])


@compiled
def height(system, state):
    """Height of the outline over the fence in its tolerances, plus one; NaN without an outline."""
    return shapes.height(system.shape, system.body, system.room.corners, state[ANGLE], state[GAP])


@compiled
def initial(system, angle, gap, twist, state):
    """Write down the state at time 0."""
    state[:] = 0.0
    state[GAP], state[ANGLE] = gap, angle
    if len(state) >= MOVING + len(system.effects):
        now = pose(system, state)
        state[OVER], state[RISE] = contact_motion(now, twist[0], twist[1], twist[2])
        state[SPIN] = twist[2]


@compiled
def scales(system, found):
    """Write down typical magnitudes of the state, for the tolerance near zero."""
    length = max(1.0, system.body.length)
    found[:] = system.body.force * length
    found[:LOST] = length
    found[ANGLE] = 1.0
    if len(found) >= MOVING + len(system.effects):
        found[OVER:MOVING] = 0.01 * system.body.speed


@compiled
def center_velocity(system, during, time, state):
    """Velocity of the slider's center, where the twist is part of the state."""
    fence_x, fence_y = velocity(system, during, time, state)
    now = pose(system, state)
    return center_motion(now, fence_x + state[OVER], fence_y + state[RISE], state[SPIN])


@compiled
def pace(system, during, time):
    """Time in which the motion takes the slider about one length, or friction stops it."""
    body, (x, y) = system.body, fence.velocity(system.fence, during, time)
    speed = body.speed if body.mass > 0.0 else sqrt(x * x + y * y)
    along = max(1.0, body.length) / speed if speed > 0.0 else inf
    return min(along, speed * body.mass / body.weight) if body.mass * body.weight > 0.0 else along


@compiled
def contact_mode(kind):
    """The contact mode of what the slider does."""
    if kind == PROPPED:
        return STICK
    return kind if kind < CLEAR else SEPARATE


@compiled
def rank(policy, previous, kind):
    """Rank of a contact mode in the order in which a policy takes the modes."""
    preferred = PREFERRED[policy]
    if kind == (previous if preferred == SO_FAR else preferred):
        return SEPARATE
    return SLIP_LEFT + 1 if kind == SEPARATE else kind


@compiled
def is_slow(system, v_x, v_y, spin):
    """Whether friction holds a slider at a twist."""
    return size_of(v_x, v_y, spin) <= AT_REST * system.body.speed


@compiled
def load_power(system, now, state, v_x, v_y, spin):
    """Power of the loads."""
    x, y = to_body(now.frame, v_x, v_y)
    pull = load_at(system.body, state[ANGLE])
    return pull.x * x + pull.y * y + pull.torque * spin
