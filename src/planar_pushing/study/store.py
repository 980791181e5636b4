"""Datasets in netCDF4 files: written completely or not at all, with one-line errors for damaged files."""

from __future__ import annotations

import json
import math
import os
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any, Literal

import h5netcdf
import h5py
import numpy as np
import xarray as xr

from planar_pushing.study.catalog import DATASETS, FOLDERS, building, dataset_place
from planar_pushing.study.chunks import joined, shape
from planar_pushing.study.files.replacing import PathLike, replacing
from planar_pushing.study.studies import built_folder
from planar_pushing.terms.errors import (
    InvalidFile,
    InvalidValue,
    PlanarPushingError,
    require_path,
    suggestion,
)

ENGINE: Literal["h5netcdf"] = "h5netcdf"
#: Minimum size in bytes, one page, for which a variable gains from compression.
SMALL = 4096
#: Maximum number of values in a separately compressed piece, and the compression level.
STORED, LEVEL = 2**15, 1
#: Size in bytes above which a dataset is read on demand.
LARGE = 2**23
#: Attribute of an index: the maximum length of a chunk along each dimension that is split.
CHUNKS = "chunks"


def write_dataset(built: xr.Dataset | dict[str, xr.Dataset], path: PathLike) -> None:
    """Write a dataset, or several as groups of one file, completely or not at all.

    The bytes of the file depend only on the content, unless dask reads the dataset.
    """
    groups = {"/": built} if isinstance(built, xr.Dataset) else built
    # Drop encodings inherited from other files.
    plain = {name: each.drop_encoding() for name, each in groups.items()}
    tree = xr.DataTree.from_dict(
        {name: each.assign_attrs(_attributes(each.attrs)) for name, each in plain.items()}
    )
    encoding = {
        node.path: {name: _encoding(each) for name, each in node.variables.items()}
        for node in tree.subtree
    }
    with replacing(path) as temporary:
        tree.to_netcdf(temporary, engine=ENGINE, encoding=encoding)


def _attributes(attrs: Mapping[Any, Any]) -> dict[Any, Any]:
    """Attributes with integers of 32 bits if they fit, since not every reader has attributes of 64."""
    limits = np.iinfo(np.int32)
    return {
        name: np.int32(each)
        if isinstance(each, (int, np.int64)) and limits.min <= each <= limits.max
        else each
        for name, each in attrs.items()
    }


def _encoding(variable: xr.Variable) -> dict[str, Any]:
    """Encoding without a fill value; numbers are compressed if that saves space."""
    chunks = stored_chunks(variable.shape, variable.dtype)
    layout = {"zlib": True, "complevel": LEVEL, "chunksizes": chunks} if chunks else {}
    return {"_FillValue": None} | layout


def stored_chunks(lengths: Sequence[int], dtype: np.dtype[Any]) -> tuple[int, ...] | None:
    """Shape of the compressed pieces of a variable; None without compression."""
    small = dtype.kind in "OU" or math.prod(lengths) * dtype.itemsize < SMALL
    return None if small else shape(lengths, STORED)


@contextmanager
def reading(path: PathLike) -> Iterator[None]:
    """Report any error while reading a file as a one-line message, since damage can cause any error."""
    try:
        yield
    except PlanarPushingError:
        raise
    except FileNotFoundError:
        message = f"{path}: no such dataset; build it with make or snakemake"
        raise InvalidFile(message) from None
    except Exception as error:
        number = error.errno if isinstance(error, OSError) else None
        reason = f" ({os.strerror(number)})" if number else ""
        raise InvalidFile(
            f"{path}: is not a netCDF4 file{reason}; give a dataset, or rebuild a damaged one"
        ) from None


@contextmanager
def _netcdf(path: PathLike) -> Iterator[h5netcdf.File]:
    """Open a file with a readable root; otherwise h5netcdf would report a second error on closing."""
    with reading(path):
        with h5py.File(path, "r") as file:
            dict(file.attrs)
        with h5netcdf.File(path, "r") as file:
            yield file


def read_attributes(path: PathLike) -> dict[str, object]:
    """Read only the root attributes of a file; errors as in `read_dataset`."""
    with _netcdf(path) as file:
        return dict(file.attrs)


def read_dataset(path: PathLike, group: str | None = None) -> xr.Dataset:
    """Read a dataset into memory and close its file; a dataset above 8 MB is read on demand.

    A dataset that is stored in chunks is also read on demand, by dask.

    Raises
    ------
    InvalidFile
        If the file is missing, is not netCDF4, or has no such group.
    """
    if group not in (None, *group_names(path)):
        raise InvalidFile(f"{path}: has no group {group!r}; delete it and build it again")
    with reading(path):
        # An HDF5 file that is not netCDF4 has no named dimensions. No dataset holds dates.
        opened = xr.open_dataset(
            path, engine=ENGINE, group=group, phony_dims="access", decode_times=False
        )
        if opened.nbytes > LARGE:
            return opened
        with opened:
            found = opened.load()
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


def group_names(path: PathLike) -> list[str]:
    """Names of a file's groups, in order; errors as in `read_dataset`."""
    with _netcdf(path) as file:
        return sorted(file.groups)


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
    """Open a dataset of a study by name.

    Parameters
    ----------
    name : str
        One of limit_curves, motion_cones, contact_modes, acceleration_centers and center_regions; a scene
        such as "scenes/figure_08"; a simulation such as "simulations/figure_15"; the numbers that a figure
        plots, such as "figures/figure_06"; or a dataset about the computation itself, such as
        "accuracy/cone". A study with supports also has supports, support_cones and support_modes.
        `planar-pushing query` lists the datasets that are built.
    results : path
        Results folder of the pipeline.
    study : str, optional
        Name of a study other than the paper's, whose results are in studies/NAME in that folder.

    Returns
    -------
    xarray.Dataset
        Dataset in memory, or read on demand if it is above 8 MB or stored in chunks; angles are in
        degrees.

    Raises
    ------
    InvalidValue
        If there is no dataset or no study with this name.
    InvalidFile
        If the folder is not a results folder, or the dataset has not been built; the message says which
        command builds it.
    """
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
