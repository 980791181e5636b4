"""What accuracy costs: one sweep of all methods, whose errors and evaluations, or whose times, are kept."""

from __future__ import annotations

import json
import os
import platform
import time
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import cache, partial
from importlib.metadata import version
from pathlib import Path
from types import MappingProxyType
from typing import Any, NamedTuple

import numpy as np
import xarray as xr
from flint import arb, fmpq

from planar_pushing.mechanics.plane import Array
from planar_pushing.scenes.files import load_scene_file
from planar_pushing.terms.replacing import PathLike
from pulling_by_pushing.evidence.costs.methods import (
    METHODS,
    ROD_ANGLE,
    SCENES,
    SPIN_RATIOS,
    cones,
    edges,
    run_of_no_duration,
)
from pulling_by_pushing.oracle.balls import at_radians, cross, dot, precise, rational
from pulling_by_pushing.oracle.body import Body
from pulling_by_pushing.oracle.logs.log import log_values
from pulling_by_pushing.oracle.motions import ray
from pulling_by_pushing.oracle.prove import Slider
from pulling_by_pushing.oracle.shapes import support
from pulling_by_pushing.oracle.support import friction
from pulling_by_pushing.study.catalog import EVIDENCE
from pulling_by_pushing.study.describe import describe
from pulling_by_pushing.study.quantities import COSTS
from pulling_by_pushing.study.running.build import Attributes, write_built

#: Number of times that each call is timed.
REPEATS = 5
#: Number of calls for a single wrench whose mean duration is a repeat.
SINGLES = 4
PACKAGES = ("planar-pushing", "numpy", "scipy", "h5py", "python-flint")


class Quantity(NamedTuple):
    """A quantity that methods compute for cases along a dimension, or, if it is empty, for a single case.

    `arguments` makes the arguments of a method for a case, in a number of copies, each of which has some
    `results`; `singles` makes those of calls with one result each; `error` compares the results for a case
    with certified values.
    """

    dim: str
    cases: Sequence[Any]
    arguments: Callable[[Any, int], tuple[Any, ...]]
    singles: Callable[[Any], Sequence[tuple[Any, ...]]]
    error: Callable[..., float]
    results: int = 1


class Call(NamedTuple):
    """A method at a setting, applied to a case.

    `run` computes a number of `results` in one call; `calls` compute one result each. `takes_arrays` says
    whether `run` does so in an array, or one by one.
    """

    run: Callable[[], tuple[Any, ...]]
    case: Any
    results: int
    calls: Sequence[Callable[[], object]]
    takes_arrays: bool


# --- Certified values, one function for each quantity ---------------------------------------------------


@precise
def ring_wrench(k: float) -> tuple[arb, arb]:
    """Force and torque of the ring at a spin ratio."""
    return friction(arb(k))


@precise
def edge_angle(length: float, angle: float) -> arb:
    """Motion angle under friction, radians (Eq. 7), for exactly these doubles.

    The oracle's rods are at angles in degrees, so that the force is turned to a rod at angle 0.
    """
    body = Body(length=rational(length), support=support({"shape": "ring"}), weight=fmpq(1))
    force = at_radians(rational(angle) - rational(ROD_ANGLE))
    motion = ray(Slider(body, fmpq(0)), force).q[:2]
    return arb(angle) + arb.atan2(cross(force.ball, motion), dot(force.ball, motion))


@cache
@precise
def last_rod_angle(scene: str) -> arb:
    """Rod angle at the end of a motion, degrees."""
    file = load_scene_file(SCENES[scene]).model_dump()
    angle: arb = log_values(file, [file["simulate"]["duration"]])["rod_angle"][1][-1]
    return angle


@cache
def _edge_angles() -> list[arb]:
    return [edge_angle(float(x), float(y)) for x, y in zip(*edges(), strict=True)]


# --- Errors, formed without rounding --------------------------------------------------------------------


@precise
def _difference(value: float, exact: arb, unit: arb) -> float:
    """Absolute difference in a unit; infinite if the value is not finite."""
    return abs(float((arb(value) - exact) / unit)) if np.isfinite(value) else np.inf


def wrench_error(k: float, force: Array, torque: Array) -> float:
    """The larger of the relative errors of force and torque at a spin ratio."""
    pairs = zip((force, torque), ring_wrench(k), strict=True)
    return max(_difference(float(value[0]), exact, exact) for value, exact in pairs)


def cone_error(_: None, angles: Array) -> float:
    """Largest error of the edges, degrees."""
    pairs = zip(map(float, angles), _edge_angles(), strict=False)
    return float(np.rad2deg(max(_difference(value, exact, arb(1)) for value, exact in pairs)))


def motion_error(scene: str, rod_angle: float) -> float:
    """Error of the last rod angle, degrees."""
    return _difference(rod_angle, last_rod_angle(scene), arb(1))


QUANTITIES = {
    "wrench": Quantity(
        "spin_ratio",
        SPIN_RATIOS.tolist(),
        lambda k, copies: (np.full(copies, k),),
        lambda k: [(np.full(1, k),)] * SINGLES,
        wrench_error,
    ),
    "cone": Quantity(
        "",
        (None,),
        lambda _, copies: tuple(np.tile(edges(), copies)),
        lambda _: cones(),
        cone_error,
        edges()[0].size // 2,
    ),
    "motion": Quantity(
        "scene", list(SCENES), lambda *case: case, lambda scene: [(scene, 1)], motion_error
    ),
}


# --- The sweep ------------------------------------------------------------------------------------------


def sweep(name: str) -> list[Call]:
    """Calls for every case and, in the outer loop, every setting of every method for a quantity."""
    quantity, calls = QUANTITIES[name], []
    for method in METHODS[name]:
        for setting in method.settings:
            copies = max(1, method.batch // max(1, int(setting)))
            for case in quantity.cases:
                run, *singles = (
                    partial(method.run, *arguments, setting)
                    for arguments in (quantity.arguments(case, copies), *quantity.singles(case))
                )
                calls.append(Call(run, case, copies * quantity.results, singles, method.batch > 0))
    return calls


def accuracy() -> dict[str, xr.Dataset]:
    """Errors and evaluations of every method against certified values, a group for each quantity."""
    groups = {}
    for name, quantity in QUANTITIES.items():
        errors, counts = [], []
        for call in sweep(name):
            *values, evaluations = call.run()
            errors.append(quantity.error(call.case, *values))
            counts.append(float(np.mean(evaluations)))
        variables = {f"{name}_error": errors, "evaluations": counts}
        groups[name] = _point_dataset(name, "accuracy", variables)
    return groups


def write_accuracy(path: PathLike, *, marks: Attributes) -> None:
    """Write the dataset of errors and evaluations."""
    write_built(accuracy(), path, "accuracy", marks)


def accuracy_time() -> dict[str, xr.Dataset]:
    """Times for one result of every method on this machine, a group for each quantity.

    They are of two kinds: of a result in an array or a batch, NaN for a method without arrays, and of a
    result in a call of its own. A time for a cone is that of both edges. For motions the time of a run
    without duration is apart. The attribute `machine` names the processor, its cores and the versions.
    """
    groups = {}
    for name in QUANTITIES:
        calls = sweep(name)
        times = {
            f"{name}_seconds": _array_seconds(calls),
            f"{name}_call_seconds": _call_seconds(calls),
        }
        idle = {} if name != "motion" else {"log_seconds": (("scene", "repeat"), _log_seconds())}
        groups[name] = add_machine(_point_dataset(name, "accuracy_time", times, idle))
    return groups


def write_accuracy_time(path: PathLike, *, marks: Attributes) -> None:
    """Measure times of every method on this machine, and write the dataset."""
    write_built(accuracy_time(), path, "accuracy_time", marks)


def _array_seconds(calls: Sequence[Call]) -> Array:
    """Times of a result in an array, shape (calls, repeats)."""
    arrays = np.array([call.takes_arrays for call in calls])
    results = np.array([call.results for call in calls])
    times = np.full((len(calls), REPEATS), np.nan)
    times[arrays] = seconds([call.run for call in calls if call.takes_arrays], REPEATS)
    times /= results[:, None]
    return times


def _call_seconds(calls: Sequence[Call]) -> Array:
    """Times of a result in a call of its own, shape (calls, repeats)."""

    def run_all(singles: Sequence[Callable[[], object]]) -> None:
        for single in singles:
            single()

    counts = np.array([len(call.calls) for call in calls])
    times = seconds([partial(run_all, call.calls) for call in calls], REPEATS)
    times /= counts[:, None]
    return times


def _log_seconds() -> Array:
    """Times of runs without duration, shape (scenes, repeats)."""
    return seconds([partial(run_of_no_duration, scene) for scene in SCENES], REPEATS)


def _point_dataset(
    name: str,
    dataset: str,
    variables: dict[str, Any],
    further: Mapping[str, Any] = MappingProxyType({}),
) -> xr.Dataset:
    """Dataset over `point`, a row for each setting of a method, and the cases, from values of all calls.

    It can contain further variables, given with their dimensions.
    """
    quantity = QUANTITIES[name]
    rows = [(row.name, setting, row.counted) for row in METHODS[name] for setting in row.settings]
    columns = zip(("method", "setting", "counted"), zip(*rows, strict=True), strict=True)
    coords: dict[str, Any] = {key: ("point", list(column)) for key, column in columns}
    dims, shape = ["point"], [len(rows)]
    if quantity.dim:
        dims, shape = [*dims, quantity.dim], [*shape, len(quantity.cases)]
        coords[quantity.dim] = quantity.cases
    data = {}
    for key, values in variables.items():
        repeats = np.shape(values)[1:]
        data[key] = [*dims, *["repeat" for _ in repeats]], np.reshape(values, (*shape, *repeats))
    return describe(
        xr.Dataset({**data, **further}, coords=coords),
        title=EVIDENCE[dataset].capitalize(),
        source={"wrench": "Eqs. (2)-(3)", "cone": "Eqs. (7), (10)-(12)", "motion": "Sec. 3"}[name],
        parameters={"repeats": REPEATS} if dataset == "accuracy_time" else {},
        quantities=COSTS,
    )


def seconds(calls: Iterable[Callable[[], object]], repeats: int) -> Array:
    """Durations of calls, taken in turn after a warm-up round, shape (calls, repeats).

    A disturbance of the machine then affects few repeats of every call, and not all repeats of one
    call.
    """
    runs = list(calls)
    durations = np.empty((repeats + 1, len(runs)))
    for row in durations:
        for index, run in enumerate(runs):
            start = time.perf_counter()
            run()
            row[index] = time.perf_counter() - start
    return durations[1:].T


def add_machine(dataset: xr.Dataset) -> xr.Dataset:
    """Name the machine that a dataset was measured on: no host name."""
    machine = {
        "processor": _processor(),
        "cores": str(os.cpu_count()),
        "system": f"{platform.system()} {platform.machine()}",
        "python": platform.python_version(),
        **{name: version(name) for name in PACKAGES},
    }
    return dataset.assign_attrs(machine=json.dumps(machine))


def _processor() -> str:
    info = Path("/proc/cpuinfo")
    lines = info.read_text(encoding="utf-8").splitlines() if info.is_file() else []
    models = (line.partition(":")[2].strip() for line in lines if line.startswith("model name"))
    return next(models, platform.processor() or "unknown")
