"""Compute the golden data anew and print how they differ from the stored ones: `make golden`.

Storing them takes `--write`. A run that finds or makes a difference ends with status 1, so that
changed golden data are never green in the run that changed them.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import xarray as xr

from planar_pushing.golden import generate, modes, pictures, plotted
from planar_pushing.golden.compare import MARKS, golden_variables
from planar_pushing.study.files import load_scene_file, load_study
from planar_pushing.study.jobs import run_command
from planar_pushing.study.models import StudyFile
from planar_pushing.study.store import read_dataset, write_dataset

#: Coefficients of friction of the certified contact modes, where the study has them.
COEFFICIENTS = (0.0, 0.5, 1.0, 1.25, 1.3, 1.4, 1.5, 2.0, 5.0, 100.0)
STEP = 15
PROCESSES = 2


def plain(study: StudyFile) -> dict[str, Any]:
    """The study as plain values: the golden data share no code with the mechanics."""
    values: dict[str, Any] = study.model_dump()
    values["scenes"] = {
        name: (load_scene_file(push.file).model_dump(), push.model_dump())
        for name, push in study.scenes.items()
    }
    coulomb = {
        f"coulomb_{mu:g}": ("coulomb", modes.coulomb(mu))
        for mu in study.grid.contact_friction_coefficient
    }
    values["contacts"] = coulomb | {
        "infinite_friction_free": ("infinite_friction", modes.INFINITE_FREE),
        "infinite_friction_none": ("infinite_friction", modes.INFINITE_NONE),
        "perfectly_rough": ("perfectly_rough", modes.PERFECTLY_ROUGH),
    }
    return values


def golden_files(study: StudyFile) -> Iterator[tuple[str, xr.Dataset]]:
    """Name and content of every golden file of a study."""
    values, grid = plain(study), study.grid.model_dump()
    coarse = {"force_angle": [phi for phi in grid["force_angle"] if phi % STEP == 0]}
    parameters = plotted.parameters(values)
    psi = study.slider.rod_angle
    yield "limit_curves", generate.limit_curves(grid | coarse, parameters, PROCESSES)
    yield "motion_cones", generate.motion_cones(grid, parameters, PROCESSES)
    half = {"force_angle": [phi for phi in coarse["force_angle"] if 0 <= phi <= 180]}
    yield (
        "acceleration_centers",
        generate.acceleration_centers(grid | half, psi, parameters, PROCESSES),
    )
    finite = (law.friction_coefficient for _, law in values["contacts"].values())
    kept = {mu for mu in finite if mu in COEFFICIENTS or mu == float("inf")}
    contacts = {
        label: (kind, law)
        for label, (kind, law) in values["contacts"].items()
        if law.friction_coefficient in kept
    }
    near = {
        "pusher_angle": [a for a in grid["pusher_angle"] if a % STEP == 0 or abs(a) in (1, 179)]
    }
    yield "contact_modes", generate.contact_modes(grid | near, contacts, psi, parameters, PROCESSES)
    for name in study.scenes:
        yield f"scenes.{name}", pictures.scene(name, values)
    for name in pictures.FIGURES:
        yield name, pictures.figure(name, values)


def stored_names(golden: Path) -> list[str]:
    """Names of the stored golden files."""
    return [path.stem for path in golden.glob("*.nc")]


def differences(name: str, new: xr.Dataset, path: Path) -> list[str]:
    """How new golden data differ from the stored ones, beyond their own radii."""
    if not path.is_file():
        return [f"{name}: new, with {len(golden_variables(new))} variables"]
    stored = read_dataset(path)
    gone = set(golden_variables(stored)) - set(golden_variables(new))
    found = [f"{name}: {each} is no longer certified" for each in sorted(gone)]
    for each in sorted(set(golden_variables(new)) & set(golden_variables(stored))):
        if new[each].shape != stored[each].shape or not new[each].coords.equals(
            stored[each].coords
        ):
            found.append(f"{name}: {each} has other coordinates")
        elif any(new[each].attrs.get(key) != stored[each].attrs.get(key) for key in MARKS):
            found.append(f"{name}: {each} has other units or flags")
        elif (apart := _disjoint(each, new, stored)).any():
            found.append(f"{name}: {each} changes at {apart.sum()} of {apart.size} points")
    fresh = set(golden_variables(new)) - set(golden_variables(stored))
    found += [f"{name}: {each} is new" for each in sorted(fresh)]
    return found


def _disjoint(name: str, new: xr.Dataset, stored: xr.Dataset) -> npt.NDArray[np.bool_]:
    """Where the enclosures of a variable in two golden files do not overlap."""
    if f"{name}_low" not in new:
        return np.asarray(new[name].values != stored[name].values)
    high, low, radius = (name, f"{name}_low", f"{name}_radius")
    with np.errstate(invalid="ignore"):
        gap = np.abs(
            new[high].values - stored[high].values + (new[low].values - stored[low].values)
        )
    same = new[high].values == stored[high].values
    infinite = same & ~np.isfinite(new[high].values)
    return np.asarray(~infinite & ~(gap <= new[radius].values + stored[radius].values))


def main(arguments: list[str] | None = None) -> int:
    """Print the differences; store the new data if asked to; 1 where anything differs."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--study", default="workflow/config/paper.yaml")
    parser.add_argument("--golden", default="tests/golden", type=Path)
    parser.add_argument("--write", action="store_true", help="store the new golden data")
    args = parser.parse_args(arguments)
    start, changed, seen = time.perf_counter(), 0, set()
    for name, new in golden_files(load_study(args.study)):
        seen.add(name)
        path = args.golden / f"{name}.nc"
        found = differences(name, new, path)
        changed += len(found)
        print("\n".join(found) if found else f"{name}: unchanged", flush=True)
        if found and args.write:
            write_dataset(new, path)
    for name in sorted(set(stored_names(args.golden)) - seen):
        changed += 1
        print(f"{name}: no longer a part of the study; remove its file")
    print(f"{changed} differences, {time.perf_counter() - start:.0f} s")
    if changed and args.write:
        print(f"stored in {args.golden}; look at them, commit them, and run the check")
    elif changed:
        print("nothing was stored; --write stores the new golden data")
    return 1 if changed else 0


if __name__ == "__main__":
    sys.exit(run_command(main))
