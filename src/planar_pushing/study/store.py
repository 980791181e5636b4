"""Datasets in files, netCDF4: written whole or not at all, read with one line where a file is damaged."""

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
#: A variable of fewer bytes, a page, gains nothing from compression.
SMALL = 4096
#: Most numbers of a piece that is compressed by itself, and how hard that is tried.
STORED, LEVEL = 2**15, 1
#: A dataset of more bytes is read when it is used.
LARGE = 2**23
#: Attribute of an index: the most values of a chunk along each dimension that is cut.
CHUNKS = "chunks"


def write_dataset(built: xr.Dataset | dict[str, xr.Dataset], path: PathLike) -> None:
    """Write a dataset, or one group for each of several, whole or not at all.

    The bytes depend on the content alone, but for those of a dataset that dask reads.
    """
    groups = {"/": built} if isinstance(built, xr.Dataset) else built
    # Without the encoding that another file has chosen.
    tree = xr.DataTree.from_dict({name: each.drop_encoding() for name, each in groups.items()})
    encoding = {
        node.path: {name: _encoding(each) for name, each in node.variables.items()}
        for node in tree.subtree
    }
    with replacing(path) as temporary:
        tree.to_netcdf(temporary, engine=ENGINE, encoding=encoding)


def _encoding(variable: xr.Variable) -> dict[str, Any]:
    """No value stands for a missing one; numbers are compressed where that saves space."""
    chunks = stored_chunks(variable.shape, variable.dtype)
    layout = {"zlib": True, "complevel": LEVEL, "chunksizes": chunks} if chunks else {}
    return {"_FillValue": None} | layout


def stored_chunks(lengths: Sequence[int], dtype: np.dtype[Any]) -> tuple[int, ...] | None:
    """Shape of the pieces in which a variable is compressed; None for one that is not."""
    small = dtype.kind in "OU" or math.prod(lengths) * dtype.itemsize < SMALL
    return None if small else shape(lengths, STORED)


@contextmanager
def reading(path: PathLike) -> Iterator[None]:
    """Say in one line what is wrong with a file that is read within; damage shows itself in any error."""
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
            f"{path}: is not a netCDF4 file{reason}; remove it and build it anew"
        ) from None


@contextmanager
def _netcdf(path: PathLike) -> Iterator[h5netcdf.File]:
    """A file whose root can be read; h5netcdf itself would complain a second time while it closes."""
    with reading(path):
        with h5py.File(path, "r") as file:
            dict(file.attrs)
        with h5netcdf.File(path, "r") as file:
            yield file


def read_attributes(path: PathLike) -> dict[str, object]:
    """Read the root attributes of a file, and nothing else of it; errors as in `read_dataset`."""
    with _netcdf(path) as file:
        return dict(file.attrs)


def read_dataset(path: PathLike, group: str | None = None) -> xr.Dataset:
    """Read a dataset into memory, and close its file; one above 8 MB is read when it is used.

    So is one that stays in its chunks, by dask.

    Raises
    ------
    InvalidFile
        Where the file is missing, is not netCDF4, or has no such group.
    """
    if group not in (None, *group_names(path)):
        raise InvalidFile(f"{path}: has no group {group!r}; remove it and build it anew")
    with reading(path):
        # A file that is HDF5 and no netCDF4 names no dimensions; no dataset holds dates.
        opened = xr.open_dataset(
            path, engine=ENGINE, group=group, phony_dims="access", decode_times=False
        )
        if opened.nbytes > LARGE:
            return opened
        with opened:
            found = opened.load()
    return _behind_index(found, Path(path)) if CHUNKS in found.attrs else found


def index_of(whole: xr.Dataset, steps: Mapping[str, int]) -> xr.Dataset:
    """The index of a dataset that stays in its chunks: its coordinates and attributes."""
    return whole.drop_vars(list(whole.data_vars)).assign_attrs({CHUNKS: json.dumps(dict(steps))})


def _behind_index(index: xr.Dataset, path: Path) -> xr.Dataset:
    """The dataset for which an index stands, with the attributes of the index."""
    steps = _steps(index, path)
    folder = path.parent.parent / "chunks" / path.stem
    lengths = {str(dim): length for dim, length in index.sizes.items()}
    with reading(folder):
        whole = joined(folder, lengths, steps)
    if not all(whole[dim].equals(index[dim]) for dim in steps):
        raise InvalidFile(
            f"{path}: its chunks are those of another grid; remove it and build it anew"
        )
    return whole.assign_attrs({key: each for key, each in index.attrs.items() if key != CHUNKS})


def _steps(index: xr.Dataset, path: Path) -> dict[str, int]:
    """Lengths of the chunks that an index names, or `InvalidFile`."""
    try:
        steps = {str(dim): int(step) for dim, step in json.loads(index.attrs[CHUNKS]).items()}
    except (TypeError, ValueError, AttributeError):
        steps = {}
    dims = DATASETS[path.stem].dims if path.stem in DATASETS else ()
    if not steps or not set(steps) <= set(dims) or min(steps.values()) < 1:
        raise InvalidFile(f"{path}: names no chunks; remove it and build it anew")
    return steps


def group_names(path: PathLike) -> list[str]:
    """Names of a file's groups, in order; errors as in `read_dataset`."""
    with _netcdf(path) as file:
        return sorted(file.groups)


def _filled(folder: Path) -> Path:
    """The folder of results, or `InvalidFile` where it is not one that the pipeline has filled."""
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
        limit_curves, motion_cones, contact_modes, acceleration_centers, center_regions, a scene as
        "scenes/figure_08", a simulation as "simulations/figure_15", the numbers that a figure plots as
        "figures/figure_06", or one on how this work computes, such as "accuracy_errors/cone"; of a study
        with supports also supports, support_cones and support_modes. `planar-pushing query` lists those
        that are built.
    results : path
        The folder that the pipeline filled.
    study : str, optional
        Name of another study than the paper's, whose results are in studies/NAME there.

    Returns
    -------
    xarray.Dataset
        In memory, or read when it is used where it is above 8 MB or stays in its chunks; angles are
        degrees.

    Raises
    ------
    InvalidValue
        Where there is no dataset of this name, or no study.
    InvalidFile
        Where the folder is not one of results, or the dataset has not been built: the message says which
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
    """The folder of a study's results; errors as in `open_dataset`."""
    return _filled(built_folder(study, require_path("results", results)))


def _not_built(name: str, path: Path) -> PlanarPushingError:
    """The error that says what builds a dataset, or which simulations and figures there are."""
    stem = name.partition("/")[0]
    others = [f"{stem}/{each.stem}" for each in sorted(path.parent.glob("*.nc"))]
    if stem in FOLDERS and others:
        remedy = f"name one of these, or list it under {stem} in the study and build that anew"
        return InvalidValue("name", name, ", ".join(others), remedy)
    return InvalidFile(f"{path}: no such dataset; {building(name)}")


def _require_part(name: str, group: str | None, path: Path) -> None:
    """Reject a part that a file does not have, and a whole where the file has parts alone."""
    parts = group_names(path)
    if group is None and not parts:
        return
    stem = name.partition("/")[0]
    allowed = [f"{stem}/{each}" for each in parts] or [stem]
    if name not in allowed:
        remedy = suggestion(name, allowed, "name one of these")
        raise InvalidValue("name", name, ", ".join(allowed), remedy)
