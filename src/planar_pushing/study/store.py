"""Write and open the datasets, netCDF4 files in results/data."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, Literal

import h5netcdf
import xarray as xr

from planar_pushing.study.catalog import DATASETS, SIMULATIONS, dataset_file
from planar_pushing.study.files.replacing import PathLike, replacing
from planar_pushing.terms.errors import InvalidFile, InvalidValue, require_path

ENGINE: Literal["h5netcdf"] = "h5netcdf"
#: A variable of fewer bytes, a page, gains nothing from compression.
SMALL = 4096
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
    large = variable.dtype.kind not in "OU" and variable.nbytes >= SMALL
    return {"_FillValue": None} | ({"zlib": True, "complevel": 1} if large else {})


def read_attributes(path: PathLike) -> dict[str, object]:
    """Read the root attributes of a file that is there, and nothing else of it."""
    with h5netcdf.File(path, "r") as file:
        return dict(file.attrs)


def read_dataset(path: PathLike, group: str | None = None) -> xr.Dataset:
    """Read a dataset into memory, and close its file; one above 8 MB is read when it is used.

    Raises
    ------
    InvalidFile
        Where the file is missing, is not netCDF4 or has no such group.
    """
    if group and group not in group_names(path):
        raise InvalidFile(f"{path}: has no group {group!r}; build it anew")
    with _readable(path):
        # A file that is HDF5 and no netCDF4 names no dimensions.
        opened = xr.open_dataset(path, engine=ENGINE, group=group, phony_dims="access")
    if opened.nbytes > LARGE:
        return opened
    with opened:
        return opened.load()


def group_names(path: PathLike) -> list[str]:
    """Names of a file's groups, in order; errors as in `read_dataset`."""
    with _readable(path), h5netcdf.File(path, "r") as file:
        return sorted(file.groups)


@contextmanager
def _readable(path: PathLike) -> Iterator[None]:
    """Say of a file that cannot be opened what is wrong with it."""
    try:
        yield
    except FileNotFoundError:
        message = f"{path}: no such dataset; build it with make or snakemake"
        raise InvalidFile(message) from None
    except OSError as error:
        reason = f" ({os.strerror(error.errno)})" if error.errno else ""
        raise InvalidFile(f"{path}: is not a netCDF4 file{reason}; build it anew") from None


def _filled(folder: Path) -> Path:
    """The folder of results, or `InvalidFile` where it is not one that the pipeline has filled."""
    if not (folder / "data").is_dir():
        place = (
            f"{folder}: holds no folder data" if folder.is_dir() else f"{folder}: no such folder"
        )
        raise InvalidFile(f"{place}; name the folder of the results, or build them with make")
    return folder


def open_dataset(name: str, results: PathLike = "results") -> xr.Dataset:
    """Open a dataset of the study by name.

    Parameters
    ----------
    name : str
        limit_curves, motion_cones, contact_modes, acceleration_centers, a scene as
        "scenes/figure_08", or a simulation as "simulations/figure_15".
    results : path
        The folder that the pipeline filled.

    Returns
    -------
    xarray.Dataset
        In memory, or read when it is used where it is above 8 MB; angles are degrees.

    Raises
    ------
    InvalidValue
        Where there is no dataset of this name.
    InvalidFile
        Where the folder is not one of results, or the dataset has not been built.
    """
    folder = Path(require_path("results", results))
    stem, _, group = name.partition("/") if isinstance(name, str) else ("", "", "")
    if stem == SIMULATIONS and group:
        return read_dataset(_filled(folder) / dataset_file(name))
    if stem not in DATASETS:
        allowed = ", ".join([*DATASETS, f"{SIMULATIONS}/NAME"])
        raise InvalidValue("name", name, allowed, "name one of these datasets")
    path = _filled(folder) / dataset_file(name)
    if (group or stem == "scenes") and path.is_file():
        parts = [f"{stem}/{each}" for each in group_names(path)] or [stem]
        if name not in parts:
            raise InvalidValue("name", name, ", ".join(parts), "name one of these")
    return read_dataset(path, group or None)
