"""Small datasets on accuracy, hard cases and effects, with values that tests can tell apart."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import xarray as xr

from planar_pushing.evidence.costs.times import TIMED
from planar_pushing.study.store import read_dataset, write_dataset

STORED = Path(__file__).parents[1] / "evidence/costs/golden_accuracy.nc"
#: Machine of the measured times.
MACHINE = {"processor": "Some(R) Processor(TM)", "cores": "6", "python": "3.98", "numpy": "9.9"}
COMPUTED = {
    "one slider": ("motion_cone", "limit_curve", "solve"),
    "grid": ("limit_curves", "motion_cones", "contact_modes"),
    "figure_02": ("motion_cone", "limit_curve", "solve"),
}
#: Evaluations of friction and inertia by listed effects, and the factors of the methods.
COUNTS = {"support_friction": (3, 0), "inertia": (0, 5), "support_friction+inertia": (70, 90)}
#: Numbers of supports among which friction is divided.
SUPPORTS = (1, 2, 4)
METHODS = {"event-driven": 1, "time-stepping": 10}


def evaluations() -> xr.Dataset:
    counts = np.multiply.outer(list(METHODS.values()), list(COUNTS.values()))
    return xr.Dataset(
        {"evaluations": (("integrator", "effects", "effect"), counts)},
        coords={
            "integrator": list(METHODS),
            "effects": list(COUNTS),
            "effect": ["support_friction", "inertia"],
        },
    )


def effects(machine: str) -> xr.Dataset:
    """Times of each case, the least of which grows from case to case."""
    cases = [
        (scene, operation, effects, effects.count("+") + 1)
        for scene, operations in COMPUTED.items()
        for operation in operations
        for effects in (COUNTS if scene != "figure_02" else ("support_friction",))
    ]
    cases += [("equal supports", "simulate", "support_friction", number) for number in SUPPORTS]
    names = zip(("scene", "operation", "effects", "number"), zip(*cases, strict=True), strict=True)
    return xr.Dataset(
        {"time": (("case", "repeat"), growing(len(cases)))},
        coords={name: ("case", list(labels)) for name, labels in names},
        attrs={"machine": machine},
    )


def hard_cases() -> xr.Dataset:
    """Eight cases: one for each place, and one at the last place that is ill-conditioned."""
    columns = {
        "line": np.array([1, 2, 3, 4, 5, 6, 7, 7], np.int8),
        "error_ulp": [0.5, 1.5, 3.0, 2.5, 0.0, 3.5, 9.0, 4e7],
        "condition": [1.0, 2.0, 1.0, 4.0, 1.0, 1.5, 17.0, 3e8],
        "error_bound": [1e-16, 2e-16, 1e-16, 4e-16, 1e-16, 2e-16, 2e-15, 6.7e-8],
        "ill_conditioned": np.array([0] * 7 + [1], np.int8),
    }
    names = [f"case at phi = {i}" for i in range(8)]
    return xr.Dataset(
        {name: ("case", column) for name, column in columns.items()},
        coords={"case": names},
        attrs={"parameters": json.dumps({"ill_conditioned_from": 1e6})},
    )


def write_costs(folder: Path) -> None:
    """Write what the report reads: the stored errors, times made up for them, and the datasets above."""
    groups = {name: read_dataset(STORED, name) for name in ("wrench", "cone")}
    write_dataset(groups, folder / "data/accuracy_errors.nc")
    few = groups["wrench"].sel(spin_ratio=TIMED)
    times = timed(few, "wrench_seconds", json.dumps(MACHINE))
    write_dataset(times, folder / "data/accuracy_time.nc")
    write_dataset(hard_cases(), folder / "data/hard_cases.nc")
    write_dataset(evaluations(), folder / "data/evaluations.nc")


def timed(data: xr.Dataset, name: str, machine: str) -> xr.Dataset:
    """The dataset with times of three repeats, the least of which grows from row to row."""
    axes = data.evaluations.dims if name == "wrench_seconds" else data.evaluations.dims[:1]
    times = growing(*(data.sizes[axis] for axis in axes))
    return data.assign({name: ((*axes, "repeat"), times)}).assign_attrs(machine=machine)


def growing(*shape: int) -> np.ndarray:
    """Times of three repeats, the least of which grows by a microsecond."""
    least = 1e-6 * (1 + np.arange(np.prod(shape)).reshape(shape))
    return np.stack([3 * least, least, 2 * least], axis=-1)


def motion(machine: str) -> xr.Dataset:
    """Runs of both integrators, with times and errors that can be told apart."""
    return xr.Dataset(
        {
            "motion_error": (("point", "scene"), [[3e-12, 1.0], [4e-3, 1.0], [5e-3, 1.0]]),
            "motion_seconds": (("point", "scene", "repeat"), np.full((3, 2, 1), 0.0125)),
        },
        coords={
            "method": ("point", ["event-driven", "time-stepping", "time-stepping"]),
            "setting": ("point", [1e-10, 1000.0, 3000.0]),
            "scene": ["slipping", "pulling"],
        },
        attrs={"machine": machine},
    )


def write_times(folder: Path, machine: str = '{"processor": "one"}') -> None:
    """Write what the supplement reads, measured on one machine, the effects on `machine`."""
    one = '{"processor": "one"}'
    groups = {
        "wrench": timed(read_dataset(STORED, "wrench"), "wrench_seconds", one),
        "cone": timed(read_dataset(STORED, "cone"), "cone_seconds", one),
        "motion": motion(one),
    }
    write_dataset(groups, folder / "data/accuracy.nc")
    write_dataset(effects(machine), folder / "data/effects.nc")
