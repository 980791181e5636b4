"""Regenerate the golden data of studies and print the differences from the stored ones: `make golden`.

The datasets of a results folder provide the coordinates, texts and attributes; every number is
proved by the oracle. At one of twenty points the friction is computed a second time, by its defining
integrals; data on which the two routes disagree are never stored. A run that finds or stores a
difference ends with status 1, so that changed golden data never pass in the run that changed them.
"""

from __future__ import annotations

import argparse
import os
import sys
import time
from collections.abc import Iterator, Mapping, Sequence
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr
from flint import __FLINT_VERSION__ as FLINT
from tqdm import tqdm

from planar_pushing.scenes.files import load_scene_file
from planar_pushing.terms.errors import InvalidResult
from planar_pushing.terms.netcdf import group_names, read_attributes, write_dataset
from pulling_by_pushing.evidence.golden.compare import KIND, UNCOMPARED_ATTRIBUTES, Kind, comparable
from pulling_by_pushing.evidence.golden.digests import DIGESTS, changed_files, list_digests
from pulling_by_pushing.evidence.golden.enclosures import RADIUS, holds_radii
from pulling_by_pushing.evidence.golden.flaws import flaws, radii_by_condition
from pulling_by_pushing.evidence.golden.grid import (
    CELLS,
    certify,
    certify_record,
)
from pulling_by_pushing.evidence.golden.scenes import scene_values
from pulling_by_pushing.oracle.balls import PRECISION, ROUNDINGS
from pulling_by_pushing.oracle.logs.log import log_values
from pulling_by_pushing.study.catalog import SIMULATIONS, dataset_place
from pulling_by_pushing.study.model import StudyFile
from pulling_by_pushing.study.running.jobs import run_command
from pulling_by_pushing.study.slices import result_names, study_slice
from pulling_by_pushing.study.store import read_dataset
from pulling_by_pushing.study.studies import PAPER_FILE, SLIDERS_FILE, study_folder, study_name
from pulling_by_pushing.study.study_file import load_study

METHOD = {
    Kind.ENCLOSED: "Arb: roots of the equations of an answer, proved by interval Newton",
    Kind.INTEGRATED: "integrated to 30 digits by a method of two orders",
    Kind.PLAIN: "stored as computed",
}
Groups = dict[str, xr.Dataset]


def golden_groups(
    study: StudyFile, name: str, result: Path, processes: int
) -> tuple[Kind, Groups, int]:
    """The golden datasets of a result by group, and the number of centers checked by the second route."""
    groups = {
        group: read_dataset(result, group or None).load() for group in group_names(result) or [""]
    }
    if name in CELLS:
        values = study_slice(study, name)
        dataset, count = certify(name, values, groups[""], processes)
        return Kind.ENCLOSED, {"": dataset}, count
    if name == "scenes":
        return (
            Kind.ENCLOSED,
            {
                group: certify_record(
                    f"{name}/{group}", scene_values(_scene(study, group)), dataset
                )
                for group, dataset in groups.items()
            },
            0,
        )
    folder, _, part = name.partition("/")
    if folder == SIMULATIONS:
        return *_log(name, study.simulations[part], comparable(name, groups[""])), 0
    compared = {
        group: _with_radii(f"{name}/{group}" if group else name, dataset)
        for group, dataset in groups.items()
    }
    return Kind.PLAIN, compared, 0


def _with_radii(file: str, dataset: xr.Dataset) -> xr.Dataset:
    """Stored values, with radii where rounding errors differ between processors."""
    conditions = radii_by_condition(file, dataset).items()
    stored: xr.Dataset = comparable(file, dataset)
    return stored.assign({f"{name}{RADIUS}": radius for name, radius in conditions})


def _scene(study: StudyFile, name: str) -> dict[str, Any]:
    push = study.scenes[name]
    return {"scene": load_scene_file(push.file).model_dump(), "push": push.model_dump()}


def _log(name: str, path: str, log: xr.Dataset) -> tuple[Kind, Groups]:
    """The golden log of a simulation; its times are stored as computed."""
    columns = log_values(load_scene_file(path).model_dump(), log["time"].values.tolist())
    record = {variable: values for variable, (_, values) in columns.items()}
    return Kind.INTEGRATED, {"": certify_record(name, record, log, plain=("time",))}


def differences(name: str, new: Groups, path: Path) -> list[str]:
    """Differences between new golden data and the stored ones."""
    if not path.is_file():
        return [f"{name}: new"]
    stored = {
        group: read_dataset(path, group or None).load() for group in group_names(path) or [""]
    }
    if set(stored) != set(new):
        return [f"{name}: different groups"]
    return [
        f"{name}{'/' if group else ''}{group}: {change}"
        for group in new
        for change in _changes(new[group], stored[group])
    ]


def _changes(new: xr.Dataset, stored: xr.Dataset) -> Iterator[str]:
    names = sorted(set(map(str, new.variables)) ^ set(map(str, stored.variables)))
    if names:
        yield f"different variables: {', '.join(names)}"
        return
    if _marks(new.attrs) != _marks(stored.attrs):
        yield "different attributes"
    for name in map(str, new.variables):
        if holds_radii(name, new):
            continue
        new_variable, stored_variable = new[name], stored[name]
        if new_variable.dims != stored_variable.dims or new_variable.shape != stored_variable.shape:
            yield f"{name} has different dimensions"
        elif new_variable.dtype != stored_variable.dtype and new_variable.dtype.kind not in "OU":
            yield f"{name} has the type {new_variable.dtype}, not {stored_variable.dtype}"
        elif _marks(new_variable.attrs) != _marks(stored_variable.attrs):
            yield f"{name} has different attributes"
        elif f"{name}{RADIUS}" in new:
            yield from _changed_numbers(name, new, stored)
        elif not new_variable.equals(stored_variable):
            yield f"{name} changes"


def _changed_numbers(name: str, new: xr.Dataset, stored: xr.Dataset) -> Iterator[str]:
    """Changes of the midpoints of a variable by more than an ulp, and changes of its radii."""
    new_values, stored_values = (dataset[name].values.astype(float) for dataset in (new, stored))
    same = (new_values == stored_values) | (np.isnan(new_values) & np.isnan(stored_values))
    with np.errstate(invalid="ignore"):
        changed = ~same & ~(np.abs(new_values - stored_values) <= np.spacing(np.abs(stored_values)))
    wider = new[f"{name}{RADIUS}"].values != stored[f"{name}{RADIUS}"].values
    if changed.any():
        yield f"{name}: {changed.sum()} of {changed.size} numbers change"
    if wider.any():
        yield f"{name}: {wider.sum()} of {wider.size} radii change"


def _marks(attrs: Mapping[str, Any]) -> dict[str, str]:
    return {
        key: repr(value)
        for key, value in attrs.items()
        if key not in UNCOMPARED_ATTRIBUTES or key == KIND
    }


def main(arguments: Sequence[str] | None = None) -> int:
    """Print the differences, store the new data on request, and return 1 if anything differs."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--study", nargs="+", default=[PAPER_FILE, SLIDERS_FILE])
    parser.add_argument("--results", type=Path, default=Path("results"))
    parser.add_argument("--golden", type=Path, help="folder instead of those of the studies")
    parser.add_argument("--only", nargs="+", help="names of results, such as limit_curves")
    parser.add_argument("--write", action="store_true", help="store the new golden data")
    args = parser.parse_args(arguments)
    start = time.perf_counter()
    changed = sum(_update(file, args) for file in args.study)
    print(f"{changed} differences, {time.perf_counter() - start:.0f} s")
    if changed and args.write:
        print("stored; inspect them, commit them, and run the check")
    elif changed:
        print("nothing was stored; --write stores the new golden data")
    return 1 if changed else 0


def _update(file: str, args: argparse.Namespace) -> int:
    """Regenerate the golden data of a study, store them on request, and count the differences."""
    study = load_study(file)
    golden = args.golden or Path(study.golden or "")
    folder = study_folder(study_name(file), args.results)
    processes, changed, checked = os.cpu_count() or 1, 0, 0
    names = [name for name in result_names(study) if not args.only or name in args.only]
    for name in tqdm(names, study_name(file), disable=None, leave=False):
        kind, new, count = golden_groups(study, name, folder / dataset_place(name)[0], processes)
        checked += count
        new = {group: _mark_golden(dataset, kind, count) for group, dataset in new.items()}
        _require_sound(name, new)
        changes = differences(name, new, golden / f"{name}.nc")
        if changes and args.write:
            root = xr.Dataset(attrs=read_attributes(folder / dataset_place(name)[0]))
            content = {"/": _mark_golden(root, kind, count)} | new
            write_dataset(new.get("", content), golden / f"{name}.nc")
        changes = changes or _other_digest(golden, name)
        changed += len(changes)
        print("\n".join(changes) if changes else f"{name}: unchanged", flush=True)
    if changed and args.write:
        list_digests(golden, names)
    print(f"D and its gradient agree with their integrals at {checked} centers")
    return changed


def _require_sound(name: str, new: Groups) -> None:
    """Refuse golden data that the check would refuse."""
    for group, dataset in new.items():
        file = f"{name}/{group}" if group else name
        for flaw in flaws(file, dataset):
            raise InvalidResult(f"{file} {flaw}; fix its cell or its condition")


def _other_digest(golden: Path, name: str) -> list[str]:
    """The problem of a golden file that is not as it was stored."""
    if not (golden / DIGESTS).is_file():
        return [f"{name}: {golden / DIGESTS} is missing"]
    return [f"{name}: {problem}" for _, problem in changed_files(golden, [name])]


def _mark_golden(dataset: xr.Dataset, kind: Kind, count: int) -> xr.Dataset:
    marks: dict[str, Any] = {KIND: str(kind), "golden_method": METHOD[kind]}
    if kind is not Kind.PLAIN:
        marks["golden_versions"] = f"python-flint {version('python-flint')}, FLINT {FLINT}"
        marks["golden_precision_bits"] = PRECISION
    if kind is Kind.ENCLOSED:
        marks["golden_roundings"] = ROUNDINGS
    if count:
        marks["golden_checked_by_integrals"] = count
    return dataset.assign_attrs(marks)


if __name__ == "__main__":
    sys.exit(run_command(main))
