"""What a residual says of a variable: the error of each value, and what rounding explains."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any, NamedTuple

import numpy as np
import xarray as xr

from planar_pushing.certified.doubled.numbers import Doubled, doubled

EPSILON = float(np.finfo(float).eps)
#: Degrees of a radian.
DEGREE = 180.0 / np.pi


class Finding(NamedTuple):
    """Errors of the values of a variable, and the largest that rounding explains; of its shape."""

    variable: str
    error: Any
    allowed: Any


#: Puts the values of a dataset into the equations of a study.
Residuals = Callable[[xr.Dataset, Any], Iterable[Finding]]


def relative(variable: str, stored: Any, wanted: Any, roundings: Any) -> Finding:
    """Values that follow from others, but for some roundings; infinite ones must be the same."""
    stored, wanted = np.asarray(stored, dtype=float), doubled(wanted)
    infinite = ~np.isfinite(wanted.high) | ~np.isfinite(stored)
    gap = np.abs((Doubled(stored, np.zeros_like(stored)) - wanted).value())
    error = np.where(infinite, np.where(stored == wanted.high, 0.0, np.inf), gap)
    allowed = np.where(infinite, 0.0, np.abs(wanted.high)) * (roundings * EPSILON)
    return Finding(variable, error, allowed)


def same(variable: str, stored: Any, wanted: Any) -> Finding:
    """Values that must be equal: flags, counts and what is not there (NaN)."""
    stored, wanted = np.asarray(stored), np.asarray(wanted)
    equal = stored == wanted
    if stored.dtype.kind == "f":
        equal = equal | (np.isnan(stored) & np.isnan(wanted))
    return Finding(variable, np.where(equal, 0.0, np.inf), 0.0)
