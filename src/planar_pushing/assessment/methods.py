"""What accuracy costs: errors, evaluations and seconds of a push at settings of both methods."""

from __future__ import annotations

import platform
import time
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
import xarray as xr

from planar_pushing.assessment.trial import Trial, evaluations_of
from planar_pushing.mechanics.scene import Scene
from planar_pushing.terms.options import Method

#: Tolerance of the run that counts as exact: the tightest.
EXACT = 1e-13
#: Settings of the methods: relative tolerances, and numbers of equal steps.
RTOLS = (1e-2, 1e-4, 1e-6, 1e-8, 1e-10)
STEPS = (10, 30, 100, 300, 1000, 3000, 10000)
#: Steps end when the error is this part of the tolerance.
ENOUGH = 1.0 / 3.0
#: Evaluations of equal runs that are timed together, at most this many runs, and how often.
TIMED, COPIES, REPEATS = 10_000, 50, 2
#: Steps that are timed for all runs of equal steps.
MANY_STEPS = 1000


class Setting(NamedTuple):
    """A setting of a method and what it costs.

    Attributes
    ----------
    method : str
    value : float
        Relative tolerance, or number of steps.
    error : float
        Largest displacement of the final pose from that of the exact run, in the scene's unit of length.
    evaluations : int
        Calls of the right-hand side.
    seconds : float
        Processor time of a run without its log.
    """

    method: str
    value: float
    error: float
    evaluations: int
    seconds: float


def assess_methods(trial: Trial, scene: Scene, tolerance: float) -> xr.Dataset:
    """Errors and costs of settings over `setting`, with the cheapest that holds the tolerance.

    The seconds are those of a batch less those of a batch of one run, because a run of `simulate` spends
    most of its time on its log, `log_seconds`; those of steps are those of 1000 steps, by their number.
    """
    exact = trial.run(scene, samples=2, rtol=EXACT)
    short = Trial(trial.pusher, trial.duration * 1e-6, trial.circles)
    log_seconds, _ = _seconds(lambda: short.run(scene, samples=2))
    rows = [_event_driven(trial, scene, rtol, exact) for rtol in RTOLS]
    of_step = _seconds_of_a_step(trial, scene, log_seconds)
    for count in STEPS:
        rows.append(_steps(trial, scene, count, exact, of_step))
        if rows[-1].error <= ENOUGH * tolerance:
            break
    variables = {
        name: ("setting", list(column))
        for name, column in zip(Setting._fields, zip(*rows, strict=True), strict=True)
    }
    cheapest = _cheapest(rows, tolerance)
    machine = f"{platform.system()} {platform.machine()}"
    attributes = {"cheapest": cheapest, "log_seconds": log_seconds, "machine": machine}
    return xr.Dataset(variables, attrs=attributes)


def _cheapest(rows: list[Setting], tolerance: float) -> int:
    """Index of the cheapest setting that holds the tolerance, or -1.

    Evaluations rank the settings of a method, because they are the same in each run; seconds rank methods.
    """
    best: dict[str, int] = {}
    for i, row in enumerate(rows):
        other = best.get(row.method)
        if row.error <= tolerance and (other is None or row.evaluations < rows[other].evaluations):
            best[row.method] = i
    return min(best.values(), key=lambda i: rows[i].seconds, default=-1)


def settings_of(methods: xr.Dataset, duration: float) -> dict[str, Any]:
    """Arguments of `simulate` for the cheapest setting; empty if none holds the tolerance."""
    if methods.attrs["cheapest"] < 0:
        return {}
    row = methods.isel(setting=methods.attrs["cheapest"])
    value = float(row["value"])
    if row["method"].item() == Method.EVENT_DRIVEN:
        return {"rtol": value}
    return {"method": str(Method.TIME_STEPPING), "step": duration / value}


def _event_driven(trial: Trial, scene: Scene, rtol: float, exact: xr.Dataset) -> Setting:
    seconds, batch = _seconds(lambda: trial.batch(scene, 1, rtol))
    count = int(batch["evaluations"].values[0])
    copies = int(np.clip(TIMED // max(count, 1), 1, COPIES))
    more, _ = _seconds(lambda: trial.batch(scene, 1 + copies, rtol))
    error = trial.end_change(exact, batch)
    kernel = max(more - seconds, 0.0) / copies
    return Setting(str(Method.EVENT_DRIVEN), rtol, error, count, kernel)


def _steps(trial: Trial, scene: Scene, count: int, exact: xr.Dataset, of_step: float) -> Setting:
    log = _run_in_steps(trial, scene, count)
    evaluations = evaluations_of(log)
    error = trial.end_change(exact, log)
    return Setting(str(Method.TIME_STEPPING), count, error, evaluations, evaluations * of_step)


def _run_in_steps(trial: Trial, scene: Scene, count: int) -> xr.Dataset:
    step = trial.duration / count
    return trial.run(scene, samples=2, method=Method.TIME_STEPPING, step=step)


def _seconds_of_a_step(trial: Trial, scene: Scene, log_seconds: float) -> float:
    """Processor time of one evaluation of the time-stepping method."""
    seconds, log = _seconds(lambda: _run_in_steps(trial, scene, MANY_STEPS))
    return max(seconds - log_seconds, 0.0) / evaluations_of(log)


def _seconds(call: Callable[[], xr.Dataset]) -> tuple[float, xr.Dataset]:
    """Processor time of a call, the shorter of two, and what it returns."""
    times = []
    for _ in range(REPEATS):
        start = time.process_time()
        answer = call()
        times.append(time.process_time() - start)
    return min(times), answer
