"""Logs as tables with one row per instant."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pandas as pd
import xarray as xr

from planar_pushing.terms.errors import InvalidValue


def to_pandas(log: xr.Dataset) -> pd.DataFrame:
    """Convert a log to a table with one row per instant.

    Parameters
    ----------
    log : xarray.Dataset
        Log returned by `simulate`, or read from its file.

    Returns
    -------
    pandas.DataFrame
        Table with the index `time`, in the log's units. A variable with components has one column for each:
        `position_x`, `position_y`, `twist_v_x`, ..., `dissipated_support_friction`. Flags (`mode`, `event`,
        `outcome`) are categories with their names.

    Raises
    ------
    InvalidValue
        If the dataset is not a log.
    """
    if not isinstance(log, xr.Dataset) or "time" not in log.dims or "time" not in log.coords:
        raise InvalidValue(
            "log", type(log).__name__, "a log of simulate, over time",
            "for a batch, use xarray's to_dataframe",
        )  # fmt: skip
    over_time = [name for name, variable in log.data_vars.items() if "time" in variable.dims]
    columns = {name: column for each in over_time for name, column in _columns(log[each])}
    return pd.DataFrame(columns, index=pd.Index(log["time"].values, name="time"))


def _columns(variable: xr.DataArray) -> Iterator[tuple[str, Any]]:
    """Columns of a variable, by name."""
    components = [dim for dim in variable.dims if dim != "time"]
    if not components:
        yield str(variable.name), _named(variable)
        return
    for label in variable[components[0]].values:
        yield f"{variable.name}_{label}", variable.sel({components[0]: label}).values


def _named(variable: xr.DataArray) -> Any:
    """Values of a variable; flags are replaced by their names."""
    if "flag_meanings" not in variable.attrs:
        return variable.values
    names = variable.attrs["flag_meanings"].split()
    flags = [int(flag) for flag in variable.attrs["flag_values"]]
    codes = [flags.index(int(value)) for value in variable.values]
    return pd.Categorical.from_codes(codes, categories=names)
