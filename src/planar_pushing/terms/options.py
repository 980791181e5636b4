"""Options that files, Python and the command line share: their names, and what they allow.

An option is given as the enum or as its value.
"""

from __future__ import annotations

from enum import IntEnum, StrEnum
from typing import Literal, NamedTuple


class Policy(StrEnum):
    """Which mode is taken where several are consistent.

    `KEEP_CONTACT` takes sticking before slip and separation last. The others prefer a mode, and act like
    `KEEP_CONTACT` where that mode is not consistent.
    """

    KEEP_CONTACT = "keep-contact"
    SEPARATE = "separate"
    STAY_IN_MODE = "stay-in-mode"
    STICK = "stick"
    SLIP_RIGHT = "slip-right"
    SLIP_LEFT = "slip-left"


#: The same as the enum, or as its value.
PolicyName = (
    Policy | Literal["keep-contact", "separate", "stay-in-mode", "stick", "slip-right", "slip-left"]
)


class Method(StrEnum):
    """How a motion is integrated over time."""

    EVENT_DRIVEN = "event-driven"
    TIME_STEPPING = "time-stepping"


#: The same as the enum, or as its value.
MethodName = Method | Literal["event-driven", "time-stepping"]


class Shape(StrEnum):
    """What pushes: a line against a point of the slider, or a point against a side of it."""

    FENCE = "fence"
    FINGER = "finger"


class PusherFrame(StrEnum):
    """Axes along which the pusher moves: those of the fence frame at time 0, or of the world."""

    FENCE = "fence"
    WORLD = "world"


class AtZeroNormal(StrEnum):
    """Tangential force of infinite friction without normal force: the paper's definitions 1 and 2."""

    FREE = "free"
    NONE = "none"


class EffectKind(StrEnum):
    """What resists or drives the motion, by its name in files and datasets."""

    SUPPORT_FRICTION = "support_friction"
    INERTIA = "inertia"
    VISCOUS = "viscous"
    LOAD = "load"


class EffectSet(StrEnum):
    """The effects that resist the motion together, by their name in studies and datasets."""

    SUPPORT_FRICTION = EffectKind.SUPPORT_FRICTION.value
    INERTIA = EffectKind.INERTIA.value
    BOTH = f"{EffectKind.SUPPORT_FRICTION}+{EffectKind.INERTIA}"


#: Effects by the types that scene files give them.
EFFECT_TYPES = {
    "ring_friction": EffectKind.SUPPORT_FRICTION,
    "support_friction": EffectKind.SUPPORT_FRICTION,
    "inertia": EffectKind.INERTIA,
    "viscous": EffectKind.VISCOUS,
    "load": EffectKind.LOAD,
}
#: Effects by the names of their classes.
EFFECT_CLASSES = {
    "RingFriction": EffectKind.SUPPORT_FRICTION,
    "SupportFriction": EffectKind.SUPPORT_FRICTION,
    "Inertia": EffectKind.INERTIA,
    "Viscous": EffectKind.VISCOUS,
    "Load": EffectKind.LOAD,
}
#: The effects of studies.
STUDIED = (EffectKind.SUPPORT_FRICTION, EffectKind.INERTIA)


class Range(NamedTuple):
    """A closed range of numbers, in figures and in words."""

    least: float
    most: float
    allowed: str

    def holds(self, number: float) -> bool:
        """Whether a number lies in the range."""
        return self.least <= number <= self.most


#: Speeds over time other than 0: the square of one, in units of the least tolerance, is a double.
SPEED = Range(1e-140, 1e140, "0, or a number in [1e-140, 1e140]")
#: Entries of a log at even intervals, and steps of equal length: what a run can hold, and do in hours.
SAMPLES = Range(2, 1e7, "a whole number >= 2, at most 1e7")
MOST_STEPS = 1e9
#: Relative tolerance of a motion over time: what double precision can hold.
TOLERANCE = Range(1e-13, 1e-2, "a number in [1e-13, 1e-2]")


class Event(IntEnum):
    """Why a contact mode ends, or why the modes are enumerated anew: flags of `event` in a log."""

    NONE = -1
    #: The force leaves the friction cone; a slip or a force ends; the contact is made.
    LEAVES_CONE = 0
    SLIP_ENDS = 1
    FORCE_ENDS = 2
    TOUCHES = 3
    #: The fence begins to push a slider at rest; without a force the contact would part, or no longer.
    STARTS = 4
    LIFTS = 5
    #: Friction no longer holds the support point about which the slider pivots.
    HINGE_YIELDS = 6
    #: The slider's center comes down to the fence; the slider comes to rest.
    LIES = 7
    STOPS = 8
    #: The center of rotation arrives at a support point, or leaves it.
    ARRIVES = 9
    #: The response to the motion is not smooth, or a pivot starts or ends.
    KINK = 10
    #: The normal motion of the fence changes its sign, or it starts to move; that along itself does.
    TURNS = 11
    TURNS_ALONG = 12
    #: A finger comes to the end of its side.
    END_OF_SIDE = 13
    #: Another point of the outline meets the fence.
    PENETRATES = 14
