"""Check that friction holds the loads of a slider without inertia; otherwise no motion balances them."""

from __future__ import annotations

from math import sqrt
from typing import Any

import numpy as np

from planar_pushing.mechanics.compiled import kernel, owning
from planar_pushing.mechanics.core import entries
from planar_pushing.mechanics.effects import Load, RingFriction, SupportFriction
from planar_pushing.mechanics.effects.base import count_fields, made
from planar_pushing.mechanics.numerics.arrays import Output, mapped
from planar_pushing.mechanics.reduced.psi import contact_at
from planar_pushing.mechanics.reduced.under import pushed
from planar_pushing.terms.errors import InvalidValue

#: Distance, in radii, at which a force replaces a pure couple.
FAR = 1e6


@kernel
@owning
def _limits(kinds, rows, ratios):
    """Ratio of each load, a wrench after the columns of friction, to the largest that friction holds."""
    first = count_fields(kinds)
    for i in range(len(rows)):
        x, y, torque = rows[i, first], rows[i, first + 1], rows[i, first + 2]
        if abs(x) + abs(y) <= abs(torque) / FAR:
            x, y = abs(torque) / FAR, 0.0
        size = sqrt(x * x + y * y)
        ratios[i] = 0.0
        if size > 0.0:
            # The load is a force along a line, as of a pusher at the point of the line nearest the origin.
            at = contact_at(y * torque / size**2, -x * torque / size**2)
            limit = pushed(made(kinds, rows[i], 0), at, x / size, y / size, 1.0)
            ratios[i] = size / sqrt(limit.f_x * limit.f_x + limit.f_y * limit.f_y)


def require_held(scene: Any) -> None:
    """Refuse a scene without inertia whose loads friction cannot hold.

    Raises
    ------
    InvalidValue
        With the ratio of the load to the largest load that friction holds.
    """
    loads = entries([each for each in scene.effects if isinstance(each, Load)], scene)
    if not loads or scene.stores_energy:
        return
    kinds = SupportFriction, RingFriction
    friction = entries([each for each in scene.effects if isinstance(each, kinds)], scene)
    whole = [sum(each.forces[k] for each in loads) for k in range(3)]
    ratio = np.array(np.inf)
    if friction:
        columns = [each for entry in friction for each in entry.columns]
        found = mapped(
            _limits, tuple(entry.kind for entry in friction), [*columns, *whole], [Output("ratio")]
        )
        ratio = found[0]
    if np.any(~(ratio < 1.0)):
        raise InvalidValue(
            "force", f"{float(np.max(ratio)):.6g} times what friction can hold",
            "a load that friction can hold, in a scene without inertia",
            "add Inertia: nothing else resists the rest of the load",
        )  # fmt: skip
