"""Runs that end early: their reasons, what to do, and the warning that says so."""

from __future__ import annotations

import inspect
from collections import Counter
from collections.abc import Callable, Mapping
from functools import wraps
from typing import NamedTuple, ParamSpec

import xarray as xr

from planar_pushing.simulation.fields import Stop
from planar_pushing.terms.errors import EarlyEndWarning, warn_user
from planar_pushing.terms.quantities import unit_of

P = ParamSpec("P")
#: Beginning of the attribute `stopped` of a run whose condition `until` holds.
UNTIL = "until: "


class Reason(NamedTuple):
    """Why a run ended early, as in the attribute `stopped` of its log, and what to do."""

    text: str
    remedy: str


STEPS = 'simulate with method="time-stepping", which passes through such instants'
REASONS: Mapping[Stop, Reason] = {
    Stop.INCONSISTENT: Reason(
        "no contact mode is consistent",
        'no motion obeys the contact law there; with Inertia, method="time-stepping" can go on by impulses',
    ),
    Stop.SLIDER_CENTER_REACHES_FENCE: Reason(
        "the slider's center comes down to the fence",
        "give the object's outline, so that one of its sides comes to lie on the fence",
    ),
    Stop.NO_IMPULSE: Reason(
        "no impulse at the contact is consistent",
        "no impulse obeys the contact law there; choose another law",
    ),
    Stop.SINGULAR: Reason("the motion is singular in the mode", STEPS),
    Stop.EVENTS: Reason("without any time between them", STEPS),
    Stop.PROGRESS: Reason("thousands of steps make no progress", STEPS),
    Stop.EVALUATIONS: Reason("millions of steps are not enough", STEPS),
    Stop.TWO_CONTACTS: Reason(
        "the finger touches the object at two places",
        "end the push before, push at another place or with a smaller finger; without Inertia in the "
        "scene, the run goes on",
    ),
    Stop.JAMMED: Reason(
        "the object is jammed: its contacts leave it no motion",
        "the pushers close in on it; let one of them stop or give way",
    ),
    Stop.WEDGED: Reason(
        "the object is wedged: forces of its contacts cancel without bound",
        "no rigid motion obeys the contact laws there; lower the friction or push in another direction",
    ),
    Stop.MANY_CONTACTS: Reason(
        "the object touches at more than four places",
        "a run has four contacts at most, two of them on a flat side; leave out pushers or walls",
    ),
}  # fmt: skip


def warn_of_early_end(function: Callable[P, xr.Dataset]) -> Callable[P, xr.Dataset]:
    """A function that simulates, with an `EarlyEndWarning` if a run that it returns ended early."""

    @wraps(function)
    def simulate_and_warn(*args: P.args, **kwargs: P.kwargs) -> xr.Dataset:
        dataset = function(*args, **kwargs)
        if text := early_end(dataset):
            warn_user(EarlyEndWarning(text))
        return dataset

    return simulate_and_warn


def quietly(function: Callable[P, xr.Dataset]) -> Callable[P, xr.Dataset]:
    """The same function without the warning, for callers that ask themselves how a run ended."""
    quiet: Callable[P, xr.Dataset] = inspect.unwrap(function)
    return quiet


def early_end(dataset: xr.Dataset) -> str:
    """When and why the run of a log, or how many runs of a batch, ended early; empty if none did."""
    return _end_of_log(dataset) if "stopped" in dataset.attrs else _ends_of_batch(dataset)


def _end_of_log(log: xr.Dataset) -> str:
    stopped, unit = str(log.attrs["stopped"]), unit_of(log["time"].attrs)
    if not stopped or stopped.startswith(UNTIL):
        return ""
    of_time = "" if unit in ("1", "time") else f" {unit}"
    ended, duration = (f"{log.attrs[name]:.6g}{of_time}" for name in ("stopped_time", "duration"))
    remedy = _reason_in(stopped).remedy
    return f"the run ended at time {ended} of {duration}: {stopped}; {remedy}"


def _ends_of_batch(batch: xr.Dataset) -> str:
    last = batch["stopped"].isel(part=-1) if "part" in batch["stopped"].dims else batch["stopped"]
    reasons = Counter(_reason_in(text) for text in last.values.ravel().tolist() if text)
    if not reasons:
        return ""
    ((reason, most),) = reasons.most_common(1)
    often = "" if len(reasons) == 1 else f"in {most} of them, "
    return (
        f"{reasons.total()} of {last.size} runs ended early, see stopped and time: {often}{reason.text}; "
        f"{reason.remedy}"
    )


def _reason_in(stopped: str) -> Reason:
    """The reason in the text `stopped`, which can add numbers."""
    return next(reason for reason in REASONS.values() if reason.text in stopped)
