"""Golden data of a study of sliders: wrenches, motion cones and contact modes of any support.

A part of the study's grid is certified: `CENTERS`, and the rods, laws and motions below. Of the supports on
points it leaves out where a point takes its share to all digits of the file's coordinates: there their
rounding decides what pivots.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial
from typing import Any

import xarray as xr

from planar_pushing.evidence.golden.build import generate
from planar_pushing.evidence.golden.build.generate import tabulated
from planar_pushing.evidence.golden.build.sliders import cells

#: How the numbers are proved, and which part of the study they are.
MARKS = {
    "method": "closed forms in balls; motions and rotations by a change of "
    "sign, pivots by the force at the point against its share",
    "part": "the coordinates of this file, of those of the study",
}
#: Plain values of a study of sliders: the entries of its supports, and its grid.
Study = Mapping[str, Any]
#: Steps between the certified centers of rotation, in the unit of length.
CENTERS = 0.5
#: Values kept of each axis, for the cones and for the modes.
CONES: Mapping[str, tuple[Any, ...]] = {"friction_coefficient": (0.25, 1.5, 2, 5, float("inf"))}
MODES: Mapping[str, tuple[Any, ...]] = {
    "rod_length": (0.5, 5),
    "friction_coefficient": (0.25, 2, float("inf")),
    "pusher_angle": (-180, -135, -45, -15, 0, 15, 45, 90, 105, 135, 165, 180),
}
ROD = ("support", "rod_length", "rod_angle", "friction_coefficient")
SOURCE = "paper/manual/theory/any_support.md: any pressure distribution"


def kept(study: Study, axes: Mapping[str, tuple[Any, ...]]) -> dict[str, Any]:
    """The study's grid with a part of some axes, and its supports as an axis."""
    grid = {
        name: [each for each in values if each in axes.get(name, values)]
        for name, values in study["grid"].items()
    }
    return {"support": list(study["supports"]), **grid}


def supports(study: Study, processes: int = 1) -> xr.Dataset:
    """Wrenches over centers of rotation, and numbers of each support as a whole."""
    whole = kept(study, {})
    steps = {name: [each for each in whole[name] if each % CENTERS == 0] for name in cells.CENTERS}
    dims, inner = ("support", *cells.CENTERS), ("twist_component", "wrench_component")
    entries = study["supports"]
    variables = tabulated(whole | steps, dims, partial(cells.wrench, entries), processes)
    numbers = partial(cells.numbers, entries)
    variables |= tabulated(whole, dims[:1], numbers, processes, inner=inner)
    axes = {"twist_component": ["v_x", "v_y", "omega"], "wrench_component": ["f_x", "f_y", "tau"]}
    return _assembled(whole | steps | axes, (*dims, *inner), variables, "Supports")


def cones(study: Study, processes: int = 1) -> xr.Dataset:
    """Motion cones of every support."""
    grid = kept(study, CONES)
    cone = partial(cells.cone, study["supports"])
    variables = tabulated(grid, ROD, cone, processes, inner=("edge",))
    axes = grid | {"edge": ["right", "left"]}
    return _assembled(axes, (*ROD, "edge"), variables, "Motion cones of every support")


def modes(study: Study, processes: int = 1) -> xr.Dataset:
    """Contact modes of every support."""
    grid, dims = kept(study, MODES), (*ROD, "pusher_angle")
    mode = partial(cells.mode, study["supports"])
    variables = tabulated(grid, dims, mode, processes, inner=("mode",))
    axes = grid | {"mode": list(cells.MODES)}
    return _assembled(axes, (*dims, "mode"), variables, "Contact modes of every support")


def _assembled(
    grid: Any, dims: tuple[str, ...], variables: dict[str, Any], title: str
) -> xr.Dataset:
    return generate.assembled(grid, dims, variables, title, SOURCE).assign_attrs(MARKS)
