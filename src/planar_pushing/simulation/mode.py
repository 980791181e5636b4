"""What an event-driven simulation is made of: systems, and modes that last while margins are positive.

The state is a list of floats that starts with the entries of `Entry`; a system adds its own.
"""

from __future__ import annotations

from enum import Enum, IntEnum
from typing import NamedTuple, Protocol

from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.simulation.pusher import Segment
from planar_pushing.simulation.record import Record

State = list[float]

#: A margin (dimensionless) this far below zero ends a mode; rounding stays above it.
SLACK = 1e-11


class Entry(IntEnum):
    """Where the state holds what; the place of the contact is relative to the fence.

    `WORK` is that of the fence. The energies dissipated by each effect of degree 1 follow `WORK`.
    """

    ALONG = 0
    GAP = 1
    ANGLE = 2
    FENCE_X = 3
    FENCE_Y = 4
    SLIP = 5
    CONTACT = 6
    WORK = 7


class Cause(Enum):
    """Why a mode ends, or why the modes are enumerated anew."""

    LEAVES_CONE = "the force leaves the friction cone"
    SLIP_ENDS = "the slip ends"
    FORCE_ENDS = "the contact force ends"
    TOUCHES = "the contact is made"
    STOPS = "the slider comes to rest"
    CHOICE = "another mode may have become consistent"
    KINK = "the response to the motion is not smooth here"
    STARTS = "the fence begins to push a slider at rest"
    LIES = "the ring's centre comes down to the fence"


class Inconsistent(Exception):
    """There is no state after an event; the message says what is not consistent."""


class Guard(NamedTuple):
    """A margin, positive while the mode lasts; or a watch, whose change of sign is an event."""

    cause: Cause
    value: float
    watch: bool = False


class Mode(Protocol):
    """One way in which the slider moves on; made anew at every event."""

    @property
    def kind(self) -> ContactMode:
        """What the contact does."""
        ...

    def force(self, time: float, state: State) -> tuple[float, float]:
        """Force of the fence on the slider."""
        ...

    def rates(self, time: float, state: State) -> State:
        """Derivative of the state."""
        ...

    def guards(self, time: float, state: State) -> tuple[Guard, ...]:
        """Margins and watches, always the same ones in the same order."""
        ...


class System(Protocol):
    """The equations of a scene: which modes there are, and what happens between them."""

    def initial(self) -> State:
        """State at time 0."""
        ...

    def scales(self) -> list[float]:
        """Typical size of each entry of the state, to which the tolerance is relative near zero."""
        ...

    def pace(self, time: float) -> float:
        """Time in which the motion takes the slider about one length."""
        ...

    def settling(self, time: float, state: State) -> float:
        """Rate at which friction turns the twist towards its quasi-static direction; 0 without inertia."""
        ...

    def enter(self, segment: Segment, state: State, mode: Mode | None) -> State:
        """State just after the fence has taken up the motion of a segment; errors as in `after`."""
        ...

    def modes(self, time: float, state: State) -> list[Mode]:
        """Modes whose conditions hold at this instant."""
        ...

    def after(self, cause: Cause, time: float, state: State, mode: Mode) -> tuple[float, State]:
        """Time and state just after an event that ends a mode.

        Raises
        ------
        Inconsistent
            Where there is no such state.
        """
        ...

    def record(self, time: float, state: State, mode: Mode | None, solutions: int) -> Record:
        """What is logged at an instant."""
        ...
