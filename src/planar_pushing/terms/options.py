"""Enumerations: options of files, Python and the command line, and the flags of results.

An option is given as the enum or as its value. Contact modes, outcomes and statuses are flags.
"""

from __future__ import annotations

from collections.abc import Mapping
from enum import IntEnum, StrEnum
from typing import Literal, NamedTuple


class Policy(StrEnum):
    """Choice of a mode if several are consistent.

    `KEEP_CONTACT` prefers sticking to slip, and slip to separation. The others prefer one mode, and act
    like `KEEP_CONTACT` if that mode is not consistent.
    """

    KEEP_CONTACT = "keep-contact"
    SEPARATE = "separate"
    STAY_IN_MODE = "stay-in-mode"
    STICK = "stick"
    SLIP_RIGHT = "slip-right"
    SLIP_LEFT = "slip-left"


#: The enum, or its value.
PolicyName = (
    Policy | Literal["keep-contact", "separate", "stay-in-mode", "stick", "slip-right", "slip-left"]
)


class Method(StrEnum):
    """Method of integration over time."""

    EVENT_DRIVEN = "event-driven"
    TIME_STEPPING = "time-stepping"


#: The enum, or its value.
MethodName = Method | Literal["event-driven", "time-stepping"]


class Shape(StrEnum):
    """Shape of the pusher: a line that touches a point of the slider, or a point that touches a side."""

    FENCE = "fence"
    FINGER = "finger"


class PusherFrame(StrEnum):
    """Frame of the pusher's motion: the fence frame at time 0, or the world."""

    FENCE = "fence"
    WORLD = "world"


class AtZeroNormal(StrEnum):
    """Tangential force of infinite friction at zero normal force: the paper's definitions 1 and 2."""

    FREE = "free"
    NONE = "none"


class Sense(StrEnum):
    """Sense of a rotation, seen from above."""

    COUNTERCLOCKWISE = "counterclockwise"
    CLOCKWISE = "clockwise"


class StableBound(StrEnum):
    """What ends a set of stable pushes: the load is at the edge of what the two ends of a side can exert.

    The force is on the right or left edge of the contact law's cone; its line of action passes through the
    start or the end of the side; or the object turns about a foot, whose friction can leave the cone. The
    pivot itself, a single point, does not belong to the set.
    """

    RIGHT_EDGE = "right-edge"
    LEFT_EDGE = "left-edge"
    START = "start"
    END = "end"
    PIVOT = "pivot"


class EffectKind(StrEnum):
    """Effects that resist or drive the motion, by their names in files and datasets."""

    SUPPORT_FRICTION = "support_friction"
    INERTIA = "inertia"
    VISCOUS = "viscous"
    LOAD = "load"


class EffectSet(StrEnum):
    """Sets of effects that together resist the motion, by their names in studies and datasets."""

    SUPPORT_FRICTION = EffectKind.SUPPORT_FRICTION.value
    INERTIA = EffectKind.INERTIA.value
    BOTH = f"{EffectKind.SUPPORT_FRICTION}+{EffectKind.INERTIA}"


#: The effects of studies.
STUDIED = (EffectKind.SUPPORT_FRICTION, EffectKind.INERTIA)


class Range(NamedTuple):
    """A closed range of numbers, as bounds and in words."""

    minimum: float
    maximum: float
    allowed: str

    def holds(self, number: float) -> bool:
        """Whether a number lies in the range."""
        return self.minimum <= number <= self.maximum


#: Nonzero speeds in simulations, whose squares are doubles also in units of the smallest tolerance.
SPEED = Range(1e-140, 1e140, "0, or a number in [1e-140, 1e140]")
#: Number of entries of a log at equal intervals, limited by memory, and of equal time steps, limited by
#: hours of computation.
SAMPLES = Range(2, 1e7, "a whole number >= 2, at most 1e7")
MOST_STEPS = 1e9
#: Relative tolerance of a simulation, limited by double precision.
TOLERANCE = Range(1e-13, 1e-2, "a number in [1e-13, 1e-2]")


class Event(IntEnum):
    """Reason why a contact mode ends or the modes are enumerated again: values of `event` in a log."""

    NONE = -1
    #: The force leaves the friction cone; a slip ends, or a force, also at one end of a side on the fence;
    #: the contact is made.
    LEAVES_CONE = 0
    SLIP_ENDS = 1
    FORCE_ENDS = 2
    TOUCHES = 3
    #: The pusher starts to push a slider at rest.
    PUSH_STARTS = 4
    #: Without a contact force, the contact would now separate, or no longer separate.
    SEPARATION_CHANGES = 5
    #: Friction no longer holds the support point about which the slider pivots.
    PIVOT_YIELDS = 6
    #: The slider's center reaches the fence; the slider comes to rest.
    SLIDER_CENTER_REACHES_FENCE = 7
    SLIDER_STOPS = 8
    #: The motion center reaches a support point, or leaves it.
    MOTION_CENTER_AT_POINT = 9
    #: The response to the motion is not smooth, or a pivot starts or ends.
    KINK = 10
    #: The normal or the tangential velocity of the pusher changes sign, or starts.
    NORMAL_VELOCITY_REVERSES = 11
    TANGENTIAL_VELOCITY_REVERSES = 12
    #: The contact reaches the end of a finger's side, or that of a piece of the outline; not in flight.
    END_OF_SIDE = 13
    #: Another point of the outline meets the pusher: a side arrives on a fence, or a finger touches two.
    PENETRATES = 14


def name_of(member: IntEnum) -> str:
    """The printed form of a member, which is its name; `int` gives its number."""
    return member.name


def format_member(member: IntEnum, format_spec: str) -> str:
    """A member in a formatted string: its name, or its number with the format d."""
    number = format_spec.endswith("d")
    return format(int(member) if number else member.name, format_spec)


class ContactMode(IntEnum):
    """The motion at the contact; in a slip the slider moves to the right or to the left along the fence."""

    SEPARATE = 0
    STICK = 1
    SLIP_RIGHT = 2
    SLIP_LEFT = 3

    __str__ = name_of
    __format__ = format_member


class Outcome(IntEnum):
    """How many solutions are consistent: none, one, or several; a continuum counts as several."""

    INCONSISTENT = 0
    UNIQUE = 1
    AMBIGUOUS = 2

    __str__ = name_of
    __format__ = format_member


class Status(IntEnum):
    """The status of the solutions of one push, or of a curve at one angle.

    `NONE`: no mode is consistent. `CONSISTENT`: every solution is an isolated motion. `PIVOTS`: one of
    them is a rotation about a support point, which is the same for an interval of forces. `CONTINUUM`: one
    of them belongs to a continuum of motions. `UNSOLVED`: an iteration has not converged, or there are
    more slips than expected.
    """

    NONE = 0
    CONSISTENT = 1
    PIVOTS = 2
    CONTINUUM = 3
    UNSOLVED = 4

    __str__ = name_of
    __format__ = format_member


class Reason(IntEnum):
    """Why several contacts have no consistent solution.

    `JAMMED`: the pushers close every motion in, so that something must yield. `WEDGED`: each contact holds
    whatever the other exerts, because forces of their friction cones cancel one another.
    """

    JAMMED = 1
    WEDGED = 2

    __str__ = name_of
    __format__ = format_member


#: Names of the values of variables that hold flags, in datasets of every kind.
FLAGS: dict[str, Mapping[str, int]] = {
    "mode": ContactMode.__members__,
    "outcome": Outcome.__members__,
    "status": Status.__members__,
}
#: Description of the value of a mode after the last solution.
BEHIND = "-1 after the last solution"
