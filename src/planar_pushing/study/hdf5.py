"""Read a netCDF4 file as the HDF5 file that it is: the same dataset as through xarray's own reader.

h5netcdf looks an object up some forty times for each variable, which made reading the slowest part of
many jobs. The decoding of fill values, flags and coordinates stays xarray's.
"""

from __future__ import annotations

from typing import Any

import h5py
import numpy as np
import xarray as xr

#: How the netCDF4 format marks a dimension that has no coordinate.
BARE = b"This is a netCDF dimension but not a netCDF variable"
#: Attributes of the formats themselves.
FORMAT = {"CLASS", "NAME", "DIMENSION_LIST", "REFERENCE_LIST", "_NCProperties"}


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
    text = h5py.check_string_dtype(node.dtype) is not None
    values = node.asstr()[()].astype(str) if text else node[()]
    return xr.Variable(_dims(node), values, attributes(node))


def read_variables(file: h5py.File, group: str | None) -> xr.Dataset:
    """The variables of a file's root, or of a group, in memory.

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
