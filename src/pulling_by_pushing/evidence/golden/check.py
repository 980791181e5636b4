"""Check of a results folder against the golden data of its study, file by file."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import xarray as xr
from tqdm import tqdm

from planar_pushing.terms.errors import InvalidFile
from planar_pushing.terms.netcdf import group_names, read_attributes
from planar_pushing.terms.replacing import PathLike
from pulling_by_pushing.evidence.golden.compare import (
    Check,
    TolerancesFile,
    compare,
    load_tolerances,
)
from pulling_by_pushing.evidence.golden.digests import REMEDY, changed_files
from pulling_by_pushing.evidence.golden.flaws import flaws
from pulling_by_pushing.study.catalog import SIMULATIONS, dataset_place
from pulling_by_pushing.study.slices import result_names
from pulling_by_pushing.study.store import read_dataset
from pulling_by_pushing.study.study_file import load_study


def check_results(folder: Path, file: PathLike) -> list[Check]:
    """Compare every value of a study's results with its golden data.

    Parameters
    ----------
    folder : Path
        The results.
    file : path
        The study, which defines the contents of the results and names the folder of golden data.

    Returns
    -------
    list of Check
        One for each variable; a result that cannot be read is a failed check.

    Raises
    ------
    InvalidFile
        If the study names no golden data, a golden file is missing or damaged, or the folder is not one
        of results.
    """
    study = load_study(file)
    require_results(folder)
    if not study.golden:
        remedy = "certify some of its points with --points N, or name golden data in it"
        raise InvalidFile(f"{file}: golden: missing; allowed: a folder of golden data; {remedy}")
    golden, names = Path(study.golden), result_names(study)
    for path in [golden / f"{name}.nc" for name in names]:
        if not path.is_file():
            raise InvalidFile(f"{path}: no such golden file; make it with make golden WRITE=1")
    checks, tolerances = list(_surplus(golden, names)), load_tolerances()
    checks += [Check(file=name, problem=problem) for name, problem in changed_files(golden, names)]
    for name in tqdm(names, "checking", disable=None, leave=False):
        checks += _check_file(
            name, folder / dataset_place(name)[0], golden / f"{name}.nc", tolerances
        )
    return checks


def require_results(folder: Path) -> None:
    """Refuse a folder without datasets."""
    if not any(folder.glob("data/*.nc")):
        problem = "contains no datasets" if folder.is_dir() else "no such folder"
        remedy = "build them with make, or with planar-pushing run STUDY.yaml"
        raise InvalidFile(f"{folder}: {problem}; name the folder of the results, or {remedy}")


def _surplus(golden: Path, names: list[str]) -> Iterator[Check]:
    """Golden files of results that the study does not have."""
    for folder in ("", f"{SIMULATIONS}/"):
        for path in sorted((golden / folder).glob("*.nc")):
            if f"{folder}{path.stem}" not in names:
                problem = "is a golden file, but not a result of the study"
                yield Check(file=f"{folder}{path.stem}", problem=problem)


def _check_file(name: str, path: Path, golden: Path, tolerances: TolerancesFile) -> list[Check]:
    """Compare every group of a file."""
    golden_groups = _golden_groups(golden)
    try:
        groups = group_names(path) or [""]
        checks = [
            Check(file=f"{name}/{group}", problem="is no group of this dataset")
            for group in set(groups) - set(golden_groups)
        ]
        if "" not in golden_groups:
            checks += check_dataset(name, _root(path), _root(golden), tolerances)
        for group, dataset in golden_groups.items():
            result = read_dataset(path, group or None).load()
            file = f"{name}/{group}" if group else name
            checks += check_dataset(file, result, dataset, tolerances)
        return checks
    except InvalidFile as error:
        return [Check(file=name, problem=f"cannot be read: {error}")]


def check_dataset(
    file: str, result: xr.Dataset, golden: xr.Dataset, tolerances: TolerancesFile
) -> list[Check]:
    """Checks of a dataset; golden data that cannot judge it are failed checks themselves."""
    unsound = [Check(file=file, problem=f"{flaw}; {REMEDY}") for flaw in flaws(file, golden)]
    return unsound or compare(file, result, golden, tolerances)


def _golden_groups(path: Path) -> dict[str, xr.Dataset]:
    """The groups of a golden file, or `InvalidFile`."""
    try:
        return {
            group: read_dataset(path, group or None).load() for group in group_names(path) or [""]
        }
    except InvalidFile:
        raise InvalidFile(f"{path}: is a damaged golden file; {REMEDY}") from None


def _root(path: Path) -> xr.Dataset:
    """The attributes of a file with groups."""
    return xr.Dataset(attrs=read_attributes(path))
