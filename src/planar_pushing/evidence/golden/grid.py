"""Certified values over a grid, or at some of its points: each point by its cell, in several processes."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from multiprocessing import get_context
from typing import Any

import numpy as np
import xarray as xr
from tqdm import tqdm

from planar_pushing.certified import ring
from planar_pushing.certified.balls import Undecided, precise
from planar_pushing.certified.integrals import printed
from planar_pushing.certified.storage import stored
from planar_pushing.certified.supports.pressure import integrals, moments
from planar_pushing.evidence.golden import cells, supports
from planar_pushing.evidence.golden.cells import Record, Values
from planar_pushing.evidence.golden.enclosures import EXACT, RADIUS
from planar_pushing.terms.errors import InvalidResult

Point = tuple[Any, ...]
#: Midpoints and exponents by variable.
Arrays = dict[str, tuple[Any, Any]]


@dataclass(frozen=True, slots=True)
class Cell:
    """A function of a point, and the dimensions whose coordinates it takes."""

    dims: tuple[str, ...]
    function: Callable[..., Record]


ROD = ("support", "rod_length", "rod_angle", "friction_coefficient")
#: The cells of each dataset; together they provide all of its numbers.
CELLS: Mapping[str, tuple[Cell, ...]] = {
    "limit_curves": (
        Cell(("effects", "rod_length", "rod_angle", "force_angle"), cells.limit_point),
    ),
    "motion_cones": (
        Cell(("effects", "rod_length", "rod_angle", "friction_coefficient"), cells.motion_cone),
        Cell(("friction_coefficient",), cells.coefficients),
    ),
    "contact_modes": (
        Cell(
            ("effects", "contact", "rod_length", "pusher_magnitude", "pusher_angle"),
            cells.solutions,
        ),
        Cell(("contact",), cells.contact_laws),
    ),
    "acceleration_centers": (
        Cell(("rod_length", "force_angle", "inertia_share"), cells.acceleration_center),
        Cell(("rod_length",), cells.acceleration_cones),
    ),
    "center_regions": (Cell(("rod_length", "rod_angle", "force_angle"), cells.region_ends),),
    "supports": (
        Cell(("support", "center_x", "center_y"), supports.wrench),
        Cell(("support",), supports.numbers),
    ),
    "support_cones": (
        Cell(ROD, supports.cone),
        Cell(("friction_coefficient",), cells.coefficients),
    ),
    "support_modes": (
        Cell((*ROD, "pusher_angle"), supports.solutions),
        Cell(("friction_coefficient",), cells.coefficients),
    ),
}
#: Number of points that a process takes at once.
TAKEN = 400
#: Fewer points than this are done before another process has started.
FEW = 100


def use_integrals() -> None:
    """Evaluate every support by its integrals as printed from now on."""
    ring.use(printed)
    moments.use(integrals.printed)


@precise
def evaluated(cell: Cell, values: Values, point: Point) -> Record | str:
    """Record of a point with each number as midpoint and exponent, or the reason why there is none."""
    try:
        return {name: _nested(each) for name, each in cell.function(values, *point).items()}
    except Undecided as error:
        return str(error)


def _nested(value: Any) -> Any:
    """Numbers as pairs of midpoint and exponent, in the same nested lists."""
    if isinstance(value, list):
        return [_nested(each) for each in value]
    return stored(value)


def records(
    cell: Cell, values: Values, points: Sequence[Point], processes: int, second: bool = False
) -> Iterator[Record | str]:
    """Records of points, in order; with `second`, all are evaluated by the integrals as printed.

    The second route has processes of its own, because a process remembers what it has evaluated.
    """
    wanted = partial(evaluated, cell, values)
    if not points or (len(points) < FEW and not second):
        yield from map(wanted, points)
        return
    with get_context("spawn").Pool(processes, use_integrals if second else None) as pool:
        step = max(1, min(TAKEN, len(points) // (4 * processes)))
        yield from pool.imap(wanted, points, chunksize=step)


def points(dataset: xr.Dataset, dims: Iterable[str]) -> list[Point]:
    """The coordinates of all points along some dimensions."""
    axes = [dataset[dim].values.tolist() for dim in dims]
    return list(itertools.product(*axes))


def certified(name: str, values: Values, template: xr.Dataset, processes: int) -> xr.Dataset:
    """A dataset with certified values instead of its own, and the exponents of their radii.

    Parameters
    ----------
    name : str
    values : mapping
        Slice of the study.
    template : xarray.Dataset
        The dataset as computed; its coordinates, texts and attributes are retained.

    Raises
    ------
    InvalidResult
        If a point is undecided, or no cell certifies a number of the dataset.
    """
    arrays: Arrays = {}
    for cell in CELLS[name]:
        every = points(template, cell.dims)
        sizes = [template.sizes[dim] for dim in cell.dims]
        computed = records(cell, values, every, processes)
        for index, record in enumerate(tqdm(computed, name, len(every), disable=None, leave=False)):
            if isinstance(record, str):
                raise InvalidResult(kink(name, cell, every[index], record))
            _place(arrays, template, tuple(np.unravel_index(index, sizes)), record)
    return _assembled(name, arrays, template)


def single(
    name: str,
    record: Record,
    template: xr.Dataset,
    plain: Sequence[str] = (),
    check: bool = True,
) -> xr.Dataset:
    """A dataset with the certified values of one record instead of its own; `plain` ones are retained.

    Without `check` the record is one of `evaluated`, and contains only some of the numbers.
    """
    arrays: Arrays = {}
    named = {key: _nested(each) for key, each in record.items()} if check else record
    _place(arrays, template, (), named)
    return _assembled(name, arrays, template, plain if check else None)


def kink(name: str, cell: Cell, point: Point, reason: str) -> str:
    """The message about a point that cannot be certified."""
    where = ", ".join(f"{dim}={each}" for dim, each in zip(cell.dims, point, strict=True))
    return (
        f"{name}: {where}: on a kink, where rounding decides ({reason}); allowed: a point off it; "
        "choose another value of the grid, such as another coefficient of friction"
    )


def _place(arrays: Arrays, template: xr.Dataset, at: tuple[Any, ...], record: Record) -> None:
    """Store the numbers of a point at their place."""
    for name, nested in record.items():
        if name not in arrays:
            like = template[name].values
            empty = np.full(like.shape, _empty(name, like.dtype), like.dtype)
            arrays[name] = empty, np.full(like.shape, EXACT, np.int8)
        middle, exponent = arrays[name]
        if isinstance(nested, tuple):
            middle[at], exponent[at] = nested
        elif nested:
            numbers = np.array(nested, dtype=object)
            span = (*at, *(slice(0, length) for length in numbers.shape[:-1]))
            middle[span], exponent[span] = numbers[..., 0], numbers[..., 1]


def _assembled(
    name: str, arrays: Arrays, template: xr.Dataset, plain: Sequence[str] | None = ()
) -> xr.Dataset:
    """The template with the certified values; all of its numbers except `plain` ones are required."""
    # As variables, so that no index aligns them: a certified time differs from the stored one.
    variables = {str(each): variable.copy() for each, variable in template.variables.items()}
    for each, (middle, exponent) in arrays.items():
        dims, attrs = template[each].dims, template[each].attrs
        variables[each] = xr.Variable(dims, middle, attrs)
        variables[f"{each}{RADIUS}"] = xr.Variable(dims, exponent)
    coords = {each: variables.pop(each) for each in map(str, template.coords)}
    found = xr.Dataset(variables, coords, template.attrs)
    if plain is not None:
        _require_all(name, found, plain)
    return found


def _empty(name: str, dtype: np.dtype[Any]) -> Any:
    """The value of unused entries, such as those after the last solution."""
    if dtype.kind == "f":
        return np.nan
    return -1 if name in ("mode", "pivot") else 0


def _require_all(name: str, found: xr.Dataset, known: Sequence[str] = ()) -> None:
    """Refuse a dataset with numbers that no cell certifies; coordinates of the grid are exact."""
    for each, variable in found.variables.items():
        plain = variable.dtype.kind in "OU" or str(each) in found.dims or str(each).endswith(RADIUS)
        given = str(each) == "friction_coefficient" or each in known
        if not (plain or given or f"{each}{RADIUS}" in found):
            raise InvalidResult(f"{name}: {each} is certified by no cell; add it to one")
