"""Compute the golden data anew and print how they differ from the stored ones: `make golden`.

Both routes are run: the whole by elliptic integrals, a part by the printed integrals. Data on which they
disagree are never stored, and storing others takes `--write`. A run that finds or makes a difference
ends with status 1, so that changed golden data are never green in the run that changed them.
"""

from __future__ import annotations

import argparse
import sys
import time
from functools import partial
from pathlib import Path
from typing import Any

import xarray as xr
from tqdm import tqdm

from planar_pushing.evidence.golden.build.enclosures import disjoint, golden_variables
from planar_pushing.evidence.golden.build.jobs import STEP, contacts, golden_jobs
from planar_pushing.evidence.golden.build.motions import INSTANTS
from planar_pushing.evidence.golden.build.scenes import CONE_SAMPLES
from planar_pushing.evidence.golden.build.second import agreement, second_route
from planar_pushing.evidence.golden.compare import MARKS
from planar_pushing.study.files.scenes import load_scene_file
from planar_pushing.study.files.sliders_model import SlidersFile, Study
from planar_pushing.study.running.jobs import run_command
from planar_pushing.study.store import read_dataset, write_dataset
from planar_pushing.study.studies import PAPER_FILE, SLIDERS_FILE
from planar_pushing.study.study_file import load_study
from planar_pushing.terms.errors import InvalidResult

PROCESSES = 2
#: Root attribute of a golden file: how many of its numbers the second route encloses as well.
CHECKED = "checked_by_integrals"


def plain(study: Study) -> dict[str, Any]:
    """The study as plain values: the golden data share no code with the mechanics."""
    values: dict[str, Any] = study.model_dump()
    if isinstance(study, SlidersFile):
        return values
    samples = {"cone_samples": tuple(range(CONE_SAMPLES))}
    values["scenes"] = {
        name: (load_scene_file(push.file).model_dump(), push.model_dump() | samples)
        for name, push in study.scenes.items()
    }
    values["simulations"] = {
        name: load_scene_file(path).model_dump() for name, path in study.simulations.items()
    }
    values["instants"] = INSTANTS
    values["contacts"] = contacts(tuple(study.grid.contact_friction_coefficient))
    values["curve_angles"] = tuple(range(0, 361, STEP))
    return values


def golden_files(values: dict[str, Any]) -> dict[str, xr.Dataset]:
    """Content of every golden file of a study, given as plain values; second route included.

    Raises
    ------
    InvalidResult
        Where the two routes disagree.
    """
    jobs = list(golden_jobs(values))
    shown = partial(tqdm, total=len(jobs), disable=None, leave=False)
    files = {name: job(PROCESSES) for name, job in shown(jobs, "golden files")}
    for name, second in shown(second_route(values, PROCESSES), "second route"):
        found = agreement(values, second, files[name])
        if found.apart:
            raise InvalidResult(f"{name}: the two routes disagree on {', '.join(found.apart)}")
        files[name].attrs[CHECKED] = found.compared
    return files


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
    counts = [data.attrs.get(CHECKED) for data in (new, stored)]
    if counts[0] != counts[1]:
        found.append(f"{name}: {counts[0]} numbers are checked by the integrals, were {counts[1]}")
    for each in sorted(set(golden_variables(new)) & set(golden_variables(stored))):
        if new[each].shape != stored[each].shape or not new[each].coords.equals(
            stored[each].coords
        ):
            found.append(f"{name}: {each} has other coordinates")
        elif any(new[each].attrs.get(key) != stored[each].attrs.get(key) for key in MARKS):
            found.append(f"{name}: {each} has other units or flags")
        elif (apart := disjoint(each, new, stored)).any():
            found.append(f"{name}: {each} changes at {apart.sum()} of {apart.size} points")
    fresh = set(golden_variables(new)) - set(golden_variables(stored))
    found += [f"{name}: {each} is new" for each in sorted(fresh)]
    return found


def main(arguments: list[str] | None = None) -> int:
    """Print the differences; store the new data if asked to; 1 where anything differs."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--study", nargs="+", default=[PAPER_FILE, SLIDERS_FILE])
    parser.add_argument("--golden", type=Path, help="folder in the place of the studies' own")
    parser.add_argument("--write", action="store_true", help="store the new golden data")
    args = parser.parse_args(arguments)
    start = time.perf_counter()
    studies = [load_study(file) for file in args.study]
    changed = sum(
        _update(each, args.golden or Path(each.golden or ""), args.write) for each in studies
    )
    print(f"{changed} differences, {time.perf_counter() - start:.0f} s")
    if changed and args.write:
        print("stored; look at them, commit them, and run the check")
    elif changed:
        print("nothing was stored; --write stores the new golden data")
    return 1 if changed else 0


def _update(study: Study, golden: Path, write: bool) -> int:
    """Compute the golden data of a study, store them if asked to, and count the differences."""
    files, changed = golden_files(plain(study)), 0
    for name, new in files.items():
        path = golden / f"{name}.nc"
        found = differences(name, new, path)
        changed += len(found)
        print("\n".join(found) if found else f"{name}: unchanged", flush=True)
        if found and write:
            write_dataset(new, path)
    for name in sorted(set(stored_names(golden)) - set(files)):
        changed += 1
        print(f"{name}: no longer a part of the study; remove its file")
    checked = sum(each.attrs[CHECKED] for each in files.values())
    print(f"{checked} numbers lie in the enclosures of both routes")
    return changed


if __name__ == "__main__":
    sys.exit(run_command(main))
