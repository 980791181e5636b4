"""Numbers of the report about accuracy, hard cases and effects, computed from their datasets."""

from __future__ import annotations

import json
from collections.abc import Callable

import numpy as np
import numpy.typing as npt
import xarray as xr

EPS = float(np.finfo(float).eps)
#: Errors up to this number of units in the last place count as rounding errors.
FEW_ULP = 4
#: Number of the hard cases in which two slipping solutions meet.
PAINLEVE = 7


def part(data: xr.Dataset, axis: str, holds: npt.NDArray[np.bool_]) -> xr.Dataset:
    """Rows along an axis without coordinates that satisfy a condition."""
    return data.isel({axis: np.flatnonzero(holds)})


def method(data: xr.Dataset, name: str) -> xr.Dataset:
    """Rows of one method, one for each setting."""
    return part(data, "point", data.method.values == name)


def worst_error(wrench: xr.Dataset, name: str) -> float:
    """Largest relative error over the spin ratios, at the method's best setting."""
    return float(method(wrench, name).error.max("spin_ratio").min())


def worst_error_in(wrench: xr.Dataset, unit: float, name: str) -> float:
    """Largest relative error over the spin ratios, in a given unit, at the best setting."""
    return worst_error(wrench, name) / unit


def last_error(wrench: xr.Dataset, name: str, spin_ratio: float) -> float:
    """Relative error at one spin ratio, at the most accurate setting."""
    return float(method(wrench, name).error.sel(spin_ratio=spin_ratio)[-1])


def last_evaluations(wrench: xr.Dataset, name: str, spin_ratio: float) -> float:
    """Evaluations at one spin ratio, at the most accurate setting."""
    return float(method(wrench, name).evaluations.sel(spin_ratio=spin_ratio)[-1])


def cone_error(cone: xr.Dataset, name: str) -> float:
    """Largest error of a cone's edge, at the most accurate setting."""
    return float(method(cone, name).cone_error[-1])


def cone_evaluations(cone: xr.Dataset, name: str) -> float:
    """Mean evaluations for a cone's edge, at the most accurate setting."""
    return float(method(cone, name).evaluations[-1])


def spin_ratios(wrench: xr.Dataset) -> float:
    """Number of spin ratios."""
    return float(wrench.sizes["spin_ratio"])


def well(cases: xr.Dataset) -> xr.Dataset:
    """Hard cases that are not ill-conditioned."""
    return part(cases, "case", cases.ill_conditioned.values == 0)


def ill(cases: xr.Dataset) -> xr.Dataset:
    """Hard cases that are ill-conditioned."""
    return part(cases, "case", cases.ill_conditioned.values > 0)


def hard_cases(cases: xr.Dataset) -> float:
    """Number of hard cases."""
    return float(cases.sizes["case"])


def ill_cases(cases: xr.Dataset) -> float:
    """Number of ill-conditioned cases."""
    return float(ill(cases).sizes["case"])


def well_cases(cases: xr.Dataset) -> float:
    """Number of well-conditioned cases."""
    return float(well(cases).sizes["case"])


def accurate_cases(cases: xr.Dataset) -> float:
    """Number of well-conditioned cases that are accurate to a few units in the last place."""
    return float((well(cases).error_ulp <= FEW_ULP).sum())


def largest_error(cases: xr.Dataset) -> float:
    """Largest error of the well-conditioned cases, units in the last place."""
    return float(well(cases).error_ulp.max())


def condition_there(cases: xr.Dataset) -> float:
    """Condition number where the error of the well-conditioned cases is largest."""
    fine = well(cases)
    return float(fine.condition[int(np.argmax(fine.error_ulp.values))])


def largest_error_elsewhere(cases: xr.Dataset) -> float:
    """Largest error of the well-conditioned cases except slips that meet."""
    fine = well(cases)
    return float(fine.error_ulp.values[fine.line.values != PAINLEVE].max())


def largest_share(cases: xr.Dataset) -> float:
    """Largest error of any case in units of one plus its condition number."""
    return float((cases.error_ulp / (1 + cases.condition)).max())


def ill_from(cases: xr.Dataset) -> float:
    """Condition number from which a case counts as ill-conditioned."""
    return float(json.loads(cases.attrs["parameters"])["ill_conditioned_from"])


def condition_of_ill(cases: xr.Dataset, which: Callable[[npt.NDArray[np.float64]], float]) -> float:
    """Extreme condition number of the ill-conditioned cases."""
    return float(which(ill(cases).condition.values))


def single(counts: xr.Dataset) -> xr.Dataset:
    """Counts of the sets with one effect."""
    return counts.sel(effects=[name for name in counts.effects.values.tolist() if "+" not in name])


def single_runs(counts: xr.Dataset) -> float:
    """Number of runs with one effect."""
    return float(single(counts).evaluations.isel(effect=0).size)


def listed(counts: xr.Dataset) -> float:
    """Evaluations of the listed effect in the runs with one effect."""
    alone = single(counts).evaluations
    return float(alone.where(alone.effects == alone.effect).sum())


def absent(counts: xr.Dataset) -> float:
    """Evaluations of the unlisted effect in the runs with one effect."""
    return float(single(counts).evaluations.sum()) - listed(counts)
