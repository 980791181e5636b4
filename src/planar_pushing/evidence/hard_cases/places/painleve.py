"""Line 7: n . u falls as the force grows, so that one normal motion has two slips or none.

The published example: l = 2, psi = 45 degrees, mu = 1.4, W = m = rho = R = 1, force on the right edge.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

import numpy as np
from flint import arb

from planar_pushing.certified import radians
from planar_pushing.evidence.hard_cases.case import Case, Quantity
from planar_pushing.evidence.hard_cases.scenes import make_scene
from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.mechanics.solve import solve

LENGTH, ROD_ANGLE, COEFFICIENT = 2.0, np.pi / 4, 1.4
#: Spin ratio at which n . u is least (at |f| = 1.42); towards that level the slips meet.
TURN, LEAST = 0.47159055, -0.04002960666599751
LEVELS = (-1e-8, -1e-4, -0.01, -0.03, -0.04, LEAST * (1 - 1e-8), LEAST * (1 - 1e-13))


def _spins(mu: float, level: float) -> list[float]:
    # Far to the right, so that every motion slips to the left.
    found = solve(
        make_scene(LENGTH, ROD_ANGLE, mu=mu), np.arctan2(level, 10.0), np.hypot(level, 10.0)
    )
    return [each.spin_ratio for each in found if each.mode is ContactMode.SLIP_LEFT]


def _spin(branch: int, mu: float, level: float) -> float:
    return sorted(_spins(mu, level))[branch]


def _exact_spin(branch: int, mu: arb, level: arb) -> arb:
    phi = radians.friction_edge(mu, 1)
    psi = arb(ROD_ANGLE)
    arm = LENGTH * (psi - phi).sin()
    normal, lever = phi.sin(), LENGTH * psi.cos()
    ends = (normal / lever, arb(TURN), radians.friction_spin(arm.mid()))
    return radians.slip_spin(arm, normal, lever, level, ends[branch], ends[branch + 1])


def cases() -> Iterator[Case]:
    """Cases of line 7: the slip of the fast motion and that of the slow one."""
    for level in LEVELS:
        for branch, name in enumerate(("fast", "slow")):
            yield Case(
                label=f"{name} slip at n . u = {level!r}", line=7, quantity=Quantity.SPIN_RATIO,
                inputs=(COEFFICIENT, level), compute=partial(_spin, branch),
                reference=partial(_exact_spin, branch),
            )  # fmt: skip
