"""The kernels of the core, compiled or as plain Python, with arrays in and out.

The compiled module stores the digest of the sources from which it was built. If they have changed since, if
there is no compiled module, or if its arithmetic is not that of the source, the sources run as plain
Python, with a warning. The environment variable ``PLANAR_PUSHING_PLAIN=1`` selects plain Python without a
warning.
"""

from __future__ import annotations

import functools
import importlib
import os
import warnings
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
import numpy.typing as npt

from planar_pushing.core import FOLDER, MODULES, digest, keeps_bits
from planar_pushing.terms.errors import PlainCoreWarning

Array = npt.NDArray[np.float64]
Kernel = Callable[..., None]
CORE = digest.__module__


def run(name: str, data: npt.ArrayLike, rows: npt.ArrayLike, width: int) -> Array:
    """Results of a kernel, one row for each row of inputs.

    Parameters
    ----------
    name : str
        A function of the core whose arguments are data, rows, count, columns, results and width.
    data : array_like, shape (n,)
        Numbers that all rows share.
    rows : array_like, shape (count, columns)
    width : int
        How many numbers the kernel writes for each row.

    Returns
    -------
    ndarray, shape (count, width)
        NaN where the kernel writes nothing.
    """
    data = np.ascontiguousarray(data, np.float64)
    rows = np.ascontiguousarray(rows, np.float64)
    results = np.empty((len(rows), width))
    results.fill(np.nan)
    run_into(name, data, rows, results)
    return results


def run_into(name: str, data: Array, rows: Array, results: Array) -> None:
    """Call a kernel with results in and out, one row for each row of inputs.

    Parameters
    ----------
    name : str
        As in `run`.
    data, rows, results : ndarray
        Contiguous; results have shape (count, width). A kernel can continue from earlier results.
    """
    (count, columns), width = rows.shape, results.shape[1]
    if COMPILED is not None:
        COMPILED[name](data, rows, count, columns, results, width)
    else:
        # The numbers of a memory view are Python floats; those of an array are numpy scalars.
        numbers, inputs, outputs = map(_flat, (data, rows, results))
        plain_kernel(name)(numbers, inputs, count, columns, outputs, width)


def _flat(array: Array) -> memoryview:
    """A flat memory view of an array, without a copy."""
    flat: Any = array.reshape(-1)
    return memoryview(flat)


@functools.cache
def plain_kernel(name: str) -> Kernel:
    """The Python function of a kernel, from the module of the core that defines it."""
    for path in MODULES:
        parts = path.relative_to(FOLDER).with_suffix("").parts
        module = importlib.import_module(".".join([CORE, *parts]))
        if hasattr(module, name):
            kernel: Kernel = getattr(module, name)
            return kernel
    raise LookupError(f"no function {name} in {CORE}")


def load_kernels() -> Mapping[str, Kernel] | None:
    """The compiled kernels by name; none, with a warning, if they are missing, out of date or inexact."""
    if os.environ.get("PLANAR_PUSHING_PLAIN", "") not in ("", "0"):
        return None
    try:
        compiled = importlib.import_module(f"{CORE}._compiled")
    except ModuleNotFoundError:
        reason = "it is not compiled"
        remedy = "install a C compiler and Python's headers, then install the package again"
    except ImportError as error:
        reason, remedy = f"it cannot be loaded ({error})", "install the package again"
    else:
        if digest() != compiled.DIGEST or not hasattr(compiled, "probe"):
            reason, remedy = "it has changed since it was compiled", "compile it"
        elif not keeps_bits(compiled.probe):
            reason = "compiled, it rounds in another way, or drops subnormal numbers"
            remedy = "compile it without options such as -ffast-math, here and in other libraries"
        else:
            kernels: Mapping[str, Kernel] = compiled.KERNELS
            return kernels
    slower = "the core runs as plain Python, about 100 times slower"
    message = f"{slower}, as {reason}; {remedy} (in a clone: make)"
    warnings.warn(PlainCoreWarning(message), stacklevel=2)
    return None


COMPILED = load_kernels()
