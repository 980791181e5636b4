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
    require_path,
    suggestion,
)
from planar_pushing.terms.netcdf import group_names, reading
from planar_pushing.terms.replacing import PathLike
from pulling_by_pushing.study.catalog import DATASETS, FOLDERS, building, dataset_place
from pulling_by_pushing.study.chunks import joined
from pulling_by_pushing.study.studies import built_folder

#: Attribute of an index: the maximum length of a chunk along each dimension that is split.
CHUNKS = "chunks"


def read_dataset(path: PathLike, group: str | None = None) -> xr.Dataset:
    """Read a dataset as `netcdf.read_dataset` does; dask reads one in chunks on demand.

    Raises
    ------
    InvalidFile
        If the file is missing, is not netCDF4, or has no such group.
    """
    found = netcdf.read_dataset(path, group)
    return _behind_index(found, Path(path)) if CHUNKS in found.attrs else found


def index_of(whole: xr.Dataset, steps: Mapping[str, int]) -> xr.Dataset:
    """Index of a dataset that is stored in chunks: its coordinates and attributes."""
    return whole.drop_vars(list(whole.data_vars)).assign_attrs({CHUNKS: json.dumps(dict(steps))})


def _behind_index(index: xr.Dataset, path: Path) -> xr.Dataset:
    """Dataset of the chunks that an index describes, with the attributes of the index."""
    steps = _steps(index, path)
    folder = path.parent.parent / "chunks" / path.stem
    lengths = {str(dim): length for dim, length in index.sizes.items()}
    with reading(folder):
        whole = joined(folder, lengths, steps)
    if not all(whole[dim].equals(index[dim]) for dim in steps):
        raise InvalidFile(
            f"{path}: its chunks belong to another grid; delete it and build it again"
        )
    return whole.assign_attrs({key: each for key, each in index.attrs.items() if key != CHUNKS})


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


def _filled(folder: Path) -> Path:
    """Results folder; raises `InvalidFile` if the pipeline has not written to it."""
    if not (folder / "data").is_dir():
        place = (
            f"{folder}: holds no folder data" if folder.is_dir() else f"{folder}: no such folder"
        )
        remedy = "build them with make, or with planar-pushing run STUDY.yaml"
        raise InvalidFile(f"{place}; name the folder of the results, or {remedy}")
    return folder


def open_dataset(
    name: str, results: PathLike = "results", *, study: str | None = None
) -> xr.Dataset:
    """Open a dataset of a study by name, as `planar_pushing.open_dataset` describes."""
    file, group = dataset_place(name)
    folder = built_results(results, study)
    path = folder / file
    if not path.exists():
        raise _not_built(name, path)
    _require_part(name, group, path)
    return read_dataset(path, group)


def built_results(results: PathLike, study: str | None = None) -> Path:
    """Folder of a study's results; errors as in `open_dataset`."""
    return _filled(built_folder(study, require_path("results", results)))


def _not_built(name: str, path: Path) -> PlanarPushingError:
    """Error that names the command to build a dataset, or lists the existing simulations and figures."""
    stem = name.partition("/")[0]
    others = [f"{stem}/{each.stem}" for each in sorted(path.parent.glob("*.nc"))]
    if stem in FOLDERS and others:
        remedy = f"name one of these, or list it under {stem} in the study and build that again"
        return InvalidValue("name", name, ", ".join(others), remedy)
    return InvalidFile(f"{path}: no such dataset; {building(name)}")


def _require_part(name: str, group: str | None, path: Path) -> None:
    """Reject a missing part of a file, and the name of a whole file that has only parts."""
    parts = group_names(path)
    if group is None and not parts:
        return
    stem = name.partition("/")[0]
    allowed = [f"{stem}/{each}" for each in parts] or [stem]
    if name not in allowed:
        remedy = suggestion(name, allowed, "name one of these")
        raise InvalidValue("name", name, ", ".join(allowed), remedy)
