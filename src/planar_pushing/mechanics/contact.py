"""Contact laws: the angles of the forces that a contact transmits, and whether it slips at their limits.

The modes of a contact and the outcomes of a push come from `terms.options` and are public here, too.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Annotated, Any, Literal, NamedTuple, Protocol, runtime_checkable

import numpy as np

from planar_pushing.mechanics.angles import AngleInterval
from planar_pushing.mechanics.kernels.arrays import same
from planar_pushing.terms.caches import cache_results
from planar_pushing.terms.declared import Within, one_of, require_declared
from planar_pushing.terms.domain import ROUGHEST, Number, Parameter
from planar_pushing.terms.options import AtZeroNormal
from planar_pushing.terms.options import ContactMode as ContactMode
from planar_pushing.terms.options import Outcome as Outcome
from planar_pushing.terms.options import Status as Status


@runtime_checkable
class ContactLaw(Protocol):
    """The forces that a contact transmits: an interval of angles, and whether it slips at the edges."""

    @property
    def force_angles(self) -> AngleInterval:
        """Angles of the forces that the fence can exert, in radians."""
        ...

    @property
    def slips(self) -> bool:
        """Whether the contact slips under a force on an edge of `force_angles`."""
        ...


#: Number of laws whose numbers are kept.
KEPT = 64
#: Declarations of the parameters of contact laws.
FRICTION_COEFFICIENT = Within(
    lambda x: (x >= 0) & (x <= ROUGHEST), f"a number in [0, {ROUGHEST:g}]",
    "use the law of infinite friction where no coefficient is large enough",
    {"type": "number", "minimum": 0, "maximum": ROUGHEST},
)  # fmt: skip
AT_ZERO_NORMAL = one_of(
    AtZeroNormal, '"free" or "none"',
    'choose "free" for definition 1 and "none" for definition 2',
)  # fmt: skip


@dataclass(frozen=True, slots=True)
class Coulomb:
    """Coulomb friction (Sec. 2): |f_t| <= mu f_n, with equality while slipping.

    Parameters
    ----------
    friction_coefficient : float or array
        mu in [0, 1e9]. For infinite friction use `InfiniteFriction`.
    """

    friction_coefficient: Annotated[Parameter, FRICTION_COEFFICIENT]

    def __post_init__(self) -> None:
        require_declared(self)

    def __eq__(self, other: object) -> Any:
        return same(self, other)

    @property
    def force_angles(self) -> AngleInterval:
        right = np.arctan2(1.0, self.friction_coefficient)
        right = float(right) if isinstance(right, float) else right
        return AngleInterval(right, math.pi - right)

    @property
    def slips(self) -> bool:
        return True


@dataclass(frozen=True, slots=True)
class InfiniteFriction:
    """Infinite friction (Secs. 3.2 and 5).

    Parameters
    ----------
    at_zero_normal : {"free", "none"}
        Tangential force at zero normal force: any with "free", the paper's definition 1, under which the
        contact can slip with f_n = 0; zero with "none", definition 2, under which it cannot.
    """

    at_zero_normal: Annotated[AtZeroNormal | Literal["free", "none"], AT_ZERO_NORMAL] = "free"

    def __post_init__(self) -> None:
        require_declared(self)

    @property
    def force_angles(self) -> AngleInterval:
        return AngleInterval(0.0, math.pi, closed=self.slips)

    @property
    def slips(self) -> bool:
        return self.at_zero_normal == "free"


@dataclass(frozen=True, slots=True)
class PerfectlyRough:
    """Kinematic no-slip (Sec. 5): the contact transmits any force, also an adhesive one that pulls."""

    @property
    def force_angles(self) -> AngleInterval:
        return AngleInterval(-math.pi / 2, 3 * math.pi / 2)

    @property
    def slips(self) -> bool:
        return False


#: Contact laws by their names in scene files.
LAWS = {
    "coulomb": Coulomb,
    "infinite_friction": InfiniteFriction,
    "perfectly_rough": PerfectlyRough,
}


def friction_coefficient(law: ContactLaw) -> float:
    """The friction coefficient of a law; infinite for laws without one."""
    return float(getattr(law, "friction_coefficient", np.inf))


class Law(NamedTuple):
    """A contact law in numbers: the edges of its cone, and the behavior there.

    A `rough` law transmits every force. In the public layer each entry is a number or an array.
    """

    right: Number
    left: Number
    slips: Number
    closed: Number
    rough: Number


def in_numbers(law: ContactLaw) -> Law:
    """A law in the form of the core."""
    # A law of the user's own kind can change.
    return _known_in_numbers(law) if type(law) in LAWS.values() else _in_numbers(law)


def _in_numbers(law: ContactLaw) -> Law:
    cone = law.force_angles
    rough = np.ndim(cone.right) == 0 and cone.span > math.pi
    return Law(cone.right, cone.left, law.slips, cone.closed, rough)


_known_in_numbers = cache_results(KEPT)(_in_numbers)


def is_law(law: object) -> bool:
    """Whether an object is a contact law, and not a class of one."""
    known = isinstance(law, tuple(LAWS.values()))
    return known or (isinstance(law, ContactLaw) and not isinstance(law, type))


def as_numbers(contact: Number) -> Law:
    """A law, or an array of laws of any kinds, in the form of the core."""
    if not isinstance(contact, (list, tuple)) and not hasattr(contact, "ndim"):
        return in_numbers(contact)
    laws = np.asarray(contact, dtype=object)
    entries = zip(*(in_numbers(law) for law in laws.ravel()), strict=True)
    columns = (np.array(entry).reshape(laws.shape) for entry in entries)
    if hasattr(contact, "dims"):
        return Law(*(contact.copy(data=column) for column in columns))
    return Law(*columns)
