"""Files of pushes in netCDF4 format, written completely or not at all."""

from __future__ import annotations

from pathlib import Path

import h5py
import xarray as xr

from planar_pushing.pushes.logs.schema import require_pushes
from planar_pushing.terms.errors import InvalidFile, InvalidValue, require_path
from planar_pushing.terms.netcdf import read_dataset, write_dataset
from planar_pushing.terms.replacing import PathLike

#: Formats that `planar-pushing convert` reads, by the ending of a file's name.
FORMATS = {".csv": "csv", ".mat": "mit", ".txt": "three-feet"}


#: First bytes of an HDF5 file.
HDF5 = b"\x89HDF\r\n\x1a\n"
#: Variables of the MIT push data as published, a file for each push, and what to do with them.
RAW = ("tip_pose", "object_pose", "ft_wrench")
RAW_REMEDY = (
    "read the logs with h5py, and make the dataset with pushes_from_poses, a row for each log: "
    "object_pose[0, 1:4], object_pose[-1, 1:4], tip_pose[0, 1:3] and tip_pose[-1, 1:3], in m and radians"
)


def refuse_raw(file: Path) -> None:
    """Refuse a log of one push in HDF5, as the MIT push data are published, with its remedy."""
    try:
        with file.open("rb") as stream:
            if stream.read(len(HDF5)) != HDF5:
                return
        with h5py.File(file) as content:
            is_raw = set(RAW) <= set(content)
    except OSError:
        return
    if is_raw:
        raise InvalidFile(
            f"{file}: is a raw log of one push in HDF5, with {', '.join(RAW)}; "
            f"allowed: a dataset of pushes; {RAW_REMEDY}"
        )


def save_pushes(pushes: xr.Dataset, file: PathLike) -> None:
    """Write pushes to a netCDF4 file, completely or not at all.

    Parameters
    ----------
    pushes : xarray.Dataset
        Returned by `load_pushes`, `pushes_from_poses` or a reader.
    file : path

    Raises
    ------
    InvalidValue
        If the dataset does not contain pushes.
    InvalidFile
        If the file cannot be written.
    """
    require_path("file", file)
    write_dataset(require_pushes(pushes), file)


def load_pushes(file: PathLike) -> xr.Dataset:
    """Read pushes from a netCDF4 file.

    Parameters
    ----------
    file : path
        File written by `save_pushes` or ``planar-pushing convert``.

    Returns
    -------
    xarray.Dataset
        Loaded into memory, over `push`, `object`, `corner` and `xy`, and over `foot`, `sample`, `piece` and
        `column` if there are any.

    Raises
    ------
    InvalidFile
        If the file is missing, is not netCDF4, or does not contain pushes, like the raw MIT push data.
    """
    if not Path(require_path("file", file)).is_file():
        fault = "is a folder" if Path(file).is_dir() else "no such file"
        raise InvalidFile(f"{file}: {fault}; write one with save_pushes or planar-pushing convert")
    refuse_raw(Path(file))
    try:
        with read_dataset(file) as dataset:
            return require_pushes(dataset.load())
    except InvalidValue as error:
        raise InvalidFile(f"{file}: {error}") from None
    except InvalidFile:
        kind = FORMATS.get(Path(file).suffix.lower())
        remedy = (
            f"convert it with planar-pushing convert {kind}" if kind
            else "write one with save_pushes or planar-pushing convert"
        )  # fmt: skip
        raise InvalidFile(f"{file}: is not a netCDF4 file of pushes; {remedy}") from None
