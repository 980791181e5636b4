"""Numbers that users give: the one place that makes doubles of them.

Integers and single precision become doubles before any arithmetic, because sums and products of small
integers wrap around. Everything else that numpy would convert is refused.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from planar_pushing.terms.errors import InvalidValue

#: A number, a numpy array or a DataArray.
Number = Any
Array = npt.NDArray[np.float64]

#: Remedy for an array with masked entries.
MASKED = "fill the masked entries, or leave them out"


def is_lazy(value: object) -> bool:
    """Whether a value is a DataArray whose numbers are computed later."""
    return hasattr(value, "dims") and isinstance(getattr(value, "chunks", None), tuple)


def as_array(value: Any) -> Array | None:
    """An array of doubles, or None for a value that is not plain numbers.

    Parameters
    ----------
    value : object
        A number, nested lists or tuples of numbers, or an array. The index of a pandas Series is dropped.
        Not plain numbers are texts, bytes, booleans, complex numbers, dates, masked entries, other objects,
        lists of several lengths, and integers too large for a double.
    """
    try:
        if not _are_plain(value):
            return None
        with np.errstate(over="ignore"):
            return np.asarray(np.asarray(value), dtype=np.float64)
    except (TypeError, ValueError, OverflowError):
        return None


def _are_plain(value: Any) -> bool:
    """Whether a value consists of integers and floating-point numbers."""
    if isinstance(value, (list, tuple)):
        return all(map(_are_plain, value))
    if isinstance(value, (int, float)):
        return not isinstance(value, bool)
    if np.ma.is_masked(value):
        return False
    array = np.asarray(value)
    if array.dtype.kind == "O" and array.ndim:
        return all(map(_are_plain, array.ravel().tolist()))
    return array.dtype.kind in "iuf"


def as_numbers(value: Any) -> Number | None:
    """As `as_array`, but a number stays a number, and a DataArray keeps its labels."""
    if type(value) is float:
        return value
    array = as_array(value)
    if array is None:
        return None
    if hasattr(value, "dims"):
        return value if value.dtype == array.dtype else value.copy(data=array)
    if isinstance(value, (int, float)) and not isinstance(value, np.generic):
        return float(array)
    return array[()]


def require_array(name: str, value: Any, allowed: str, remedy: str) -> Array:
    """The array of `as_array`, or `InvalidValue`."""
    array = as_array(value)
    if array is None:
        raise InvalidValue(name, value, allowed, remedy_for(value, remedy))
    return array


def pair_of(value: Any) -> tuple[Any, Any] | None:
    """The two entries of a tuple, a list or a flat array of numpy; None for anything else."""
    entries = value.tolist() if isinstance(value, np.ndarray) and value.ndim == 1 else value
    if not isinstance(entries, (tuple, list)) or len(entries) != 2:
        return None
    return entries[0], entries[1]


def remedy_for(value: Any, remedy: str) -> str:
    """Remedy for a value that is not plain numbers; another one if entries are masked."""
    return MASKED if np.ma.is_masked(value) else remedy


def in_radians(degrees: Any) -> Any:
    """Radians of directions in degrees, any finite numbers; those beyond two turns lose whole turns."""
    near = np.where(np.abs(degrees) <= 720.0, degrees, np.fmod(degrees, 360.0))
    return np.deg2rad(near)[()]
