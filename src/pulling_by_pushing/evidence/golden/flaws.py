"""What makes golden data unfit to judge a result: numbers of another kind, or radii that are too wide.

A radius is at most `WIDEST` of its number; for a number below 1, of 1 or of the variable's largest number,
if that is smaller. More is allowed where the condition of a case says so, by the columns of the golden data
themselves: rounding errors of hard cases and of the methods for a wrench, and the component of a center of
rotation along an axis at right angles to that along which it is at infinity.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np
import xarray as xr

from pulling_by_pushing.evidence.golden.compare import KIND, Kind
from pulling_by_pushing.evidence.golden.enclosures import RADIUS, Floats, holds_radii, radii
from pulling_by_pushing.study.catalog import DATASETS, SIMULATIONS

#: Largest radius, as a part of its number.
WIDEST = 1e-9
#: Smallest size from which on a number may count as infinite.
NEARLY_INFINITE = 1e9
#: An error below this many rounding errors counts as rounding, and can be larger by this factor elsewhere.
NOISE = 8.0
#: Line of the hard cases with the motions over time, and their tolerance of integration in units in the
#: last place.
MOTION, TOLERANCE_ULPS = 13, 1e-12 / np.finfo(float).eps


def kind_of(file: str) -> Kind:
    """How the numbers of a result are known, by the catalog."""
    stem = file.partition("/")[0]
    if stem == SIMULATIONS:
        return Kind.INTEGRATED
    return Kind.ENCLOSED if stem in DATASETS and DATASETS[stem].certified else Kind.PLAIN


def flaws(file: str, golden: xr.Dataset) -> Iterator[str]:
    """Reasons why golden data of a dataset, or of its group, cannot judge a result; usually none."""
    kind, wanted = golden.attrs.get(KIND), kind_of(file)
    if kind != wanted:
        yield f"has golden data of the kind {kind!r}, not {str(wanted)!r}"
    conditions = radii_by_condition(file, golden)
    for name in map(str, golden.variables):
        if not holds_radii(name, golden):
            continue
        number = name.removesuffix(RADIUS)
        if golden[number].dtype.kind == "f" and (
            count := _count_wide(golden[number], golden[name], conditions.get(number))
        ):
            yield f"has {count} golden radii of {number} above {WIDEST:g} of their numbers"


def _count_wide(numbers: xr.DataArray, stored: xr.DataArray, condition: xr.DataArray | None) -> int:
    """Number of radii that are wider than allowed; NaN is wider than any."""
    values, radius = numbers.values, radii(stored.values)
    finite, infinite = np.isfinite(values), np.isinf(values)
    sizes = np.where(finite, np.abs(values), 0.0)
    largest = sizes.max(initial=0.0)
    unit = largest if WIDEST < largest < 1.0 else 1.0  # numbers that are all zero have no size
    allowed: Floats = WIDEST * np.maximum(sizes, unit)
    if condition is not None:
        allowed = np.fmax(allowed, condition.values)
    if "xy" in numbers.dims:
        # A translation along an axis: rounding decides where along the other one its center is.
        axis = numbers.get_axis_num("xy")
        allowed = np.where(infinite.any(axis=axis, keepdims=True), np.inf, allowed)
    wide = finite & ~(radius <= allowed)
    wide |= infinite & ~((radius == 0.0) | (radius >= NEARLY_INFINITE))
    return int(wide.sum())


def radii_by_condition(file: str, dataset: xr.Dataset) -> Mapping[str, xr.DataArray]:
    """Radii of the numbers of a dataset that follow from its own columns, by the names of the numbers."""
    if file == "hard_cases":
        return _rounding_of_cases(dataset)
    return _rounding_of_wrenches(dataset) if file == "accuracy/wrench" else {}


def _rounding_of_cases(cases: xr.Dataset) -> dict[str, xr.DataArray]:
    """Rounding errors of hard cases that their condition numbers allow on another processor.

    Thin shapes, which are computed as differences, have larger ones: of the size of the error itself. So do
    motions over time; rounding changes their steps, within the tolerance of the integration.
    """
    ulps = 8 + 4 * cases["condition"]
    ulps = ulps.where(cases["error_ulp"] <= ulps, 4 * cases["error_ulp"])
    ulps = ulps.where(cases["line"] != MOTION, np.fmax(ulps, TOLERANCE_ULPS))
    return {"result": ulps * np.spacing(np.abs(cases["reference_high"])), "error_ulp": ulps}


def _rounding_of_wrenches(wrench: xr.Dataset) -> dict[str, xr.DataArray]:
    """Radii of those errors of methods that are rounding errors, which differ between processors.

    Rounding of the smaller component of the spin ratio magnifies a rounding error by max(k, 1 / k).
    """
    k = wrench["spin_ratio"]
    rounding = NOISE * np.finfo(float).eps * np.maximum(k, 1 / k)
    error = wrench["wrench_error"]
    return {"wrench_error": (NOISE * error).where(error < rounding, 0.0)}
