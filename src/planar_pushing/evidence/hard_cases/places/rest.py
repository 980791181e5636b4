"""Line 6: no motion, where the gradient of friction is a set, and the smallest motions around it."""

from __future__ import annotations

from collections.abc import Iterator

from flint import arb

from planar_pushing.certified import radians
from planar_pushing.evidence.hard_cases.case import Case, Quantity
from planar_pushing.mechanics.effects import RingFriction
from planar_pushing.mechanics.wrench import wrench

TWISTS = (
    (0.0, 0.0),
    (-0.0, -0.0),
    (5e-324, 0.0),
    (0.0, 5e-324),
    (5e-324, 5e-324),
    (1e-300, -1e-308),
)


def _force(speed: float, spin: float) -> float:
    return float(wrench(RingFriction(), [speed, 0.0, spin])[0])


def _torque(speed: float, spin: float) -> float:
    return float(wrench(RingFriction(), [speed, 0.0, spin])[2])


def _exact_force(speed: arb, spin: arb) -> arb:
    """The subgradient nearest zero at rest."""
    return arb(0) if speed == 0 else radians.force((spin / speed).mid())


def _exact_torque(speed: arb, spin: arb) -> arb:
    if speed == 0:
        return spin.sgn()
    return radians.torque((spin / speed).mid())


def cases() -> Iterator[Case]:
    """Cases of line 6."""
    for speed, spin in TWISTS:
        for quantity, compute, exact in (
            (Quantity.FORCE, _force, _exact_force),
            (Quantity.TORQUE, _torque, _exact_torque),
        ):
            yield Case(
                label=f"{quantity} at v = {speed:g}, R omega = {spin:g}", line=6, quantity=quantity,
                inputs=(speed, spin), compute=compute, reference=exact,
            )  # fmt: skip
