"""Statements about every spin ratio of an interval, by subdivision into boxes, and the ring on a box.

A box is an interval [low, high] with exact ends. A function of a box returns a ball that encloses its
values on the box or bounds them from below. On [0, 1] the power series in k of t, of t / k and of (1 -
f) / k^2 have positive coefficients: all three increase, and the ends of a box enclose them. Duality,
f(k) = t(1 / k), extends a statement to k > 1.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from flint import arb, fmpq

from pulling_by_pushing.evidence.proofs.mechanics import profile
from pulling_by_pushing.evidence.proofs.verdicts import Evidence, Means, Verdict

OnBox = Callable[[arb, arb], arb]

#: Maximum number of boxes; a statement that needs more remains undecided.
_MOST_BOXES = 2000


@dataclass(frozen=True, slots=True)
class Cover:
    """Boxes that cover the interval, the smallest value on them, and a point of failure if there is one."""

    smallest: arb
    boxes: int
    failure: arb | None = None
    open: bool = False

    def evidence(self) -> Evidence:
        """Evidence for positive values on the whole interval."""
        verdict, reason = Verdict.PROVED, None
        if self.failure is not None:
            verdict = Verdict.REFUTED
            reason = f"fails at {self.failure.str(12, radius=False)}"
        elif self.open:
            verdict = Verdict.UNDECIDED
            reason = f"undecided after {self.boxes} boxes"
        return Evidence(
            verdict=verdict,
            value=self.smallest,
            unit="1",
            margin=self.smallest,
            points=self.boxes,
            means=(Means.COVER,),
            reason=reason,
        )


def cover(margin: OnBox, low: arb, high: arb, most: int = _MOST_BOXES) -> Cover:
    """Cover [low, high] by boxes on which `margin` is positive, or find a point where it is not."""
    rest, smallest, boxes = [(low, high)], arb.pos_inf(), 0
    while rest:
        a, b = rest.pop()
        value = margin(a, b)
        boxes += 1
        if value > 0:
            smallest = arb.min(smallest, value.lower())
            continue
        middle = ((a + b) / 2).mid()
        point = margin(middle, middle)
        if point < 0:
            return Cover(point, boxes, failure=middle)
        if boxes >= most:
            return Cover(value, boxes, open=True)
        rest += [(middle, b), (a, middle)]
    return Cover(smallest, boxes)


def positive(margin: OnBox) -> Evidence:
    """Evidence for a positive value at every spin ratio from 0 to 1."""
    return cover(margin, arb(0), arb(1)).evidence()


def turn(low: arb, high: arb) -> arb:
    """Lower bound of t / k, 1/2 at k = 0."""
    return arb(fmpq(1, 2)) if low == 0 else profile(low)[1] / low


def loss(low: arb, high: arb) -> arb:
    """Lower bound of (1 - f) / k^2, 1/4 at k = 0."""
    return arb(fmpq(1, 4)) if low == 0 else (1 - profile(low)[0]) / low**2


def slope(low: arb, high: arb) -> arb:
    """Lower bound of t', which increases from 1/2."""
    if not 0 < low < 1:
        return arb(fmpq(1, 2)) if low == 0 else arb.pos_inf()
    force, torque = profile(low)
    return (low * force - torque) / (low * (1 - low) * (1 + low))


def arm_slope(low: arb, high: arb) -> arb:
    """Lower bound of the derivative of the moment arm H = t / f, ``H' = t' (f + k t) / f^2``."""
    (falling, rising), (last, _) = profile(low), profile(high)
    return slope(low, high) * (last + low * rising) / falling**2
