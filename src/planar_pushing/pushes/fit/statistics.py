"""Statistics of model errors: medians, percentiles, and comparisons with the reference."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.mechanics.plane import Array
from planar_pushing.pushes.fit.scores import REFERENCE
from planar_pushing.pushes.logs.measured import Index

#: Ends of the intervals, in percent.
ENDS = (2.5, 97.5)
#: Variables and their descriptions.
VARIABLES = {
    "median": "median error",
    "percentile_90": "90th percentile of the error",
    "ratio": "median error divided by that of the reference",
    "ratio_90": "90th percentile of the error divided by that of the reference",
    "difference": "median of the paired differences from the errors of the reference",
}
#: Variables that cannot be negative.
POSITIVE = ("median", "percentile_90", "ratio", "ratio_90")


def statistics(
    error: xr.DataArray, resamples: int = 1000, seed: int = 0, model: str = REFERENCE
) -> xr.Dataset:
    """Statistics of errors over (quantity, model, push), relative to a model, with intervals over `bound`.

    For each quantity and model, they include the pushes for which both the model and the reference have an
    error. The intervals contain 95 percent of the statistics of resampled pushes; all models share the same
    resamples.
    """
    values = error.transpose("quantity", "model", "push").values
    reference = list(error["model"].values).index(model)
    count = values.shape[2]
    draws = np.random.default_rng(seed).random((resamples, count))
    shape = values.shape[:2]
    values_by_name: dict[str, Any] = {name: np.full(shape, np.nan) for name in VARIABLES}
    ends: dict[str, Any] = {name: np.full((*shape, 2), np.nan) for name in VARIABLES}
    for cell in np.ndindex(shape):
        errors, other = values[cell], values[cell[0], reference]
        both = np.isfinite(errors) & np.isfinite(other)
        if not both.any():
            continue
        sample = _statistics(errors[both][None], other[both][None])
        index = (draws[:, : both.sum()] * both.sum()).astype(int)
        again = _statistics(errors[both][index], other[both][index])
        for name in VARIABLES:
            values_by_name[name][cell] = sample[name][0]
            ends[name][cell] = np.percentile(again[name], ENDS)
    return _dataset(error, values_by_name, ends)


def split_statistics(
    errors: xr.DataArray, resampled: xr.DataArray, draws: Index, model: str = REFERENCE
) -> xr.Dataset:
    """Means over splits of the statistics of errors, with intervals from splits of resampled pushes.

    Parameters
    ----------
    errors, resampled : xarray.DataArray
        Errors over (split, quantity, model, push) of divisions of all pushes, and of pushes drawn with
        replacement; NaN if a push was not drawn.
    draws : ndarray of int, shape (splits, pushes)
        How often each push was drawn.
    model : str
        The reference.

    Returns
    -------
    xarray.Dataset
        Like that of `statistics`; an error is the mean over the splits. The results of the resamples are
        moved to the mean over the splits, those of positive statistics by a factor, before the 2.5th and
        the 97.5th percentile are taken.
    """
    shape, ones = errors.shape[1:3], np.ones_like(draws)
    values: dict[str, Any] = {name: np.full(shape, np.nan) for name in VARIABLES}
    ends: dict[str, Any] = {name: np.full((*shape, 2), np.nan) for name in VARIABLES}
    reference = list(errors["model"].values).index(model)
    for cell in np.ndindex(shape):
        rows, others = (cell[0], cell[1]), (cell[0], reference)
        if not np.isfinite(errors.values[:, *rows] + errors.values[:, *others]).any():
            continue
        sample = _by_split(errors.values[:, *rows], errors.values[:, *others], ones)
        again = _by_split(resampled.values[:, *rows], resampled.values[:, *others], draws)
        for name in VARIABLES:
            values[name][cell] = mean = sample[name].mean()
            ends[name][cell] = np.percentile(
                _center(again[name], mean, name in POSITIVE), ENDS, method="weibull"
            )
    dataset = _dataset(errors.mean("split"), values, ends)
    dataset["split_error"] = errors.assign_attrs(long_name="error in each split")
    dataset["resampled_error"] = resampled.assign_attrs(
        long_name="error in each split of resampled pushes"
    )
    text = "number of times that the resample of a split contains the push"
    dataset["draws"] = ("split", "push"), draws, {"long_name": text}
    return dataset


def _by_split(errors: Array, other: Array, counts: Index) -> dict[str, Array]:
    """Statistics of each split of pushes that count several times, where both errors are known."""
    rows = []
    for row, reference, count in zip(errors, other, counts, strict=True):
        number = np.where(np.isfinite(row) & np.isfinite(reference), count, 0)
        rows.append(_statistics(np.repeat(row, number)[None], np.repeat(reference, number)[None]))
    return {name: np.array([row[name][0] for row in rows]) for name in VARIABLES}


def _center(values: Array, mean: float, is_positive: bool) -> Array:
    """Values moved so that their mean is another one; positive ones by a factor."""
    if is_positive and values.mean() > 0.0:
        return np.asarray(values * (mean / values.mean()))
    return np.asarray(values + (mean - values.mean()))


def _dataset(error: xr.DataArray, values: dict[str, Any], ends: dict[str, Any]) -> xr.Dataset:
    """Errors, and their statistics with intervals."""
    dims = ("quantity", "model")
    variables: dict[str, Any] = {"error": error}
    for name, text in VARIABLES.items():
        variables[name] = dims, values[name], {"long_name": text}
        variables[f"{name}_interval"] = (
            (*dims, "bound"), ends[name], {"long_name": f"95 percent interval of the {text}"},
        )  # fmt: skip
    return xr.Dataset(variables, {"bound": ["low", "high"]})


def _statistics(errors: Array, other: Array) -> dict[str, Array]:
    """Statistics of rows of pushes."""
    median, reference = np.median(errors, axis=1), np.median(other, axis=1)
    tail, reference_tail = (np.percentile(rows, 90.0, axis=1) for rows in (errors, other))
    return {
        "median": median, "percentile_90": tail, "ratio": median / reference,
        "ratio_90": tail / reference_tail, "difference": np.median(errors - other, axis=1),
    }  # fmt: skip
