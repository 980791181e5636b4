"""Errors and evaluation counts of every method as datasets: they repeat exactly."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.evidence.costs.errors import angle_errors, relative_error, wrench
from planar_pushing.evidence.costs.methods.cones import ROD_ANGLE, cone_methods, edges
from planar_pushing.evidence.costs.methods.models import rim_errors
from planar_pushing.evidence.costs.methods.wrench import wrench_methods
from planar_pushing.mechanics.plane import Array
from planar_pushing.terms.quantities import DATASET, Quantities, attributes

SPIN_RATIOS = np.array([1e-8, 0.1, 0.9, 1 - 1e-3, 1 - 1e-9, 1, 1 + 1e-9, 3, 1e8])
#: Those at which the default build measures times: regular, next to the ring, on it, a spin.
TIMED = np.array([0.1, 1 - 1e-9, 1, 1e8])

#: Units and long names; a name may mean something else than in the other datasets.
VARIABLES: Quantities = {
    "method": ("1", "method"),
    "setting": ("1", "number of points, table entries or steps, or tolerance; 0 for none"),
    "spin_ratio": DATASET["spin_ratio"],
    "error": ("1", "largest relative error of force and torque; inf where a part is NaN"),
    "evaluations": ("1", "evaluations of an integrand, or of the wrench, for one result"),
    "batch": ("1", "results that a timed call computes"),
    "wrench_seconds": ("s", "time for one wrench, each repeat"),
    "cone_error": ("degree", "largest error of an edge of a motion cone"),
    "cone_error_mean": ("degree", "mean error of an edge of a motion cone"),
    "cone_seconds": ("s", "time for both edges of a motion cone, each repeat"),
    "model": ("1", "model of the limit surface"),
    "rim_error": ("degree", "mean direction error for a rim of 100 point supports"),
    "size": ("1", "points of the grid"),
    "block": ("1", "points that are computed at once"),
    "point_error": ("degree", "largest error of the motion angle at points of the grid"),
    "interpolation_error": ("degree", "largest error of linear interpolation between them"),
    "size_seconds": ("s", "time for a grid, each repeat"),
    "size_memory": ("byte", "largest memory held while a grid is computed and stored"),
    "block_seconds": ("s", "time for a grid of 10^6 points, each repeat"),
    "block_memory": ("byte", "largest memory held while it is computed and stored"),
    "scene": ("1", "scene that moves over time"),
    "motion_error": ("degree", "error of the rod angle at the end of a run"),
    "motion_seconds": ("s", "time for a run, each repeat"),
    "repeat": ("1", "number of the repeat"),
}
Variables = dict[str, Any]


def described(dataset: xr.Dataset) -> xr.Dataset:
    """Give every variable its unit and name."""
    for name, variable in dataset.variables.items():
        variable.attrs = attributes(VARIABLES, str(name))
    return dataset


def labelled(variables: Variables, coords: dict[str, Any], title: str) -> xr.Dataset:
    """Make a dataset in which every variable has its unit and name."""
    return described(xr.Dataset(variables, coords=coords, attrs={"title": title}))


def wrench_errors() -> xr.Dataset:
    """Errors and evaluations of every method at every setting and spin ratio."""
    rows = [(each, setting) for each in wrench_methods() for setting in each.settings]
    results = [each.run(SPIN_RATIOS, setting) for each, setting in rows]
    variables = {
        "error": (("point", "spin_ratio"), [_wrench_error(*each[:2]) for each in results]),
        "evaluations": (("point", "spin_ratio"), [each[2] for each in results]),
    }
    return labelled(variables, _points(rows) | {"spin_ratio": SPIN_RATIOS}, "Friction wrench")


def _points(rows: list[tuple[Any, float]]) -> dict[str, Any]:
    return {
        "method": ("point", [each.name for each, _ in rows]),
        "setting": ("point", [setting for _, setting in rows]),
    }


def _wrench_error(force: Array, torque: Array) -> list[float]:
    found = zip(SPIN_RATIOS, force, torque, strict=True)
    return [max(map(relative_error, map(float, (f, t)), wrench(float(k)))) for k, f, t in found]


def cone_errors() -> xr.Dataset:
    """Errors and evaluations of every method for motion cones, and of the models for a rim."""
    length, angle = edges()
    rows = [(each, setting) for each in cone_methods() for setting in each.settings]
    results = [each.run(length, angle, setting) for each, setting in rows]
    errors = [angle_errors(each, length, angle, ROD_ANGLE) for each, _ in results]
    rim = rim_errors()
    variables = {
        "cone_error": ("point", [each.max() for each in errors]),
        "cone_error_mean": ("point", [each.mean() for each in errors]),
        "evaluations": ("point", [float(count.mean()) for _, count in results]),
        "rim_error": ("model", list(rim.values())),
    }
    return labelled(variables, _points(rows) | {"model": list(rim)}, "Motion cone")
