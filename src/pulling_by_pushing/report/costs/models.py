"""Numbers of the report about what leaving out an effect changes, from runs with and without it."""

from __future__ import annotations

import numpy as np
import xarray as xr

from planar_pushing.assessment.estimate import FACTOR

#: Error that the prose calls small, m.
TOLERANCE = 1e-3


def _median(errors: xr.Dataset, support: str, left_out: str) -> xr.DataArray:
    """Median over the pushes of the error on a support."""
    median: xr.DataArray = errors.pose_error.sel(support=support, left_out=left_out).median("push")
    return median


def speed_in_centimeters(errors: xr.Dataset, speed: float) -> float:
    """A speed of the dataset, cm/s."""
    return 1e2 * float(errors.speed.sel(speed=speed))


def small_error(errors: xr.Dataset) -> float:
    """Error that the prose calls small, mm."""
    return 1e3 * TOLERANCE


def first_error(errors: xr.Dataset, support: str, speed: float) -> float:
    """Error of the first push without inertia on a support at a speed, mm."""
    pushed = errors.pose_error.sel(support=support, left_out="inertia", speed=speed)
    return 1e3 * float(pushed.isel(push=0))


def crossing(errors: xr.Dataset, support: str, left_out: str) -> float:
    """Speed at which the median error without an effect on a support is a millimeter, m/s.

    Between the speeds of the dataset, the logarithm of the error is linear in that of the speed.
    """
    median = _median(errors, support, left_out)
    logarithms = np.log(median.values / TOLERANCE)
    (before, *_) = np.flatnonzero(np.diff(np.signbit(logarithms)))
    span = slice(before, before + 2)
    order = np.argsort(logarithms[span])
    speeds = np.log(median.speed.values[span])
    return float(np.exp(np.interp(0.0, logarithms[span][order], speeds[order])))


def slowest(errors: xr.Dataset) -> float:
    """Slowest speed, mm/s."""
    return 1e3 * float(errors.speed.min())


def evaluations_ratio(errors: xr.Dataset) -> float:
    """Median ratio of the evaluations with friction and inertia to friction alone at the slowest speed."""
    both = errors.evaluations.sel(speed=errors.speed.min())
    return float((both / errors.evaluations_alone.sel(left_out="inertia")).median())


def random_pushes(estimates: xr.Dataset) -> float:
    """Number of random pushes."""
    return float(estimates.sizes["push"])


def largest_ratio(estimates: xr.Dataset) -> float:
    """Largest error divided by its estimate."""
    return float((estimates.pose_error / estimates.estimate).max())


def percentage_settled(estimates: xr.Dataset) -> float:
    """Percentage of the errors that the estimate tells to be at most a millimeter."""
    return 100.0 * float(_told_small(estimates).mean())


def count_missed(estimates: xr.Dataset) -> float:
    """Number of the errors above a millimeter that the estimate tells to be at most this."""
    return float((_told_small(estimates) & (estimates.pose_error > TOLERANCE)).sum())


def _told_small(estimates: xr.Dataset) -> xr.DataArray:
    is_small: xr.DataArray = FACTOR * estimates.estimate <= TOLERANCE
    return is_small
