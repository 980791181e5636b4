"""Contacts on a side at which a force exerts a load of a set, and the minimum friction that they need.

Forces have two components here, along the tangent of the side and along its inward normal. Lengths x along
the side are measured from the projection of a foot r on the side's line, and h is the height of the foot
above it. A force at x has its load in the set if it is in the disc of the foot, ``|f - f_0| <= p``, and has
the torque of the rest about the foot, ``h f_t + x f_n = M``. At each x this line cuts a chord from the
disc. All lines pass through (M / h, 0), and those tangent to the disc are at the ends of the intervals of
contacts.

On an arc, the same holds on its tangent at each place, which the direction beta of the tangent describes.
The ends of intervals are the roots of polynomials of second degree in cos(beta) and sin(beta).
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from math import acos, atan2, copysign, hypot, inf, pi, remainder, sqrt
from typing import NamedTuple

import numpy as np
from scipy.optimize import minimize_scalar

from planar_pushing.mechanics.plane import Array
from planar_pushing.objects.boundary import OutlineArc, OutlineSide
from planar_pushing.objects.wrench_set import WrenchSet
from planar_pushing.terms.domain import ROUGHEST

#: Rounding error of the torque of a load, relative to its terms.
ROUNDING = 1e-13
#: Number of places of an interval on an arc among which the one of least friction is searched.
PLACES = 64
#: Largest distance of a root in the complex plane from the unit circle, on which directions are.
ON_CIRCLE = 1e-6


class Contact(NamedTuple):
    """A contact on a side or on an arc.

    Attributes
    ----------
    position : float
        Distance from the start of the side; on an arc, the direction of its tangent, in radians.
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
    cuts = [low, *(x for x in _tangent_places(disc) if low < x < high), high]
    intervals = []
    for start, end in pairwise(cuts):
        middle = (start + end) / 2.0
        if _meets(disc, middle) and _best_contact(disc, middle).friction < inf:
            ends = [min(max(x, disc.low), disc.high) for x in (start, end)]
            intervals.append(_stretch(disc, *ends))
    return intervals


def _tangent_places(disc: ForceDisc) -> list[float]:
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


def stretches_on_arc(arc: OutlineArc, loads: WrenchSet) -> list[Stretch]:
    """As `stretches`, for an arc; the direction of the tangent falls along a hollow one."""
    force, torque = loads.offset[:2], float(loads.offset[2])
    size = hypot(*arc.center) + abs(arc.rho)
    if loads.foot is None:
        slack = ROUNDING * (abs(torque) + hypot(*force) * size)
        return _meeting_arc(arc, force, torque - _cross(arc.center, force), slack)
    forces = _ArcForces(arc, loads, loads.foot, torque - _cross(loads.foot, force))
    intervals = forces.stretches(ROUNDING * size / abs(arc.rho))
    return [Stretch(best, *ends[:: 1 if arc.rho > 0.0 else -1]) for best, *ends in intervals]


def _meeting_arc(arc: OutlineArc, force: Array, torque: float, slack: float) -> list[Stretch]:
    """Contact at which the line of action of a load meets an arc, with the torque about its center.

    The torque is rho f_t. Of the two places where the line meets the circle, f_n > 0 at one.
    """
    size = hypot(*force)
    if abs(torque) >= size * abs(arc.rho):
        return []
    angle = acos(torque / (arc.rho * size))
    along, normal = torque / arc.rho, sqrt((size - torque / arc.rho) * (size + torque / arc.rho))
    coefficient = friction(along, normal)
    middle, half = (arc.low + arc.high) / 2.0, (arc.high - arc.low) / 2.0
    turn = remainder(atan2(force[1], force[0]) - angle - middle, 2.0 * pi)
    error = slack / (abs(arc.rho) * normal) if coefficient < inf else 0.0
    if coefficient == inf or abs(turn) > half + error:
        return []
    near = copysign(half, turn) if abs(abs(turn) - half) <= error else turn
    contact = Contact(middle + near, along, normal, coefficient)
    return [Stretch(contact, contact, contact)]


class _ArcForces:
    """Forces of a set at the places of an arc.

    With a = q - r from the foot to the place q, their lines are ``a x f = M``.
    """

    def __init__(self, arc: OutlineArc, loads: WrenchSet, foot: Array, torque: float) -> None:
        self.arc, self.torque, self.radius = arc, torque, loads.radius
        self.force, self.offset = loads.offset[:2], arc.center - foot

    def disc(self, beta: float) -> tuple[ForceDisc, float]:
        """The disc relative to the tangent, and the place on it relative to the foot."""
        _, tangent, normal = self.arc.frame(beta)
        arm = self.offset - self.arc.rho * normal
        along, across = float(self.force @ tangent), float(self.force @ normal)
        height, x = -float(arm @ normal), float(arm @ tangent)
        return ForceDisc(along, across, self.radius, height, self.torque, x, x), x

    def best(self, beta: float) -> Contact:
        """The contact at a place, with the force that needs the least friction."""
        return _best_contact(*self.disc(beta))._replace(position=beta)

    def _is_contact(self, beta: float) -> bool:
        return _meets(*self.disc(beta)) and self.best(beta).friction < inf

    def _distance_to_tangent(self, beta: Array) -> Array:
        """Zero where the line is tangent to the disc."""
        tangent, normal = (
            np.array([np.cos(beta), np.sin(beta)]),
            np.array([-np.sin(beta), np.cos(beta)]),
        )
        moment = _cross(self.offset, self.force) + self.arc.rho * (self.force @ tangent)
        square = self.offset @ self.offset + self.arc.rho**2
        square = square - 2.0 * self.arc.rho * (self.offset @ normal)
        return np.asarray((moment - self.torque) ** 2 - self.radius**2 * square)

    def _on_rim(self, beta: Array, shift: float, rho: float) -> Array:
        """Zero where the force on the line along a direction of the frame is on the disc's rim."""
        way = np.array([np.cos(beta + shift), np.sin(beta + shift)])
        arm = self.offset[0] * way[1] - self.offset[1] * way[0] + rho
        ahead, gap = self.force @ way, self.force @ self.force - self.radius**2
        return np.asarray(self.torque**2 - 2.0 * self.torque * ahead * arm + gap * arm * arm)

    def _flat(self, beta: Array) -> Array:
        """Zero where the force has no component along the normal."""
        return self._on_rim(beta, 0.0, self.arc.rho)

    def _upright(self, beta: Array) -> Array:
        """Zero at the ends of places without friction."""
        return self._on_rim(beta, pi / 2.0, 0.0)

    def stretches(self, slack: float) -> list[Stretch]:
        """Intervals of contacts, between ends of the arc, lines tangent to the disc, and flat forces."""
        flat = self._inside(self._flat)
        cuts = sorted([*self._inside(self._distance_to_tangent), *flat])
        low, high = self.arc.low - slack, self.arc.high + slack
        if self.arc.high - self.arc.low >= 2.0 * pi - slack and cuts:
            low, high = cuts[0], cuts[0] + 2.0 * pi
        bounds = [low, *(beta for beta in cuts if low < beta < high), high]
        intervals: list[list[float]] = []
        for start, end in pairwise(bounds):
            if not self._is_contact((start + end) / 2.0):
                continue
            if intervals and intervals[-1][1] == start:
                intervals[-1][1] = end
            else:
                intervals.append([start, end])
        return [self._stretch(start, end, flat) for start, end in intervals]

    def _stretch(self, start: float, end: float, flat: list[float]) -> Stretch:
        limits = [
            any(abs(remainder(x - beta, 2.0 * pi)) < 1e-12 for x in flat) for beta in (start, end)
        ]
        if self.arc.high - self.arc.low < 2.0 * pi - 1e-9:
            start, end = (min(max(beta, self.arc.low), self.arc.high) for beta in (start, end))
        # At an end with a flat force, contacts of ever larger friction end.
        ends = [
            self.best(beta)._replace(friction=inf) if limit else self.best(beta)
            for beta, limit in zip((start, end), limits, strict=True)
        ]
        return Stretch(min([self._least(start, end), *ends], key=lambda x: x.friction), *ends)

    def _least(self, start: float, end: float) -> Contact:
        """The contact of least friction in an interval, in the middle of those without friction."""
        turns = [
            beta + turn
            for beta in self._roots(self._upright)
            for turn in (-2.0 * pi, 0.0, 2.0 * pi)
        ]
        cuts = [start, *sorted(beta for beta in turns if start < beta < end), end]
        middles = [self.best((one + other) / 2.0) for one, other in pairwise(cuts)]
        places = np.linspace(start, end, PLACES + 1)
        sampled = min(map(self.best, places.tolist()), key=lambda contact: contact.friction)
        step = (end - start) / PLACES
        bounds = max(sampled.position - step, start), min(sampled.position + step, end)
        if not bounds[0] < bounds[1]:
            return sampled
        search = minimize_scalar(
            lambda beta: self.best(float(beta)).friction, bounds=bounds, method="bounded",
            options={"xatol": 1e-12},
        )  # fmt: skip
        refined = self.best(float(search.x))
        return min([*middles, refined, sampled], key=lambda contact: contact.friction)

    def _inside(self, polynomial: Callable[[Array], Array]) -> list[float]:
        """Roots on the arc."""
        low, span = self.arc.low, self.arc.high - self.arc.low
        roots = [low + (beta - low) % (2.0 * pi) for beta in self._roots(polynomial)]
        return [beta for beta in roots if beta < low + span]

    def _roots(self, polynomial: Callable[[Array], Array]) -> list[float]:
        """Zeros in (-pi, pi] of a polynomial of second degree in the cosine and sine."""
        # Five coefficients of exp(i beta) from eight values.
        values: Array = polynomial(2.0 * pi * np.arange(8, dtype=np.float64) / 8.0)
        coefficients = np.fft.fft(values) / 8.0
        roots = np.roots(coefficients[[2, 1, 0, -1, -2]])
        return np.angle(roots[np.abs(np.abs(roots) - 1.0) < ON_CIRCLE]).tolist()  # type: ignore[no-any-return]
