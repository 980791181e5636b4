"""Slipping motions with friction and inertia: every motion with a given normal component, certified.

Under a force on an edge the spin ratio k determines the speed, ``v = (W / m) X / Y`` with ``X = h f -
t`` and ``Y = g k - h``, which is positive on the open segment between the friction value (X = 0) and
the inertia value (Y = 0). The normal component ``N = v A``, ``A = n_f - lever k``, need not be
monotone. The segment is subdivided until balls decide the sign of N' on every part except for
negligible gaps, so that no motion is missed.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import chain, islice, pairwise

from flint import arb

from planar_pushing.certified import ring
from planar_pushing.certified.balls import Undecided, precise, sign
from planar_pushing.certified.inverse import spin_of_arm
from planar_pushing.certified.roots import increasing_root
from planar_pushing.certified.setting import FRICTION, INERTIA, Heading, Slider

#: Parts narrower than this, relative to k, become gaps.
_GAP = arb(2) ** -40

#: Maximum number of parts of the subdivision.
_MOST = 4096


@dataclass(frozen=True, slots=True)
class Part:
    """Part of the segment, and N at its ends; N is monotone on it with the sign `rise`, or 0 on a gap."""

    low: arb
    high: arb
    rise: int
    start: arb
    end: arb


@dataclass(frozen=True, slots=True)
class Edge:
    """Line of force on an edge, mirrored so that the moment arm is positive.

    `normal` and `lever` determine A; `ends` are the friction and the inertia value of k; `stays` says
    that A vanishes with Y, so that N remains finite as the motion grows.
    """

    slider: Slider
    arm: arb
    normal: arb
    lever: arb
    ends: tuple[arb, arb]
    stays: bool

    def advance(self, k: arb) -> arb:
        """Return A, the normal component of the contact's motion per unit speed of the center."""
        return self.normal - self.lever * k

    def surplus(self, k: arb) -> arb:
        """Return X; it decreases with k, so that its values at the ends enclose it."""
        ends = (k,) if k.is_exact() else (k.lower(), k.upper())
        values = [self.arm * force - torque for force, torque in map(ring.profile, ends)]
        return values[0].union(values[-1])

    def lag(self, k: arb) -> arb:
        """Return Y."""
        return self.slider.gyration * k - self.arm

    def speed(self, k: arb) -> arb:
        """Speed of the center."""
        return self.slider.weight / self.slider.mass * self.surplus(k) / self.lag(k)

    def normal_motion(self, k: arb) -> arb:
        """Return N."""
        if self.stays:
            ratio = self.slider.weight / self.slider.mass / self.slider.gyration
            return -ratio * self.lever * self.surplus(k)
        return self.speed(k) * self.advance(k)

    def turn(self, low: arb, high: arb) -> int:
        """Sign of ``N' Y^2`` on [low, high], or 0 if it is undecided."""
        k = low.union(high)
        if self.stays:  # N is a multiple of X, which decreases
            return sign(self.lever)
        advance, surplus, lag = self.advance(k), self.surplus(k), self.lag(k)
        steady = -self.lever * surplus * lag - self.slider.gyration * advance * surplus
        steep = -lag * advance * (1 + k * self.arm)  # times t', which is unbounded next to k = 1
        least, greatest = (bound(low, high) for bound in (ring.least_slope, ring.greatest_slope))
        ends = [steady + steep * least]
        ends += [steady + steep * greatest] if greatest.is_finite() else [steep]
        if all(each > 0 for each in ends):
            return 1
        return -1 if all(each < 0 for each in ends) else 0


def mirrored_edge(slider: Slider, force: Heading, sine: arb, cosine: arb, finite: bool) -> Edge:
    """Edge for a force with a nonzero moment arm; `cosine` is that of the rod angle."""
    arm = slider.rod_length * abs(sine)
    lever = slider.rod_length * cosine * sine.sgn()
    friction, inertia = (spin_of_arm(arm, slider.gyration, share) for share in (FRICTION, INERTIA))
    return Edge(slider, arm, force.y, lever, (friction, inertia), finite)


@precise
def parts(edge: Edge) -> list[Part]:
    """Monotone parts and gaps that cover the open segment, in order of k."""
    friction, inertia = edge.ends
    low, high = (friction, inertia) if friction < inertia else (inertia, friction)
    if not low < high:
        raise Undecided(
            "friction and inertia agree on the spin ratio of a line of force off the center"
        )
    cuts = [low.lower(), high.upper()]
    if low < 1 < high:
        cuts.insert(1, arb(1))
    if edge.stays and edge.lever.is_zero():  # no motion under this force leaves the fence
        return []
    divided = chain.from_iterable(_divide(edge, a, b) for a, b in pairwise(cuts))
    found = list(islice(divided, _MOST))
    if len(found) == _MOST:
        raise Undecided("balls do not decide the sign of the slope of the normal motion")
    return list(_merged(edge, found))


def _divide(edge: Edge, low: arb, high: arb) -> Iterator[tuple[arb, arb, int]]:
    rise = edge.turn(low, high)
    if rise or high - low < _GAP * high:
        yield low, high, rise
        return
    middle = ((low + high) / 2).mid()
    yield from _divide(edge, low, middle)
    yield from _divide(edge, middle, high)


def _merged(edge: Edge, found: list[tuple[arb, arb, int]]) -> Iterator[Part]:
    joined: list[tuple[arb, arb, int]] = []
    for low, high, rise in found:
        if joined and joined[-1][2] == rise:
            low = joined.pop()[0]
        joined.append((low, high, rise))
    for index, (low, high, rise) in enumerate(joined):
        first, last = index == 0, index == len(joined) - 1
        start = _limit(edge, 0) if first else edge.normal_motion(low)
        end = _limit(edge, 1) if last else edge.normal_motion(high)
        yield Part(low, high, rise, start, end)


def _limit(edge: Edge, side: int) -> arb:
    """Limit of N at the lower (0) or the upper (1) end of the segment: 0, infinite, or finite."""
    friction, inertia = edge.ends
    if (friction < inertia) == (side == 0):
        return arb(0)
    if edge.stays:
        return edge.normal_motion(inertia)
    return arb.pos_inf() * sign(edge.advance(inertia))


@precise
def slip_spins(edge: Edge, cover: list[Part], normal_motion: arb) -> list[arb]:
    """Every |k| whose motion has the normal component N = `normal_motion`, slowest first."""
    if normal_motion.is_zero():
        found = _grazing(edge)
    else:
        found = [k for part in cover for k in _in_part(edge, part, normal_motion)]
    return found if edge.ends[0] < edge.ends[1] else found[::-1]


def _grazing(edge: Edge) -> list[arb]:
    """Motion along the fence: A = 0 inside the segment."""
    if edge.stays or edge.lever.is_zero():
        return []
    k = edge.normal / edge.lever
    inside = sign(k - edge.ends[0]) * sign(k - edge.ends[1]) < 0
    return [k] if inside else []


def _in_part(edge: Edge, part: Part, target: arb) -> list[arb]:
    if part.rise == 0:
        if edge.normal_motion(part.low.union(part.high)).overlaps(target):
            raise Undecided("a slipping motion next to an extremum of the normal motion")
        return []
    before, after = sign(part.start - target), sign(part.end - target)
    if before == after:
        return []
    scale = edge.slider.weight / edge.slider.mass
    behind = 1 if edge.ends[0] > edge.ends[1] else -1  # sign of Y on the segment

    def excess(k: arb) -> arb:
        """Return a multiple of N - target that remains finite where Y vanishes."""
        if edge.stays:
            return after * (edge.normal_motion(k) - target)
        gap = scale * edge.surplus(k) * edge.advance(k) - target * edge.lag(k)
        return after * behind * gap

    return [increasing_root(excess, part.low, part.high)]
