"""Calls of the kernels of the core: flat rows of numbers in, flat rows of numbers out."""

from __future__ import annotations

import importlib
import pkgutil
from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np
import numpy.typing as npt

from planar_pushing import core

Array = npt.NDArray[np.float64]


@cache
def _kernel(name: str) -> Callable[..., None]:
    for module in pkgutil.iter_modules(core.__path__, f"{core.__name__}."):
        found = getattr(importlib.import_module(module.name), name, None)
        if found is not None and found.__module__ == module.name:
            return found  # type: ignore[no-any-return]
    raise AttributeError(name)


def run(name: str, data: Any, rows: Any, width: int) -> Array:
    """Results of a kernel, shape (len(rows), width), for rows of numbers and the data that they share."""
    table = np.ascontiguousarray(rows, dtype=float)
    results = np.zeros((len(table), width))
    flat = [
        memoryview(np.ascontiguousarray(each, dtype=float).reshape(-1))
        for each in (data, table, results)
    ]
    if len(table):
        _kernel(name)(flat[0], flat[1], *table.shape, flat[2], width)
    return results
