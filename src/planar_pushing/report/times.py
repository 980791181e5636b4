"""Numbers of the supplement: least times of repeated runs on one machine."""

from __future__ import annotations

import json
from collections.abc import Callable

import numpy as np
import xarray as xr

from planar_pushing.mechanics.planar import Array

NANO, MICRO, MILLI, MEGA = 1e9, 1e6, 1e3, 1e6


def machine(data: xr.Dataset) -> dict[str, str]:
    """Machine on which a dataset was measured, as it was stored."""
    found: dict[str, str] = json.loads(data.attrs["machine"])
    return found


def _least(data: xr.Dataset, times: str, name: str) -> Array:
    """Least times of a method at its last setting, seconds."""
    return np.asarray(data[times][data.method.values == name][-1].min("repeat").values)


def wrench_time(
    name: str, which: Callable[[Array], float], per: float
) -> Callable[[xr.Dataset], float]:
    """Make the function that finds an extreme over the spin ratios of a method's times.

    Times are in the unit of which a second has `per`.
    """

    def time(wrench: xr.Dataset) -> float:
        """Extreme over the spin ratios of the least time for a wrench, most accurate setting."""
        return per * float(which(_least(wrench, "wrench_seconds", name)))

    return time


def cone_time(name: str) -> Callable[[xr.Dataset], float]:
    """Make the function that finds a method's time for a motion cone."""

    def time(cone: xr.Dataset) -> float:
        """Least time for both edges of a motion cone, most accurate setting, microseconds."""
        return MICRO * float(_least(cone, "cone_seconds", name))

    return time


def cone_ratio(name: str) -> Callable[[xr.Dataset], float]:
    """Make the function that compares a method's time with that of the closed form."""

    def ratio(cone: xr.Dataset) -> float:
        """Least time for a motion cone in units of that of the closed form."""
        return cone_time(name)(cone) / cone_time("closed form")(cone)

    return ratio


def point_time(place: int) -> Callable[[xr.Dataset], float]:
    """Make the function that finds the time for a point of the grid of this place."""

    def time(study: xr.Dataset) -> float:
        """Least time for a point of the grid, nanoseconds."""
        least = study.size_seconds[place].min("repeat") / study["size"][place]
        return NANO * float(least)

    return time


def points(place: int) -> Callable[[xr.Dataset], float]:
    """Make the function that finds the size of the grid of this place."""

    def size(study: xr.Dataset) -> float:
        """Points of the grid."""
        return float(study["size"][place])

    return size


def largest_memory(study: xr.Dataset) -> float:
    """Largest memory held over all sizes of the grid, megabytes."""
    return float(study.size_memory.max()) / MEGA


def half_way_error(study: xr.Dataset) -> float:
    """Largest error half way between the points of the largest grid, degrees."""
    return float(study.interpolation_error[-1])


def _run(motion: xr.Dataset, method: str, setting: float) -> xr.Dataset:
    """Row of a method at a setting, the slipping scene."""
    here = (motion.method.values == method) & np.isclose(motion.setting.values, setting, atol=0.0)
    return motion.isel(point=int(np.flatnonzero(here)[0])).sel(scene="slipping")


def run_time(method: str, setting: float) -> Callable[[xr.Dataset], float]:
    """Make the function that finds the time of an integrator."""

    def time(motion: xr.Dataset) -> float:
        """Least time for a run of the slipping scene, milliseconds."""
        return MILLI * float(_run(motion, method, setting).motion_seconds.min())

    return time


def run_error(method: str, setting: float) -> Callable[[xr.Dataset], float]:
    """Make the function that finds the error of an integrator."""

    def error(motion: xr.Dataset) -> float:
        """Error of the last rod angle of the slipping scene, degrees."""
        return float(_run(motion, method, setting).motion_error)

    return error


def both_ratio(operation: str) -> Callable[[xr.Dataset], float]:
    """Make the function that compares both effects with the two alone for one slider."""

    def ratio(effects: xr.Dataset) -> float:
        """Least time with both effects in units of the sum of the times with one, one slider."""
        here = (effects.scene.values == "one slider") & (effects.operation.values == operation)
        times = effects.time[np.flatnonzero(here)].min("repeat").values
        both = np.char.count(effects.effects.values[here].astype(str), "+") > 0
        return float(times[both].sum() / times[~both].sum())

    return ratio
