"""What a simulation is made of: a system, its state, and modes that last while margins are positive.

A system is a named tuple of a kind of its own. Where systems differ the functions choose by that kind, so
that what a scene does not list is not compiled into its integrators.
"""

from __future__ import annotations

from math import inf, nan, sqrt
from typing import Any, NamedTuple

import numpy as np

from planar_pushing.mechanics.compiled import by_kind, compiled
from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.mechanics.modes import MOST
from planar_pushing.mechanics.plane import contact_motion
from planar_pushing.mechanics.reduced.base import MOTION
from planar_pushing.simulation import fence
from planar_pushing.simulation.fence import Span
from planar_pushing.simulation.systems.motion import rod_of, size_of
from planar_pushing.simulation.systems.shapes import base as shapes

#: Where the state holds what: place of the contact relative to the fence, rod angle, slip accumulated,
#: energy dissipated at the contact, work of the fence, energy dissipated by friction of the support. A
#: system with inertia adds the velocity of the contact over the fence and the rotation.
ALONG, GAP, ANGLE, SLIP, LOST, WORK, RUBBED, OVER, RISE, SPIN = range(10)
#: Entries of the state without and with inertia.
STILL, MOVING = OVER, SPIN + 1
#: What the slider does: the contact modes, of which `SEPARATE` is a flight, and rests clear of the fence
#: and on it.
SEPARATE, STICK = int(ContactMode.SEPARATE), int(ContactMode.STICK)
SLIP_RIGHT, SLIP_LEFT = int(ContactMode.SLIP_RIGHT), int(ContactMode.SLIP_LEFT)
CLEAR, HELD = 4, 5
#: The contact modes that the policies prefer, in the order of `Policy`; none, and the mode so far.
NONE, SO_FAR = -1, -2
PREFERRED = NONE, SEPARATE, SO_FAR, STICK, SLIP_RIGHT, SLIP_LEFT

#: A margin (dimensionless) this far below zero ends a mode; rounding stays above it.
SLACK = 1e-11
#: The fence pushes a slider at rest from this part of the typical speed on.
PUSHES = 2e-10
#: Below this part of the typical speed friction holds the slider.
AT_REST = 1e-9

#: Why a mode ends, or why the modes are enumerated anew; of two at once the first counts. The force leaves
#: the friction cone, a slip or a force ends, the contact is made, the fence begins to push a slider at
#: rest; without a force the contact would part, or no longer; the ring's centre comes down to the fence,
#: the slider comes to rest, the response to the motion is not smooth or a pivot starts or ends; the normal
#: motion of the fence changes its sign, or it starts to move, or its motion along itself changes its sign;
#: a finger comes to the end of its side.
CAUSES = 12
LEAVES_CONE, SLIP_ENDS, FORCE_ENDS, TOUCHES, STARTS, LIFTS = range(6)
LIES, STOPS, KINK, TURNS, TURNS_ALONG, END_OF_SIDE = range(6, CAUSES)
#: Some are watches: their change of sign is an event. The others are margins, positive while a mode lasts.
WATCHED = LIFTS, STOPS, KINK, TURNS, TURNS_ALONG, END_OF_SIDE
WATCHES = tuple(cause in WATCHED for cause in range(CAUSES))

#: What of a scene does not change while it moves: l / R; edges of the friction cone and their angles,
#: and what the law allows there; weight, mass and moment m (rho / R)^2, zero where there is no such
#: effect; centre of mass in the body frame, its distance from the contact, and cosine and sine of the
#: angle of the line there to the rod; typical speed and force, to which slacks are relative; initial gap.
#: And what does change: how often the motion was evaluated, and whether the contact has ended for good;
#: and room for modes, their motions and starts, and rates, on which functions work.
BODY = np.dtype(
    [
        ("length", "f8"), ("right", "f8", (2,)), ("left", "f8", (2,)), ("right_angle", "f8"),
        ("left_angle", "f8"), ("slips", "b1"), ("closed", "b1"), ("rough", "b1"),
        ("weight", "f8"), ("mass", "f8"), ("moment", "f8"), ("center", "f8", (2,)), ("reach", "f8"),
        ("lean", "f8", (2,)), ("speed", "f8"), ("force", "f8"), ("gap", "f8"), ("evaluations", "i8"),
        ("parted", "b1"), ("modes", "i1", (MOST,)), ("motions", "f8", (MOST, MOTION)),
        ("kinds", "i8", (MOST,)), ("starts", "f8", (MOST, 3)), ("rates", "f8", (MOVING,)),
    ],
    align=True,
)  # fmt: skip


class QuasiStatic(NamedTuple):
    """The system of a scene whose effects are all friction; `body` is a record of `BODY`.

    `fence` is the pusher's motion, of a fence or of a finger, of which kind `shape` says.
    """

    effects: tuple[Any, ...]
    body: Any
    fence: Any
    shape: Any


class Inertial(NamedTuple):
    """The system of a scene with inertia."""

    effects: tuple[Any, ...]
    body: Any
    fence: Any
    shape: Any


class Mode(NamedTuple):
    """One way in which the slider moves on: a contact mode, `CLEAR` or `HELD`, during a span of the fence.

    (x, y, spin) is the acceleration with which the slider starts from rest, zero otherwise.
    """

    kind: int
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
#: Write down the modes that may be: span, time, state, kinds, starts. Returns their number.
modes = by_kind(SYSTEMS, "modes")
#: Change the state just after an event: cause, mode, time, state, policy. Returns the time and a `Stop`.
after = by_kind(SYSTEMS, "after")
#: The `Motion` at an instant: mode, time, state.
motion = by_kind(SYSTEMS, "motion")
#: Write down what ends a contact: mode, state, motion, found.
guard_contact = by_kind(SYSTEMS, "guard_contact")


@compiled
def pose(system, state):
    """The slider as the contact sees it."""
    return pose_of(system, rod_of(system.body, state[ANGLE]), state)


@compiled
def pose_of(system, own, state):
    """As `pose`, of a rod that is known."""
    return shapes.pose(system.shape, system.effects, system.body, own, state[ALONG], state[GAP])


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
def initial(system, angle, gap, twist, state):
    """Write down the state at time 0."""
    state[:] = 0.0
    state[GAP], state[ANGLE] = gap, angle
    if len(state) == MOVING:
        own = pose(system, state).own
        state[OVER], state[RISE] = contact_motion(own, twist[0], twist[1], twist[2])
        state[SPIN] = twist[2]


@compiled
def scales(system, found):
    """Write down typical sizes of the state, for the tolerance near zero."""
    length = max(1.0, system.body.length)
    found[:] = length
    found[ANGLE] = 1.0
    found[LOST:OVER] = system.body.force * length
    found[OVER:] = 0.01 * system.body.speed


@compiled
def center_velocity(system, during, time, state):
    """Velocity of the slider's centre, where the twist is part of the state."""
    fence_x, fence_y = velocity(system, during, time, state)
    own = pose(system, state).own
    return contact_motion(own, fence_x + state[OVER], fence_y + state[RISE], -state[SPIN])


@compiled
def pace(system, during, time):
    """Time in which the motion takes the slider about one length, or friction stops it."""
    body, (x, y) = system.body, fence.velocity(system.fence, during, time)
    speed = body.speed if body.mass > 0.0 else sqrt(x * x + y * y)
    along = max(1.0, body.length) / speed if speed > 0.0 else inf
    return min(along, speed * body.mass / body.weight) if body.mass * body.weight > 0.0 else along


@compiled
def settling(system, during, time, state):
    """Rate at which friction turns the twist to its quasi-static direction, 0 without inertia."""
    body = system.body
    if body.mass == 0.0:
        return 0.0
    v_x, v_y = center_velocity(system, during, time, state)
    return body.weight / (body.mass * max(size_of(v_x, v_y, state[SPIN]), AT_REST * body.speed))


@compiled
def contact_mode(kind):
    """The contact mode of what the slider does."""
    return kind if kind < CLEAR else SEPARATE


@compiled
def rank(policy, previous, kind):
    """Place of a contact mode in the order in which a policy takes the modes."""
    preferred = PREFERRED[policy]
    if kind == (previous if preferred == SO_FAR else preferred):
        return SEPARATE
    return SLIP_LEFT + 1 if kind == SEPARATE else kind


@compiled
def rates(system, mode, time, state, found):
    """Write down the derivative of the state."""
    _rates(mode, motion(system, mode, time, state), found)


@compiled
def guards(system, mode, time, state, found):
    """Write down margins and watches by cause, NaN where there is none."""
    _guards(system, mode, state, motion(system, mode, time, state), found)


@compiled
def rates_and_guards(system, mode, time, state, found, guarded):
    """Write down both, of one motion."""
    now = motion(system, mode, time, state)
    _rates(mode, now, found)
    _guards(system, mode, state, now, guarded)


@compiled
def _rates(mode, now, found):
    found[ALONG], found[GAP], found[ANGLE] = now.slip, now.rise, now.spin
    # The contact does not slip while the slider rests or flies over the fence.
    found[SLIP] = now.slip if contact_mode(mode.kind) != SEPARATE else 0.0
    found[LOST] = -now.f_x * now.slip - now.f_y * now.rise
    found[WORK] = now.f_x * now.fence_x + now.f_y * now.fence_y
    found[RUBBED] = now.rubbed
    if len(found) == MOVING:
        found[OVER], found[RISE], found[SPIN] = now.a_x, now.a_y, now.turn


@compiled
def _guards(system, mode, state, now, found):
    body = system.body
    found[:] = nan
    if mode.kind == HELD:
        found[STARTS] = PUSHES - now.fence_y / body.speed
    elif contact_mode(mode.kind) == SEPARATE:
        height = clearance(system, state)
        found[TOUCHES] = height if height < inf else nan
    if mode.kind < CLEAR:
        found[LIES] = shapes.upright(system.shape, body, state[ANGLE], state[GAP])
    if mode.kind != SEPARATE and mode.kind != CLEAR and state[GAP] <= SLACK:
        found[END_OF_SIDE] = shapes.room(system.shape, state[ALONG])
    guard_contact(system, mode, state, now, found)
