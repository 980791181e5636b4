"""Models of support friction that are fitted to pushes, and the errors of their predictions."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple, Protocol

import numpy as np
import xarray as xr

from planar_pushing.mechanics.outline import Outline
from planar_pushing.mechanics.outline.chains import sample_chain, split_chains
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.supports import Disc, Points, Polygon, fit_ellipsoid
from planar_pushing.pushes.fit.ellipsoid import Ellipsoid
from planar_pushing.pushes.fit.fitted import fitted_ellipsoid
from planar_pushing.pushes.fit.friction import contact_friction
from planar_pushing.pushes.fit.quartic import fitted_quartic
from planar_pushing.pushes.fit.scores import REFERENCE, angles
from planar_pushing.pushes.fit.supported import OnSupport
from planar_pushing.pushes.identify import identify_measured
from planar_pushing.pushes.logs.measured import (
    Measured,
    measurements_of,
    twists_at,
    wrenches_about,
)
from planar_pushing.pushes.logs.schema import without_padding
from planar_pushing.terms.caches import cache_results

#: Candidate contact friction coefficients for a given support, if no measured force determines it.
FRICTIONS = np.geomspace(0.05, 1.2, 20)
#: Deviation of the polygon of a uniform pressure from arcs, in sizes of the outline.
FINE = 1e-4


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


#: Fits a model and the contact friction to half of the pushes; None if it does not apply.
Fit = Callable[[Half], tuple[Model, float] | None]
#: Functions that fit each model.
MODELS: dict[str, Fit] = {
    "known_feet": _known_feet, "identified": _identify, "uniform": _uniform,
    "known_feet_ellipsoid": _known_feet_ellipsoid, "uniform_ellipsoid": _uniform_ellipsoid,
    "fitted_quartic": _fitted_quartic, REFERENCE: _fitted_ellipsoid,
}  # fmt: skip


def fixed_model(support: Any, half: Half) -> tuple[Model, float]:
    """Model of a support that a user gives, and the contact friction that fits half of the pushes."""
    return on_support(support, half.pushes)


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
    model = ellipsoid_of(support)
    return model, _friction(model, pushes)


@cache_results(16)
def ellipsoid_of(support: Any) -> Ellipsoid:
    """Ellipsoid of a support; it is the same for every half of the pushes."""
    fit = fit_ellipsoid(support)
    return Ellipsoid.about(np.array(fit.center), fit.matrix)


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
