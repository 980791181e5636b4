"""Statistics of model errors: medians, percentiles, and comparisons with the reference."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.mechanics.plane import Array

#: Predicted quantities, and the reference model.
QUANTITIES, REFERENCE = ("wrench", "motion", "pose"), "fitted_ellipsoid"
#: Ends of the intervals, in percent.
ENDS = (2.5, 97.5)
#: Variables and their descriptions.
VARIABLES = {
    "median": "median error",
    "percentile_90": "90th percentile of the error",
    "ratio": "median error divided by that of the reference",
    "difference": "median of the paired differences from the errors of the reference",
}


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
    dims = ("quantity", "model")
    variables: dict[str, Any] = {"error": error}
    for name, text in VARIABLES.items():
        variables[name] = dims, values_by_name[name], {"long_name": text}
        variables[f"{name}_interval"] = (
            (*dims, "bound"), ends[name], {"long_name": f"95 percent interval of the {text}"},
        )  # fmt: skip
    return xr.Dataset(variables, {"bound": ["low", "high"]})


def _statistics(errors: Array, other: Array) -> dict[str, Array]:
    """Statistics of rows of pushes."""
    median, reference = np.median(errors, axis=1), np.median(other, axis=1)
    return {
        "median": median, "percentile_90": np.percentile(errors, 90.0, axis=1),
        "ratio": median / reference, "difference": np.median(errors - other, axis=1),
    }  # fmt: skip


def angles(a: Array, b: Array) -> Array:
    """Angles between vectors of shape (n, 3) in degrees, accurate for small angles."""
    across = np.linalg.norm(np.cross(a, b), axis=1)
    return np.asarray(np.rad2deg(np.arctan2(across, (a * b).sum(axis=1))))
