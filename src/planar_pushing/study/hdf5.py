"""Read and write a netCDF4 file as the HDF5 file that it is: the same dataset as through xarray's own way.

h5netcdf looks an object up some forty times for each variable, which made files the slowest part of
many jobs. The coding of fill values, flags and coordinates stays xarray's.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import h5py
import numpy as np
import xarray as xr
from xarray import conventions
from xarray.backends import BackendArray
from xarray.core import indexing

#: How the netCDF4 format marks a dimension that has no coordinate.
BARE = b"This is a netCDF dimension but not a netCDF variable."
#: Attributes of the formats themselves.
FORMAT = {"CLASS", "NAME", "DIMENSION_LIST", "REFERENCE_LIST", "_NCProperties"}
#: Values in a chunk at most: two megabytes of doubles fit a cache.
CHUNK = 2**18
#: A variable of fewer bytes, a page, gains nothing from compression.
SMALL = 4096
#: A variable of more bytes is read when it is used.
LARGE = 2**23


def attributes(node: h5py.Group | h5py.Dataset) -> dict[str, Any]:
    """Attributes of a file, a group or a variable, without those of the formats."""
    names = [name for name in node.attrs if name not in FORMAT and not name.startswith("_Netcdf4")]
    return {name: _plain(node.attrs[name]) for name in names}


def _plain(value: Any) -> Any:
    """An attribute as xarray gives it: an array of one element is that element."""
    if isinstance(value, np.ndarray) and value.size == 1:
        return value.item() if value.dtype.kind == "O" else value.reshape(())[()]
    return value


def _dims(node: h5py.Dataset) -> tuple[str, ...]:
    own = node.name.rpartition("/")[2]
    if node.is_scale:
        return (own,)
    scales = (node.dims[axis] for axis in range(node.ndim))
    # A file that is HDF5 and no netCDF4 names no dimensions.
    return tuple(
        scale[0].name.rpartition("/")[2] if len(scale) else f"{own}_{axis}"
        for axis, scale in enumerate(scales)
    )


def _variable(node: h5py.Dataset) -> xr.Variable:
    values: Any
    if h5py.check_string_dtype(node.dtype) is not None:
        values = np.asarray(node.asstr()[()], dtype=str)
    elif node.nbytes > LARGE:
        values = indexing.LazilyIndexedArray(_Stored(node))
    else:
        values = node[()]
    return xr.Variable(_dims(node), values, attributes(node))


class _Stored(BackendArray):
    """Values in a file, of which only those are read that are used."""

    def __init__(self, node: h5py.Dataset) -> None:
        self.place = Path(node.file.filename).resolve(), node.name
        self.shape, self.dtype = node.shape, node.dtype

    def __getitem__(self, key: indexing.ExplicitIndexer) -> Any:
        support = indexing.IndexingSupport.OUTER_1VECTOR
        return indexing.explicit_indexing_adapter(key, self.shape, support, self._read)

    def _read(self, key: tuple[Any, ...]) -> Any:
        path, name = self.place
        with h5py.File(path, "r") as file:
            return file[name][key]


def read_variables(file: h5py.File, group: str | None) -> xr.Dataset:
    """The variables of a file's root, or of a group, in memory; large ones are read when they are used.

    Raises
    ------
    KeyError
        Where there is no such group.
    """
    node = file[group] if group else file
    if not isinstance(node, h5py.Group):
        raise KeyError("a variable, not a group")
    variables = {
        name: _variable(each)
        for name, each in node.items()
        if isinstance(each, h5py.Dataset) and not each.attrs.get("NAME", b"").startswith(BARE)
    }
    return xr.decode_cf(xr.Dataset(variables, attrs=attributes(node)))


def write_variables(group: h5py.Group, dataset: xr.Dataset) -> None:
    """Write a dataset into a file's root, or into a group; each tracks the order of what it holds."""
    variables, attrs = conventions.encode_dataset_coordinates(dataset)
    for each in variables.values():
        each.encoding = {"_FillValue": None}  # every value is stored: none stands for another
    variables, attrs = conventions.cf_encoder(variables, attrs)
    _set_attributes(group, attrs)
    nodes = {str(name): _create(group, str(name), each) for name, each in variables.items()}
    for index, (dim, size) in enumerate(dataset.sizes.items()):
        title = str(dim).encode()
        if dim not in nodes:
            limit = size or None  # netCDF4 knows no fixed dimension of length 0
            nodes[str(dim)] = group.create_dataset(dim, (size,), ">f4", maxshape=(limit,))
            title = BARE + b"%10d" % size
        nodes[str(dim)].make_scale(title)
        nodes[str(dim)].attrs["_Netcdf4Dimid"] = np.int32(index)
    for name, variable in variables.items():
        for axis, dim in enumerate(variable.dims if name not in dataset.sizes else ()):
            nodes[str(name)].dims[axis].attach_scale(nodes[str(dim)])


def _create(group: h5py.Group, name: str, variable: xr.Variable) -> h5py.Dataset:
    values = variable.values
    options: dict[str, Any] = {}
    if values.dtype.kind in "OU":
        values, options["dtype"] = values.astype(object), h5py.string_dtype()
    elif values.nbytes >= SMALL:
        options |= {"chunks": _chunks(values.shape), "compression": 1, "shuffle": True}
    if 0 in values.shape:
        options["maxshape"] = tuple(size or None for size in values.shape)
    node = group.create_dataset(name, data=values, track_order=True, **options)
    _set_attributes(node, variable.attrs)
    return node


def _chunks(shape: tuple[int, ...]) -> tuple[int, ...]:
    """Trailing axes whole, as far as a chunk has room for them."""
    chunks, room = [], CHUNK
    for size in reversed(shape):
        chunks.append(max(1, min(size, room)))
        room //= chunks[-1]
    return tuple(reversed(chunks))


def _set_attributes(node: h5py.Group | h5py.Dataset, attrs: dict[Any, Any]) -> None:
    """Set attributes as netCDF4 has them: a number is an array of one."""
    for name, value in attrs.items():
        array = np.atleast_1d(value)
        text = value if isinstance(value, str) else array.tolist()
        node.attrs[str(name)] = text if array.dtype.kind == "U" else array
