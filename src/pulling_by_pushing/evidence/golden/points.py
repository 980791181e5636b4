"""Certified points of any study: the check if there are no golden data."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.terms.replacing import PathLike
from pulling_by_pushing.evidence.golden.cells.sliders import CENTERS
from pulling_by_pushing.evidence.golden.check import require_results
from pulling_by_pushing.evidence.golden.compare import Check, judge
from pulling_by_pushing.evidence.golden.enclosures import EXACT, radii
from pulling_by_pushing.evidence.golden.grid import (
    CELLS,
    Cell,
    Point,
    dims_of,
    empty_entry,
    kink,
    records,
)
from pulling_by_pushing.study.catalog import dataset_file
from pulling_by_pushing.study.slices import computes, study_slice
from pulling_by_pushing.study.store import read_dataset
from pulling_by_pushing.study.study_file import load_study

SEED = 20_261_125


@dataclass(slots=True)
class Comparison:
    """Numbers of a variable at points: computed values, midpoints, exponents, and the points."""

    computed: list[Any] = field(default_factory=list)
    middle: list[Any] = field(default_factory=list)
    exponent: list[int] = field(default_factory=list)
    where: list[str] = field(default_factory=list)


def check_points(folder: Path, file: PathLike, number: int) -> tuple[list[Check], str]:
    """Certify random points of each dataset of a study, and compare them with the results.

    Returns
    -------
    list of Check
    str
        How many points were certified, and which are undecided.
    """
    study = load_study(file)
    require_results(folder)
    checks: list[Check] = []
    counts, undecided = [], []
    for name in (dataset for dataset in CELLS if computes(study, dataset)):
        result = read_dataset(folder / dataset_file(name))
        count, skipped, numbers = _certify_points(name, study_slice(study, name), result, number)
        if not count:
            checks.append(Check(file=name, problem="has no point that could be certified"))
        checks += [_check(name, variable, comparison) for variable, comparison in numbers.items()]
        counts.append(f"{count} of {name}")
        undecided += skipped
    note = f"certified points, chosen at random: {', '.join(counts)}"
    if undecided:
        note += f"; {len(undecided)} more are undecided, the first: {undecided[0]}"
    return checks, note


def _certify_points(
    name: str, values: Mapping[str, Any], result: xr.Dataset, number: int
) -> tuple[int, list[str], dict[str, Comparison]]:
    """Numbers of random points, by variable; the number of points; and those that are undecided."""
    numbers: dict[str, Comparison] = {}
    skipped = []
    chooser, count = np.random.default_rng(SEED), 0
    for cell in CELLS[name]:
        samples = list(_random_points(cell, result, number, chooser))
        points = [point for _, point in samples]
        point_records = records(cell, values, points, min(os.cpu_count() or 1, 4))
        for (index, point), record in zip(samples, point_records, strict=True):
            if isinstance(record, str):
                skipped.append(kink(name, cell, point, record))
                continue
            count += cell is CELLS[name][0]
            record.pop(CENTERS)
            named = zip(dims_of(cell), point, strict=True)
            where = ", ".join(f"{dim}={value}" for dim, value in named)
            for variable, nested in record.items():
                values_here = np.asarray(result[variable].isel(index).values)
                _add(
                    numbers.setdefault(variable, Comparison()), variable, values_here, nested, where
                )
    return count, skipped, numbers


def _random_points(
    cell: Cell, result: xr.Dataset, number: int, chooser: np.random.Generator
) -> Iterator[tuple[dict[str, int], Point]]:
    """Indices and coordinates of points, each at most once."""
    sizes = [result.sizes[dim] for dim in dims_of(cell)]
    size = int(np.prod(sizes))
    for flat in sorted(chooser.choice(size, min(number, size), replace=False).tolist()):
        index = dict(zip(dims_of(cell), map(int, np.unravel_index(flat, sizes)), strict=True))
        yield index, tuple(result[dim].values[i].item() for dim, i in index.items())


def _add(comparison: Comparison, name: str, computed: Any, nested: Any, where: str) -> None:
    """Add the numbers of a point; after the last solution both have empty entries."""
    pairs = np.empty(0, object) if nested == [] else np.array(nested, dtype=object)
    sizes = pairs.shape[:-1] if pairs.size else (0,) * computed.ndim
    shape = tuple(map(max, sizes, computed.shape))
    blank = empty_entry(name, computed.dtype)
    left, middle = (np.full(shape, blank, computed.dtype) for _ in range(2))
    exponent = np.full(shape, EXACT, np.int8)
    left[tuple(map(slice, computed.shape))] = computed
    if pairs.size:
        within = tuple(map(slice, sizes))
        middle[within], exponent[within] = pairs[..., 0], pairs[..., 1]
    comparison.computed += left.ravel().tolist()
    comparison.middle += middle.ravel().tolist()
    comparison.exponent += exponent.ravel().tolist()
    comparison.where += [where] * left.size


def _check(name: str, variable: str, comparison: Comparison) -> Check:
    computed, middle = (np.asarray(part) for part in (comparison.computed, comparison.middle))
    if middle.dtype.kind == "f":
        computed = computed.astype(float)
    exponents = np.asarray(comparison.exponent, np.int8)
    check = Check(file=name, variable=variable)
    return judge(
        check, computed, middle, radii(exponents), lambda index: comparison.where[index[0]]
    )
