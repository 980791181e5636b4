"""Datasets of a study by name, each in one file or in chunks behind an index."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path

import xarray as xr

from planar_pushing.terms import netcdf
from planar_pushing.terms.errors import (
    InvalidFile,
    InvalidValue,
    PlanarPushingError,
    require_name,
    require_path,
    suggestion,
)
from planar_pushing.terms.netcdf import group_names, reading
from planar_pushing.terms.replacing import PathLike
from pulling_by_pushing.study.catalog import (
    DATASETS,
    FOLDERS,
    build_command,
    dataset_file,
    dataset_place,
)
from pulling_by_pushing.study.studies import PAPER, built_folder, built_studies, study_folder

#: Attribute of an index: the maximum length of a chunk along each dimension that is split.
CHUNKS = "chunks"


def read_dataset(path: PathLike, group: str | None = None) -> xr.Dataset:
    """Read a dataset as `netcdf.read_dataset` does; dask reads one in chunks on demand.

    Raises
    ------
    InvalidFile
        If the file is missing, is not netCDF4, or has no such group.
    """
    dataset = netcdf.read_dataset(path, group)
    return _indexed_dataset(dataset, Path(path)) if CHUNKS in dataset.attrs else dataset


def index_of(dataset: xr.Dataset, steps: Mapping[str, int]) -> xr.Dataset:
    """Index of a dataset that is stored in chunks: its coordinates and attributes."""
    return dataset.drop_vars(list(dataset.data_vars)).assign_attrs(
        {CHUNKS: json.dumps(dict(steps))}
    )


def _indexed_dataset(index: xr.Dataset, path: Path) -> xr.Dataset:
    """Dataset of the chunks that an index describes, with the attributes of the index."""
    from pulling_by_pushing.study.chunks import open_chunks  # few datasets are in chunks

    steps = _steps(index, path)
    folder = path.parent.parent / "chunks" / path.stem
    lengths = {str(dim): length for dim, length in index.sizes.items()}
    with reading(folder):
        dataset = open_chunks(folder, lengths, steps)
    if not all(dataset[dim].equals(index[dim]) for dim in steps):
        raise InvalidFile(
            f"{path}: its chunks belong to another grid; delete it and build it again"
        )
    return dataset.assign_attrs({key: value for key, value in index.attrs.items() if key != CHUNKS})


def _steps(index: xr.Dataset, path: Path) -> dict[str, int]:
    """Chunk lengths from an index; raises `InvalidFile` if it has none."""
    try:
        steps = {str(dim): int(step) for dim, step in json.loads(index.attrs[CHUNKS]).items()}
    except (TypeError, ValueError, AttributeError):
        steps = {}
    dims = DATASETS[path.stem].dims if path.stem in DATASETS else ()
    if not steps or not set(steps) <= set(dims) or min(steps.values()) < 1:
        raise InvalidFile(f"{path}: names no chunks; delete it and build it again")
    return steps


def _require_results(folder: Path) -> Path:
    """Results folder; raises `InvalidFile` if the pipeline has not written to it."""
    if not (folder / "data").is_dir():
        problem = (
            f"{folder}: holds no folder data" if folder.is_dir() else f"{folder}: no such folder"
        )
        remedy = "build them with make, or with planar-pushing run STUDY.yaml"
        raise InvalidFile(f"{problem}; name the folder of the results, or {remedy}")
    return folder


def open_dataset(
    name: str, results: PathLike = "results", *, study: str | None = None
) -> xr.Dataset:
    """Open a dataset of a study by name, as `planar_pushing.open_dataset` describes."""
    file, group = dataset_place(name)
    folder = built_folder(study, require_path("results", results))
    path = folder / file
    if not path.exists():
        if advice := study_advice(name, results):
            raise InvalidFile(f"{path}: no such dataset; {advice}")
        raise _not_built(name, _require_results(folder) / file)
    _require_part(name, group, path)
    return read_dataset(path, group)


def built_results(results: PathLike, study: str | None = None) -> Path:
    """Folder of a study's results; errors as in `open_dataset`."""
    return _require_results(built_folder(study, require_path("results", results)))


def study_advice(name: str, results: PathLike) -> str:
    """Which other studies have a dataset that a study lacks, and how to name one; empty if none has it.

    In a name such as "simulations/NAME", NAME stands for every simulation.
    """
    files = dataset_file(name).replace("NAME", "*")
    studies = [
        study
        for study in (PAPER, *built_studies(results))
        if any(study_folder(study, results).glob(files))
    ]
    if not studies:
        return ""
    listed = f"the {'study' if len(studies) == 1 else 'studies'} {', '.join(studies)}"
    return f"built for {listed}: give --study {studies[0]}, or study={studies[0]!r} in Python"


def _not_built(name: str, path: Path) -> PlanarPushingError:
    """Error that names the command to build a dataset, or lists the existing simulations."""
    stem = name.partition("/")[0]
    files = sorted(path.parent.glob("*.nc"))
    others = [f"{stem}/{file.stem}" for file in files]
    if stem in FOLDERS and others:
        otherwise = f"name one of these, or list it under {stem} in the study and build that again"
        stems = (file.stem for file in files)
        remedy = suggestion(path.stem, stems, otherwise, before=f"{stem}/")
        return InvalidValue("name", name, ", ".join(others), remedy)
    return InvalidFile(f"{path}: no such dataset; {build_command(name)}")


def _require_part(name: str, group: str | None, path: Path) -> None:
    """Reject a missing part of a file, and the name of a whole file that has only parts."""
    parts = group_names(path)
    if group is None and not parts:
        return
    stem = name.partition("/")[0]
    allowed = [f"{stem}/{part}" for part in parts] or [stem]
    require_name("name", name, allowed, "name one of these")
