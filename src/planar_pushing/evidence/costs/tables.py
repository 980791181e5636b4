"""The dataset `accuracy_errors`: errors and evaluations of every method, which are exactly repeatable."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr
from flint import arb

from planar_pushing.certified import radians, ring
from planar_pushing.certified.balls import precise
from planar_pushing.evidence.costs.inverses import ROD_ANGLE, edges
from planar_pushing.evidence.costs.methods import rows
from planar_pushing.evidence.costs.models import rim_errors
from planar_pushing.mechanics.plane import Array
from planar_pushing.terms.quantities import COSTS, attributes

SPIN_RATIOS = np.array([1e-8, 0.1, 0.9, 1 - 1e-3, 1 - 1e-9, 1, 1 + 1e-9, 3, 1e8])


def accuracy_errors() -> dict[str, xr.Dataset]:
    """Errors and evaluations of every method against certified values, a group for each quantity."""
    return {"wrench": wrench_errors(), "cone": cone_errors()}


def wrench_errors() -> xr.Dataset:
    """Errors and evaluations of the methods for the wrench, over `point` and `spin_ratio`.

    Each point is a setting of a method, given by the coordinates along it.
    """
    found = [method.run(SPIN_RATIOS, setting) for method, setting in rows("wrench")]
    exact = wrenches()
    variables = {
        "error": (("point", "spin_ratio"), [_larger_error(exact, *each[:2]) for each in found]),
        "evaluations": (("point", "spin_ratio"), [each[2] for each in found]),
    }
    coords = points("wrench") | {"spin_ratio": SPIN_RATIOS}
    return labeled(variables, coords, "Friction wrench")


def cone_errors() -> xr.Dataset:
    """Errors and evaluations of the methods for motion cones, over `point`, and of the models for a rim."""
    found = [method.run(*edges(), setting) for method, setting in rows("cone")]
    exact = motion_angles()
    errors = [_angle_errors(exact, angles) for angles, _ in found]
    rim = rim_errors()
    variables = {
        "cone_error": ("point", [each.max() for each in errors]),
        "cone_error_mean": ("point", [each.mean() for each in errors]),
        "evaluations": ("point", [float(count.mean()) for _, count in found]),
        "rim_error": ("model", list(rim.values())),
    }
    return labeled(variables, points("cone") | {"model": list(rim)}, "Motion cone")


def points(quantity: str) -> dict[str, Any]:
    """Coordinates along `point`: a row for each setting of a method."""
    each = rows(quantity)
    return {
        "method": ("point", [method.name for method, _ in each]),
        "setting": ("point", [setting for _, setting in each]),
        "counted": ("point", [method.counted for method, _ in each]),
    }


def labeled(variables: dict[str, Any], coords: dict[str, Any], title: str) -> xr.Dataset:
    """Make a dataset in which every variable has its unit and name."""
    return described(xr.Dataset(variables, coords=coords, attrs={"title": title}))


def described(dataset: xr.Dataset) -> xr.Dataset:
    """Give every variable its unit and name."""
    for name, variable in dataset.variables.items():
        variable.attrs = attributes(COSTS, str(name))
    return dataset


@precise
def wrenches() -> list[tuple[arb, arb]]:
    """Certified force and torque of the ring at each of `SPIN_RATIOS`."""
    return [ring.profile(arb(float(k))) for k in SPIN_RATIOS]


@precise
def motion_angles() -> list[arb]:
    """Certified motion angle of each edge under friction, radians (Eq. 7), for exactly these doubles."""
    given = zip(*edges(), strict=True)
    return [
        radians.motion_angle(arb(float(x)), arb(ROD_ANGLE), arb(float(y)), share=arb(0), rho=arb(1))
        for x, y in given
    ]


def _larger_error(exact: list[tuple[arb, arb]], force: Array, torque: Array) -> list[float]:
    """Larger relative error of force and torque at each spin ratio."""
    pairs = zip(exact, zip(force, torque, strict=True), strict=True)
    return [max(map(relative_error, found, certified)) for certified, found in pairs]


@precise
def relative_error(value: float, exact: arb) -> float:
    """``|value - exact| / |exact|``, formed without rounding; infinite if `value` is not finite."""
    return abs(float((arb(float(value)) - exact) / exact)) if np.isfinite(value) else np.inf


@precise
def _angle_errors(exact: list[arb], angles: Array) -> Array:
    """Differences of motion angles from certified ones, degrees, shape (n,)."""
    apart = [abs(float(arb(float(a)) - b)) for a, b in zip(angles, exact, strict=True)]
    return np.asarray(np.rad2deg(apart))
