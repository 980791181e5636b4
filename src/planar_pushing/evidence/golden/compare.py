"""Compare results with golden data: what differs, where and by how much, worst first.

A golden file holds, for each variable `x` that it certifies, the midpoint of an enclosure as the pair of
doubles `x` and `x_low` and its rigorous radius `x_radius`. Its axes are a part of the result's.
A computed value passes where it differs from the midpoint by no more than tolerance plus radius.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import numpy.typing as npt
import xarray as xr

from planar_pushing.evidence.golden.build.enclosures import golden_variables
from planar_pushing.evidence.golden.rules import Rule
from planar_pushing.evidence.golden.tolerances import Tolerance

Floats = npt.NDArray[np.float64]
#: A variable that no tolerance names must agree exactly.
EXACT = Tolerance()
#: Attributes that must be the same.
MARKS = ("units", "quantity", "flag_meanings")


@dataclass(frozen=True, slots=True, kw_only=True)
class Check:
    """Comparison of one variable by its rule, or the reason why there was none.

    Attributes
    ----------
    file, variable : str
        The dataset, and the variable in it; empty where the dataset as a whole is compared.
    rule : Rule
        How the values are verified.
    count, failed : int
        Values compared, and how many of them differ by more than is allowed.
    error, ulp, allowed : float
        Of the worst value: its difference, the same in units in the last place, and what is allowed.
    where : str
        Coordinates and value of the worst, and the golden value.
    problem : str
        Why the variable could not be compared; empty where it was.
    """

    file: str
    variable: str = ""
    rule: Rule = Rule.ENCLOSURE
    count: int = 0
    failed: int = 0
    error: float = 0.0
    ulp: float = 0.0
    allowed: float = 0.0
    where: str = ""
    problem: str = ""

    @property
    def name(self) -> str:
        return f"{self.file}: {self.variable}"

    @property
    def passed(self) -> bool:
        return not self.problem and not self.failed

    @property
    def badness(self) -> float:
        """Sorts checks: those that could not be made first, then by error against allowance."""
        if self.problem:
            return np.inf
        return self.error / self.allowed if self.allowed else np.inf if self.error else 0.0


def compare(
    file: str, result: xr.Dataset, golden: xr.Dataset, tolerances: Mapping[str, Tolerance]
) -> list[Check]:
    """Compare every variable that a golden file certifies with a result."""
    return [
        _compare_variable(file, name, result, golden, tolerances.get(name, EXACT))
        for name in golden_variables(golden)
    ]


def _problem(name: str, result: xr.Dataset, golden: xr.Dataset) -> Iterator[str]:
    """Reasons why a variable cannot be compared."""
    if name not in result:
        yield "is missing from the result"
        return
    found, wanted = result[name], golden[name]
    if found.dims != wanted.dims:
        yield f"has the dims {found.dims}, not {wanted.dims}"
        return
    for mark in MARKS:
        if found.attrs.get(mark) != wanted.attrs.get(mark):
            yield f"has {mark} {found.attrs.get(mark)!r}, not {wanted.attrs.get(mark)!r}"
    for dim in wanted.dims:
        if dim in golden.coords:
            absent = ~np.isin(golden[dim].values, result[dim].values)
            if absent.any():
                yield f"has no {dim} {golden[dim].values[absent][0]}"
            if result[dim].attrs.get("units") != golden[dim].attrs.get("units"):
                yield f"has {dim} in {result[dim].attrs.get('units')!r}"
        elif found.sizes[dim] != wanted.sizes[dim]:
            yield f"has {found.sizes[dim]} entries of {dim}, not {wanted.sizes[dim]}"


def _compare_variable(
    file: str, name: str, result: xr.Dataset, golden: xr.Dataset, tolerance: Tolerance
) -> Check:
    problem = "; ".join(_problem(name, result, golden))
    check = Check(file=file, variable=name, problem=problem)
    if problem:
        return check
    wanted = golden[name]
    chosen = {dim: golden[dim].values for dim in wanted.dims if dim in golden.coords}
    found = result[name].sel(chosen)
    computed, middle = found.values, wanted.values
    if computed.dtype.kind not in "fiu":
        wrong = computed != middle
        failed = int(wrong.sum())
        return replace(check, count=computed.size, failed=failed, error=float(wrong.any()))
    absent = np.isnan(computed.astype(float)) != np.isnan(middle.astype(float))
    if absent.any():
        return replace(check, problem=f"has NaN, or none, at {int(absent.sum())} points")
    low, radius = (
        golden[f"{name}{part}"].values if f"{name}{part}" in golden else np.zeros(middle.shape)
        for part in ("_low", "_radius")
    )
    error = _difference(computed, middle, low)
    finite = np.where(np.isfinite(middle), np.abs(middle), 0.0)
    allowed = tolerance.ulp * np.spacing(finite) + tolerance.absolute + radius
    return _worst(check, wanted, computed, error, allowed)


def _difference(computed: Floats, middle: Floats, low: Floats) -> Floats:
    """Absolute difference from ``middle + low``; 0 where both are the same infinity, or both NaN."""
    same = (computed == middle) | (np.isnan(computed) & np.isnan(middle))
    with np.errstate(invalid="ignore"):
        gap = np.abs((np.asarray(computed, float) - middle) - low)
    return np.where(same & ~np.isfinite(middle), 0.0, np.where(np.isnan(gap), np.inf, gap))


def _worst(
    check: Check, wanted: xr.DataArray, computed: Floats, error: Floats, allowed: Floats
) -> Check:
    found = judged(check, wanted.copy(data=computed), error, allowed)
    at = worst(error, allowed)
    middle = wanted.values[at]
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        ulp = float(error[at] / np.spacing(np.abs(middle.astype(float)))) if found.error else 0.0
    return replace(found, ulp=ulp, where=f"{found.where}, golden {middle!s}")


def worst(error: Floats, allowed: Floats) -> tuple[int, ...]:
    """Place of the largest error against what is allowed."""
    if not error.size:
        return ()
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        ratio = np.where(error == 0, 0.0, error / allowed)
    flat = int(np.argmax(np.where(np.isnan(ratio), np.inf, ratio)))
    return tuple(int(i) for i in np.unravel_index(flat, error.shape))


def judged(check: Check, values: xr.DataArray, error: Any, allowed: Any) -> Check:
    """The check with the errors of all values; it fails where an error is NaN."""
    error, allowed = (np.broadcast_to(each, values.shape) for each in (error, allowed))
    failed = ~(error <= allowed)
    if not values.size:
        return check
    at = worst(error, allowed)
    coordinates = ", ".join(
        f"{dim}={values[dim].values[i] if dim in values.coords else i}"
        for dim, i in zip(values.dims, at, strict=True)
    )
    return replace(
        check,
        count=values.size,
        failed=int(failed.sum()),
        error=float(error[at]),
        allowed=float(allowed[at]),
        where=f"{coordinates}: computed {values.values[at]!s}".lstrip(": "),
    )
