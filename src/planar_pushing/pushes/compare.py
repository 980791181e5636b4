"""`compare`: how well friction models of an object predict its pushes."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from typing import Any, NamedTuple, Protocol

import numpy as np
import xarray as xr

from planar_pushing.mechanics.outline import Outline
from planar_pushing.mechanics.outline.chains import sample_chain, split_chains
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.supports import Disc, Points, Polygon, fit_ellipsoid
from planar_pushing.mechanics.supports.base import require_in_frame, require_support
from planar_pushing.pushes.fit.ellipsoid import Ellipsoid
from planar_pushing.pushes.fit.fitted import fitted_ellipsoid
from planar_pushing.pushes.fit.friction import contact_friction
from planar_pushing.pushes.fit.quartic import fitted_quartic
from planar_pushing.pushes.fit.statistics import QUANTITIES, REFERENCE, angles, statistics
from planar_pushing.pushes.fit.supported import OnSupport
from planar_pushing.pushes.identify import identify_measured
from planar_pushing.pushes.logs.arguments import MOST, whole_number
from planar_pushing.pushes.logs.combine import of_object
from planar_pushing.pushes.logs.measured import (
    Mask,
    Measured,
    measurements_of,
    twists_at,
    wrenches_about,
)
from planar_pushing.pushes.logs.schema import require_pushes, without_padding
from planar_pushing.terms.errors import InvalidValue, number_of, require_flag, suggestion

#: Candidate contact friction coefficients for a given support, if no measured force determines it.
FRICTIONS = np.geomspace(0.05, 1.2, 20)
#: Deviation of the polygon of a uniform pressure from arcs, in sizes of the outline.
FINE = 1e-4
#: Smallest number of pushes of an object; half of them must determine five numbers of an ellipsoid.
LEAST = 8


class Model(Protocol):
    """A model of support friction in the object's frame."""

    def poses(self, pushes: Measured, friction: float) -> Array:
        """Final poses of the object's frame, shape (n, 3), for a contact friction coefficient."""

    def wrenches(self, twists: Array) -> Array:
        """Directions of the wrenches for twists of shape (n, 3)."""

    def motions(self, wrenches: Array) -> Array:
        """Directions of the twists for wrenches of shape (n, 3); NaN if there is no motion."""


class Half(NamedTuple):
    """Half of an object's pushes, to which models are fitted: dataset, arrays, and options."""

    dataset: xr.Dataset
    pushes: Measured
    options: dict[str, Any]


def feet_of(dataset: xr.Dataset) -> Points | None:
    """Feet of the object of a dataset, if they and their loads are known."""
    if "feet" not in dataset or "foot_weight" not in dataset:
        return None
    places = without_padding(dataset["feet"].values[0])
    loads = dataset["foot_weight"].values[0][: len(places)]
    return Points(places, loads) if len(places) and np.isfinite(loads).all() else None


def uniform_support(outline: Outline) -> Any:
    """A uniform pressure within an outline, whose arcs are polygons within a ten-thousandth of its size."""
    rows = outline.pieces
    if len(rows) == 1:
        x, y, radius = rows[0, :3].tolist()
        return Disc(radius, (x, y))
    if outline.corners is not None:
        return Polygon(outline.corners)
    rings = [sample_chain(chain, FINE * outline.size) for chain in split_chains(rows)]
    return Polygon(rings[0], holes=rings[1:])


def _known_feet(half: Half) -> tuple[Model, float] | None:
    feet = feet_of(half.dataset)
    return None if feet is None else on_support(feet, half.pushes)


def _uniform(half: Half) -> tuple[Model, float]:
    return on_support(uniform_support(half.pushes.outline), half.pushes)


def _identify(half: Half) -> tuple[Model, float]:
    result = identify_measured(measurements_of(half.dataset), resamples=1, **half.options)
    return OnSupport(result.support), result.contact_friction


def _known_feet_ellipsoid(half: Half) -> tuple[Model, float] | None:
    feet = feet_of(half.dataset)
    return None if feet is None else on_ellipsoid(feet, half.pushes)


def _uniform_ellipsoid(half: Half) -> tuple[Model, float]:
    return on_ellipsoid(uniform_support(half.pushes.outline), half.pushes)


def _fitted_ellipsoid(half: Half) -> tuple[Model, float]:
    return fitted_ellipsoid(half.pushes)


def _fitted_quartic(half: Half) -> tuple[Model, float] | None:
    return fitted_quartic(half.pushes)


#: Functions that fit each model and the contact friction to pushes, or return None if it does not apply.
MODELS: dict[str, Callable[[Half], tuple[Model, float] | None]] = {
    "known_feet": _known_feet, "identified": _identify, "uniform": _uniform,
    "known_feet_ellipsoid": _known_feet_ellipsoid, "uniform_ellipsoid": _uniform_ellipsoid,
    "fitted_quartic": _fitted_quartic, REFERENCE: _fitted_ellipsoid,
}  # fmt: skip


def compare(
    pushes: xr.Dataset,
    models: Any = None,
    *,
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
    seed : int
        Seed of the division into halves and of the resampling.
    resamples : int
        Number of resamples of the pushes for the intervals.
    spacing, family
        As in `identify`.
    progress : bool
        Whether to show a progress bar while a support is identified.

    Returns
    -------
    xarray.Dataset
        `error` over (quantity, model, push), and medians, 90th percentiles, ratios and paired differences
        relative to the fitted ellipsoid, with 95 percent intervals over `bound`. The quantities are the
        wrench under the measured twist, the motion under the measured force, and the final pose. Errors of
        wrench and motion are angles in degrees between predicted and measured vectors, with torques and
        rotations scaled by half the outline's extent (`length`). The error of the final pose is the
        distance plus `length` times the angle. Values are NaN if no force was measured or a model does not
        apply; those of wrench and motion also if the object did not move.

    Raises
    ------
    InvalidValue
        If a model is unknown or an object has too few pushes for two halves.

    Notes
    -----
    The pushes of each object are divided into halves at random. All fits, including that of the contact
    friction, are made on one half and scored on the other, and vice versa. In every model, the finger
    follows the outline: around corners and arcs, and also if it leaves the object and meets it again. If it
    touches two places, as in an inner corner, the object rests from then on. No model is fitted to pushes
    that touch a corner first (`at_corner`), which depend strongly on where they do.

    The quartic is the model of Zhou, Paolini, Bagnell, and Mason (ICRA 2016, pp. 372-377): a convex form of
    degree 4 in the wrench, whose level set is the limit surface and whose gradient is along the twist. A
    semidefinite program fits its fifteen coefficients, with weights from cross-validation within the half.
    It applies to halves with measured forces of at least five pushes.
    """
    checked = require_pushes(pushes)
    draws, seed = whole_number("resamples", resamples, 1, MOST), whole_number("seed", seed, 0)
    require_flag("progress", progress)
    fits = _required_models(models)
    options = {"spacing": spacing, "family": family, "progress": progress}
    count, lengths = checked.sizes["push"], []
    errors = np.full((len(QUANTITIES), len(fits), count), np.nan)
    corner = np.zeros(count, dtype=bool)
    objects = {name: of_object(checked, name) for name in map(str, checked["object"].values)}
    measured = {name: measurements_of(one) for name, one in objects.items()}
    for name, every in measured.items():
        _require_halves(name, every)
    for name, names in objects.items():
        rows = np.flatnonzero(checked["pushed"].values == name)
        every = measured[name]
        lengths.append(every.length)
        corner[rows] = every.at_corner
        generator = np.random.default_rng(seed)
        order = generator.permutation(len(rows))
        parts = np.array_split(order, 2)
        for fit, score in (parts, parts[::-1]):
            half = Half(names.isel(push=np.sort(fit)), every.part(np.sort(fit)), options)
            scored = every.part(score)
            for k, fit_model in enumerate(fits.values()):
                fitted = fit_model(half)
                if fitted is not None:
                    errors[:, k, rows[score]] = errors_of(*fitted, scored)
    kept = np.isfinite(errors).any(axis=(0, 2))
    error = xr.DataArray(
        errors[:, kept], dims=("quantity", "model", "push"),
        coords={"quantity": list(QUANTITIES), "model": [n for n, k in zip(fits, kept, strict=True) if k]},
    )  # fmt: skip
    return _comparison(error, checked, corner, np.array(lengths), draws, seed)


def errors_of(model: Model, friction: float, pushes: Measured) -> Array:
    """Errors of a model in wrench and motion (degrees) and in final pose (length), shape (3, n)."""
    scale = np.array([1.0, 1.0, pushes.length])
    error = np.full((3, len(pushes)), np.nan)
    forced = pushes.has_directions
    if forced.any():
        part = pushes.part(forced)
        wrenches = wrenches_about(model.wrenches(part.twists), pushes.center)
        twists = twists_at(model.motions(part.wrenches), pushes.center)
        error[0, forced] = angles(wrenches / scale, part.centered_wrenches / scale)
        error[1, forced] = angles(twists * scale, part.centered_twists * scale)
    difference = model.poses(pushes, friction) - pushes.observed
    error[2] = np.hypot(*difference[:, :2].T) + pushes.length * np.abs(difference[:, 2])
    return error


def on_support(support: Any, pushes: Measured) -> tuple[Model, float]:
    """Model of a given support, and the contact friction that fits it best."""
    model = OnSupport(support)
    return model, _friction(model, pushes)


def on_ellipsoid(support: Any, pushes: Measured) -> tuple[Model, float]:
    """Ellipsoid of a support, and the contact friction that fits it best."""
    fit = fit_ellipsoid(support)
    model = Ellipsoid.about(np.array(fit.center), fit.matrix)
    return model, _friction(model, pushes)


def _friction(model: Model, pushes: Measured) -> float:
    """Contact friction from forces, or otherwise the value with the most accurate final poses."""
    if pushes.has_force.any():
        return contact_friction(pushes).coefficient
    sides = pushes.part(~pushes.at_corner)
    scale = [1.0, 1.0, sides.length]
    errors = [
        np.median(np.abs((model.poses(sides, mu) - sides.observed) * scale).sum(axis=1))
        for mu in FRICTIONS
    ]
    return float(FRICTIONS[int(np.argmin(errors))])


def _required_models(models: Any) -> dict[str, Callable[[Half], tuple[Model, float] | None]]:
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
    functions = {name: partial(_fixed_model, support) for name, support in models.items()}
    return {**functions, **MODELS}


def _fixed_model(support: Any, half: Half) -> tuple[Model, float]:
    return on_support(support, half.pushes)


def _require_halves(name: str, pushes: Measured) -> None:
    """Refuse pushes if half of them are too few to fit an ellipsoid."""
    usable = pushes.has_force | ~pushes.at_corner
    if usable.sum() < LEAST:
        raise InvalidValue(
            "pushes", f"{number_of(int(usable.sum()), 'push')} of {name} to which a model can be fitted",
            f"at least {LEAST}",
            "measure more pushes: half of them are used for the fit",
        )  # fmt: skip


def _comparison(
    error: xr.DataArray,
    pushes: xr.Dataset,
    corner: Mask,
    lengths: Array,
    resamples: int,
    seed: int,
) -> xr.Dataset:
    """Dataset of the errors and their statistics, the objects of the pushes, and attributes."""
    unit = str(pushes["displacement"].attrs["units"])
    comparison = statistics(error, resamples, seed)
    comparison["pushed"] = (
        "push",
        pushes["pushed"].values,
        {"long_name": "name of the object that is pushed"},
    )
    comparison["at_corner"] = (
        "push",
        corner,
        {"long_name": "whether the push touches a corner first"},
    )
    comparison["length"] = (
        "object", lengths, {"units": unit, "long_name": "half the extent of the outline"},
    )  # fmt: skip
    for name, variable in comparison.data_vars.items():
        if "quantity" in variable.dims:
            ratio = str(name).startswith("ratio")
            variable.attrs |= {"units": "1"} if ratio else {"component_units": "error_unit"}
    about = {"long_name": "unit of the errors of the quantity"}
    units = "quantity", ["degree", "degree", unit], about
    comparison = comparison.assign_coords(object=pushes["object"].values, error_unit=units)
    return comparison.assign_attrs(
        seed=seed, resamples=resamples, reference=REFERENCE, pose_units=unit,
        angle_units="degree", source=str(pushes.attrs.get("source", "")),
    )  # fmt: skip
