"""Numbers of the report: the source, unit and digits of each."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.terms.errors import InvalidValue
from pulling_by_pushing.report.results import Results

Read = Callable[[Results], float | str]
NOWHERE: Mapping[str, float | str] = {}


@dataclass(frozen=True, slots=True, kw_only=True)
class Quantity:
    """A number of the prose.

    Attributes
    ----------
    read : callable
        Function that reads the number from the results; it can also return text.
    digits : int
        Digits after the decimal point.
    unit : str
        "1", "degree", "percent", or a unit of the datasets; "name" for text.
    source : str
        Result file, and the location of the number in it.
    """

    read: Read
    digits: int
    unit: str
    source: str

    def entry(self, results: Results) -> dict[str, str]:
        """Text, unit and source for the report's table of numbers."""
        value = self.read(results)
        text = value if isinstance(value, str) else decimal_text(value, self.digits)
        return {"text": text, "unit": self.unit, "source": self.source}


#: Quantities by key.
Numbers = dict[str, Quantity]


def decimal_text(value: float, digits: int) -> str:
    """Value with the given number of digits after the decimal point; a rounded zero has no sign.

    Raises
    ------
    InvalidValue
        If the value is not finite and therefore cannot be printed.
    """
    if not np.isfinite(value):
        raise InvalidValue("value", value, "a finite number", "read another number of the results")
    text = f"{value:.{digits}f}"
    return text.lstrip("-") if float(text) == 0 else text


def significant(value: float, digits: int = 2) -> str:
    """Value with significant digits, as a power of ten if it is below 0.01 or above 99,999."""
    scaled = f"{value:.{digits - 1}e}"
    power = int(scaled.partition("e")[2])
    plain = value == 0 or -2 <= power <= 4
    return f"{value:.{max(0, digits - 1 - power)}f}" if plain else scaled


def pick(
    dataset: str,
    variable: str,
    location: Mapping[str, float | str] = NOWHERE,
    *,
    digits: int = 2,
    unit: str = "degree",
) -> Quantity:
    """One value of a dataset at these coordinates, or at these indices of axes without coordinates."""

    def read(results: Results) -> float:
        return float(select_value(results.dataset(dataset)[variable], location).item())

    coordinates = ", ".join(f"{axis}={value}" for axis, value in location.items())
    source = f"{dataset}: {variable}" + (f" at {coordinates}" if coordinates else "")
    return Quantity(read=read, digits=digits, unit=unit, source=source)


def select_value(variable: xr.DataArray, location: Mapping[str, float | str]) -> xr.DataArray:
    """Select by coordinate, or by index along axes without coordinates."""
    values = {axis: value for axis, value in location.items() if axis in variable.coords}
    indices = {axis: int(index) for axis, index in location.items() if axis not in values}
    return variable.sel(values).isel(indices)


def compute_number(
    dataset: str, compute: Callable[..., float], *arguments: Any, digits: int = 0, unit: str = "1"
) -> Quantity:
    """Number computed by a function from a dataset and other arguments; its docstring is the source."""

    def read(results: Results) -> float:
        return compute(results.dataset(dataset), *arguments)

    what = (compute.__doc__ or "").partition("\n")[0].rstrip(".")
    return Quantity(read=read, digits=digits, unit=unit, source=f"{dataset}: {what}")


def magnitude(
    dataset: str, compute: Callable[..., float], *arguments: Any, unit: str = "1", digits: int = 1
) -> Quantity:
    """As `compute_number`, with the given number of significant digits after the first."""
    number = compute_number(dataset, compute, *arguments, unit=unit)

    def read(results: Results) -> str:
        return significant(compute(results.dataset(dataset), *arguments), digits + 1)

    return replace(number, read=read)


def check_number(
    claim: str, check: str, *, field: str = "value", digits: int, unit: str = "1"
) -> Quantity:
    """A number found by a check of a claim."""

    def read(results: Results) -> float:
        return float(results.check(claim, check)[field])

    source = f"tables/claims.json: {field} of {check} of {claim}"
    return Quantity(read=read, digits=digits, unit=unit, source=source)


def count_claims(what: str, count: Callable[[dict[str, Any]], int]) -> Quantity:
    """Sum of a count over the claims of the ledger."""

    def read(results: Results) -> float:
        return float(sum(count(claim) for claim in results.claims["claims"]))

    return Quantity(read=read, digits=0, unit="1", source=f"tables/claims.json: {what}")
