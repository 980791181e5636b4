"""Golden datasets: the names, dimensions and units of the results, each number with its radius.

A number is stored as three variables: `name` and `name_low`, whose sum is the midpoint, and
`name_radius`, a rigorous bound of its error. Flags and counts are proved, not rounded, and have one.
Coordinates and parameters are plain values, taken as exact; lengths and magnitudes are doubles,
angles degrees.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import partial
from multiprocessing import get_context
from typing import Any

import numpy as np
import xarray as xr
from tqdm import tqdm

from planar_pushing.certified.balls import precise
from planar_pushing.certified.contact import modes
from planar_pushing.evidence.golden.build import cells
from planar_pushing.evidence.golden.build.cells import UNIT, Parameters, Record
from planar_pushing.evidence.golden.build.marks import marks, provenance
from planar_pushing.evidence.golden.build.packing import parts

Grid = Mapping[str, Sequence[Any]]
Cell = Callable[..., Record]


def coefficient(law: modes.Law) -> float:
    """Coefficient of friction of a law; perfect roughness is none of friction, and has NaN."""
    return math.nan if law.adhesive else law.friction_coefficient


def limit_curves(grid: Grid, parameters: Parameters = UNIT, processes: int = 1) -> xr.Dataset:
    """Limit curves over effects, rod_length, rod_angle and force_angle (Eqs. 2-7, Sec. 4)."""
    dims = ("effects", "rod_length", "rod_angle", "force_angle")
    variables = tabulated(grid, dims, partial(cells.limit_point, parameters), processes)
    return assembled(grid, dims, variables, "Limit curves", "Eqs. (2)-(7), Sec. 4")


def motion_cones(grid: Grid, parameters: Parameters = UNIT, processes: int = 1) -> xr.Dataset:
    """Motion cones over effects, rod_length, rod_angle and friction_coefficient (Secs. 3 and 4)."""
    dims = ("effects", "rod_length", "rod_angle", "friction_coefficient")
    variables = tabulated(grid, dims, partial(cells.motion_cone, parameters), processes)
    return assembled(grid, dims, variables, "Motion cones", "Secs. 3.1, 3.2 and 4")


def contact_modes(
    grid: Grid,
    contacts: Mapping[str, tuple[str, modes.Law]],
    rod_angle: float = 45.0,
    parameters: Parameters = UNIT,
    processes: int = 1,
) -> xr.Dataset:
    """Contact modes over effects, contact, rod_length, pusher_magnitude and pusher_angle (Secs. 2-5).

    `contacts` maps a label to the type of the law and the law itself.
    """
    coords = {**grid, "contact": list(contacts)}
    dims = ("effects", "contact", "rod_length", "pusher_magnitude", "pusher_angle")
    laws = {label: law for label, (_, law) in contacts.items()}
    cell = partial(cells.contact_mode, parameters, rod_angle, laws)
    variables = tabulated(coords, dims, cell, processes, inner=("mode",))
    coords["mode"] = [mode.name for mode in modes.Mode]
    dataset = assembled(coords, (*dims, "mode"), variables, "Contact modes", "Secs. 2 to 5")
    return dataset.assign_coords(
        law=("contact", [kind for kind, _ in contacts.values()], marks("law")),
        friction_coefficient=(
            "contact",
            [coefficient(law) for law in laws.values()],
            marks("friction_coefficient"),
        ),
    )


def acceleration_centers(
    grid: Grid, rod_angle: float = 45.0, parameters: Parameters = UNIT, processes: int = 1
) -> xr.Dataset:
    """Acceleration centers over rod_length, force_angle and inertia_share; cones over rod_length."""
    dims = ("rod_length", "force_angle", "inertia_share")
    centers = partial(cells.center, parameters, rod_angle)
    bounds = partial(cells.acceleration_cones, parameters, rod_angle)
    variables = tabulated(grid, dims, centers, processes)
    variables |= tabulated(grid, dims[:1], bounds, processes)
    return assembled(grid, dims, variables, "Acceleration centres and cones", "Sec. 4")


def center_regions(grid: Grid, parameters: Parameters = UNIT, processes: int = 1) -> xr.Dataset:
    """Ends of the paper's bound and of the exact set over rod_length, rod_angle and force_angle."""
    dims = ("rod_length", "rod_angle", "force_angle")
    ends = {"bound_end": ["inner", "outer"], "exact_end": ["support_friction", "inertia"]}
    made = {"bound_end": cells.bound_ends, "exact_end": cells.exact_ends}
    variables: dict[str, Any] = {}
    for end, cell in made.items():
        variables |= tabulated(grid, dims, partial(cell, parameters), processes, inner=(end,))
    return assembled({**grid, **ends}, (*dims, *ends), variables, "Regions of centres", "Sec. 4")


def tabulated(
    grid: Grid, dims: tuple[str, ...], cell: Cell, processes: int, inner: tuple[str, ...] = ()
) -> dict[str, Any]:
    """Evaluate a cell at every point of the grid; lists in its record run along `inner`."""
    points = list(itertools.product(*(grid[name] for name in dims)))
    records = _evaluate(partial(_packed, cell), points, processes)
    shape = tuple(len(grid[name]) for name in dims)
    variables = {}
    for name in records[0]:
        values = np.array([record[name] for record in records])
        array = values.reshape(shape + values.shape[1:])
        variables[name] = (dims + inner[: array.ndim - len(dims)], array)
    return variables


def _evaluate(cell: Callable[[Any], Any], points: Iterable[Any], processes: int) -> list[Any]:
    if processes == 1:
        return [cell(point) for point in points]
    points = list(points)
    with get_context("spawn").Pool(processes) as pool:
        records = pool.imap(cell, points, chunksize=-(-len(points) // (32 * processes)))
        return list(tqdm(records, "cells", len(points), disable=None, leave=False))


@precise
def _packed(cell: Cell, point: tuple[Any, ...]) -> dict[str, Any]:
    """Record of one point with every ball as midpoint, low part and radius."""
    record = cell(*point).items()
    return {part: array for name, value in record for part, array in parts(name, value).items()}


def assembled(
    grid: Grid, dims: tuple[str, ...], variables: dict[str, Any], title: str, source: str
) -> xr.Dataset:
    """Dataset of tabulated variables over axes."""
    coords = {name: (name, list(grid[name]), marks(name)) for name in dims}
    values = {name: (*value, marks(name)) for name, value in variables.items()}
    return xr.Dataset(values, coords, provenance(title) | {"source": source})
