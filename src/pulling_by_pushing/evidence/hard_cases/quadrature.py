"""Motion over time with friction alone, by quadrature: a route of its own to references of hard motions.

In a contact mode, the rate of rotation depends on the rod angle alone. Time and slip are therefore
integrals over the rod angle between the events, which the double exponential rule computes; rates and
events are roots of Eqs. (2)-(7). Nothing is validated: two step sizes tell how many digits are known.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from typing import NamedTuple

from flint import acb, arb, ctx

from pulling_by_pushing.oracle.balls import Undecided

Pair = tuple[arb, arb]
#: Bits of the numbers, and the finest step of the rule as a power of two.
BITS, LEVEL = 160, 5
#: Largest abscissa of the rule before its substitution, where weights are below 2^-BITS.
REACH = 4
#: Steps in the rod angle in which events are sought, radians, and iterations of a root.
STRIDE, ITERATIONS = arb(1) / 64, 500
#: Relative difference of two iterates of a root, which are then equal.
CLOSE = arb(2) ** (32 - BITS)
#: Width of the first bracket of the root of an increasing function.
WIDTH = arb(1) / 256
STICK, SLIP_RIGHT, SLIP_LEFT = "stick", "slip-right", "slip-left"
#: Number of the event at which a side comes to lie on the fence.
FLUSH = -1
#: Largest number of phases.
PHASES = 64


class Foot(NamedTuple):
    """A foot in the frame of the rod, whose x axis goes from the contact to the center, and its share."""

    x: arb
    y: arb
    share: arb


class Push(NamedTuple):
    """A fence of constant velocity that pushes the end of the rod of a slider on a unit ring, or on feet.

    Attributes
    ----------
    length : arb
        Length of the rod.
    mu : arb
        Coefficient of friction.
    fence : tuple of arb
        Velocity of the fence.
    feet : tuple of Foot
        Support; without feet the ring.
    flush : arb, optional
        Rod angle at which a side lies on the fence and the motion ends, radians.
    """

    length: arb
    mu: arb
    fence: Pair
    feet: tuple[Foot, ...] = ()
    flush: arb | None = None


class Place(NamedTuple):
    """Time, rod angle in radians, and slip along the fence."""

    time: arb
    angle: arb
    slip: arb


class Phase(NamedTuple):
    """A contact mode, and the signs of the margins that end it while it lasts."""

    mode: str
    signs: tuple[int, ...]


def ring_profile(k: arb) -> Pair:
    """Force and torque of the unit ring at a spin ratio (Eqs. 2-3), by complete elliptic integrals."""
    size = abs(k).mid()
    if size > 1:
        force, torque = ring_profile((1 / size).mid())
        return torque, (force if k > 0 else -force)
    m = (size * size).mid()
    first = acb(m).elliptic_e().real
    second = first - (1 - m) * acb(m).elliptic_k().real if m < 1 else first
    torque = (second / size).mid() if size > 0 else arb(0)
    scale = 2 / arb.pi()
    return (scale * first).mid(), (scale * torque * (1 if k > 0 else -1)).mid()


def find_root(function: Callable[[arb], arb], low: arb, high: arb) -> arb:
    """Root in a bracket, by regula falsi in its Illinois form."""
    a, b, f_a, f_b = low, high, function(low), function(high)
    if f_a == 0 or f_b == 0:
        return a if f_a == 0 else b
    if (f_a > 0) == (f_b > 0):
        raise Undecided("a root is not bracketed")
    for _ in range(ITERATIONS):
        c = (b - f_b * (b - a) / (f_b - f_a)).mid()
        f_c = function(c)
        if f_c == 0 or abs(c - b) <= abs(c) * CLOSE:
            return c
        if (f_c > 0) != (f_b > 0):
            a, f_a = b, f_b
        else:
            f_a = (f_a / 2).mid()
        b, f_b = c, f_c
    raise Undecided("a root is not found")


def find_increasing(function: Callable[[arb], arb], guess: arb) -> arb:
    """Root of an increasing function near a guess."""
    value, width = function(guess), WIDTH
    while value != 0:
        other = (guess - width).mid() if value > 0 else (guess + width).mid()
        if (function(other) > 0) != (value > 0):
            return find_root(function, guess, other)
        width = 4 * width
    return guess


def nodes(level: int) -> Iterator[Pair]:
    """Abscissas and weights on [-1, 1] from left to right."""
    count, half_pi = REACH * 2**level, arb.pi() / 2
    for j in range(-count, count + 1):
        t = arb(j) / 2**level
        inner = half_pi * t.sinh()
        weight = half_pi * t.cosh() / inner.cosh() ** 2 / 2**level
        yield inner.tanh().mid(), weight.mid()


class Motion:
    """The motion of a push from event to event."""

    def __init__(self, push: Push, level: int = LEVEL) -> None:
        """Motion at a level of the rule, the power of two by which its step is divided."""
        self.push, self.rule = push, list(nodes(level))
        self.near_spin = self.near_ratio = arb(0)  # the last roots, next to which the next ones are
        norm = (1 + push.mu * push.mu).sqrt()
        #: Unit vectors of the right and the left edge of the friction cone.
        self.edges = tuple((side * push.mu / norm, 1 / norm) for side in (1, -1))

    def rod(self, angle: arb) -> Pair:
        """Vector from the contact to the center."""
        return (self.push.length * angle.cos()).mid(), (self.push.length * angle.sin()).mid()

    def load(self, angle: arb, spin: arb) -> tuple[arb, arb, arb]:
        """Force that the support needs at the velocity of the fence, and its torque about the contact."""
        (x, y), (u, v) = self.rod(angle), self.push.fence
        if not self.push.feet:
            u, v = u - spin * y, v + spin * x
            speed = (u * u + v * v).sqrt()
            force, torque = ring_profile((spin / speed).mid())
            f_x, f_y = force * u / speed, force * v / speed
            return f_x.mid(), f_y.mid(), (torque + x * f_y - y * f_x).mid()
        total = [arb(0)] * 3
        cosine, sine = angle.cos(), angle.sin()
        for foot in self.push.feet:
            along, across = self.push.length + foot.x, foot.y
            x, y = cosine * along - sine * across, sine * along + cosine * across
            f_x, f_y = u - spin * y, v + spin * x
            size = foot.share / (f_x * f_x + f_y * f_y).sqrt()
            f_x, f_y = f_x * size, f_y * size
            total = [a + b for a, b in zip(total, (f_x, f_y, x * f_y - y * f_x), strict=True)]
        return total[0].mid(), total[1].mid(), total[2].mid()

    def spin_of_stick(self, angle: arb) -> arb:
        """Rate of rotation if the contact sticks: its force has no torque about it."""

        def torque(spin: arb) -> arb:
            return self.load(angle, spin)[2]

        self.near_spin = find_increasing(torque, self.near_spin)
        return self.near_spin

    def rates_of_slip(self, angle: arb, edge: Pair) -> tuple[arb, arb, arb]:
        """Rates of rotation and of slip on an edge of the cone, and the spin ratio, for the ring."""
        if self.push.feet:
            raise Undecided("slip is computed for the ring alone")
        x, y = self.rod(angle)
        arm = (edge[0] * y - edge[1] * x).mid()

        def excess(k: arb) -> arb:
            force, torque = ring_profile(k)
            return (torque - abs(arm) * force).mid()

        self.near_ratio = find_increasing(excess, self.near_ratio)
        k = self.near_ratio * (1 if arm > 0 else -1)
        speed = self.push.fence[1] / (edge[1] - k * x)
        spin = (k * speed).mid()
        return spin, (speed * edge[0] + spin * y - self.push.fence[0]).mid(), k

    def rates(self, angle: arb, mode: str) -> Pair:
        """Rates of rotation and of slip in a mode."""
        if mode == STICK:
            return self.spin_of_stick(angle), arb(0)
        return self.rates_of_slip(angle, self.edges[mode == SLIP_RIGHT])[:2]

    def margins(self, angle: arb, mode: str) -> tuple[arb, ...]:
        """Numbers whose signs change at the events of a mode, or where the rates have a kink.

        For a stick: those of the right and of the left edge; for a slip: the slip. Then the distance of the
        center of rotation from the ring, or for each foot that of its normal line from the contact.
        """
        if mode != STICK:
            _, slip, k = self.rates_of_slip(angle, self.edges[mode == SLIP_RIGHT])
            return slip, abs(k) - 1
        spin, (u, v) = self.spin_of_stick(angle), self.push.fence
        f_x, f_y, _ = self.load(angle, spin)
        (r_x, r_y), (l_x, l_y) = self.edges
        cone = r_x * f_y - r_y * f_x, f_x * l_y - f_y * l_x
        x, y = self.rod(angle)
        if not self.push.feet:
            speed = ((u - spin * y) ** 2 + (v + spin * x) ** 2).sqrt()
            return *cone, (abs(spin) / speed - 1).mid()
        cosine, sine = angle.cos(), angle.sin()
        crossings = (
            u * (cosine * (self.push.length + foot.x) - sine * foot.y)
            + v * (sine * (self.push.length + foot.x) + cosine * foot.y)
            for foot in self.push.feet
        )
        return *cone, *crossings

    def integrate(self, start: arb, end: arb, mode: str) -> Pair:
        """Time and slip from one rod angle to another."""
        half, middle = (end - start) / 2, (end + start) / 2
        time = slip = arb(0)
        for x, weight in self.rule:
            angle = (middle + half * x).mid()
            if not abs(x) < 1 or angle in (start, end):
                continue
            spin, slip_rate = self.rates(angle, mode)
            share = half * weight / spin
            time, slip = (time + share).mid(), (slip + share * slip_rate).mid()
        return time, slip

    def begin(self, angle: arb, mode: str) -> Phase:
        """Phase of a mode at a rod angle."""
        return Phase(mode, tuple(1 if margin > 0 else -1 for margin in self.margins(angle, mode)))

    def first_mode(self, angle: arb) -> str:
        """The mode of a fence that pushes: the stick if its force is in the friction cone, else a slip."""
        right, left = self.margins(angle, STICK)[:2]
        return STICK if right > 0 and left > 0 else SLIP_LEFT if left > 0 else SLIP_RIGHT

    def next_mode(self, mode: str, event: int) -> str:
        """The mode after the margin with this number has changed its sign."""
        if mode == STICK and event < 2:
            return (SLIP_LEFT, SLIP_RIGHT)[event]
        return STICK if mode != STICK and event == 0 else mode

    def end_of(self, phase: Phase, start: arb, time: arb) -> tuple[arb, int | None]:
        """Rod angle at the next event and its number, or one that is reached after more than a time."""
        angle, passed, flush = start, arb(0), self.push.flush
        while True:
            spin, _ = self.rates(angle, phase.mode)
            after = (angle + STRIDE * (1 if spin > 0 else -1)).mid()
            if flush is not None and angle < flush < after:
                after = flush
            margins = self.margins(after, phase.mode)
            changed = [i for i, m in enumerate(margins) if (m > 0) != (phase.signs[i] > 0)]
            if changed:
                ends = [
                    (find_root(partial(self._margin, phase.mode, i), angle, after), i)
                    for i in changed
                ]
                return min(ends, key=lambda end: float(abs(end[0] - start)))
            if after is flush:
                return flush, FLUSH
            later, _ = self.rates(after, phase.mode)
            if (spin > 0) != (later > 0) or passed > 2 * time:
                return after, None
            angle, passed = after, passed + STRIDE / abs(spin)

    def _margin(self, mode: str, event: int, angle: arb) -> arb:
        return self.margins(angle, mode)[event]

    def angle_after(self, phase: Phase, start: arb, end: arb, time: arb) -> arb:
        """Rod angle after a time in a phase, by Newton's method."""
        angle = start
        for _ in range(ITERATIONS):
            spin, _ = self.rates(angle, phase.mode)
            passed = self.integrate(start, angle, phase.mode)[0] if angle != start else arb(0)
            change = ((time - passed) * spin).mid()
            angle = (angle + change).mid()
            if abs(change) < CLOSE:
                return angle
        raise Undecided("the rod angle at a time is not found")


def follow(push: Push, start: arb, duration: arb, level: int = LEVEL) -> list[Place]:
    """Places at the events of a motion, the first of them its start, and its last place.

    Raises
    ------
    Undecided
        If a root is not found.
    """
    with ctx.workprec(BITS):
        motion = Motion(push, level)
        places = [Place(arb(0), start.mid(), arb(0))]
        phase = motion.begin(start, motion.first_mode(start))
        for _ in range(PHASES):
            time, angle, slip = places[-1]
            end, event = motion.end_of(phase, angle, duration - time)
            if event == FLUSH:
                passed, slipped = motion.integrate(angle, end, phase.mode)
                return [*places, Place((time + passed).mid(), end, (slip + slipped).mid())]
            if event is not None:
                passed, slipped = motion.integrate(angle, end, phase.mode)
                if time + passed < duration:
                    places.append(Place((time + passed).mid(), end, (slip + slipped).mid()))
                    beyond = (end + (end - angle) * arb(2) ** -30).mid()
                    phase = motion.begin(beyond, motion.next_mode(phase.mode, event))
                    continue
            end = motion.angle_after(phase, angle, end, duration - time)
            _, slipped = motion.integrate(angle, end, phase.mode)
            return [*places, Place(duration, end, (slip + slipped).mid())]
    raise Undecided(f"a motion has more than {PHASES} phases")
