"""Line 3: short and long rods, radii of gyration far from the ring's, rods along fence and normal."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from planar_pushing.certified import radians
from planar_pushing.evidence.hard_cases.case import Case, Quantity
from planar_pushing.evidence.hard_cases.scenes import make_scene
from planar_pushing.mechanics.cones import motion_angle

ROD_ANGLE = np.pi / 4
LENGTHS = (1e-8, 1.0, 1e4, 1e6)
GYRATION_RADII = (1e-4, 1e-2, 1e2, 1e4)
ROD_ANGLES = (
    1e-300,
    1e-8,
    np.pi / 2,
    float(np.nextafter(np.pi / 2, 0)),
    float(np.nextafter(np.pi, 0)),
)
#: A force off the rod, and two nearly along it, where a long rod turns the motion fastest.
FORCE_ANGLES = (0.2, ROD_ANGLE + 1e-6, float(np.nextafter(ROD_ANGLE, 9)))


def _compute(length: float, psi: float, phi: float, share: float, rho: float) -> float:
    scene = make_scene(length, psi, share=share, rho=rho)
    return float(motion_angle(scene, phi, None if share in (0.0, 1.0) else share))


def _case(label: str, *inputs: float) -> Case:
    return Case(
        label=label, line=3, quantity=Quantity.MOTION_ANGLE, inputs=inputs,
        compute=_compute, reference=radians.motion_angle,
    )  # fmt: skip


def cases() -> Iterator[Case]:
    """Cases of line 3."""
    for share, name in ((0.0, "friction"), (1.0, "inertia")):
        for length in LENGTHS:
            for phi in FORCE_ANGLES:
                text = f"{name}, l = {length:g}, phi = {phi!r}"
                yield _case(text, length, ROD_ANGLE, phi, share, 1.0)
        for psi in ROD_ANGLES:
            yield _case(f"{name}, psi = {psi!r}", 2.0, psi, 2.6, share, 1.0)
    for rho in GYRATION_RADII:
        for share in (0.1, 1.0):
            yield _case(f"rho = {rho:g}, share {share:g}", 2.0, ROD_ANGLE, 0.2, share, rho)
