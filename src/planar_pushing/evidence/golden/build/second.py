"""The second route: a part of the golden data computed from the integrals that define friction.

They are those of Eqs. (2)-(3) as printed for the ring, and for other supports those that define D and G
(`paper/manual/theory/any_support.md`).

The part is a thinner study, computed like the whole one in processes of their own, so that no number
of the first route is at hand. Its enclosures must overlap those of the first.
"""

from __future__ import annotations

from collections.abc import Iterator
from multiprocessing import get_context
from typing import Any, NamedTuple

import numpy as np
import xarray as xr

from planar_pushing.certified import ring
from planar_pushing.certified.integrals import printed
from planar_pushing.certified.supports.pressure import integrals, moments
from planar_pushing.evidence.golden.build.enclosures import disjoint, golden_variables
from planar_pushing.evidence.golden.build.jobs import Study, golden_jobs

#: Values kept of each axis: the edge cases are a rod of no length, a line of force tangent to the ring
#: (k = 1), along and across the rod, the fence itself, mu = 0 and infinity, and every law and mode.
GRID: dict[str, tuple[Any, ...]] = {
    "rod_length": (0, 1, 2, 10),
    "rod_angle": (45, 90),
    "force_angle": (0, 15, 45, 90, 135, 180, 225, 360),
    "friction_coefficient": (0, 1, 2, float("inf")),
    "inertia_share": (0, 0.5, 1),
    "pusher_angle": (-180, -15, -1, 0, 45, 165, 180),
    "pusher_magnitude": (1,),
}
CONTACTS = (
    *("coulomb_0", "coulomb_1.4", "coulomb_2"),
    *("infinite_friction_free", "infinite_friction_none", "perfectly_rough"),
)
CURVE_ANGLES = (45, 60, 90, 135, 180)
CONE_SAMPLES = (0, 45, 90, 180)
#: Motion over time starts from numbers of this route; its integrals over the spin ratio are of the first.
FIRST = (0.0,)
#: Values kept of a study of sliders: centers off the lines and rims of its supports, and one rod.
SLIDERS: dict[str, tuple[Any, ...]] = {
    "center_x": (-1.5, -0.5, 0.5, 1.5),
    "center_y": (-1.5, -0.5, 0.5, 1.5),
    "rod_length": (5,),
    "rod_angle": (45,),
    "friction_coefficient": (0.25,),
    "pusher_angle": (-45, 90),
}


class Agreement(NamedTuple):
    """How many enclosures of two routes were compared, and the variables in which they lie apart.

    Exact numbers and flags come on top of the count.
    """

    compared: int
    apart: tuple[str, ...]


def thinned(study: Study) -> dict[str, Any]:
    """The part of a study that is computed from the integrals."""
    if "supports" in study:
        return {**study, "grid": _thinned(study["grid"], SLIDERS)}
    scenes = {
        name: (file, {**push, "cone_samples": CONE_SAMPLES})
        for name, (file, push) in study["scenes"].items()
    }
    contacts = {label: law for label, law in study["contacts"].items() if label in CONTACTS}
    grid = _thinned(study["grid"], GRID)
    part = {"grid": grid, "scenes": scenes, "contacts": contacts, "curve_angles": CURVE_ANGLES}
    part["instants"] = FIRST
    return {**study, **part}


def _thinned(grid: Any, part: dict[str, tuple[Any, ...]]) -> dict[str, Any]:
    return {
        axis: [each for each in values if each in part[axis]] if axis in part else values
        for axis, values in grid.items()
    }


def use_integrals() -> None:
    """Evaluate every support by its integrals from now on."""
    ring.use(printed)
    moments.use(integrals.printed)


def second_route(study: Study, processes: int) -> Iterator[tuple[str, xr.Dataset]]:
    """Golden files of the thinned study, computed from the integrals."""
    names = [name for name, _ in golden_jobs(thinned(study))]
    with get_context("spawn").Pool(processes, use_integrals) as pool:
        built = pool.imap(_build, [(study, name) for name in names])
        yield from zip(names, built, strict=True)


def _build(job: tuple[Study, str]) -> xr.Dataset:
    study, name = job
    return dict(golden_jobs(thinned(study)))[name](1)


def agreement(study: Study, second: xr.Dataset, first: xr.Dataset) -> Agreement:
    """Compare the enclosures of two routes at the points of the second."""
    kept = study["grid"]["friction_coefficient"]
    bare = {  # dimensions that some file has no coordinate for
        "cone_sample": list(CONE_SAMPLES),
        "friction_coefficient": np.flatnonzero(np.isin(kept, GRID["friction_coefficient"])),
    }
    apart, count = [], 0
    for each in golden_variables(second):
        dims = second[each].dims
        part = first.sel({dim: second[dim].values for dim in dims if dim in second.coords})
        part = part.isel(
            {dim: bare[dim] for dim in dims if dim in bare and dim not in first.coords}
        )
        count += int((second[f"{each}_radius"] > 0).sum()) if f"{each}_radius" in second else 0
        if disjoint(each, second, part).any():
            apart.append(each)
    return Agreement(count, tuple(apart))
