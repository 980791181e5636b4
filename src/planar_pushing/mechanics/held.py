"""Whether friction holds the loads of a slider without inertia; otherwise no motion balances them."""

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

#: Distance in radii at which a couple counts as a force.
FAR = 1e6


@kernel
@owning
def _limits(kinds, rows, ratios):
    """Of each load, a wrench behind the columns of the friction, its part of what friction can hold."""
    first = count_fields(kinds)
    for i in range(len(rows)):
        x, y, torque = rows[i, first], rows[i, first + 1], rows[i, first + 2]
        if abs(x) + abs(y) <= abs(torque) / FAR:
            x, y = abs(torque) / FAR, 0.0
        size = sqrt(x * x + y * y)
        ratios[i] = 0.0
        if size > 0.0:
            # The load is a force along a line, like that of a pusher at the foot of the origin on it.
            at = contact_at(y * torque / size**2, -x * torque / size**2)
            limit = pushed(made(kinds, rows[i], 0), at, x / size, y / size, 1.0)
            ratios[i] = size / sqrt(limit.f_x * limit.f_x + limit.f_y * limit.f_y)


def require_held(scene: Any) -> None:
    """Refuse a scene without inertia whose loads friction cannot hold.

    Raises
    ------
    InvalidValue
        With the part of the load that friction can hold.
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
            "a load less than what friction holds, in a scene without inertia",
            "add Inertia: nothing else resists the rest of the load",
        )  # fmt: skip
