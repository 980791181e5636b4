"""Line 4: no friction, friction without bound, and pushers next to the fence or a cone's edge."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import partial

import numpy as np
from flint import arb

from planar_pushing.certified import radians
from planar_pushing.evidence.hard_cases.case import Case, Quantity
from planar_pushing.evidence.hard_cases.scenes import make_scene
from planar_pushing.mechanics.cones import motion_cone
from planar_pushing.mechanics.contact import ContactMode, PerfectlyRough
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.solve import solve

ROD_ANGLE = np.pi / 4
COEFFICIENTS = (0.0, 1e-300, 1e-8, 1.0, 1e8, 1e9, math.inf)
SHARES = ((0.0, "friction"), (1.0, "inertia"))


def _edge(side: int, share: float, length: float, psi: float, mu: float) -> float:
    cone = motion_cone(make_scene(length, psi, share=share, mu=mu))
    return float(cone.right if side > 0 else cone.left)


def _exact_edge(side: int, share: float, length: arb, psi: arb, mu: arb) -> arb:
    return radians.motion_edge(length, psi, mu, arb(share), arb(1), side)


def _stick(length: float, psi: float, pusher: float) -> float:
    scene = make_scene(length, psi, share=0.0)
    rough = Scene(slider=scene.slider, contact=PerfectlyRough(), effects=scene.effects)
    (stick,) = (each for each in solve(rough, pusher) if each.mode is ContactMode.STICK)
    return float(stick.spin_ratio)


def _exact_stick(length: arb, psi: arb, pusher: arb) -> arb:
    return radians.sticking_spin(length, psi, pusher, arb(0), arb(1))


def cases() -> Iterator[Case]:
    """Cases of line 4."""
    for share, name in SHARES:
        for mu in COEFFICIENTS:
            for side, edge in ((1, "right"), (-1, "left")):
                yield Case(
                    label=f"{edge} edge, {name}, mu = {mu:g}", line=4,
                    quantity=Quantity.MOTION_ANGLE, inputs=(2.0, ROD_ANGLE, mu),
                    compute=partial(_edge, side, share),
                    reference=partial(_exact_edge, side, share),
                )  # fmt: skip
    cone = motion_cone(make_scene(2.0, ROD_ANGLE, share=0.0, mu=2.0))
    edges = {"0": 0.0, "pi": np.pi, "the right edge": cone.right, "the left edge": cone.left}
    for name, angle in edges.items():
        for towards in (-9.0, 9.0):
            pusher = float(np.nextafter(angle, towards))
            yield Case(
                label=f"stick, pusher at {pusher!r}, an ulp off {name}", line=4,
                quantity=Quantity.SPIN_RATIO, inputs=(2.0, ROD_ANGLE, pusher), compute=_stick,
                reference=_exact_stick,
            )  # fmt: skip
