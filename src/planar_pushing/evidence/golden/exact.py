"""Compare what must be equal: the list of variables, dimensions, types, labels, axes and attributes."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.evidence.golden.expected import Expectation

#: Root attribute that tells what a dataset was built with: its packages are compared, and no versions.
VERSIONS = "versions"


def variable_problems(found: xr.Dataset, expected: Expectation) -> dict[str, str]:
    """What is wrong with each variable or coordinate beside its values; empty where nothing is."""
    wanted = {str(name): each for name, each in expected.structure.variables.items()}
    wanted |= {name: each.variable for name, each in expected.axes.items()}
    names = dict.fromkeys([*wanted, *map(str, found.variables)])
    return {name: "; ".join(_problems(name, found, wanted, expected)) for name in names}


def _problems(
    name: str, found: xr.Dataset, wanted: Mapping[str, xr.Variable], expected: Expectation
) -> Iterable[str]:
    if name not in found.variables:
        yield "is missing from the result"
        return
    if name not in wanted:
        yield "is no variable of this dataset"
        return
    if name not in expected.rules and name not in expected.structure.coords:
        yield "has no rule by which it is verified"
    ours, theirs = found.variables[name], wanted[name]
    if ours.dims != theirs.dims:
        yield f"has the dims {ours.dims}, not {theirs.dims}"
    if _kind(ours) != _kind(theirs):
        yield f"has the type {ours.dtype}, not {theirs.dtype}"
    yield from _attributes(ours.attrs, theirs.attrs)
    sizes = {dim: each.size for dim, each in expected.axes.items()}
    for dim, size in zip(ours.dims, ours.shape, strict=True):
        if size != sizes.get(str(dim), expected.structure.sizes.get(dim)):
            yield f"has {size} entries of {dim}"


def _kind(variable: xr.Variable) -> str:
    """Type of numbers; labels may have any length."""
    return "label" if variable.dtype.kind in "OUT" else variable.dtype.name


def _attributes(found: Mapping[Any, Any], wanted: Mapping[Any, Any]) -> Iterable[str]:
    """Attributes that differ, are missing or should not be there."""
    for key in dict.fromkeys([*wanted, *found]):
        ours, theirs = found.get(key), wanted.get(key)
        if key == VERSIONS and ours is not None and theirs is not None:
            ours, theirs = _packages(ours), _packages(theirs)
        if not _equal(ours, theirs):
            yield f"has {key} {_short(ours)}, not {_short(theirs)}"


def _equal(one: Any, other: Any) -> bool:
    if one is None or other is None:
        return one is other
    return np.array_equal(np.asarray(one), np.asarray(other))


def _packages(versions: Any) -> list[str]:
    try:
        return sorted(json.loads(versions))
    except (TypeError, ValueError):
        return []


def _short(value: Any) -> str:
    text = repr(value)
    return text if len(text) < 80 else f"{text[:77]}..."


def root_problem(found: xr.Dataset, expected: Expectation) -> str:
    """Root attributes that differ."""
    return "; ".join(_attributes(found.attrs, expected.structure.attrs))


def value_errors(name: str, found: xr.Dataset, expected: Expectation) -> tuple[Any, Any]:
    """Errors of values that must be equal, but for the slack that the expectation gives."""
    coords = expected.coords
    wanted = (coords[name] if name in coords else expected.structure[name]).values
    ours = found[name].values
    if wanted.dtype.kind in "OUT":
        return np.where(ours.astype(str) == wanted.astype(str), 0.0, np.inf), 0.0
    numbers, exact = wanted.astype(float), ours.astype(float)
    same = (exact == numbers) | (np.isnan(exact) & np.isnan(numbers))
    with np.errstate(invalid="ignore"):
        error = np.where(same, 0.0, np.abs(exact - numbers))
    allowed = expected.slack.get(name, 0.0) * np.where(np.isfinite(numbers), np.abs(numbers), 0.0)
    return np.where(np.isnan(error), np.inf, error), allowed
