"""`compare`: how well friction models of an object predict its pushes."""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial
from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.supports.base import require_in_frame, require_support
from planar_pushing.pushes.fit.scores import QUANTITIES, REFERENCE
from planar_pushing.pushes.fit.statistics import split_statistics, statistics
from planar_pushing.pushes.halves import (
    PLAIN,
    RESAMPLED,
    Job,
    Task,
    divisions,
    require_workers,
    score_jobs,
    usable_for_fits,
)
from planar_pushing.pushes.logs.arguments import MOST, whole_number
from planar_pushing.pushes.logs.combine import of_object
from planar_pushing.pushes.logs.measured import measurements_of
from planar_pushing.pushes.logs.schema import require_pushes
from planar_pushing.pushes.models import MODELS, Fit, fixed_model
from planar_pushing.terms.errors import InvalidValue, number_of, require_flag, suggestion

#: Smallest number of pushes of an object; half of them must determine five numbers of an ellipsoid.
LEAST = 8
#: The same for several splits: a resample of so many has about 0.63 times as many different pushes.
LEAST_RESAMPLED = 16


def compare(
    pushes: xr.Dataset,
    models: Any = None,
    *,
    splits: int = 1,
    workers: Any = 1,
    seed: int = 0,
    resamples: int = 1000,
    spacing: float | None = None,
    family: str = "points",
    progress: bool = False,
) -> xr.Dataset:
    """Compare how well friction models predict measured pushes.

    Parameters
    ----------
    pushes : xarray.Dataset
        Pushes of one or several objects (`load_pushes`, `pushes_from_poses`).
    models : sequence of str, or mapping of names to supports, optional
        Any of "known_feet" (the feet in the dataset), "identified" (`identify`), "uniform" (a uniform
        pressure on the outline), "known_feet_ellipsoid" and "uniform_ellipsoid" (`fit_ellipsoid` of these
        supports), "fitted_quartic" and "fitted_ellipsoid" (fitted to the same pushes); by default all that
        apply. A mapping adds the user's own supports, in the object's frame, to these models.
    splits : int
        Number of random divisions of the pushes into halves. One, the default, is cheap; a result to rely
        on takes fifty or more, since it can depend on the division more than on the model. With s splits,
        models are fitted 4 s times to each object, which has at least 16 pushes.
    workers : int or callable
        Number of processes, -1 for one on each core, or a function like `map` that calls a function for
        each task in order. A script that starts processes runs its own code under ``if __name__ ==
        "__main__"``.
    seed : int
        Seed of the divisions into halves and of the resampling.
    resamples : int
        Number of resamples of the errors for the intervals of a single split.
    spacing, family
        As in `identify`.
    progress : bool
        Whether to show a progress bar.

    Returns
    -------
    xarray.Dataset
        `error` over (quantity, model, push), and medians, 90th percentiles, their ratios to those of the
        fitted ellipsoid, and paired differences from its errors, with 95 percent intervals over `bound`.
        With several splits, all of these are means over the splits, and the errors of each split and of
        each resample are `split_error` and `resampled_error`, over (split, quantity, model, push); `draws`
        over (split, push) is how often a resample has drawn a push. The quantities are the wrench under the
        measured twist, the motion under the measured force, and the final pose. Errors of wrench and motion
        are angles in degrees between predicted and measured vectors, with torques and rotations scaled by
        half the outline's extent (`length`). The error of the final pose is the distance plus `length`
        times the angle. Values are NaN if no force was measured or a model does not apply; those of wrench
        and motion also if the object did not move.

    Raises
    ------
    InvalidValue
        If a model or an option is unknown, or an object has too few pushes for two halves.

    Notes
    -----
    The pushes of each object are divided into halves at random. All fits, including that of the contact
    friction, are made on one half and scored on the other, and vice versa. In every model, the finger
    follows the outline: around corners and arcs, and also if it leaves the object and meets it again. If it
    touches two places, as in an inner corner, the object rests from then on. No model is fitted to pushes
    that touch a corner first (`at_corner`), which depend strongly on where they do.

    With one split, the intervals are from resampled errors of the two fits, as if these fits were given:
    they contain neither the division nor the variation of the fits. With several splits, a value is the
    mean over random divisions of all pushes, which averages the division out. Its interval is from as many
    further splits, each of pushes drawn anew with replacement, fitted again, and scored again; a push that
    was drawn twice is in one half alone. So the interval contains the pushes, the division and the fit.
    Pushes must be drawn before they are divided: in two halves of the same pushes, the errors of one fit
    make up for those of the other, and divisions alone would show too small a variation. Since a resample
    has fewer different pushes, its fits are worse, those of flexible models most; hence the results of the
    resamples are centered at the mean over the splits (for the positive statistics by a factor), and only
    their spread counts. The ends are the 2.5th and 97.5th percentiles; of fewer than 40 splits, they are
    the smallest and the largest result. A resample is divided once, so the intervals are wider than those
    of a mean over many divisions.

    The quartic is the model of Zhou, Paolini, Bagnell, and Mason (ICRA 2016, pp. 372-377): a convex form of
    degree 4 in the wrench, whose level set is the limit surface and whose gradient is along the twist. A
    semidefinite program fits its fifteen coefficients, with weights from cross-validation within the half.
    It applies to halves with measured forces of at least five pushes.
    """
    checked = require_pushes(pushes)
    splits, workers = whole_number("splits", splits, 1, MOST), require_workers(workers)
    draws, seed = whole_number("resamples", resamples, 1, MOST), whole_number("seed", seed, 0)
    require_flag("progress", progress)
    fits = _required_models(models)
    objects = [of_object(checked, name) for name in map(str, checked["object"].values)]
    for one in objects:
        _require_halves(one, LEAST if splits == 1 else LEAST_RESAMPLED)
    options = {"spacing": spacing, "family": family, "progress": progress and splits == 1}
    jobs = [
        Job(kind, split, np.flatnonzero(checked["pushed"].values == one["object"].item()), task)
        for number, one in enumerate(objects)
        for kind, split, fold in divisions(measurements_of(one), number, splits, seed)
        for task in [Task(one, fold, fits, options)]
    ]
    shape = splits, len(QUANTITIES), len(fits), checked.sizes["push"]
    errors, counts = score_jobs(jobs, shape, workers, progress and splits > 1)
    kept = np.isfinite(errors[PLAIN]).any(axis=(0, 1, 3))
    names = [name for name, is_kept in zip(fits, kept, strict=True) if is_kept]
    by_split, resampled = (_labelled(array[:, :, kept], names) for array in errors)
    if splits == 1:
        results = statistics(by_split[0], draws, seed)
    else:
        results = split_statistics(by_split, resampled, counts[RESAMPLED])
    about = {"seed": seed, "splits": splits} | ({"resamples": draws} if splits == 1 else {})
    return _describe(results, checked, objects).assign_attrs(**about)


def _labelled(errors: Array, models: list[str]) -> xr.DataArray:
    """Errors of shape (splits, quantities, models, pushes) with names."""
    dims = ("split", "quantity", "model", "push")
    return xr.DataArray(errors, {"quantity": list(QUANTITIES), "model": models}, dims)


def _required_models(models: Any) -> dict[str, Fit]:
    """Return the models to compare, including the reference, or raise `InvalidValue`."""
    if models is None:
        return dict(MODELS)
    names = list(models) if isinstance(models, (list, tuple)) else []
    unknown = [name for name in names if name not in MODELS]
    if unknown or not isinstance(models, (list, tuple, Mapping)):
        wrong = unknown[0] if unknown else models
        raise InvalidValue(
            "models", wrong, f"a sequence of {', '.join(MODELS)}, or a mapping of names to supports",
            suggestion(wrong, MODELS, "name some of these"),
        )  # fmt: skip
    if not isinstance(models, Mapping):
        return {name: MODELS[name] for name in dict.fromkeys((*names, REFERENCE))}
    for name, support in models.items():
        require_support("models", support)
        require_in_frame("models", support)
        if name in MODELS:
            raise InvalidValue(
                "models", {name: support}, "supports under names of your own",
                f"use none of the names {', '.join(MODELS)}",
            )  # fmt: skip
    functions = {name: partial(fixed_model, support) for name, support in models.items()}
    return {**functions, **MODELS}


def _require_halves(pushes: xr.Dataset, fewest: int) -> None:
    """Refuse pushes of an object if half of them are too few to fit an ellipsoid."""
    usable = int(usable_for_fits(measurements_of(pushes)).sum())
    if usable < fewest:
        name = pushes["object"].item()
        raise InvalidValue(
            "pushes", f"{number_of(usable, 'push')} of {name} to which a model can be fitted",
            f"at least {fewest}",
            "measure more pushes: half of them are used for the fit",
        )  # fmt: skip


def _describe(results: xr.Dataset, pushes: xr.Dataset, objects: list[xr.Dataset]) -> xr.Dataset:
    """Statistics with the objects of the pushes, units, and attributes."""
    unit = str(pushes["displacement"].attrs["units"])
    measured = [measurements_of(one) for one in objects]
    corner = np.zeros(pushes.sizes["push"], dtype=bool)
    for one, each in zip(objects, measured, strict=True):
        corner[pushes["pushed"].values == one["object"].item()] = each.at_corner
    results["pushed"] = (
        "push",
        pushes["pushed"].values,
        {"long_name": "name of the object that is pushed"},
    )
    results["at_corner"] = (
        "push",
        corner,
        {"long_name": "whether the push touches a corner first"},
    )
    results["length"] = (
        "object", [each.length for each in measured],
        {"units": unit, "long_name": "half the extent of the outline"},
    )  # fmt: skip
    for name, variable in results.data_vars.items():
        if "quantity" in variable.dims:
            ratio = "ratio" in str(name)
            variable.attrs |= {"units": "1"} if ratio else {"component_units": "error_unit"}
    about = {"long_name": "unit of the errors of the quantity"}
    units = "quantity", ["degree", "degree", unit], about
    results = results.assign_coords(object=pushes["object"].values, error_unit=units)
    return results.assign_attrs(
        reference=REFERENCE, pose_units=unit, angle_units="degree",
        source=str(pushes.attrs.get("source", "")),
    )  # fmt: skip
