"""Statements about every point of an interval, by subdivision into boxes.

A box is an interval [low, high] with exact ends. A function of a box returns a ball that encloses, or
bounds from below, its values on the box.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from flint import arb

from planar_pushing.evidence.claims.proofs.verdicts import Evidence, Verdict

OnBox = Callable[[arb, arb], arb]

#: Boxes after which a statement counts as out of reach.
_MOST = 2000


@dataclass(frozen=True, slots=True)
class Cover:
    """Boxes that cover the interval, the least value on them, and a point of failure if any."""

    least: arb
    boxes: int
    failure: arb | None = None
    open: bool = False

    def evidence(self, method: str, unit: str = "1", value: arb | None = None) -> Evidence:
        """Evidence for positive values on the whole interval."""
        verdict, reason = Verdict.PROVED, None
        if self.failure is not None:
            verdict = Verdict.REFUTED
            reason = f"fails at {self.failure.str(12, radius=False)}"
        elif self.open:
            verdict = Verdict.UNDECIDED
            reason = f"open after {self.boxes} boxes"
        return Evidence(
            verdict=verdict,
            method=method,
            value=self.least if value is None else value,
            unit=unit,
            margin=self.least,
            points=self.boxes,
            reason=reason,
        )


def cover(margin: OnBox, low: arb, high: arb, most: int = _MOST) -> Cover:
    """Cover [low, high] by boxes on which `margin` is positive, or find a point where it is not."""
    rest, least, boxes = [(low, high)], arb.pos_inf(), 0
    while rest:
        a, b = rest.pop()
        value = margin(a, b)
        boxes += 1
        if value > 0:
            least = arb.min(least, value.lower())
            continue
        middle = ((a + b) / 2).mid()
        point = margin(middle, middle)
        if point < 0:
            return Cover(point, boxes, failure=middle)
        if boxes >= most:
            return Cover(value, boxes, open=True)
        rest += [(middle, b), (a, middle)]
    return Cover(least, boxes)
