"""Contacts on a side at which a force exerts a load of a set, and the minimum friction that they need.

Forces have two components here, along the tangent of the side and along its inward normal. Lengths x along
the side are measured from the projection of a foot r on the side's line, and h is the height of the foot
above it. A force at x has its load in the set if it is in the disc of the foot, ``|f - f_0| <= p``, and has
the torque of the rest about the foot, ``h f_t + x f_n = M``. At each x this line cuts a chord from the
disc. All lines pass through (M / h, 0), and those tangent to the disc are at the ends of the intervals of
contacts.
"""

from __future__ import annotations

from itertools import pairwise
from math import copysign, hypot, inf, sqrt
from typing import NamedTuple

from planar_pushing.mechanics.plane import Array
from planar_pushing.objects.boundary import OutlineSide
from planar_pushing.objects.wrench_set import WrenchSet
from planar_pushing.terms.domain import ROUGHEST

#: Rounding error of the torque of a load, relative to its terms.
ROUNDING = 1e-13


class Contact(NamedTuple):
    """A contact on a side.

    Attributes
    ----------
    position : float
        Distance from the start of the side.
    along, normal : float
        Components of the force that needs the least friction.
    friction : float
        |along| / normal of this force; infinite at an end that is a limit of contacts but not itself one.
    """

    position: float
    along: float
    normal: float
    friction: float


class Stretch(NamedTuple):
    """An interval of contacts: the one of least friction, and both ends; all equal for a single contact."""

    best: Contact
    start: Contact
    end: Contact


class ForceDisc(NamedTuple):
    """The forces of a set relative to a side: center, radius p, height h, torque M, and the side's ends."""

    along: float
    normal: float
    radius: float
    height: float
    torque: float
    low: float
    high: float


def stretches(side: OutlineSide, loads: WrenchSet) -> list[Stretch]:
    """The contacts on a side at which a push exerts a load of the set, in order along the side."""
    force, torque = loads.offset[:2], float(loads.offset[2])
    along, normal = float(force @ side.tangent), float(force @ side.normal)
    slack = ROUNDING * (abs(torque) + hypot(along, normal) * hypot(*side.start, *side.end))
    if loads.foot is None:
        return _meeting(along, normal, torque - _cross(side.start, force), slack, side.length)
    low = float((side.start - loads.foot) @ side.tangent)
    disc = ForceDisc(
        along, normal, loads.radius, float((loads.foot - side.start) @ side.normal),
        torque - _cross(loads.foot, force), low, low + side.length,
    )  # fmt: skip
    intervals = _stretches(disc, ROUNDING * hypot(*side.start, *side.end))
    return [
        Stretch(*(contact._replace(position=contact.position - low) for contact in stretch))
        for stretch in intervals
    ]


def _cross(one: Array, other: Array) -> float:
    return float(one[0] * other[1] - one[1] * other[0])


def friction(along: float, normal: float) -> float:
    """Minimum coefficient for a force; infinite if the normal force is not positive to rounding."""
    return abs(along) / normal if normal > 0.0 and normal * ROUGHEST >= abs(along) else inf


def _meeting(
    along: float, normal: float, torque: float, slack: float, length: float
) -> list[Stretch]:
    """Contact at which the line of action of a load meets a side; a corner belongs to both of its sides."""
    coefficient = friction(along, normal)
    if coefficient == inf:
        return []
    position, error = torque / normal, slack / normal
    if not -error <= position <= length + error:
        return []
    near = next((end for end in (0.0, length) if abs(position - end) <= error), position)
    contact = Contact(near, along, normal, coefficient)
    return [Stretch(contact, contact, contact)]


def _stretches(disc: ForceDisc, slack: float) -> list[Stretch]:
    """Intervals of contacts on a side, between its ends and the lines tangent to the disc."""
    low, high = disc.low - slack, disc.high + slack
    cuts = [low, *(x for x in _touching(disc) if low < x < high), high]
    intervals = []
    for start, end in pairwise(cuts):
        middle = (start + end) / 2.0
        if _meets(disc, middle) and _best_contact(disc, middle).friction < inf:
            ends = [min(max(x, disc.low), disc.high) for x in (start, end)]
            intervals.append(_stretch(disc, *ends))
    return intervals


def _touching(disc: ForceDisc) -> list[float]:
    """Places whose line of forces is tangent to the disc, ``(h f_t + x f_n - M)^2 = p^2 (h^2 + x^2)``."""
    offset = disc.height * disc.along - disc.torque
    lead = (disc.normal - disc.radius) * (disc.normal + disc.radius)
    reach = disc.radius * disc.height
    last, middle = (offset - reach) * (offset + reach), disc.normal * offset
    root = offset * offset + disc.height * disc.height * lead
    if root < -ROUNDING * (offset * offset + reach * reach):
        return []
    # The root of larger magnitude comes first, so that neither is a difference of large numbers.
    large = -(middle + copysign(disc.radius * sqrt(max(root, 0.0)), middle))
    fractions = ((large, lead), (last, large))
    return sorted(top / bottom for top, bottom in fractions if bottom != 0.0)


def _meets(disc: ForceDisc, x: float) -> bool:
    """Whether the line of forces at x meets the disc."""
    away = disc.height * disc.along + x * disc.normal - disc.torque
    return abs(away) <= disc.radius * hypot(disc.height, x)


def _best_contact(disc: ForceDisc, x: float) -> Contact:
    """Contact at x, where the line of forces meets the disc, with the force that needs least friction."""
    size = hypot(disc.height, x)
    if size == 0.0:
        return Contact(x, disc.along, disc.normal, inf)
    n_t, n_n = disc.height / size, x / size
    away = disc.torque / size - n_t * disc.along - n_n * disc.normal
    half = sqrt(max((disc.radius - away) * (disc.radius + away), 0.0))
    middle = disc.along + away * n_t, disc.normal + away * n_n
    ends = [(middle[0] - sign * half * n_n, middle[1] + sign * half * n_t) for sign in (1.0, -1.0)]
    (one, other), straight = ends, []
    if one[0] * other[0] < 0.0:
        part = one[0] / (one[0] - other[0])
        straight = [(0.0, one[1] + part * (other[1] - one[1]))]
    along, normal = min([*straight, *ends], key=lambda force: friction(*force))
    return Contact(x, along, normal, friction(along, normal))


def _stretch(disc: ForceDisc, start: float, end: float) -> Stretch:
    """An interval of contacts, with its contact of least friction.

    The coefficient is monotone along a chord, so its minimum is zero or on the rim: where a line through
    the origin of forces is tangent to the disc, or on the chord of an end.
    """
    ends = _best_contact(disc, start), _best_contact(disc, end)
    inside = [contact for contact in _extreme(disc) if start <= contact.position <= end]
    best = min(
        [*_frictionless(disc, start, end), *inside, *ends], key=lambda contact: contact.friction
    )
    return Stretch(best, *ends)


def _extreme(disc: ForceDisc) -> list[Contact]:
    """Contacts with forces whose direction is tangent to the disc."""
    square = disc.along * disc.along + disc.normal * disc.normal
    inner = square - disc.radius * disc.radius
    if inner <= 0.0:
        return []
    offset, contacts = disc.radius * sqrt(inner), []
    for sign in (offset, -offset):
        along = (inner * disc.along - sign * disc.normal) / square
        normal = (inner * disc.normal + sign * disc.along) / square
        if friction(along, normal) < inf:
            position = (disc.torque - disc.height * along) / normal
            contacts.append(Contact(position, along, normal, friction(along, normal)))
    return contacts


def _frictionless(disc: ForceDisc, start: float, end: float) -> list[Contact]:
    """The middle of the contacts with forces along the normal, where ``x f_n = M``."""
    if abs(disc.along) >= disc.radius:
        return []
    half = sqrt((disc.radius - disc.along) * (disc.radius + disc.along))
    smallest, largest = max(disc.normal - half, 0.0), disc.normal + half
    if largest <= 0.0:
        return []
    if disc.torque == 0.0:
        return [Contact(0.0, 0.0, (smallest + largest) / 2.0, 0.0)] if start <= 0.0 <= end else []
    far = disc.torque / smallest if smallest > 0.0 else copysign(inf, disc.torque)
    low, high = sorted((disc.torque / largest, far))
    low, high = max(low, start), min(high, end)
    position = (low + high) / 2.0
    return [Contact(position, 0.0, disc.torque / position, 0.0)] if low <= high else []
