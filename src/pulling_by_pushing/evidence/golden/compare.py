"""Comparison of results with golden data: values, coordinates, attributes and lists of variables.

A golden file is the dataset with its certified values: for a variable `x` the midpoints of the
enclosures, with the exponents of their radii in `x_radius`. A computed value passes if it differs from
the midpoint by no more than the radius, which is what rounding can change in the solution of the problem.
Numbers that are no solutions of a problem (logs, errors of methods) have tolerances
instead. Texts, integers and booleans must be equal, integers in their width, too. An angle is compared as
stored, since its branch belongs to its definition, but for those of `UP_TO_TURNS`.

Not compared are the chunks and the compression of a file, and the attribute `versions`: the packages that
computed a result may differ from those of the golden data, its numbers may not.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from enum import StrEnum
from importlib.resources import files
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import xarray as xr
from pydantic import Field

from planar_pushing.scenes.fields import FileModel, NonNegative, Share
from planar_pushing.scenes.files import load_model
from pulling_by_pushing.evidence.golden.enclosures import RADIUS, holds_radii, is_exact, radii
from pulling_by_pushing.study.catalog import SIMULATIONS

Floats = npt.NDArray[np.float64]
#: Root attribute of a golden file that states how its numbers are known, a `Kind`.
KIND = "golden_kind"
#: Angles in degrees that are compared up to whole turns: at half a turn, rounding decides the sign of a
#: direction between -180 and 180.
UP_TO_TURNS = ("sticking_force_angle",)
#: Beginning of the problem of a result that is of another study than the golden file.
OTHER_STUDY = "has study_digest "
#: Attributes of a golden file itself, or of the packages with which a result was computed.
UNCOMPARED_ATTRIBUTES = (
    KIND, "golden_method", "golden_checked_by_integrals", "golden_versions", "golden_precision_bits",
    "golden_roundings",
    "versions",
)  # fmt: skip


#: Variables that golden data leave out, by folder of results or group: an adaptive integration of motion
#: over time takes one step more or less on another processor, and counts it. The impulse of an impact
#: follows from the twists before and after it, which the golden logs enclose.
UNCOMPARED: Mapping[str, tuple[str, ...]] = {
    SIMULATIONS: ("evaluations", "impulse"),
    "accuracy/motion": ("evaluations",),
}


def comparable(file: str, dataset: xr.Dataset) -> xr.Dataset:
    """A result without the variables that are not compared."""
    names = UNCOMPARED.get(file) or UNCOMPARED.get(file.partition("/")[0], ())
    return dataset.drop_vars(names, errors="ignore")


class Kind(StrEnum):
    """How the numbers of a golden file are known."""

    ENCLOSED = "enclosed"
    INTEGRATED = "integrated to 30 digits"
    PLAIN = "compared with stored values"


class Tolerance(FileModel):
    """Largest difference from a golden value: units in the last place, a part of it and an amount, summed.

    The units in the last place are those of the largest component of a vector. `differing` is the largest
    part of all numbers of a variable that may differ at all, for counts of which rounding changes a few.
    """

    ulp: NonNegative = 0.0
    relative: NonNegative = 0.0
    absolute: NonNegative = 0.0
    differing: Share = 1.0


class TolerancesFile(FileModel):
    """Tolerances of variables by file, or by the folder of files."""

    tolerances: dict[str, dict[str, Tolerance]] = Field(default_factory=dict)

    def of(self, file: str, variable: str) -> Tolerance:
        """Tolerance of a variable; a variable that is not listed must agree exactly."""
        for name in (file, file.partition("/")[0]):
            tolerance = self.tolerances.get(name, {}).get(variable)
            if tolerance:
                return tolerance
        return Tolerance()


def load_tolerances() -> TolerancesFile:
    """Read tolerances.yaml, which belongs to the package."""
    path = files("pulling_by_pushing.evidence.golden") / "tolerances.yaml"
    return load_model(Path(str(path)), TolerancesFile)


@dataclass(frozen=True, slots=True, kw_only=True)
class Check:
    """Comparison of one variable, or the reason why it was not possible.

    Attributes
    ----------
    file, variable : str
        The dataset, and the variable in it; empty if the dataset as a whole is compared.
    kind : Kind
        How the golden values are known.
    count, labels, failed : int
        Number of finite numbers that were compared, of other entries (infinite, NaN, texts, flags), and of
        those of both that differ by more than allowed.
    error, ulp, allowed : float
        For the worst value: its difference, the same in units in the last place, and the allowed one.
    where : str
        Coordinates and value of the worst value, and the golden value.
    problem : str
        Why the variable could not be compared; empty if it was.
    """

    file: str
    variable: str = ""
    kind: Kind = Kind.ENCLOSED
    count: int = 0
    labels: int = 0
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
    def passes(self) -> bool:
        return not self.problem and not self.failed

    @property
    def badness(self) -> float:
        """Sort key: checks that could not be made come first, then by error relative to the allowance."""
        if self.problem:
            return np.inf
        return self.error / self.allowed if self.allowed else np.inf if self.error else 0.0


def compare(
    file: str, result: xr.Dataset, golden: xr.Dataset, tolerances: TolerancesFile
) -> list[Check]:
    """Checks of a dataset: one for each variable, and one for each difference in names or attributes."""
    result = comparable(file, result)
    kind = Kind(golden.attrs.get(KIND, Kind.PLAIN))
    checks = [
        Check(file=file, kind=kind, problem=problem) for problem in _differences(result, golden)
    ]
    for name in _variables(golden):
        if name in result.variables and not _mismatch(result[name], golden[name]):
            plain = golden[name].dtype.kind == "f" and f"{name}{RADIUS}" not in golden
            known_by = Kind.PLAIN if plain and not is_exact(golden, name) else kind
            check = Check(file=file, variable=name, kind=known_by)
            checks.append(_compare_variable(check, result[name], golden, tolerances.of(file, name)))
    return checks


def _variables(golden: xr.Dataset) -> list[str]:
    """Variables and coordinates of a golden file, without their radii."""
    return [str(name) for name in golden.variables if not holds_radii(name, golden)]


def _differences(result: xr.Dataset, golden: xr.Dataset) -> Iterator[str]:
    """Differences in the lists of variables, their dimensions and attributes."""
    golden_names = _variables(golden)
    for name in sorted(set(golden_names) - set(map(str, result.variables))):
        yield f"{name} is missing from the result"
    for name in sorted(set(map(str, result.variables)) - set(golden_names)):
        yield f"{name} is not in the golden data"
    yield from _attributes("", result.attrs, golden.attrs)
    for name in golden_names:
        if name in result.variables:
            problem = _mismatch(result[name], golden[name])
            if problem:
                yield f"{name} {problem}"
            yield from _attributes(f"{name} ", result[name].attrs, golden[name].attrs)


def _attributes(name: str, ours: Mapping[str, Any], theirs: Mapping[str, Any]) -> Iterator[str]:
    for key in sorted({*ours, *theirs} - set(UNCOMPARED_ATTRIBUTES)):
        value, golden_value = ours.get(key), theirs.get(key)
        if not np.array_equal(np.asarray(value), np.asarray(golden_value)):
            yield f"{name}has {key} {_abbreviate(value)}, not {_abbreviate(golden_value)}"


def _abbreviate(value: Any) -> str:
    text = repr(value)
    return text if len(text) < 80 else f"{text[:77]}..."


def _mismatch(result: xr.DataArray, golden: xr.DataArray) -> str:
    """The reason why a variable cannot be compared; empty if it can."""
    if result.dims != golden.dims:
        return f"has the dims {result.dims}, not {golden.dims}"
    if result.shape != golden.shape:
        return f"has the shape {result.shape}, not {golden.shape}"
    kind, golden_kind = (variable.dtype.kind.replace("O", "U") for variable in (result, golden))
    same = kind == golden_kind and (kind == "U" or result.dtype == golden.dtype)
    return "" if same else f"has the type {result.dtype}, not {golden.dtype}"


def _compare_variable(
    check: Check, result: xr.DataArray, golden: xr.Dataset, tolerance: Tolerance
) -> Check:
    golden_variable = golden[check.variable]
    name = f"{check.variable}{RADIUS}"
    radius = radii(golden[name].values) if name in golden else np.zeros(golden_variable.shape)
    scale = golden_variable.values
    if {"xy", "twist_component"} & set(golden_variable.dims) and golden_variable.dtype.kind == "f":
        scale = np.broadcast_to(_largest(scale), scale.shape)

    def label(index: tuple[int, ...]) -> str:
        return ", ".join(
            f"{dim}={golden_variable[dim].values[i] if dim in golden_variable.coords else i}"
            for dim, i in zip(golden_variable.dims, index, strict=True)
        )

    if check.kind is not Kind.ENCLOSED:
        numbers = golden_variable.dtype.kind == "f"
        size = np.where(np.isfinite(scale), np.abs(scale), 0.0) if numbers else radius
        radius = radius + tolerance.absolute + tolerance.relative * size
        radius = radius + tolerance.ulp * np.spacing(size)
    judged = judge(check, result.values, golden_variable.values, radius, label)
    differing, most = (result.values != golden_variable.values).sum(), tolerance.differing
    if differing > most * golden_variable.size:
        return replace(judged, problem=f"differs in {differing} of {golden_variable.size} numbers; "
                       f"allowed: a part of {most:g}, because of rounding")  # fmt: skip
    return judged


def _largest(vectors: Floats) -> Floats:
    """Largest finite component of vectors along the last dimension."""
    sizes = np.where(np.isfinite(vectors), np.abs(vectors), 0.0)
    largest: Floats = sizes.max(axis=-1, keepdims=True)
    return largest


def judge(
    check: Check,
    computed: npt.NDArray[Any],
    middle: npt.NDArray[Any],
    allowed: Floats,
    label: Any,
) -> Check:
    """The check of values against midpoints and allowed differences; `label` names a place.

    For an infinite midpoint, `allowed` is the size from which on a number counts as infinite.
    """
    if middle.dtype.kind != "f":
        wrong = (
            computed.astype(str) != middle.astype(str)
            if middle.dtype.kind in "OU"
            else computed != middle
        )
        totals = replace(
            check, labels=middle.size, failed=int(wrong.sum()), error=float(wrong.any())
        )
        return _with_worst(totals, computed, middle, wrong.astype(float), label)
    finite = np.isfinite(middle)
    error = _difference(computed, middle, check.variable in UP_TO_TURNS)
    error = np.where(
        np.isinf(middle) & (allowed > 0) & (np.abs(computed) >= allowed) & np.isfinite(computed),
        0.0,
        error,
    )
    totals = replace(
        check,
        count=int(finite.sum()),
        labels=int(finite.size - finite.sum()),
        failed=int((~(error <= np.where(finite, allowed, 0.0))).sum()),
    )
    if not error.size:
        return totals
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        ratio = np.where(error == 0, 0.0, error / allowed)
    worst_check = _with_worst(totals, computed, middle, ratio, label)
    worst = _worst_index(ratio)
    counts = finite[worst] and np.isfinite(error[worst])
    return replace(
        worst_check,
        error=float(error[worst]),
        ulp=float(error[worst]) / float(np.spacing(np.abs(middle[worst]))) if counts else 0.0,
        allowed=float(allowed[worst]),
    )


def _difference(computed: Floats, middle: Floats, turns: bool) -> Floats:
    """Absolute difference; 0 if both are the same infinity, or both NaN."""
    same = (computed == middle) | (np.isnan(computed) & np.isnan(middle))
    with np.errstate(invalid="ignore"):
        gap = np.abs(np.asarray(computed, float) - middle)
        if turns:
            gap = np.abs(gap - 360 * np.round(gap / 360))
    return np.where(same, 0.0, np.where(np.isnan(gap), np.inf, gap))


def _worst_index(badness: Floats) -> tuple[int, ...]:
    flat = int(np.argmax(np.where(np.isnan(badness), np.inf, badness)))
    return tuple(int(i) for i in np.unravel_index(flat, badness.shape))


def _with_worst(check: Check, computed: Any, middle: Any, badness: Floats, label: Any) -> Check:
    """The check, with its worst value and the place of this value."""
    if not badness.size or not badness.any():
        return check
    worst = _worst_index(badness)
    where = f"{label(worst)}: computed {computed[worst]!s}, golden {middle[worst]!s}".lstrip(": ")
    return replace(check, where=where)
