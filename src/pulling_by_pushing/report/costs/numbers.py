"""Numbers of the report about accuracy, times, effects and hard cases, computed from their datasets.

A time is the shortest of repeated runs on one machine.
"""

from __future__ import annotations

import json
import re
from collections.abc import Callable

import numpy as np
import numpy.typing as npt
import xarray as xr

#: Kinds of times: of a result in an array, and of a call for one result.
ARRAY, CALL = "_seconds", "_call_seconds"
EPS = float(np.finfo(float).eps)
#: Errors up to this number of units in the last place count as rounding errors.
FEW_ULP = 4
#: Numbers of the hard cases in which two slipping solutions meet, and of those of thin shapes, which are
#: computed as differences and lose digits beyond their condition.
PAINLEVE, THIN = 7, 12
#: Number of the motions over time, whose errors are those of the integration.
MOTION = 13


def machine(data: xr.Dataset) -> dict[str, str]:
    """Machine on which a dataset was measured, as stored in it."""
    description: dict[str, str] = json.loads(data.attrs["machine"])
    return description


def processor(data: xr.Dataset) -> str:
    """Processor on which a dataset was measured, without the marks of trademarks."""
    return re.sub(r"\((R|TM)\)", "", machine(data)["processor"])


def part(data: xr.Dataset, axis: str, holds: npt.NDArray[np.bool_]) -> xr.Dataset:
    """Rows along an axis without coordinates that satisfy a condition."""
    return data.isel({axis: np.flatnonzero(holds)})


def method(data: xr.Dataset, name: str) -> xr.Dataset:
    """Rows of one method, one for each setting."""
    return part(data, "point", data.method.values == name)


def worst_error_in(wrench: xr.Dataset, unit: float, name: str) -> float:
    """Largest relative error over the spin ratios, in a given unit, at the best setting."""
    return float(method(wrench, name).wrench_error.max("spin_ratio").min()) / unit


def error(data: xr.Dataset, name: str) -> float:
    """Largest error of a method, at its most accurate setting."""
    (variable,) = (key for key in data.data_vars if str(key).endswith("_error"))
    return float(method(data, name)[variable][-1].max())


def error_at(wrench: xr.Dataset, name: str, spin_ratio: float) -> float:
    """Relative error at one spin ratio, at the most accurate setting."""
    return error(wrench.sel(spin_ratio=[spin_ratio]), name)


def spin_ratios(wrench: xr.Dataset) -> float:
    """Number of spin ratios."""
    return float(wrench.sizes["spin_ratio"])


def times(data: xr.Dataset, name: str, kind: str) -> npt.NDArray[np.float64]:
    """Times of a method at its most accurate setting, seconds, one for each case.

    The kind is "_seconds" in an array and "_call_seconds" in a call for one result.
    """
    quantity = next(str(key) for key in data.data_vars).partition("_")[0]
    return np.atleast_1d(method(data, name)[f"{quantity}{kind}"][-1].min("repeat").values)


def time(
    data: xr.Dataset, name: str, which: Callable[[npt.NDArray[np.float64]], float], per: float
) -> float:
    """Smallest or largest time of a method in an array over the cases, at its most accurate setting."""
    return per * float(which(times(data, name, ARRAY)))


def call_time(
    data: xr.Dataset, name: str, which: Callable[[npt.NDArray[np.float64]], float], per: float
) -> float:
    """Smallest or largest time of a call of a method over the cases, at its most accurate setting."""
    return per * float(which(times(data, name, CALL)))


def time_at(wrench: xr.Dataset, name: str, spin_ratio: float, per: float) -> float:
    """Time for a wrench in an array at one spin ratio, at the most accurate setting."""
    return time(wrench.sel(spin_ratio=[spin_ratio]), name, np.min, per)


def time_ratio(data: xr.Dataset, name: str) -> float:
    """Smallest ratio over the cases of the time of a call of a method to that of the closed form."""
    return float(np.min(times(data, name, CALL) / times(data, "closed form", CALL)))


def slip(motion: xr.Dataset, variable: str, name: str, setting: float, per: float = 1.0) -> float:
    """Error, or shortest time, of a method at a setting for the slipping scene."""
    rows = method(motion.sel(scene="slipping"), name)
    row = part(rows, "point", np.isclose(rows.setting.values, setting, atol=0.0))
    return per * float(row[variable].min())


def tolerance_ratio(motion: xr.Dataset) -> float:
    """Ratio of the times of a run at the tightest and at the loosest tolerance, in a batch of slips."""
    rows = method(motion.sel(scene="slipping"), "event-driven").motion_seconds.min("repeat")
    return float(rows[-1] / rows[0])


def log_time(motion: xr.Dataset, per: float) -> float:
    """Time of a call for a run without duration, in the slipping scene."""
    return per * float(motion.log_seconds.sel(scene="slipping").min())


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


def thick(cases: xr.Dataset) -> xr.Dataset:
    """Hard cases except those of thin shapes and motions over time."""
    return part(cases, "case", ~np.isin(cases.line.values, (THIN, MOTION)))


def over_time(cases: xr.Dataset) -> xr.Dataset:
    """Hard motions over time."""
    return part(cases, "case", cases.line.values == MOTION)


def motions(cases: xr.Dataset) -> float:
    """Number of hard motions, whose labels end in their names."""
    labels = over_time(cases).case.values.tolist()
    return float(len({label.partition(", ")[2] for label in labels}))


def largest_error_of_motions(cases: xr.Dataset) -> float:
    """Largest error of the hard motions, units in the last place."""
    return float(over_time(cases).error_ulp.max())


def fewest_digits(cases: xr.Dataset) -> float:
    """Smallest number of digits of a reference of a hard motion."""
    return float(over_time(cases).reference_digits.min())


def tolerance(cases: xr.Dataset) -> float:
    """Relative tolerance of the hard motions."""
    return float(json.loads(cases.attrs["parameters"])["rtol"])


def largest_error(cases: xr.Dataset) -> float:
    """Largest error of the well-conditioned cases except thin shapes and motions, ulp."""
    return float(well(thick(cases)).error_ulp.max())


def condition_there(cases: xr.Dataset) -> float:
    """Condition number of the well-conditioned case with the largest error, as above."""
    fine = well(thick(cases))
    return float(fine.condition[int(np.argmax(fine.error_ulp.values))])


def largest_error_elsewhere(cases: xr.Dataset) -> float:
    """Largest error of the well-conditioned cases except slips that meet, thin shapes and motions."""
    fine = well(thick(cases))
    return float(fine.error_ulp.values[fine.line.values != PAINLEVE].max())


def largest_error_of_thin(cases: xr.Dataset) -> float:
    """Largest error of thin shapes, units in the last place."""
    return float(cases.error_ulp.values[cases.line.values == THIN].max())


def largest_share(cases: xr.Dataset) -> float:
    """Largest error of any case except thin shapes and motions, over one plus its condition."""
    some = thick(cases)
    return float((some.error_ulp / (1 + some.condition)).max())


def ill_from(cases: xr.Dataset) -> float:
    """Condition number from which a case counts as ill-conditioned."""
    return float(json.loads(cases.attrs["parameters"])["ill_conditioned_from"])


def single(counts: xr.Dataset) -> xr.Dataset:
    """Counts of the sets with one effect."""
    return counts.sel(effects=[name for name in counts.effects.values.tolist() if "+" not in name])


def single_runs(counts: xr.Dataset) -> float:
    """Number of runs with one effect."""
    return float(single(counts).evaluations.isel(effect=0).size)


def count_listed(counts: xr.Dataset) -> float:
    """Evaluations of the listed effect in the runs with one effect."""
    alone = single(counts).evaluations
    return float(alone.where(alone.effects == alone.effect).sum())


def count_absent(counts: xr.Dataset) -> float:
    """Evaluations of the unlisted effect in the runs with one effect."""
    return float(single(counts).evaluations.sum()) - count_listed(counts)
