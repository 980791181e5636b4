"""The measurements as datasets: the errors and counts, and the times, which differ on every run."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
import xarray as xr

from planar_pushing.evidence.costs import grids, motion
from planar_pushing.evidence.costs.methods.cones import cone_methods, edges
from planar_pushing.evidence.costs.methods.wrench import batch, wrench_methods
from planar_pushing.evidence.costs.tables import (
    SPIN_RATIOS,
    TIMED,
    VARIABLES,
    Variables,
    cone_errors,
    described,
    labelled,
    wrench_errors,
)
from planar_pushing.evidence.costs.timing import REPEATS, seconds, stamped
from planar_pushing.mechanics.plane import Array
from planar_pushing.study.catalog import EVIDENCE
from planar_pushing.study.describe import describe

#: Repeats in the default build: a round of all methods at the ratios of `TIMED` takes 0.1 s.
ROUNDS = 15


def wrench_times(spin_ratios: Array = SPIN_RATIOS, repeats: int = REPEATS) -> Variables:
    """Seconds for a wrench at every setting and spin ratio, each repeat."""
    rows = [(each, setting) for each in wrench_methods() for setting in each.settings]
    count = np.array([batch(each, setting) for each, setting in rows])
    calls = [
        partial(each.run, np.full(size, k), setting)
        for (each, setting), size in zip(rows, count, strict=True)
        for k in spin_ratios
    ]
    taken = seconds(calls, repeats).reshape(len(rows), spin_ratios.size, -1)
    taken /= count[:, None, None]
    return {"wrench_seconds": (("point", "spin_ratio", "repeat"), taken), "batch": ("point", count)}


def accuracy_time(repeats: int = ROUNDS) -> xr.Dataset:
    """Measure what the accuracy of the friction wrench costs in time, on this machine.

    Parameters
    ----------
    repeats : int
        Number of times that each method is timed, the methods in turns.

    Returns
    -------
    xarray.Dataset
        Over `point`, a row for each setting of a method, and `spin_ratio`, the four ratios of `TIMED`:
        `error`, the same as in `wrench_errors`, and `wrench_seconds`, which has the dimension `repeat`
        as well. The attribute `machine` names the processor, its cores and the versions.
    """
    errors = wrench_errors().sel(spin_ratio=TIMED).drop_vars("evaluations")
    dataset = describe(
        errors.assign(wrench_times(TIMED, repeats)),
        title=EVIDENCE["accuracy_time"].capitalize(),
        source="Eqs. (2)-(3)",
        parameters={"repeats": repeats},
        quantities=VARIABLES,
    )
    return stamped(dataset)


def cone_times() -> Variables:
    """Seconds for both edges of a motion cone at every setting, each repeat."""
    length, angle = edges()
    rows = [(each, setting) for each in cone_methods() for setting in each.settings]
    count = np.array([each.budget * length.size // 2 for each, _ in rows])
    calls = [
        partial(each.run, np.tile(length, each.budget), np.tile(angle, each.budget), setting)
        for each, setting in rows
    ]
    taken = seconds(calls) / count[:, None]
    return {"cone_seconds": (("point", "repeat"), taken), "batch": ("point", count)}


def grid_table(sizes: tuple[int, ...] = grids.SIZES) -> xr.Dataset:
    """Time, memory and error against the size of the grid, and time and memory against the block."""
    cases = [(size, grids.BLOCK) for size in sizes]
    cases += [(grids.SIZE, block) for block in grids.BLOCKS]
    with TemporaryDirectory() as folder:
        paths = [Path(folder) / f"{size}_{block}.h5" for size, block in cases]
        calls = [
            partial(grids.write_grid, *case, path) for case, path in zip(cases, paths, strict=True)
        ]
        times = seconds(calls, 3)
        errors = [grids.grid_errors(path) for path in paths[: len(sizes)]]
        memory = [grids.peak_memory(*case, path) for case, path in zip(cases, paths, strict=True)]
    points, half_way = np.array(errors).T
    variables = {
        "size_seconds": (("size", "repeat"), times[: len(sizes)]),
        "size_memory": ("size", memory[: len(sizes)]),
        "point_error": ("size", points),
        "interpolation_error": ("size", half_way),
        "block_seconds": (("block", "repeat"), times[len(sizes) :]),
        "block_memory": ("block", memory[len(sizes) :]),
    }
    coords = {"size": list(sizes), "block": list(grids.BLOCKS)}
    return labelled(variables, coords, "Grid of limit curves")


def motion_errors() -> xr.Dataset:
    """Errors and evaluations of both integrators at every setting, over the scenes."""
    error, count = motion.errors()
    variables = {
        "motion_error": (("point", "scene"), error),
        "evaluations": (("point", "scene"), count),
    }
    names = {"scene": list(motion.SCENES)}
    coords = {
        "method": ("point", [name for name, _ in motion.ROWS]),
        "setting": ("point", [float(setting) for _, setting in motion.ROWS]),
    }
    return labelled(variables, coords | names, "Motion over time")


def measured() -> dict[str, xr.Dataset]:
    """All measurements, one group each, with the machine that they were taken on."""
    groups = {"wrench": wrench_errors(), "cone": cone_errors(), "study": grid_table()}
    motion_times = {"motion_seconds": (("point", "scene", "repeat"), motion.times())}
    groups["motion"] = described(motion_errors().assign(motion_times))
    for name, times in (("wrench", wrench_times()), ("cone", cone_times())):
        groups[name] = described(groups[name].assign(times))
    return {name: stamped(each) for name, each in groups.items()}
