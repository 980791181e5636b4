"""Certified values over a grid, or at some of its points: each point by its cell, in several processes."""

from __future__ import annotations

import itertools
import math
import zlib
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import partial
from inspect import signature
from multiprocessing import get_context
from typing import Any

import numpy as np
import xarray as xr
from flint import arb, ctx
from tqdm import tqdm

from planar_pushing.terms.errors import InvalidResult
from pulling_by_pushing.evidence.golden.cells import contacts, models, ring, supports
from pulling_by_pushing.evidence.golden.cells.sliders import CENTERS, Record, StudyValues
from pulling_by_pushing.evidence.golden.enclosures import EXACT, RADIUS, holds_radii, is_exact
from pulling_by_pushing.oracle.balls import FINE, Number, Undecided, Vector, precise
from pulling_by_pushing.oracle.integrals import distance_and_gradient
from pulling_by_pushing.oracle.support import Support

Point = tuple[Any, ...]
#: Midpoints and exponents by variable.
Arrays = dict[str, tuple[Any, Any]]


#: A function of the values of a study and of a point, whose coordinates are its further arguments.
Cell = Callable[..., Record]
#: The cells of each dataset; together they provide all of its numbers but those of `PLAIN`.
CELLS: Mapping[str, tuple[Cell, ...]] = {
    "limit_curves": (ring.limit_point_values,),
    "curves": (ring.curve_point,),
    "motion_cones": (ring.motion_cone, contacts.coefficients),
    "contact_modes": (ring.ring_solutions, contacts.contact_laws),
    "mode_maps": (ring.mode_set, ring.sticking_force, ring.furthest_pull, contacts.contact_laws),
    "acceleration_centers": (ring.acceleration_center, ring.acceleration_cones),
    "center_regions": (ring.region_ends,),
    "model_errors": (models.coasting_length,),
    "supports": (supports.support_wrench, supports.support_numbers),
    "support_cones": (supports.support_cone, contacts.coefficients),
    "support_modes": (supports.support_solutions, contacts.coefficients),
    "support_curves": (supports.support_curve, supports.ring_curve),
    "support_rods": (supports.support_rod, supports.ring_rod),
}
#: Variables that are stored as computed: the errors of another model, at motions that a search found, and
#: differences and evaluations of runs over time, with the pushes of these.
PLAIN = {
    "model_errors": ("pose_error", "evaluations", "evaluations_alone", "place", "pusher_angle"),
    "supports": tuple(
        f"{size}_{kind}_error" for size in ("mean", "worst") for kind in ("force", "motion")
    ),
}
#: Largest relative radius of an integral that is compared.
WIDEST_INTEGRAL = 2.0**-60
#: The second route is taken at one of so many points.
SAMPLED_ONE_OF = 20
#: Number of points that a process takes at once.
POINTS_PER_TASK = 400
#: Fewer points than this are done before another process has started.
FEW_POINTS = 100


def dims_of(cell: Cell) -> tuple[str, ...]:
    """Dimensions of the dataset whose coordinates a cell takes: the names of its arguments, in order."""
    _, *names = signature(cell).parameters
    return tuple(names)


def evaluate(
    cell: Cell, values: StudyValues, second: Callable[[Point], bool], point: Point
) -> Record | str:
    """Record of a point with each number as midpoint and exponent, or the reason why there is none.

    At the points of the second route, the entry `CENTERS` of the record is the number of its centers at
    which D and its gradient are also those of the defining integrals.
    """
    try:
        return _record(cell, values, point, second(point))
    except Undecided as error:
        return str(error)


@precise
def _record(cell: Cell, values: StudyValues, point: Point, twice: bool) -> Record:
    record = cell(values, *point)
    centers = record.pop(CENTERS, [])
    count = sum(map(_agrees, centers)) if twice else 0
    return {name: _store_nested(value) for name, value in record.items()} | {CENTERS: count}


def is_sampled(point: Point) -> bool:
    """Whether the second route is taken at a point: at one of 20, by a digest of its coordinates."""
    return zlib.crc32(repr(point).encode()) % SAMPLED_ONE_OF == 0


def is_never(point: Point) -> bool:
    """No second route."""
    return False


def _agrees(center: tuple[Support, Vector]) -> bool:
    """Whether D and its gradient at a center agree on both routes; at the end of a line there is one."""
    pieces, c = center
    try:
        printed = distance_and_gradient(pieces, c)
    except Undecided:
        return False
    closed = pieces.dgh(
        c,
        next(
            (i for i, point in enumerate(pieces.points) if c == tuple(map(arb, point.position))), -1
        ),
    )
    if any(part.rad() > WIDEST_INTEGRAL * (1 + abs(part)) for part in printed):
        return False
    if not all(a.overlaps(b) for a, b in zip(printed, closed, strict=False)):
        raise InvalidResult(f"the integrals disagree with D and its gradient at the center {c}")
    return True


def _store_nested(value: Any) -> Any:
    """Numbers as pairs of midpoint and exponent, in the same nested lists."""
    if isinstance(value, list):
        return [_store_nested(entry) for entry in value]
    return store(value)


def records(
    cell: Cell,
    values: StudyValues,
    points: Sequence[Point],
    processes: int,
    second: Callable[[Point], bool] = is_never,
) -> Iterator[Record | str]:
    """Records of points, in order; `second` selects the points of the second route."""
    evaluate_point = partial(evaluate, cell, values, second)
    if len(points) < FEW_POINTS:
        yield from map(evaluate_point, points)
        return
    with get_context("spawn").Pool(processes) as pool:
        step = max(1, min(POINTS_PER_TASK, len(points) // (4 * processes)))
        yield from pool.imap(evaluate_point, points, chunksize=step)


def points(dataset: xr.Dataset, dims: Iterable[str]) -> list[Point]:
    """The coordinates of all points along some dimensions."""
    axes = [dataset[dim].values.tolist() for dim in dims]
    return list(itertools.product(*axes))


def certify(
    name: str, values: StudyValues, template: xr.Dataset, processes: int
) -> tuple[xr.Dataset, int]:
    """A dataset with certified values instead of its own, and the exponents of their radii.

    Also returns the number of centers of rotation that were checked by the second route.

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
    count = 0
    for cell in CELLS[name]:
        dims = dims_of(cell)
        cell_points = points(template, dims)
        sizes = [template.sizes[dim] for dim in dims]
        computed = records(cell, values, cell_points, processes, is_sampled)
        for index, record in enumerate(
            tqdm(computed, name, len(cell_points), disable=None, leave=False)
        ):
            if isinstance(record, str):
                raise InvalidResult(kink(name, cell, cell_points[index], record))
            count += record.pop(CENTERS)
            _store_at(arrays, template, tuple(np.unravel_index(index, sizes)), record)
    return _assemble(name, arrays, template, PLAIN.get(name, ())), count


def certify_record(
    name: str,
    record: Record,
    template: xr.Dataset,
    plain: Sequence[str] = (),
) -> xr.Dataset:
    """A dataset with the certified values of one record instead of its own; `plain` ones are retained."""
    arrays: Arrays = {}
    _store_at(arrays, template, (), {key: _store_nested(value) for key, value in record.items()})
    return _assemble(name, arrays, template, plain)


def kink(name: str, cell: Cell, point: Point, reason: str) -> str:
    """The message about a point that cannot be certified."""
    where = ", ".join(f"{dim}={value}" for dim, value in zip(dims_of(cell), point, strict=True))
    return (
        f"{name}: {where}: on a kink, where rounding decides ({reason}); allowed: a point off it; "
        "choose another value of the grid, such as another coefficient of friction"
    )


def _store_at(arrays: Arrays, template: xr.Dataset, index: tuple[Any, ...], record: Record) -> None:
    """Store the numbers of a point at their place."""
    for name, nested in record.items():
        if name not in arrays:
            values = template[name].values
            empty = np.full(values.shape, empty_entry(name, values.dtype), values.dtype)
            arrays[name] = empty, np.full(values.shape, EXACT, np.int8)
        middle, exponent = arrays[name]
        if isinstance(nested, tuple):
            middle[index], exponent[index] = nested
        elif nested:
            numbers = np.array(nested, dtype=object)
            span = (*index, *(slice(0, length) for length in numbers.shape[:-1]))
            if numbers.shape[:-1] > middle[index].shape:
                raise InvalidResult(f"{name}: the result has too few entries; make it anew")
            middle[span], exponent[span] = numbers[..., 0], numbers[..., 1]


def _assemble(name: str, arrays: Arrays, template: xr.Dataset, plain: Sequence[str]) -> xr.Dataset:
    """The template with the certified values; all of its numbers except `plain` ones are required."""
    # As variables, so that no index aligns them: a certified time differs from the stored one.
    variables = {
        str(variable_name): variable.copy()
        for variable_name, variable in template.variables.items()
    }
    for variable_name, (middle, exponent) in arrays.items():
        dims, attrs = template[variable_name].dims, template[variable_name].attrs
        variables[variable_name] = xr.Variable(dims, middle, attrs)
        variables[f"{variable_name}{RADIUS}"] = xr.Variable(dims, exponent)
    coords = {coord: variables.pop(coord) for coord in map(str, template.coords)}
    dataset = xr.Dataset(variables, coords, template.attrs)
    _require_all(name, dataset, plain)
    return dataset


def empty_entry(name: str, dtype: np.dtype[Any]) -> Any:
    """The value of unused entries, such as those after the last solution."""
    if dtype.kind == "f":
        return np.nan
    return -1 if name in ("mode", "pivot") else 0


def _require_all(name: str, dataset: xr.Dataset, plain: Sequence[str] = ()) -> None:
    """Refuse a dataset with numbers that no cell certifies; axes and parameters are exact."""
    for variable_name, variable in dataset.variables.items():
        is_exact_value = (
            variable.dtype.kind in "OU"
            or holds_radii(variable_name, dataset)
            or is_exact(dataset, str(variable_name))
        )
        is_plain = str(variable_name) == "friction_coefficient" or variable_name in plain
        if not (is_exact_value or is_plain or f"{variable_name}{RADIUS}" in dataset):
            raise InvalidResult(f"{name}: {variable_name} is certified by no cell; add it to one")


#: The smallest and the largest exponent of a radius.
SMALLEST_EXPONENT, LARGEST_EXPONENT = -127, 127
#: Largest radius of an enclosure itself, relative to the number, or to 1 for numbers smaller than 1.
WIDEST_ENCLOSURE = 2.0**-60


def store(value: Any) -> tuple[Any, int]:
    """Midpoint and exponent of a number; a ball has no roundings, and anything else is exact.

    Raises
    ------
    Undecided
        If the enclosure is too wide to be useful.
    """
    if isinstance(value, arb):
        value = Number(value, arb(0))
    if not isinstance(value, Number):
        return value, EXACT
    ball, rounding = value
    if ball.is_nan() or rounding.is_nan():
        raise Undecided("no enclosure, or no condition, of a number")
    middle = float(ball.mid())
    if not math.isfinite(middle):
        return middle, EXACT if rounding.is_zero() else _exponent(rounding, math.floor)
    with ctx.workprec(FINE):
        radius = (ball - middle).abs_upper()
        if ball.rad() > WIDEST_ENCLOSURE * max(abs(middle), 1.0):
            raise Undecided(f"{ball} is too wide to store")
        if middle and ball.contains(0) and radius < 2.0**SMALLEST_EXPONENT:
            middle, radius = 0.0, ball.abs_upper()  # a number that vanishes by symmetry
        radius = arb(radius) + value.allowance
    return middle, EXACT if radius.is_zero() else _exponent(radius, math.ceil)


def _exponent(size: arb, to_integer: Any) -> int:
    if not size.is_finite():
        return LARGEST_EXPONENT
    with ctx.workprec(FINE):
        logarithm = arb(size.abs_upper()).log() / arb(2).log()
        return int(
            min(max(to_integer(float(logarithm.upper())), SMALLEST_EXPONENT), LARGEST_EXPONENT)
        )
