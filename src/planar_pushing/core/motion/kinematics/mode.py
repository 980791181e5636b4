"""The modes of a run: a possible continuation of the motion, and which of several a policy prefers."""

from __future__ import annotations

from typing import NamedTuple

from planar_pushing.core.instant.solution import (
    SEPARATE,
    SLIP_LEFT,
    SLIP_RIGHT,
    STICK,
)
from planar_pushing.core.motion.kinematics.fence import Span
from planar_pushing.core.supports.rows import (
    Vector,
)

#: A slider at rest, in addition to the contact modes; no mode.
REST = 4


NO_MODE = -1


#: Policies (`Policy`).
KEEP_CONTACT, PREFER_SEPARATE, STAY_IN_MODE, PREFER_STICK, PREFER_RIGHT, PREFER_LEFT = range(6)


class Mode(NamedTuple):
    """A possible continuation of the motion during a span of the pusher's motion.

    Attributes
    ----------
    contact : int
        Contact mode, or `REST`.
    foot : int
        Number of the support point at the center of rotation, -1 without one.
    hinged : bool
        Whether friction holds this point like a hinge.
    departure : int
        Which of the ways in which it can leave the center otherwise, from 1 (`leaving_friction`).
    touches : bool
        Whether a slider at rest touches the pusher.
    rests_in : int
        Contact mode of a slider at rest.
    f_x, f_y, offset : float
        Force of a slider at rest, and its place along the fence, from the contact.
    start : Vector
        Acceleration of a slider that starts from rest, otherwise zero.
    u_x, u_y : float
        Motion of the contact in a slip without inertia.
    during : Span
    """

    contact: int
    foot: int
    hinged: bool
    departure: int
    touches: bool
    rests_in: int
    f_x: float
    f_y: float
    offset: float
    start: Vector
    u_x: float
    u_y: float
    during: Span


def moving_mode(contact: int, foot: int, hinged: bool, departure: int, during: Span) -> Mode:
    """A mode of a slider that moves."""
    return Mode(
        contact, foot, hinged, departure, touches=False, rests_in=NO_MODE, f_x=0.0, f_y=0.0,
        offset=0.0, start=Vector(0.0, 0.0, 0.0), u_x=0.0, u_y=0.0, during=during,
    )  # fmt: skip


def contact_mode_of(mode: Mode) -> int:
    """The contact mode, also of a slider at rest."""
    return mode.rests_in if mode.contact == REST else mode.contact


def is_preferred(policy: int, current: int, contact: int, other: int) -> bool:
    """Whether a policy prefers a contact mode to another one, or to none, in a current mode."""
    return other == NO_MODE or _rank_of(policy, current, contact) < _rank_of(policy, current, other)


def _rank_of(policy: int, current: int, contact: int) -> int:
    """Rank of a contact mode in the order of preference of a policy."""
    preferred = NO_MODE
    if policy == PREFER_SEPARATE:
        preferred = SEPARATE
    elif policy == STAY_IN_MODE:
        preferred = current
    elif policy >= PREFER_STICK:
        preferred = STICK + (policy - PREFER_STICK)
    if contact == preferred:
        return SEPARATE
    return SLIP_LEFT + 1 if contact == SEPARATE else contact


def slip_side(contact: int) -> float:
    """Direction of slip as 1 or -1, 0 in a mode without slip."""
    return 1.0 if contact == SLIP_RIGHT else -1.0 if contact == SLIP_LEFT else 0.0
