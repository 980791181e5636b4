"""Write and open the datasets, netCDF4 files in results/data."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path
from typing import Any, Literal

import h5netcdf
import numpy as np
import xarray as xr

from planar_pushing.study.catalog import dataset_place
from planar_pushing.study.files.replacing import PathLike, replacing
from planar_pushing.study.storage.chunk_files import behind_index
from planar_pushing.study.storage.hdf5 import readable
from planar_pushing.study.storage.parts import shape
from planar_pushing.study.studies import built_folder
from planar_pushing.terms.errors import InvalidFile, InvalidValue, require_path

ENGINE: Literal["h5netcdf"] = "h5netcdf"
#: A variable of fewer bytes, a page, gains nothing from compression.
SMALL = 4096
#: Most numbers of a piece that is compressed by itself, and how hard that is tried.
STORED, LEVEL = 2**15, 1
#: A dataset of more bytes is read when it is used.
LARGE = 2**23


def write_dataset(built: xr.Dataset | dict[str, xr.Dataset], path: PathLike) -> None:
    """Write a dataset, or one group for each of several, whole or not at all.

    The bytes depend on the content alone.
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


def read_attributes(path: PathLike) -> dict[str, object]:
    """Read the root attributes of a file, and nothing else of it; errors as in `read_dataset`."""
    with readable(path), h5netcdf.File(path, "r") as file:
        return dict(file.attrs)


def read_dataset(path: PathLike, group: str | None = None) -> xr.Dataset:
    """Read a dataset into memory, and close its file; one above 8 MB is read when it is used.

    So is one that stays in its chunks, by dask.

    Raises
    ------
    InvalidFile
        Where the file is missing, is not netCDF4, has no such group, or does not hold its own values.
    """
    if group and group not in group_names(path):
        raise InvalidFile(f"{path}: has no group {group!r}; remove it and build it anew")
    with readable(path):
        # A file that is HDF5 and no netCDF4 names no dimensions; no dataset holds dates.
        opened = xr.open_dataset(
            path, engine=ENGINE, group=group, phony_dims="access", decode_times=False
        )
        if opened.nbytes > LARGE:
            return opened
        with opened:
            found = opened.load()
    return behind_index(found, Path(path))


def group_names(path: PathLike) -> list[str]:
    """Names of a file's groups, in order; errors as in `read_dataset`."""
    with readable(path), h5netcdf.File(path, "r") as file:
        return sorted(file.groups)


def _filled(folder: Path) -> Path:
    """The folder of results, or `InvalidFile` where it is not one that the pipeline has filled."""
    if not (folder / "data").is_dir():
        place = (
            f"{folder}: holds no folder data" if folder.is_dir() else f"{folder}: no such folder"
        )
        raise InvalidFile(f"{place}; name the folder of the results, or build them with make")
    return folder


def open_dataset(
    name: str, results: PathLike = "results", *, study: str | None = None
) -> xr.Dataset:
    """Open a dataset of a study by name.

    Parameters
    ----------
    name : str
        limit_curves, motion_cones, contact_modes, acceleration_centers, center_regions, a scene as
        "scenes/figure_08", a simulation as "simulations/figure_15", what a figure plots as
        "figures/figure_06", or one on how this work computes, such as "accuracy_errors/cone"; of a study of
        sliders, supports, support_cones and support_modes.
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
        Where the folder is not one of results, or the dataset has not been built.
    """
    file, group = dataset_place(name)
    path = _filled(built_folder(study, require_path("results", results))) / file
    if path.is_file():
        _require_part(name, group, path)
    return read_dataset(path, group)


def _require_part(name: str, group: str | None, path: Path) -> None:
    """Refuse a part that a file does not have, and a whole where the file has parts alone."""
    parts = group_names(path)
    if group is None and not parts:
        return
    stem = name.partition("/")[0]
    allowed = [f"{stem}/{each}" for each in parts] or [stem]
    if name not in allowed:
        raise InvalidValue("name", name, ", ".join(allowed), "name one of these")
