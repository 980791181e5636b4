"""Times of every method on this machine: the datasets `accuracy_time` and `accuracy`."""

from __future__ import annotations

import json
import os
import platform
import time
from collections.abc import Callable, Sequence
from functools import partial
from importlib.metadata import version
from pathlib import Path

import numpy as np
import xarray as xr

from planar_pushing.evidence.costs import motion
from planar_pushing.evidence.costs.inverses import edges
from planar_pushing.evidence.costs.methods import rows
from planar_pushing.evidence.costs.tables import cone_errors, described, wrench_errors
from planar_pushing.mechanics.plane import Array
from planar_pushing.study.catalog import EVIDENCE
from planar_pushing.study.describe import describe
from planar_pushing.terms.quantities import COSTS

#: Spin ratios at which the default build measures times: regular, near the ring, on it, and a spin.
TIMED = np.array([0.1, 1 - 1e-9, 1, 1e8])
#: Rounds in `snakemake accuracy`, in that of motion, and in the default build, where one takes 0.1 s.
REPEATS, MOTION_REPEATS, ROUNDS = 9, 5, 15
PACKAGES = ("planar-pushing", "numpy", "scipy", "h5py", "python-flint")


def seconds(calls: Sequence[Callable[[], object]], repeats: int) -> Array:
    """Durations of calls, taken in turn after a warm-up round, shape (calls, repeats).

    A disturbance of the machine then affects few repeats of every call, and not all repeats of one
    call.
    """
    taken = np.empty((repeats + 1, len(calls)))
    for each in taken:
        for index, call in enumerate(calls):
            start = time.perf_counter()
            call()
            each[index] = time.perf_counter() - start
    return taken[1:].T


def accuracy_time(repeats: int = ROUNDS) -> xr.Dataset:
    """Measure the time that the accuracy of the friction wrench takes on this machine.

    Parameters
    ----------
    repeats : int
        Number of times that each method is timed; the methods take turns.

    Returns
    -------
    xarray.Dataset
        Over `point`, a row for each setting of a method, and `spin_ratio`, the four ratios of `TIMED`:
        `error`, the same as in `accuracy_errors`, and `wrench_seconds`, which has the dimension `repeat`
        as well. The attribute `machine` names the processor, its cores and the versions.
    """
    errors = wrench_errors().sel(spin_ratio=TIMED).drop_vars(["counted", "evaluations"])
    dataset = describe(
        _with_wrench_times(errors, repeats),
        title=EVIDENCE["accuracy_time"].capitalize(),
        source="Eqs. (2)-(3)",
        parameters={"repeats": repeats},
        quantities=COSTS,
    )
    return stamped(dataset)


def accuracy() -> dict[str, xr.Dataset]:
    """Measure every method at every setting, and both integrators, a group for each quantity."""
    calls = [partial(motion.run, scene, *row) for row in motion.ROWS for scene in motion.SCENES]
    taken = seconds(calls, MOTION_REPEATS).reshape(len(motion.ROWS), len(motion.SCENES), -1)
    runs = motion.motion_errors().assign(motion_seconds=(("point", "scene", "repeat"), taken))
    groups = {
        "wrench": _with_wrench_times(wrench_errors(), REPEATS),
        "cone": _with_cone_times(cone_errors(), REPEATS),
        "motion": runs,
    }
    return {name: stamped(described(each)) for name, each in groups.items()}


def _with_wrench_times(errors: xr.Dataset, repeats: int) -> xr.Dataset:
    """Times for one wrench at every setting and spin ratio of a dataset."""
    methods, ratios = rows("wrench"), errors.spin_ratio.values
    batch = np.array([max(1, each.batch // max(1, int(setting))) for each, setting in methods])
    calls = [
        partial(each.run, np.full(size, k), setting)
        for (each, setting), size in zip(methods, batch, strict=True)
        for k in ratios
    ]
    taken = seconds(calls, repeats).reshape(len(methods), len(ratios), -1) / batch[:, None, None]
    times = ("point", "spin_ratio", "repeat"), taken
    return errors.assign(wrench_seconds=times, batch=("point", batch))


def _with_cone_times(errors: xr.Dataset, repeats: int) -> xr.Dataset:
    """Times for both edges of a motion cone at every setting."""
    methods, (length, angle) = rows("cone"), edges()
    batch = np.array([each.batch * length.size // 2 for each, _ in methods])
    calls = [
        partial(each.run, np.tile(length, each.batch), np.tile(angle, each.batch), setting)
        for each, setting in methods
    ]
    taken = seconds(calls, repeats) / batch[:, None]
    return errors.assign(cone_seconds=(("point", "repeat"), taken), batch=("point", batch))


def stamped(measured: xr.Dataset) -> xr.Dataset:
    """Name the machine that a dataset was measured on."""
    return measured.assign_attrs(machine=json.dumps(machine()))


def machine() -> dict[str, str]:
    """Processor, number of cores, operating system and versions; no host name."""
    return {
        "processor": _processor(),
        "cores": str(os.cpu_count()),
        "system": f"{platform.system()} {platform.machine()}",
        "python": platform.python_version(),
        **{name: version(name) for name in PACKAGES},
    }


def _processor() -> str:
    info = Path("/proc/cpuinfo")
    lines = info.read_text(encoding="utf-8").splitlines() if info.is_file() else []
    models = (line.partition(":")[2].strip() for line in lines if line.startswith("model name"))
    return next(models, platform.processor() or "unknown")
