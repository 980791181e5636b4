"""Check that friction holds the loads of a slider without inertia; otherwise no motion balances them."""

from __future__ import annotations

from typing import Any

import numpy as np

from planar_pushing.core.instant.kernels import WrenchRow
from planar_pushing.core.supports.rows import LoadRow
from planar_pushing.mechanics.effects import Load, RingFriction, SupportFriction
from planar_pushing.mechanics.kernels.arrays import Output, broadcast_numbers, map_kernel
from planar_pushing.mechanics.kernels.columns import row_of
from planar_pushing.mechanics.rows import data_of, entries_of
from planar_pushing.terms.errors import InvalidValue


def require_held(scene: Any) -> None:
    """Refuse a scene without inertia whose loads friction cannot hold.

    Raises
    ------
    InvalidValue
        With the ratio of the load to the largest load that friction holds.
    """
    if scene.stores_energy or not scene.loads:
        return
    loads = entries_of(_select_effects(scene, Load), scene)
    friction = entries_of(_select_effects(scene, (SupportFriction, RingFriction)), scene)
    total = {name: sum(load.values[name] for load in loads) for name in LoadRow.places}
    ratio = np.array(np.inf)
    if friction:
        columns = [column for entry in friction for column in entry.columns]
        data = data_of(friction)
        columns = broadcast_numbers(*columns, *row_of(WrenchRow, **total))
        ratio = map_kernel("load_ratios", data, columns, [Output("ratio")])[0]
    if np.any(~(ratio < 1.0)):
        raise InvalidValue(
            "force", f"{float(np.max(ratio)):.6g} times what friction can hold",
            "a load that friction can hold, in a scene without inertia",
            "add Inertia: nothing else resists the rest of the load",
        )  # fmt: skip


def _select_effects(scene: Any, kinds: Any) -> list[tuple[int, Any]]:
    """Effects of some kinds with their numbers."""
    return [(i, effect) for i, effect in enumerate(scene.effects) if isinstance(effect, kinds)]
