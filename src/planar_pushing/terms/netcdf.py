"""netCDF4 files: written completely or not at all, with one-line errors for damaged files."""

from __future__ import annotations

import math
import os
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import Any, Literal

import h5py
import numpy as np
import xarray as xr
from h5netcdf.attrs import Attributes

from planar_pushing.terms.errors import InvalidFile, PlanarPushingError
from planar_pushing.terms.replacing import PathLike, replacing

ENGINE: Literal["h5netcdf"] = "h5netcdf"
#: Minimum size in bytes, one page, for which a variable gains from compression.
SMALL = 4096
#: Maximum number of values in a separately compressed piece, and the compression level.
STORED, LEVEL = 2**15, 1
#: Size in bytes above which a dataset is read on demand; a smaller one is read whole in less time.
LARGE = 2**26
#: Remedy for a file that is not netCDF4, for readers who expect a dataset.
REBUILD = "give a dataset, or rebuild a damaged one"


def write_dataset(built: xr.Dataset | dict[str, xr.Dataset], path: PathLike) -> None:
    """Write a dataset, or several as groups of one file, completely or not at all.

    The bytes of the file depend only on the content, unless dask reads the dataset.
    """
    groups = {"/": built} if isinstance(built, xr.Dataset) else built
    # Drop encodings inherited from other files.
    plain = {name: dataset.drop_encoding() for name, dataset in groups.items()}
    tree = xr.DataTree.from_dict(
        {name: dataset.assign_attrs(_attributes(dataset.attrs)) for name, dataset in plain.items()}
    )
    encoding = {
        node.path: {name: _encoding(variable) for name, variable in node.variables.items()}
        for node in tree.subtree
    }
    with replacing(path) as temporary:
        tree.to_netcdf(temporary, engine=ENGINE, encoding=encoding)


def _attributes(attrs: Mapping[Any, Any]) -> dict[Any, Any]:
    """Attributes with integers of 32 bits if they fit, since not every reader has attributes of 64."""
    limits = np.iinfo(np.int32)
    return {
        name: np.int32(value)
        if isinstance(value, (int, np.int64)) and limits.min <= value <= limits.max
        else value
        for name, value in attrs.items()
    }


def _encoding(variable: xr.Variable) -> dict[str, Any]:
    """Encoding without a fill value; numbers are compressed if that saves space."""
    chunks = stored_chunks(variable.shape, variable.dtype)
    layout = {"zlib": True, "complevel": LEVEL, "chunksizes": chunks} if chunks else {}
    return {"_FillValue": None} | layout


def stored_chunks(lengths: Sequence[int], dtype: np.dtype[Any]) -> tuple[int, ...] | None:
    """Shape of the compressed pieces of a variable; None without compression."""
    small = dtype.kind in "OU" or math.prod(lengths) * dtype.itemsize < SMALL
    return None if small else block_shape(lengths, STORED)


def block_shape(lengths: Sequence[int], most: int) -> tuple[int, ...]:
    """Shape of a block of at most `most` points: whole inner dimensions, a power of two, then ones."""
    shape: list[int] = []
    for length in reversed(lengths):
        fits = length <= most
        shape.append(length if fits else 1 << (most.bit_length() - 1))
        most = max(most // max(length, 1), 1) if fits else 1
    return tuple(reversed(shape))


@contextmanager
def reading(path: PathLike, remedy: str = REBUILD) -> Iterator[None]:
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
        raise InvalidFile(f"{path}: is not a netCDF4 file{reason}; {remedy}") from None


@contextmanager
def _root(path: PathLike, remedy: str = REBUILD) -> Iterator[h5py.File]:
    """Open a file of which only names and attributes of the root are read, not all of its variables."""
    with reading(path, remedy), h5py.File(path, "r") as file:
        dict(file.attrs)  # finds damage
        yield file


def read_attributes(path: PathLike) -> dict[str, object]:
    """Read only the root attributes of a file; errors as in `read_dataset`."""
    with _root(path) as file:
        return dict(Attributes(file.attrs, np.dtype, h5py))


class _File(h5py.File):  # type: ignore[misc]
    """A file that keeps its objects: h5netcdf looks for a variable and its axes 40 times to read it."""

    def __init__(self, path: PathLike) -> None:
        super().__init__(path, "r")
        self.path = path  # names the source of a dataset in xarray
        self._kept: dict[str, Any] = {}

    def __getitem__(self, name: Any) -> Any:
        if not isinstance(name, str):
            return super().__getitem__(name)  # of a reference
        if name not in self._kept:
            self._kept[name] = super().__getitem__(name)
        return self._kept[name]


def read_dataset(path: PathLike, group: str | None = None, *, remedy: str = REBUILD) -> xr.Dataset:
    """Read a dataset into memory and close its file; a dataset above 64 MB is read on demand.

    Parameters
    ----------
    path : path
    group : str, optional
        Group to read, by default the root.
    remedy : str
        What to do if the file is not netCDF4.

    Raises
    ------
    InvalidFile
        If the file is missing, is not netCDF4, or has no such group.
    """
    if group not in (None, *group_names(path, remedy)):
        raise InvalidFile(f"{path}: has no group {group!r}; delete it and build it again")
    with reading(path, remedy):
        with _File(path) as file, _open(file, group) as opened:
            if opened.nbytes <= LARGE:
                return opened.load()
        return _open(path, group)


def _open(file: PathLike | _File, group: str | None) -> xr.Dataset:
    # An HDF5 file that is not netCDF4 has no named dimensions. No dataset holds dates.
    return xr.open_dataset(
        file, engine=ENGINE, group=group, phony_dims="access", decode_times=False
    )


def group_names(path: PathLike, remedy: str = REBUILD) -> list[str]:
    """Names of a file's groups, in order; errors as in `read_dataset`."""
    with _root(path, remedy) as file:
        return sorted(name for name in file if file.get(name, getclass=True) is h5py.Group)
