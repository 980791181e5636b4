"""Write and open the datasets, netCDF4 files in results/data."""

from __future__ import annotations

import os
from pathlib import Path

import h5py
import xarray as xr

from planar_pushing.mechanics.errors import InvalidFile, InvalidValue
from planar_pushing.study import hdf5
from planar_pushing.study.catalog import DATASETS, SIMULATIONS, dataset_file
from planar_pushing.study.replacing import replacing

PathLike = str | os.PathLike[str]


def write_dataset(built: xr.Dataset | dict[str, xr.Dataset], path: PathLike) -> None:
    """Write a dataset, or one group for each of several, whole or not at all.

    The bytes depend on the content alone.
    """
    with replacing(path) as temporary, h5py.File(temporary, "w", track_order=True) as file:
        if isinstance(built, xr.Dataset):
            hdf5.write_variables(file, built)
            return
        for name, group in built.items():
            hdf5.write_variables(file.create_group(name, track_order=True), group)


def read_attributes(path: PathLike) -> dict[str, object]:
    """Read the root attributes of a file that is there, and nothing else of it."""
    with h5py.File(path, "r") as file:
        return hdf5.attributes(file)


def read_dataset(path: PathLike, group: str | None = None) -> xr.Dataset:
    """Read a dataset into memory, and close its file; variables above 8 MB are read when they are used.

    Raises
    ------
    InvalidFile
        Where the file is missing, is not netCDF4 or has no such group.
    """
    try:
        with h5py.File(path, "r") as file:
            return hdf5.read_variables(file, group)
    except FileNotFoundError:
        raise _missing(path) from None
    except KeyError:
        raise InvalidFile(f"{path}: has no group {group!r}; build it anew") from None
    except OSError as error:
        raise _unreadable(path, error) from None


def _missing(path: PathLike) -> InvalidFile:
    return InvalidFile(f"{path}: no such dataset; build it with make or snakemake")


def _unreadable(path: PathLike, error: OSError) -> InvalidFile:
    reason = f" ({os.strerror(error.errno)})" if error.errno else ""
    return InvalidFile(f"{path}: is not a netCDF4 file{reason}; build it anew")


def group_names(path: PathLike) -> list[str]:
    """Names of a file's groups, in order; errors as in `read_dataset`."""
    try:
        with h5py.File(path, "r") as file:
            return sorted(name for name, each in file.items() if isinstance(each, h5py.Group))
    except FileNotFoundError:
        raise _missing(path) from None
    except OSError as error:
        raise _unreadable(path, error) from None


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
        In memory but for variables above 8 MB, which are read when they are used; angles are degrees.

    Raises
    ------
    InvalidValue
        Where there is no dataset of this name.
    InvalidFile
        Where the dataset has not been built.
    """
    stem, _, group = name.partition("/")
    if stem == SIMULATIONS and group:
        return read_dataset(Path(results) / dataset_file(name))
    if stem not in DATASETS:
        allowed = ", ".join([*DATASETS, f"{SIMULATIONS}/NAME"])
        raise InvalidValue("name", name, allowed, "name one of these datasets")
    path = Path(results) / dataset_file(name)
    if (group or stem == "scenes") and path.is_file():
        parts = [f"{stem}/{each}" for each in group_names(path)] or [stem]
        if name not in parts:
            raise InvalidValue("name", name, ", ".join(parts), "name one of these")
    return read_dataset(path, group or None)
