"""Contact laws: the force angles that a contact transmits, and whether it slips at their edges."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Protocol, runtime_checkable

import numpy as np

from planar_pushing.mechanics.angles import AngleInterval
from planar_pushing.mechanics.errors import InvalidValue, require_number


@runtime_checkable
class ContactLaw(Protocol):
    """What a contact transmits: an interval of force angles, and what happens at its edges."""

    @property
    def force_angles(self) -> AngleInterval:
        """Angles of the forces that the fence can exert, radians."""
        ...

    @property
    def slips(self) -> bool:
        """Whether the contact slips under a force on an edge of `force_angles`."""
        ...


@dataclass(frozen=True, slots=True)
class Coulomb:
    """Coulomb friction (Sec. 2): |f_t| <= mu f_n, with equality while slipping.

    Parameters
    ----------
    friction_coefficient : float
        mu >= 0 and finite. Infinite friction is a law of its own, `InfiniteFriction`.
    """

    friction_coefficient: float

    def __post_init__(self) -> None:
        require_number(
            "friction_coefficient",
            self.friction_coefficient,
            lambda mu: 0 <= mu < math.inf,
            "a finite number >= 0",
            "use the law of infinite friction where no coefficient is large enough",
        )

    @property
    def force_angles(self) -> AngleInterval:
        right = math.atan2(1.0, self.friction_coefficient)
        return AngleInterval(right, math.pi - right)

    @property
    def slips(self) -> bool:
        return True


@dataclass(frozen=True, slots=True)
class InfiniteFriction:
    """Friction without bound (Secs. 3.2 and 5).

    Parameters
    ----------
    at_zero_normal : {"free", "none"}
        The tangential force where the normal force is zero: "free" is the paper's definition 1,
        under which the contact slips with f_n = 0; "none" is definition 2, under which it cannot.
    """

    at_zero_normal: str = "free"

    def __post_init__(self) -> None:
        if self.at_zero_normal not in ("free", "none"):
            raise InvalidValue(
                "at_zero_normal",
                self.at_zero_normal,
                '"free" or "none"',
                'choose "free" for definition 1 and "none" for definition 2',
            )

    @property
    def force_angles(self) -> AngleInterval:
        return AngleInterval(0.0, math.pi, closed=self.slips)

    @property
    def slips(self) -> bool:
        return self.at_zero_normal == "free"


@dataclass(frozen=True, slots=True)
class PerfectlyRough:
    """Kinematic no-slip (Sec. 5): any force, adhesive where it pulls on the slider."""

    @property
    def force_angles(self) -> AngleInterval:
        return AngleInterval(-math.pi / 2, 3 * math.pi / 2)

    @property
    def slips(self) -> bool:
        return False


def friction_coefficient(law: ContactLaw) -> float:
    """The coefficient of a law: its own, or infinite for the laws that have none."""
    return float(getattr(law, "friction_coefficient", np.inf))
