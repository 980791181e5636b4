"""Select values of a dataset by axis name."""

from __future__ import annotations

import numpy as np
import xarray as xr

from planar_pushing.terms.errors import InvalidValue
from planar_pushing.terms.netcdf import reading
from pulling_by_pushing.study.catalog import number_label


def axis_names(dataset: xr.Dataset) -> list[str]:
    """Names of axes and of labels along them that a query can use."""
    return sorted(str(name) for name, coord in dataset.coords.items() if coord.ndim == 1)


def select(dataset: xr.Dataset, wanted: dict[str, str]) -> xr.Dataset:
    """Part of a dataset in which each named axis has the requested value.

    Raises
    ------
    InvalidValue
        If there is no such axis, or no such value on it.
    """
    for name, text in wanted.items():
        if name not in axis_names(dataset):
            allowed = ", ".join(axis_names(dataset))
            raise InvalidValue(name, text, f"the axes {allowed}", "name one of the dataset's axes")
        coord = dataset.coords[name]
        value = _parse(name, text) if coord.dtype.kind == "f" else text
        found = np.flatnonzero(coord.values == value)
        if not found.size:
            raise InvalidValue(name, text, listed(coord), "choose a value of the study's grid")
        dataset = dataset.isel({coord.dims[0]: found[0] if found.size == 1 else found})
    # A large dataset is read only here, so damage to the file can first appear here.
    with reading(dataset.encoding.get("source", "the dataset")):
        return dataset.load()


def _parse(name: str, text: str) -> float:
    try:
        return float(text)
    except ValueError:
        raise InvalidValue(name, text, "a number, or inf", "give one number") from None


def listed(coord: xr.DataArray, most: int = 12) -> str:
    """Values of an axis as text; a long axis is abbreviated."""
    label = number_label if coord.dtype.kind == "f" else str
    values = list(dict.fromkeys(label(value) for value in coord.values))
    if len(values) > most:
        values = [*values[: most - 1], "...", values[-1]]
    return ", ".join(values)
