"""The builder of each dataset.

It imports all of them, so nothing that one dataset's job depends on imports it: a change to one builder
would make every dataset stale.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import xarray as xr

from planar_pushing.study.datasets import (
    acceleration_centers,
    center_regions,
    contact_modes,
    limit_curves,
    motion_cones,
    scenes,
)
from planar_pushing.study.datasets.sliders import support_cones, support_modes, supports
from planar_pushing.study.slices import sliced_study

Built = xr.Dataset | dict[str, xr.Dataset]

BUILDERS: dict[str, Callable[..., Built]] = {
    "limit_curves": limit_curves.build,
    "motion_cones": motion_cones.build,
    "contact_modes": contact_modes.build,
    "acceleration_centers": acceleration_centers.build,
    "center_regions": center_regions.build,
    "scenes": scenes.build,
    "supports": supports.build,
    "support_cones": support_cones.build,
    "support_modes": support_modes.build,
}


def build_dataset(name: str, values: dict[str, Any]) -> Built:
    """Build a dataset, or one for each group, from a slice of a study or a part of one."""
    return BUILDERS[name](sliced_study(values), **values.get("only", {}))
