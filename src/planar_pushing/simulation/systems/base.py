"""What a simulation is made of: a system, its state, and modes that last while margins are positive.

A system is a named tuple of a kind of its own; the functions below choose by that kind, so that what a
scene does not list is not compiled into its integrators.
"""

from __future__ import annotations

from collections.abc import Callable
from enum import IntEnum
from math import atan2
from typing import Any, NamedTuple

import numpy as np

from planar_pushing.mechanics.compiled import compiled, generic
from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.mechanics.contact.laws import Law
from planar_pushing.simulation.fence import Span

#: Of each kind of system, the module of its equations.
SYSTEMS: dict[type, Any] = {}

#: Where the state holds what: place of the contact relative to the fence, rod angle, slip accumulated,
#: energy dissipated at the contact, work of the fence, energy dissipated by friction of the support. A
#: system with inertia adds the velocity of the contact over the fence and the rotation.
ALONG, GAP, ANGLE, SLIP, LOST, WORK, RUBBED, OVER, RISE, SPIN = range(10)
#: Entries of the state without and with inertia.
STILL, MOVING = OVER, SPIN + 1
#: Policies in the core, in the order of `Policy`.
KEEPS, LEAVES, STAYS = range(3)

#: What the slider does: the contact modes, of which `SEPARATE` is a flight, and rests clear of the fence
#: and on it.
SEPARATE, STICK = int(ContactMode.SEPARATE), int(ContactMode.STICK)
SLIP_RIGHT, SLIP_LEFT = int(ContactMode.SLIP_RIGHT), int(ContactMode.SLIP_LEFT)
CLEAR, HELD = 4, 5

#: A margin (dimensionless) this far below zero ends a mode; rounding stays above it.
SLACK = 1e-11


class Cause(IntEnum):
    """Why a mode ends, or why the modes are enumerated anew; of two at once the first counts."""

    LEAVES_CONE = 0  # the force leaves the friction cone
    SLIP_ENDS = 1
    FORCE_ENDS = 2
    TOUCHES = 3  # the contact is made
    STARTS = 4  # the fence begins to push a slider at rest
    LIFTS = 5  # without a force the contact would part, or no longer
    LIES = 6  # the ring's centre comes down to the fence
    STOPS = 7  # the slider comes to rest
    KINK = 8  # the response to the motion is not smooth here
    TURNS = 9  # the fence's normal motion changes its sign, or it starts to move
    TURNS_ALONG = 10


CAUSES = len(Cause)
LEAVES_CONE, SLIP_ENDS, FORCE_ENDS, TOUCHES, STARTS, LIFTS = range(6)
LIES, STOPS, KINK, TURNS, TURNS_ALONG = range(6, CAUSES)
#: These are watches: their change of sign is an event. The others are margins, positive while a mode lasts.
FIRST_WATCHES = (LIFTS, STOPS, KINK, TURNS, TURNS_ALONG)
WATCHES = tuple(cause in FIRST_WATCHES for cause in range(CAUSES))


#: What of a scene does not change while it moves: l / R; edges of the friction cone and their angles,
#: and what the law allows there; weight, mass and moment m (rho / R)^2, zero where there is no such
#: effect; typical speed and force, to which slacks are relative; initial gap. And what does change: how
#: often the motion was evaluated.
BODY = np.dtype(
    [
        ("length", "f8"), ("right", "f8", (2,)), ("left", "f8", (2,)), ("right_angle", "f8"),
        ("left_angle", "f8"), ("slips", "b1"), ("closed", "b1"), ("rough", "b1"),
        ("weight", "f8"), ("mass", "f8"), ("moment", "f8"), ("speed", "f8"), ("force", "f8"),
        ("gap", "f8"), ("evaluations", "i8"),
    ],
    align=True,
)  # fmt: skip


class QuasiStatic(NamedTuple):
    """The system of a scene whose effects are all friction; `body` is a record of `BODY`."""

    effects: tuple[Any, ...]
    body: Any
    fence: Any


class Inertial(NamedTuple):
    """The system of a scene with inertia."""

    effects: tuple[Any, ...]
    body: Any
    fence: Any


class Mode(NamedTuple):
    """One way in which the slider moves on during a span of the fence's motion.

    Attributes
    ----------
    kind : int
        A contact mode, `CLEAR` or `HELD`.
    x, y, spin : float
        Acceleration with which the slider starts from rest; zero otherwise.
    during : Span
    """

    kind: int
    x: float
    y: float
    spin: float
    during: Span


@compiled
def contact_mode(kind):
    """The contact mode of what the slider does."""
    return kind if kind < CLEAR else SEPARATE


@compiled
def rank(policy, previous, kind):
    """Place of a contact mode in the order in which a policy takes the modes."""
    if policy == STAYS and kind == previous:
        return -1
    if kind == SEPARATE:
        return 0 if policy == LEAVES else SLIP_LEFT + 1
    return kind


def member(module: Any, name: str) -> Callable[..., Any]:
    """A function of a member of a family, which is a module."""
    found: Callable[..., Any] = getattr(module, name)
    return found


@generic
def initial(kind: Any) -> Callable[..., Any]:
    """Write down the state at time 0: system, rod angle, gap, twist, state."""
    return member(SYSTEMS[kind], "initial")


@generic
def scales(kind: Any) -> Callable[..., Any]:
    """Write down typical sizes of the state, for the tolerance near zero: system, sizes."""
    return member(SYSTEMS[kind], "scales")


@generic
def pace(kind: Any) -> Callable[..., Any]:
    """Time in which the motion takes the slider about one length: system, span, time."""
    return member(SYSTEMS[kind], "pace")


@generic
def settling(kind: Any) -> Callable[..., Any]:
    """Rate at which friction turns the twist to its quasi-static direction: system, span, time, state."""
    return member(SYSTEMS[kind], "settling")


@generic
def enter(kind: Any) -> Callable[..., Any]:
    """Change the state where the fence takes up the motion of a span: system, index, state, mode, policy.

    Returns 0, or the `Stop` that says why there is no such state.
    """
    return member(SYSTEMS[kind], "enter")


@generic
def modes(kind: Any) -> Callable[..., Any]:
    """Write down the modes that may be: system, span, time, state, kinds, starts; their number."""
    return member(SYSTEMS[kind], "modes")


@generic
def after(kind: Any) -> Callable[..., Any]:
    """Change the state just after an event: system, cause, mode, time, state, policy; time and `Stop`."""
    return member(SYSTEMS[kind], "after")


@generic
def rates(kind: Any) -> Callable[..., Any]:
    """Write down the derivative of the state: system, mode, time, state, found."""
    return member(SYSTEMS[kind], "rates")


@generic
def guards(kind: Any) -> Callable[..., Any]:
    """Write down margins and watches by cause, NaN where none is: system, mode, time, state, found."""
    return member(SYSTEMS[kind], "guards")


@generic
def write(kind: Any) -> Callable[..., Any]:
    """Write down position, twist, force, spin ratio and kinetic energy: system, mode, time, state, row.

    The displacement of the fence is in the row already.
    """
    return member(SYSTEMS[kind], "write")


@compiled
def edge_of(body, kind):
    """Direction of the force in a slipping mode: on the edge opposite to the slip."""
    if kind == SLIP_RIGHT:
        return body.left[0], body.left[1]
    return body.right[0], body.right[1]


@compiled
def law_of(body):
    """The contact law."""
    return Law(body.right_angle, body.left_angle, body.slips, body.closed, body.rough)


@compiled
def margin(body, f_x, f_y, least):
    """Margin of a force in the friction cone, negative outside; forces below `least` count as none.

    The angle left to the nearer edge, weighted so that it is smooth and 0 for no force.
    """
    if body.rough:
        return 1.0
    size = (f_x * f_x + f_y * f_y) ** 0.5
    lean = (body.left_angle - body.right_angle) / 2 - abs(atan2(f_x, f_y))
    return lean * size / (size + least) if size > 0.0 else 0.0
