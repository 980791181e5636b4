"""Regenerate the golden data of studies and print the differences from the stored ones: `make golden`.

The datasets of a results folder provide the coordinates, texts and attributes; every number is computed
on the certified route. A subset of the grids is computed a second time, by the integrals as printed;
data on which the two routes disagree are never stored. A run that finds or stores a difference ends
with status 1, so that changed golden data never pass in the run that changed them.
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

from planar_pushing.certified.balls import PRECISION
from planar_pushing.certified.motion.logs import log_values
from planar_pushing.evidence.golden.check import result_names
from planar_pushing.evidence.golden.compare import ASIDE, KIND, Kind, comparable
from planar_pushing.evidence.golden.enclosures import RADIUS, apart, radii
from planar_pushing.evidence.golden.grid import (
    CELLS,
    Cell,
    Point,
    certified,
    points,
    records,
    single,
)
from planar_pushing.evidence.golden.scenes import scene_values
from planar_pushing.study.catalog import SIMULATIONS, dataset_place
from planar_pushing.study.files.scenes import load_scene_file
from planar_pushing.study.files.study_model import StudyFile
from planar_pushing.study.running.jobs import run_command
from planar_pushing.study.slices import study_slice
from planar_pushing.study.store import group_names, read_attributes, read_dataset, write_dataset
from planar_pushing.study.studies import PAPER_FILE, SLIDERS_FILE, study_folder, study_name
from planar_pushing.study.study_file import load_study
from planar_pushing.terms.errors import InvalidResult

METHOD = {
    Kind.ENCLOSED: "Arb: closed forms and elliptic integrals; roots enclosed by a change of sign",
    Kind.INTEGRATED: "a right-hand side of certified physics, integrated to 30 digits and not validated",
    Kind.PLAIN: "stored as computed",
}
#: Values of each axis for the second route: a rod of length zero; lines of force tangent to the ring
#: (k = 1), along and across the rod, and along the fence; mu = 0 and infinity; every law; centers off the
#: lines and rims of supports.
SECOND: dict[str, tuple[Any, ...]] = {
    "rod_length": (0, 1, 2, 10),
    "rod_angle": (45, 90),
    "force_angle": (0, 15, 45, 90, 135, 180, 225, 360),
    "friction_coefficient": (0, 1, 2, float("inf")),
    "inertia_share": (0, 0.5, 1),
    "pusher_angle": (-180, -15, -1, 0, 45, 165, 180),
    "pusher_magnitude": (1,),
    "contact": (
        "coulomb_0", "coulomb_1.4", "coulomb_2", "infinite_friction_free",
        "infinite_friction_none", "perfectly_rough",
    ),
    "center_x": (-1.5, -0.5, 0.5, 1.5),
    "center_y": (-1.5, -0.5, 0.5, 1.5),
}  # fmt: skip
#: The same for any support, where integrals take longer, and the cells that are computed a second time.
SUPPORTS = {
    "rod_length": (5,), "rod_angle": (45,), "friction_coefficient": (0.25,), "pusher_angle": (-45, 90),
}  # fmt: skip
#: An error below this many rounding errors counts as rounding, and can be larger by this factor elsewhere.
NOISE = 8.0
#: Cells without a second route: the means of the ellipsoid are over too many motions for the integrals.
ONCE = ("numbers",)

Groups = dict[str, xr.Dataset]


def golden_groups(study: StudyFile, name: str, result: Path, processes: int) -> tuple[Kind, Groups]:
    """The golden datasets of a result by group, from the result and the certified route."""
    groups = {
        group: read_dataset(result, group or None).load() for group in group_names(result) or [""]
    }
    if name in CELLS:
        values = study_slice(study, name)
        return Kind.ENCLOSED, {"": certified(name, values, groups[""], processes)}
    if name == "scenes":
        return Kind.ENCLOSED, {
            group: single(f"{name}/{group}", scene_values(_scene(study, group)), each)
            for group, each in groups.items()
        }
    folder, _, part = name.partition("/")
    if folder == SIMULATIONS:
        return _log(name, study.simulations[part], comparable(name, groups[""]))
    if name == "hard_cases":
        groups[""] = _with_rounding(groups[""])
    if name == "accuracy_errors":
        groups["wrench"] = _with_noise(groups["wrench"])
    return Kind.PLAIN, groups


def _with_rounding(cases: xr.Dataset) -> xr.Dataset:
    """Hard cases with the rounding errors that their condition numbers allow on another processor."""
    ulps = 8 + 4 * cases["condition"]
    result = ulps * np.spacing(np.abs(cases["reference_high"]))
    return cases.assign({f"result{RADIUS}": result, f"error_ulp{RADIUS}": ulps})


def _with_noise(wrench: xr.Dataset) -> xr.Dataset:
    """Errors of methods, with a radius if they are rounding errors, which differ between processors.

    Rounding of the smaller component of the spin ratio magnifies a rounding error by max(k, 1 / k).
    """
    k = wrench["spin_ratio"]
    rounding = NOISE * np.finfo(float).eps * np.maximum(k, 1 / k)
    size = NOISE * wrench["error"]
    return wrench.assign({f"error{RADIUS}": size.where(wrench["error"] < rounding, 0.0)})


def _scene(study: StudyFile, name: str) -> dict[str, Any]:
    push = study.scenes[name]
    return {"scene": load_scene_file(push.file).model_dump(), "push": push.model_dump()}


def _log(name: str, path: str, log: xr.Dataset) -> tuple[Kind, Groups]:
    """The golden log of a simulation; its times are stored as computed."""
    found = log_values(load_scene_file(path).model_dump(), log["time"].values.tolist())
    record = {each: values for each, (_, values) in found.values.items()}
    kind = Kind.ENCLOSED if found.validated else Kind.INTEGRATED
    return kind, {"": single(name, record, log, plain=("time",))}


def second_route(
    name: str, values: Mapping[str, Any], first: xr.Dataset, processes: int
) -> tuple[int, list[str]]:
    """Count the numbers that the integrals as printed also enclose, and find disagreements."""
    count, wrong = 0, []
    for cell in (each for each in CELLS[name] if each.function.__name__ not in ONCE):
        kept = _kept(cell, first)
        found = records(cell, values, [point for _, point in kept], processes, second=True)
        for (index, point), record in zip(kept, found, strict=True):
            if isinstance(record, str):
                raise InvalidResult(f"{name}: {point}: undecided by the integrals: {record}")
            one = single(name, record, first.isel(index), check=False)
            for variable in record:
                number, off = _disagreement(variable, one, first.isel(index))
                count += number
                wrong += [f"{variable} at {point}"] if off else []
    return count, wrong


def _kept(cell: Cell, dataset: xr.Dataset) -> list[tuple[dict[str, int], Point]]:
    """Indices and coordinates of the points for the second route."""
    chosen = SECOND | (SUPPORTS if "support" in cell.dims else {})
    sizes = [dataset.sizes[dim] for dim in cell.dims]
    return [
        (dict(zip(cell.dims, map(int, np.unravel_index(flat, sizes)), strict=True)), point)
        for flat, point in enumerate(points(dataset, cell.dims))
        if all(each in chosen.get(dim, (each,)) for dim, each in zip(cell.dims, point, strict=True))
    ]


def _disagreement(name: str, one: xr.Dataset, other: xr.Dataset) -> tuple[int, bool]:
    """Numbers that have a radius, and where the enclosures of the two routes do not overlap."""
    exponents = [each[f"{name}{RADIUS}"].values for each in (one, other)]
    middles = [each[name].values.astype(float) for each in (one, other)]
    radius = [radii(each) for each in exponents]
    off = apart(middles[0], radius[0], middles[1], radius[1])
    return int((radius[0] > 0).sum()), bool(np.any(off))


def differences(name: str, new: Groups, path: Path) -> list[str]:
    """Differences between new golden data and the stored ones, beyond their own radii."""
    if not path.is_file():
        return [f"{name}: new"]
    stored = {
        group: read_dataset(path, group or None).load() for group in group_names(path) or [""]
    }
    if set(stored) != set(new):
        return [f"{name}: different groups"]
    return [
        f"{name}{'/' if group else ''}{group}: {each}"
        for group in new
        for each in _changed(new[group], stored[group])
    ]


def _changed(new: xr.Dataset, stored: xr.Dataset) -> Iterator[str]:
    names = sorted(set(map(str, new.variables)) ^ set(map(str, stored.variables)))
    if names:
        yield f"different variables: {', '.join(names)}"
        return
    if _marks(new.attrs) != _marks(stored.attrs):
        yield "different attributes"
    for name in map(str, new.variables):
        if name.endswith(RADIUS):
            continue
        one, other = new[name], stored[name]
        if one.dims != other.dims or one.shape != other.shape:
            yield f"{name} has different dimensions"
        elif _marks(one.attrs) != _marks(other.attrs):
            yield f"{name} has different attributes"
        elif f"{name}{RADIUS}" in new:
            radius = [radii(each[f"{name}{RADIUS}"].values) for each in (new, stored)]
            middles = [each.values.astype(float) for each in (one, other)]
            off = apart(middles[0], radius[0], middles[1], radius[1])
            if off.any():
                yield f"{name} changes at {off.sum()} of {off.size} points"
        elif not one.equals(other):
            yield f"{name} changes"


def _marks(attrs: Mapping[str, Any]) -> dict[str, str]:
    return {key: repr(each) for key, each in attrs.items() if key not in ASIDE or key == KIND}


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
        kind, new = golden_groups(study, name, folder / dataset_place(name)[0], processes)
        count = 0
        if name in CELLS:
            count, wrong = second_route(name, study_slice(study, name), new[""], processes)
            if wrong:
                raise InvalidResult(f"{name}: the two routes disagree on {wrong[0]}")
        checked += count
        new = {group: _described(each, kind, count) for group, each in new.items()}
        found = differences(name, new, golden / f"{name}.nc")
        changed += len(found)
        print("\n".join(found) if found else f"{name}: unchanged", flush=True)
        if found and args.write:
            root = xr.Dataset(attrs=read_attributes(folder / dataset_place(name)[0]))
            whole = {"/": _described(root, kind, count)} | new
            write_dataset(new.get("", whole), golden / f"{name}.nc")
    print(f"{checked} numbers lie in the enclosures of both routes")
    return changed


def _described(dataset: xr.Dataset, kind: Kind, count: int) -> xr.Dataset:
    marks: dict[str, Any] = {KIND: str(kind), "golden_method": METHOD[kind]}
    if kind is not Kind.PLAIN:
        marks["golden_versions"] = f"python-flint {version('python-flint')}, FLINT {FLINT}"
        marks["golden_precision_bits"] = PRECISION
    if count:
        marks["golden_checked_by_integrals"] = count
    return dataset.assign_attrs(marks)


if __name__ == "__main__":
    sys.exit(run_command(main))
