"""Contact modes of any support: decided by the motion cones, and every motion put into its equation.

The map from force angle to motion angle is monotone, so that a contact can stick where the pusher's motion
is within the motion cone, and slips under the force of an edge in the way of the motion there.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.certified.balls import precise
from planar_pushing.evidence.golden.residual.contact_modes.push import MODES, SLIPS, Decision, Flags
from planar_pushing.evidence.golden.residual.finding import EPSILON, Finding, same
from planar_pushing.evidence.golden.residual.sliders.gallery import Rod, edges, rods
from planar_pushing.evidence.golden.residual.sliders.slipping import slip_values, slips
from planar_pushing.evidence.golden.residual.sliders.sticking import Sticks
from planar_pushing.evidence.golden.residual.sliders.table import VALUES, Tables

#: Directions closer than this, for a rod of no length, are one: what rounding the angles explains, radians.
NEAR = 64 * EPSILON


@precise
def residuals(dataset: xr.Dataset, study: Any) -> Iterable[Finding]:
    """Findings of every variable."""
    tables = Tables(dataset)
    frictions = dataset["friction_coefficient"].values
    pushers = dataset["pusher_angle"].values
    for rod in rods(dataset, study):
        sticks = Sticks(rod, pushers)
        for i, friction in enumerate(frictions):
            _one_cone(tables, rod, float(friction), (*rod.place, i), sticks, pushers)
    return [
        Finding("consistent", np.where(tables.wrong, np.inf, 0.0), 0.0),
        same("outcome", dataset["outcome"].values, np.minimum(tables.counts.sum(axis=-1), 2)),
        *(Finding(name, tables.error[name], tables.allowed[name]) for name in (*VALUES, "pivot")),
    ]


def _one_cone(
    tables: Tables, rod: Rod, friction: float, at: tuple[int, ...], sticks: Sticks, pushers: Any
) -> None:
    """Check the modes of one support on one rod, for one law and every motion of the pusher."""
    found = edges(rod, friction)
    near = NEAR * (1 + float(rod.length) ** 2)
    away = (pushers <= 0) | (pushers == 180)
    tables.decide(at, "SEPARATE", Decision(away, np.zeros_like(away)))
    right, left = (np.deg2rad(float(found[side].angle)) for side in (1, -1))
    tables.decide(at, "STICK", _sticks(pushers, right, left, near))
    here = tables.counts[at][:, MODES.index("STICK")]
    for j in np.flatnonzero(here).tolist():
        sticks.check(tables, at, j, friction)
    for mode, side in SLIPS.items():
        tables.decide(at, mode, slips(pushers, found[side], side, near))
        for j in np.flatnonzero(tables.counts[at][:, MODES.index(mode)]).tolist():
            slip_values(tables, rod, (*at, j), mode, friction, pushers[j])


def _sticks(pushers: Any, right: float, left: float, near: float) -> Decision:
    """Where the pusher's motion is within the motion cone, right to left."""
    turn = 2 * np.pi
    past = np.mod(np.deg2rad(pushers) - right, turn)
    width = left - right
    off = np.minimum(np.minimum(past, turn - past), np.abs(past - width))
    within: Flags = past <= width
    return Decision(within, off <= near)
