"""From public arguments to kernels of the core and back: floats, numpy arrays and `xarray.DataArray`.

A kernel is a loop over the rows of an array, one row per scene. Arguments are broadcast (by name if their
dimensions are named, lazily if they are lazy), cut into blocks of rows, and mapped by threads.
"""

from __future__ import annotations

import math
import os
import sys
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextvars import ContextVar
from dataclasses import fields
from threading import Event
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.kernels.calls import run
from planar_pushing.terms.errors import InvalidValue
from planar_pushing.terms.numbers import Array
from planar_pushing.terms.options import FLAGS
from planar_pushing.terms.quantities import MECHANICS, TWIST, TWIST_UNITS, attributes
from planar_pushing.terms.signals import interrupts_raise_after

#: Rows per block: 1 to 100 ms of work, so that Ctrl-C is noticed and threads cost little.
BLOCK = 32768
#: Number of cores that calls may use, if the caller sets one; all by default.
CORES: ContextVar[int] = ContextVar("CORES")


class Output(NamedTuple):
    """Name of a result, its dimensions after the broadcast ones with their sizes, and its type."""

    name: str
    tail: tuple[tuple[str, int], ...] = ()
    dtype: str = "f8"


#: Writes outputs from the results of a kernel, shape (n, width), and the columns of its rows.
Decode = Callable[[Array, Sequence[Any], Sequence[npt.NDArray[Any]]], None]


def map_kernel(
    kernel: str, data: Array, columns: Sequence[Any], outputs: Sequence[Output],
    width: int = 0, decode: Decode | None = None,
) -> list[npt.NDArray[Any]]:  # fmt: skip
    """Results of a kernel for blocks of rows, on all cores.

    Parameters
    ----------
    kernel : str
        Its name.
    data : ndarray
        Numbers that all rows share.
    columns : sequence of array_like
        The columns of a row, broadcast together to shape S.
    outputs : sequence of Output
    width : int, optional
        Width of a row of results, by default that of the outputs.
    decode : callable, optional
        Writes the outputs of a block; by default a row of results holds them one after the other.

    Returns
    -------
    list of ndarray
        One per output, shape S + its tail.
    """
    arrays = [np.asarray(column, dtype=float) for column in columns]
    shape = np.broadcast_shapes(*(array.shape for array in arrays))
    size = math.prod(shape)
    tails = [tuple(length for _, length in output.tail) for output in outputs]
    filled = [np.empty((size, *t), o.dtype) for o, t in zip(outputs, tails, strict=True)]
    flat = [_flat(array, shape) for array in arrays]
    width = width or sum(math.prod(tail) for tail in tails)
    decode = decode or _split_results

    def block(start: int) -> None:
        part = slice(start, min(start + BLOCK, size))
        block_columns = [column[part] if column.ndim else column for column in flat]
        rows = np.empty((part.stop - start, len(flat)))
        for i, column in enumerate(block_columns):
            rows[:, i] = column
        results = run(kernel, data, rows, width)
        decode(results, block_columns, [array[part] for array in filled])

    starts = range(0, size, BLOCK)
    if len(starts) > 1:
        in_threads(block, starts)
    elif size:
        block(0)
    return [array.reshape(shape + tail) for array, tail in zip(filled, tails, strict=True)]


def _split_results(
    results: Array, columns: Sequence[Any], outputs: Sequence[npt.NDArray[Any]]
) -> None:
    """Write outputs that follow one another in the results."""
    first = 0
    for output in outputs:
        last = first + math.prod(output.shape[1:])
        output[...] = results[:, first:last].reshape(output.shape)
        first = last


def _flat(array: Array, shape: tuple[int, ...]) -> Array:
    """An array broadcast to a shape and flattened; a scalar is returned unchanged."""
    if array.shape == shape or not array.ndim:
        return array.reshape(-1) if array.ndim else array
    return np.broadcast_to(array, shape).reshape(-1)


def in_threads(
    block: Callable[[int], None], starts: Sequence[int], interrupted: Event | None = None
) -> None:
    """Call a function for each start on all cores.

    Ctrl-C takes effect when the current calls end, which can watch the event that is set then.
    """
    cores = CORES.get(os.cpu_count() or 1)
    if cores == 1 or len(starts) == 1:
        for start in starts:
            block(start)
        return
    stopped = Event() if interrupted is None else interrupted

    def block_unless_stopped(start: int) -> None:
        if not stopped.is_set():
            block(start)

    with interrupts_raise_after(stopped.set), ThreadPoolExecutor(cores) as pool:
        try:
            for _ in pool.map(block_unless_stopped, starts):
                pass
        except BaseException:
            stopped.set()
            raise


def is_labeled(value: object) -> bool:
    """Whether a value is a DataArray, without importing xarray."""
    xarray = sys.modules.get("xarray")
    return xarray is not None and isinstance(value, xarray.DataArray)


def elementwise(
    function: Callable[..., list[npt.NDArray[Any]]],
    arguments: Sequence[Any],
    outputs: Sequence[Output],
) -> list[Any]:
    """Results of a function of arrays, of the type of the arguments: floats, arrays or DataArrays.

    Parameters
    ----------
    function : callable
        Takes arrays that broadcast to shape S and returns one array per output, shape S + its tail.
    arguments : sequence of float, array_like or DataArray
    outputs : sequence of Output
    """
    if not any(map(is_labeled, arguments)):
        require_alike(arguments)
        results = function(*arguments)
        return [result.item() if result.ndim == 0 else result for result in results]
    import xarray as xr

    labeled = xr.apply_ufunc(
        lambda *values: tuple(function(*values)) if len(outputs) > 1 else function(*values)[0],
        *arguments,
        output_core_dims=[[dim for dim, _ in output.tail] for output in outputs],
        dask="parallelized",
        output_dtypes=[output.dtype for output in outputs],
        dask_gufunc_kwargs={"output_sizes": dict(d for output in outputs for d in output.tail)},
        keep_attrs=False,
    )
    arrays = labeled if isinstance(labeled, tuple) else (labeled,)
    return [label_result(output.name, array) for array, output in zip(arrays, outputs, strict=True)]


def require_alike(arguments: Sequence[Any]) -> None:
    """Refuse arrays that do not broadcast together, or labeled ones beside others or of several sizes."""
    labeled = [argument for argument in arguments if is_labeled(argument)]
    if labeled:
        _require_labels(labeled, [np.shape(a) for a in arguments if not is_labeled(a)])
        return
    shapes = [np.shape(argument) for argument in arguments if type(argument) is not float]
    if not any(shapes):
        return
    try:
        np.broadcast_shapes(*shapes)
    except ValueError:
        text = " and ".join(map(str, dict.fromkeys(shape for shape in shapes if shape)))
        raise InvalidValue(
            "shapes", text, "arrays that broadcast against one another",
            "give each its own axis, as in x[:, None], or label the axes with xarray.DataArray",
        ) from None  # fmt: skip


def _require_labels(labeled: Sequence[Any], shapes: Sequence[tuple[int, ...]]) -> None:
    """Refuse a dimension of several sizes or labels, and the shape of an array without labels."""
    sizes = {(str(name), size) for array in labeled for name, size in array.sizes.items()}
    names = [name for name, _ in sizes]
    several = sorted(f"{name}: {size}" for name, size in sizes if names.count(name) > 1)
    if several:
        raise InvalidValue(
            "shapes",
            ", ".join(several),
            "one size of each dimension",
            "rename one of the dimensions",
        )
    indexes: dict[Any, Any] = {}
    for name, index in (pair for array in labeled for pair in array.indexes.items()):
        if not indexes.setdefault(name, index).equals(index):
            raise InvalidValue(
                "shapes", f"different labels of {name}", "the same labels of each dimension",
                "select those that all arrays have, as xarray.align does, or rename a dimension",
            )  # fmt: skip
    unlabeled = [shape for shape in shapes if shape]
    if unlabeled:
        raise InvalidValue(
            "shapes", unlabeled[0], "labeled arrays, beside one with labels",
            "also give this array as an xarray.DataArray",
        )  # fmt: skip


def broadcast_numbers(*numbers: Any) -> list[Any]:
    """Numbers and arrays, repeated to their common shape; labeled ones over all of their dimensions."""
    if not any(map(is_labeled, numbers)):
        return [np.array(array) for array in np.broadcast_arrays(*numbers)]
    import xarray as xr

    labeled = [number if is_labeled(number) else xr.DataArray(number) for number in numbers]
    return [array.copy() for array in xr.broadcast(*labeled)]


def evaluate_kernel(
    kernel: str, data: Array, columns: Sequence[Any], outputs: Sequence[Output],
    width: int = 0, decode: Decode | None = None,
) -> list[Any]:  # fmt: skip
    """Results of a kernel that is called by `map_kernel`, in the types of `elementwise`."""
    return elementwise(
        lambda *values: map_kernel(kernel, data, values, outputs, width, decode), columns, outputs
    )


def label_result(name: str, value: Any) -> Any:
    """A result, with its name, units and flags if it is labeled."""
    if not is_labeled(value):
        return value
    flags = flag_attributes(FLAGS[name]) if name in FLAGS else {}
    return value.rename(name).assign_attrs(attributes(MECHANICS, name) | flags)


def flag_attributes(names: Mapping[str, int], dtype: npt.DTypeLike = np.int8) -> dict[str, Any]:
    """Attributes of a variable of flags, by the CF conventions."""
    return {
        "flag_values": np.array([int(number) for number in names.values()], dtype),
        "flag_meanings": " ".join(names),
    }


def component_labels() -> dict[str, Any]:
    """Coordinates of vectors and twists: the labels of their components, and the units of a twist."""
    twist = "twist_component"
    return {"xy": ["x", "y"], twist: list(TWIST), "twist_unit": (twist, list(TWIST_UNITS))}


def same(one: Any, other: Any) -> Any:
    """Whether two values of one dataclass hold the same numbers: a single answer, even for arrays.

    Labels must also be the same. NaN equals NaN.
    """
    if type(one) is not type(other):
        return NotImplemented
    names = [field.name for field in fields(one) if field.compare]
    return all(_are_same(getattr(one, name), getattr(other, name)) for name in names)


def _are_same(one: Any, other: Any) -> bool:
    if isinstance(one, (tuple, list)) and isinstance(other, (tuple, list)):
        return len(one) == len(other) and all(map(_are_same, one, other))
    if is_labeled(one) or is_labeled(other):
        return is_labeled(one) and bool(one.equals(other))
    if hasattr(one, "shape") or hasattr(other, "shape"):
        floats = np.asarray(one).dtype.kind == "f"
        return bool(np.array_equal(one, other, equal_nan=floats))
    return bool(one == other or (one != one and other != other))


def dataset(arrays: Sequence[Any]) -> Any:
    """Named DataArrays of one call as a dataset, without alignment because they share coordinates."""
    return arrays[0].to_dataset().assign({array.name: array.variable for array in arrays})
