"""Slips of a ring with friction and inertia under an edge: a guess of each, and that there is no other.

Under a line of force with the moment arm h R, the spin ratio k determines the speed of the center,
``v = (W / m) X / Y`` with ``X = h f - t``, ``Y = g k - h`` and ``g = (rho / R)^2``, which is positive
between the spin ratio of friction (X = 0) and that of inertia (Y = 0). The normal motion of the contact is
``N = v A``, ``A = n - lever k``. The interval is divided until balls decide the sign of N' on every part
except for narrow gaps; a
motion in a gap is undecided.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import NamedTuple

from flint import arb, ctx, fmpq

from pulling_by_pushing.oracle.balls import ZERO, Direction, Undecided, remember, sign
from pulling_by_pushing.oracle.body import Body
from pulling_by_pushing.oracle.exact import ONE, ring_radius
from pulling_by_pushing.oracle.motions import ray
from pulling_by_pushing.oracle.prove import Slider
from pulling_by_pushing.oracle.support import friction, ring

ONLY_A_RING = (
    "with friction and inertia together, only a ring has a certified list of contact modes"
)
#: Most parts of a cover, and the relative width of a gap.
MOST_PARTS, GAP_WIDTH = 4096, arb(2) ** -60
#: Least precision of a cover in bits, which needs signs alone; it follows a quarter of the precision.
COVER_BITS = 96


class Part(NamedTuple):
    """An interval of k on which N is monotone, with the sign of its slope; 0 in a gap."""

    low: arb
    high: arb
    slope_sign: int


@dataclass(frozen=True, eq=False)
class Path:
    """The motions under the force of an edge, mirrored so that the moment arm is positive.

    Attributes
    ----------
    arm, normal, lever : arb
        h, n and lever; all lengths over R.
    gyration : fmpq
        g.
    scale : fmpq
        W / m.
    friction, inertia : arb
        Spin ratios of friction alone and of inertia alone.
    side : int
        Sign of the moment arm before it was mirrored.
    stays : bool
        Whether inertia alone moves the contact along the fence: N is then finite for all motions.
    """

    arm: arb
    normal: arb
    lever: arb
    gyration: fmpq
    scale: fmpq | arb
    friction: arb
    inertia: arb
    side: int
    stays: bool

    def advance(self, k: arb) -> arb:
        """A, the normal motion of the contact over the speed of the center."""
        return self.normal - self.lever * k

    def surplus(self, k: arb) -> arb:
        """X; it decreases with k."""
        ends = [k] if k.is_exact() else [k.lower(), k.upper()]
        values = [self.arm * force - moment for force, moment in map(_friction, ends)]
        return values[0].union(values[-1])

    def normal_motion(self, k: arb) -> arb:
        """N, the normal motion of the contact under the force of the edge."""
        if self.stays:
            return -self.scale / self.gyration * self.lever * self.surplus(k)
        return self.scale * self.surplus(k) / (self.gyration * k - self.arm) * self.advance(k)

    def turn(self, low: arb, high: arb) -> int:
        """Sign of ``N' Y^2`` over an interval, 0 if it is undecided."""
        if self.stays:
            return sign(self.lever)
        k = low.union(high)
        advance, surplus, lag = self.advance(k), self.surplus(k), self.gyration * k - self.arm
        steady = -surplus * (self.lever * lag + self.gyration * advance)
        steep = (
            -lag * advance * (1 + k * self.arm)
        )  # times t', which increases up to k = 1 and decreases from there
        slopes = [_slope(end) for end in (low, high) if end != 1]
        inside = [steep] if low <= 1 <= high else []
        ends = [steady + steep * slope for slope in slopes] + inside
        return 1 if all(end > 0 for end in ends) else -1 if all(end < 0 for end in ends) else 0

    @cached_property
    def parts(self) -> list[Part]:
        """Monotone parts and gaps that cover the interval, in order of k."""
        with ctx.workprec(max(COVER_BITS, ctx.prec // 4)):
            return self._cover()

    def _cover(self) -> list[Part]:
        low, high = sorted((self.friction, self.inertia), key=float)
        if not low < high:
            raise Undecided(
                "friction and inertia turn the slider alike under a force off its center"
            )
        if self.stays and self.lever.is_zero():
            return []
        cuts = [low.lower(), high.upper()]
        if low < 1 < high:
            cuts.insert(1, arb(1))
        rest, parts = [(a, b) for a, b in pairwise(cuts)][::-1], list[Part]()
        for _ in range(MOST_PARTS):
            if not rest:
                return parts
            a, b = rest.pop()
            slope_sign = self.turn(a, b)
            if not slope_sign and b - a > GAP_WIDTH * b:
                middle = ((a + b) / 2).mid()
                rest += [(middle, b), (a, middle)]
            elif parts and parts[-1].slope_sign == slope_sign:
                parts[-1] = Part(parts[-1].low, b, slope_sign)
            else:
                parts.append(Part(a, b, slope_sign))
        raise Undecided("the slope of the normal motion under an edge has no decided sign")

    def spins(self, target: arb) -> list[arb]:
        """A guess of k for each motion with a normal motion other than zero, slowest first."""
        ends = [self._end(part.low, i == 0) for i, part in enumerate(self.parts)]
        ends.append(self._end(self.parts[-1].high, True) if self.parts else arb(0))
        guesses = []
        for part, start, end in zip(self.parts, ends, ends[1:], strict=False):
            if part.slope_sign == 0:
                if self.normal_motion(part.low.union(part.high)).overlaps(target):
                    raise Undecided("a slip next to an extremum of the normal motion")
            elif sign(start - target) != sign(end - target):
                guesses.append(self._bisect(part, target, sign(end - target)))
        return guesses if self.friction < self.inertia else guesses[::-1]

    def _end(self, k: arb, outer: bool) -> arb:
        """N at an end of a part; at the ends of the interval it is zero, and infinite or finite."""
        if not outer:
            return self.normal_motion(k)
        if abs(k - self.friction) < abs(k - self.inertia):
            return arb(0)
        return (
            self.normal_motion(self.inertia)
            if self.stays
            else arb.pos_inf() * sign(self.advance(self.inertia))
        )

    def _bisect(self, part: Part, target: arb, after: int) -> arb:
        low, high = part.low, part.high
        for _ in range(48):
            middle = ((low + high) / 2).mid()
            lag = self.gyration * middle - self.arm
            excess = (
                self.scale * self.surplus(middle) * self.advance(middle) - target * lag
            ) * lag.sgn()
            if self.stays:
                excess = self.normal_motion(middle) - target
            low, high = (low, middle) if excess * after > 0 else (middle, high)
        return ((low + high) / 2).mid()

    def spins_along_fence(self) -> list[arb]:
        """K of the motion along the fence, if there is one."""
        if self.stays or self.lever.is_zero():
            return []
        k = self.normal / self.lever
        return [k] if sign(k - self.friction) * sign(k - self.inertia) < 0 else []

    def speed(self, k: arb) -> arb:
        """v, the speed of the center at a spin ratio."""
        return self.scale * self.surplus(k) / (self.gyration * k - self.arm)


@remember(1 << 12)
def _friction(k: arb) -> tuple[arb, arb]:
    return friction(k)


def _slope(k: arb) -> arb:
    """t'(k) = g'(c^2) and g(c^2) at c = 1 / k: the second derivative of D along the radius, over k^3."""
    c2 = 1 / (k * k)
    _, slope, bend = ring(c2)
    return (slope + 2 * bend * c2) / (k * k * k)


@remember(1 << 12)
def path(slider: Slider, force: Direction) -> Path:
    """The motions of a ring with friction and inertia under the force of an edge that misses its center."""
    body, e = slider.body, force.about(slider.rod_angle)
    radius = ring_radius(body)
    if radius is None:
        raise Undecided(ONLY_A_RING)
    (x, y), cosine = e.ball, slider.rod[0]
    side = e.across((body.length, ZERO))
    arm, lever = abs(y) * body.length / radius, side * body.length / radius * cosine
    friction_alone, inertia_alone = (
        Slider(Body(length=body.length, support=body.support, weight=ONE), slider.rod_angle),
        Slider(Body(length=body.length, mass=ONE, gyration=body.gyration), slider.rod_angle),
    )
    friction_motion = ray(friction_alone, force).q
    center = friction_motion[0], friction_motion[1] + friction_motion[2] * body.length
    spin = abs(friction_motion[2]) * radius / (x * center[0] + y * center[1])
    inertia_motion = ray(inertia_alone, force)
    exact, gyration = inertia_motion.exact, body.gyration / (radius * radius)
    normal = inertia_alone.rod[1] * inertia_motion.q[0] + inertia_alone.rod[0] * inertia_motion.q[1]
    return Path(
        arm=arm,
        normal=force.ball[1],
        lever=lever,
        gyration=gyration,
        scale=body.weight / body.mass,
        friction=spin,
        inertia=arm / gyration,
        side=side,
        stays=sign(normal, None if exact is None else lambda: exact[1]) == 0,
    )
