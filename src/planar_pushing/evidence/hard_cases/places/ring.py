"""Lines 1 and 2: a center on the ring, a translation, a rotation about the ring center."""

from __future__ import annotations

from collections.abc import Iterator

from planar_pushing.certified import radians
from planar_pushing.evidence.hard_cases.case import Case, Quantity
from planar_pushing.mechanics.wrench import ring_profile, ring_spin_ratios

#: Distances from 1, in both directions where they are doubles.
GAPS = (0.0, 2.0**-53, 2.0**-52, 1e-12, 1e-9, 1e-6, 1e-3)
#: Sizes towards 0 and, inverted, towards infinity.
SIZES = (5e-324, 1e-300, 1e-160, 1e-8, 1e-3, 0.5)


def _force(k: float) -> float:
    return float(ring_profile(k)[0])


def _torque(k: float) -> float:
    return float(ring_profile(k)[1])


def _spin(arm: float) -> float:
    return float(ring_spin_ratios(arm))


def _cases(line: int, x: float) -> Iterator[Case]:
    for quantity, compute, exact, name in (
        (Quantity.FORCE, _force, radians.force, "k"),
        (Quantity.TORQUE, _torque, radians.torque, "k"),
        (Quantity.SPIN_RATIO, _spin, radians.friction_spin, "h"),
    ):
        yield Case(
            label=f"{quantity} at {name} = {x!r}", line=line, quantity=quantity,
            inputs=(x,), compute=compute, reference=exact,
        )  # fmt: skip


def cases() -> Iterator[Case]:
    """Cases of lines 1 and 2."""
    near = {1 - gap for gap in GAPS} | {1 + gap for gap in GAPS}
    for x in sorted(near):
        yield from _cases(1, x)
    for size in SIZES:
        yield from _cases(2, size)
        if 1 / size < float("inf"):
            yield from _cases(2, 1 / size)
