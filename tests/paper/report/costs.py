"""Small datasets on accuracy, hard cases and effects, with values that tests can tell apart."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import xarray as xr

from planar_pushing.terms.netcdf import write_dataset
from planar_pushing.terms.quantities import attributes
from pulling_by_pushing.study.quantities import COSTS
from pulling_by_pushing.study.store import read_dataset

STORED = Path("tests/golden/accuracy.nc")
#: Machine of the measured times.
MACHINE = {"processor": "Some(R) Processor(TM)", "cores": "6", "python": "3.98", "numpy": "9.9"}
#: Methods without arrays.
ONE_BY_ONE = ("quad", "brentq on quad", "time-stepping")
GROUPS = ("wrench", "cone", "motion")
#: Evaluations of friction and inertia by listed effects, and the factors of the methods.
COUNTS = {"support_friction": (3, 0), "inertia": (0, 5), "support_friction+inertia": (70, 90)}
METHODS = {"event-driven": 1, "time-stepping": 10}


def accuracy(group: str) -> xr.Dataset:
    """The stored errors, with evaluations of the motion that golden data leave out."""
    data = read_dataset(STORED, group).load()
    data = data.drop_vars(name for name in data.data_vars if str(name).endswith("_radius"))
    if group == "motion":
        data["evaluations"] = data.motion_error.dims, np.full(data.motion_error.shape, 8.0)
    return data


def accuracy_time(group: str) -> xr.Dataset:
    """Times of three repeats, the least of which grows from value to value; ten times as long in calls."""
    data = accuracy(group)
    error = data[f"{group}_error"]
    of_calls = np.isin(data.method.values, ONE_BY_ONE)
    in_arrays = growing(*error.shape)
    in_arrays[of_calls] = np.nan
    times = {"_seconds": in_arrays, "_call_seconds": 10 * growing(*error.shape)}
    variables = {
        f"{group}{kind}": ((*error.dims, "repeat"), values, attributes(COSTS, f"{group}{kind}"))
        for kind, values in times.items()
    }
    if group == "motion":
        scenes = 2e3 * growing(data.sizes["scene"])
        variables["log_seconds"] = ("scene", "repeat"), scenes, attributes(COSTS, "log_seconds")
    return xr.Dataset(variables, coords=data.coords).assign_attrs(machine=json.dumps(MACHINE))


def effects() -> xr.Dataset:
    """Evaluations of two effects."""
    counts = np.multiply.outer(list(METHODS.values()), list(COUNTS.values()))
    return xr.Dataset(
        {"evaluations": (("integrator", "effects", "effect"), counts)},
        coords={
            "integrator": list(METHODS),
            "effects": list(COUNTS),
            "effect": ["support_friction", "inertia"],
        },
    )


def hard_cases() -> xr.Dataset:
    """One case for each place, one more at the seventh place that is ill-conditioned, and a motion."""
    columns = {
        "line": np.array([1, 2, 3, 4, 5, 6, 7, 7, 8, 9, 10, 11, 12, 13], np.int8),
        "error_ulp": [0.5, 1.5, 3.0, 2.5, 0.0, 3.5, 9.0, 4e7, 1.0, 2.0, 0.5, 0.0, 6e5, 700.0],
        "condition": [1.0, 2.0, 1.0, 4.0, 1.0, 1.5, 17.0, 3e8, 1.0, 1.0, 2.0, 1.0, 1.0, 5.0],
        "error_bound": [1e-16, 2e-16, 1e-16, 4e-16, 1e-16, 2e-16, 2e-15, 6.7e-8, *[1e-16] * 6],
        "ill_conditioned": np.array([0] * 7 + [1] + [0] * 6, np.int8),
        "reference_digits": np.array([40] * 13 + [12], np.int8),
    }
    names = [f"case at phi = {i}" for i in range(13)] + ["time, slip that dies"]
    return xr.Dataset(
        {name: ("case", column) for name, column in columns.items()},
        coords={"case": names},
        attrs={"parameters": json.dumps({"ill_conditioned_from": 1e6, "rtol": 1e-12})},
    )


def write_costs(folder: Path) -> None:
    """Write what the report reads: the stored errors, and the datasets above."""
    write_dataset({each: accuracy(each) for each in GROUPS}, folder / "data/accuracy.nc")
    write_dataset({each: accuracy_time(each) for each in GROUPS}, folder / "data/accuracy_time.nc")
    write_dataset(effects(), folder / "data/effects.nc")
    write_dataset(hard_cases(), folder / "data/hard_cases.nc")


def growing(*shape: int) -> np.ndarray:
    """Times of three repeats, the least of which grows by a microsecond."""
    least = 1e-6 * (1 + np.arange(np.prod(shape)).reshape(shape))
    return np.stack([3 * least, least, 2 * least], axis=-1)
