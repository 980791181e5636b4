"""Line 5: motions slow and fast, where the combined answer joins those of friction and of inertia."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from flint import arb

from planar_pushing.certified import radians
from planar_pushing.evidence.hard_cases.case import Case, Quantity
from planar_pushing.evidence.hard_cases.scenes import make_scene
from planar_pushing.mechanics.cones import spin_ratio
from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.mechanics.solve import solve

ROD_ANGLE = np.pi / 4
SHARES = (5e-324, 1e-300, 1e-16, 1e-8, 0.5, 1 - 1e-8, 1 - 2.0**-53)
MAGNITUDES = (1e-12, 1e-8, 1.0, 1e8, 1e12)
#: An arm of the ring's own radius: friction and inertia agree, with infinite slope of H.
TANGENT = float(ROD_ANGLE - np.arcsin(0.5))


def _spin(length: float, psi: float, phi: float, share: float) -> float:
    return float(spin_ratio(make_scene(length, psi, rho=0.7), phi, share))


def _exact_spin(length: arb, psi: arb, phi: arb, share: arb) -> arb:
    return radians.spin(length, psi, phi, share, arb(0.7))


def _stick(length: float, psi: float, pusher: float, magnitude: float) -> float:
    scene = make_scene(length, psi)
    (stick,) = (each for each in solve(scene, pusher, magnitude) if each.mode is ContactMode.STICK)
    return float(stick.spin_ratio)


def _exact_stick(length: arb, psi: arb, pusher: arb, magnitude: arb) -> arb:
    return radians.sticking_spin(length, psi, pusher, magnitude, arb(1))


def cases() -> Iterator[Case]:
    """Cases of line 5."""
    for phi in (0.2, TANGENT):
        for share in SHARES:
            yield Case(
                label=f"phi = {phi:.6g}, share {share!r}", line=5, quantity=Quantity.SPIN_RATIO,
                inputs=(2.0, ROD_ANGLE, phi, share), compute=_spin, reference=_exact_spin,
            )  # fmt: skip
    for magnitude in MAGNITUDES:
        yield Case(
            label=f"stick at m a / W = {magnitude:g}", line=5, quantity=Quantity.SPIN_RATIO,
            inputs=(2.0, ROD_ANGLE, 1.0, magnitude), compute=_stick, reference=_exact_stick,
        )  # fmt: skip
