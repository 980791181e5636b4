"""The log of a simulation as a dataset: its coordinates, and attributes that describe its origin."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cache
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr
from xarray.indexes import PandasIndex

from planar_pushing.core.motion.kinematics.mode import NO_MODE
from planar_pushing.core.motion.kinematics.run import LogRow
from planar_pushing.mechanics.entries import scene_entry, to_json, versions
from planar_pushing.mechanics.kernels.arrays import flag_attributes
from planar_pushing.mechanics.plane import direction
from planar_pushing.simulation.fields import arrays, logged_fields
from planar_pushing.simulation.problem import Problem
from planar_pushing.terms import quantities
from planar_pushing.terms.errors import InvalidValue
from planar_pushing.terms.numbers import Array
from planar_pushing.terms.options import FLAGS as RESULTS
from planar_pushing.terms.options import Event, Shape
from planar_pushing.terms.quantities import LOG_TWIST_UNITS
from planar_pushing.terms.units import Units, unit_names, with_units

if TYPE_CHECKING:
    import pandas as pd

#: Names and numbers of flags, in logs and in batches.
FLAGS: dict[str, Mapping[str, int]] = {
    "mode": {"NONE": NO_MODE, **RESULTS["mode"]},
    "outcome": RESULTS["outcome"],
    "event": Event.__members__,
}


def _effect_names(problem: Problem) -> list[str]:
    """Names of the effects; those that occur several times are numbered."""
    names = [str(effect.kind) for effect in problem.scene.effects]
    return [name if names.count(name) == 1 else f"{name}_{i}" for i, name in enumerate(names)]


def coordinates(problem: Problem) -> dict[str, tuple[str, list[str]]]:
    """Labels along the dimensions other than time, each with its dimension, and units of components."""
    return {
        "xy": ("xy", ["x", "y"]),
        "twist_component": ("twist_component", list(quantities.TWIST)),
        "twist_unit": ("twist_component", unit_names(LOG_TWIST_UNITS, problem.scene.units)),
        "effect": ("effect", _effect_names(problem)),
    }


def variable_attributes(
    table: quantities.Quantities, name: str, units: Units | None = None
) -> dict[str, Any]:
    """Unit, long name and flags of a variable or a coordinate."""
    attributes: dict[str, Any] = with_units(quantities.attributes(table, name), units)
    if name in FLAGS:
        attributes |= flag_attributes(FLAGS[name])
    return attributes


def field_attributes(problem: Problem, name: str) -> dict[str, Any]:
    """Unit, long name and flags of a variable or a coordinate of a log."""
    known = _all_attributes(problem.shape == Shape.FINGER, problem.scene.units)[name]
    # A user can write to the flags of a log.
    return {key: np.copy(value) if key == "flag_values" else value for key, value in known.items()}


@cache
def _all_attributes(has_finger: bool, units: Units | None) -> dict[str, dict[str, Any]]:
    """Attributes of all variables and coordinates of a log, by their names."""
    table = quantities.FINGER if has_finger else quantities.LOG
    return {name: variable_attributes(table, name, units) for name in table}


def global_attributes(problem: Problem, method: str) -> dict[str, Any]:
    """Attributes of the log that are known before the run."""
    pusher, policies = problem.pusher, problem.on_ambiguity
    finger = {"pusher_shape": str(problem.shape)} if problem.shape == Shape.FINGER else {}
    radius: Any = pusher.radius
    disc = {"pusher_radius": float(radius)} if radius else {}
    placed = {} if problem.object_pose is None else _pose_attributes(problem)
    is_object = problem.scene.placement is not None
    masses = _mass_attributes(problem) if problem.scene.masses and is_object else {}
    return {
        "title": "motion of the pushed slider",
        "source": f"{quantities.PAPER}, Secs. 2-5, over time",
        **quantities.GLOBAL,
        "scene": to_json(scene_entry(problem.scene)),
        "pusher": to_json(pusher.pieces) if pusher.pieces else "function of time",
        **finger,
        **disc,
        "duration": float(problem.duration),
        "initial_twist": np.array(problem.twist, float),
        "initial_twist_units": ", ".join(unit_names(LOG_TWIST_UNITS, problem.scene.units)),
        "initial_gap": float(problem.gap),
        **placed,
        **masses,
        "method": str(method),
        "on_ambiguity": policies[0][1].value if len(policies) == 1 else to_json(policies),
        "rtol": float(problem.rtol),
        "unit_notes": to_json({} if problem.scene.units else quantities.LOG_NOTES),
        "versions": versions(),
    }


def _pose_attributes(problem: Problem) -> dict[str, Any]:
    """The object's pose at time 0 as the user gives it, in radians, and its units."""
    units = unit_names(("length", "length", "radian"), problem.scene.units)
    return {
        "object_pose": np.array(problem.object_pose, float),
        "object_pose_units": ", ".join(units),
    }


def _mass_attributes(problem: Problem) -> dict[str, Any]:
    """The center of mass in the object's frame, which a user can leave to its default."""
    scene, psi = problem.scene, problem.scene.slider.rod_angle
    x, y = (scene.slider.radius * coordinate for coordinate in scene.mass_center)
    along = scene.slider.rod_length + x
    (c, s), unit = direction(psi), unit_names(("length",), scene.units)[0]
    center = scene.to_object((along * c - y * s, along * s + y * c), "point")
    return {"center_of_mass": center, "center_of_mass_units": unit}


def attributes_at_start(problem: Problem, method: str) -> dict[str, Any]:
    """Attributes of the log of a run that has not ended."""
    return global_attributes(problem, method) | {"finished": np.int8(0)}


def attributes_at_end(stopped: str, time: float) -> dict[str, Any]:
    """Attributes of the log that are known at the end of the run."""
    return {"finished": np.int8(1), "stopped": stopped, "stopped_time": float(time)}


def dataset(problem: Problem, method: str, rows: Array, stopped: str) -> xr.Dataset:
    """The log in memory of a run that has ended, with the reason for an early end."""
    time, *fields = logged_fields(problem, method)
    values = arrays(rows, problem, [time, *fields])
    variables = {
        name: xr.Variable(("time", *dims), values[name], field_attributes(problem, name))
        for name, _, dims, *_ in fields
    }
    known = global_attributes(problem, method) | attributes_at_end(
        stopped, rows[-1, LogRow.places["time"]]
    )
    return xr.Dataset(variables, _labels(problem, values["time"]), known)


def _labels(problem: Problem, times: Array) -> xr.Coordinates:
    """Coordinates of the log, with their indexes, which xarray would otherwise derive for each log."""
    labels: dict[str, tuple[str, Any]] = {"time": ("time", times), **coordinates(problem)}
    indexes: dict[str, PandasIndex] = {}
    variables: dict[str, xr.Variable] = {}
    for name, (dim, values) in labels.items():
        variable = xr.Variable(
            (dim,), np.asarray(values), field_attributes(problem, name), {"_FillValue": None}
        )
        if name == dim:
            indexes[name] = (
                _index(name, tuple(values)) if name != "time" else PandasIndex(times, name)
            )
            variables |= indexes[name].create_variables({name: variable})
        else:
            variables[name] = variable
    return xr.Coordinates(variables, indexes)


@cache
def _index(dim: str, labels: tuple[str, ...]) -> PandasIndex:
    """The index of the labels along a dimension."""
    array = np.array(labels)
    return PandasIndex(array, dim, array.dtype)


def without_fill_values(dataset: xr.Dataset) -> xr.Dataset:
    """A log or a batch whose coordinates are written without a fill value, since none is missing."""
    for name in dataset.coords:
        dataset.variables[name].encoding["_FillValue"] = None
    return dataset


def to_pandas(log: xr.Dataset) -> pd.DataFrame:
    """Convert a log to a table with one row per instant.

    Parameters
    ----------
    log : xarray.Dataset
        Log returned by `simulate`, or read from its file.

    Returns
    -------
    pandas.DataFrame
        Table with the index `time`, in the log's units. A variable with components has one column for each:
        `position_x`, `position_y`, `twist_v_x`, ..., `dissipated_support_friction`. Flags (`mode`, `event`,
        `outcome`) are categories with their names.

    Raises
    ------
    InvalidValue
        If the dataset is not a log.
    """
    import pandas as pd

    if not isinstance(log, xr.Dataset) or "time" not in log.dims or "time" not in log.coords:
        raise InvalidValue(
            "log", type(log).__name__, "a log of simulate, over time",
            "for a batch, use xarray's to_dataframe",
        )  # fmt: skip
    over_time = [log[name] for name, variable in log.data_vars.items() if "time" in variable.dims]
    columns = {name: column for variable in over_time for name, column in _columns(variable)}
    return pd.DataFrame(columns, index=pd.Index(log["time"].values, name="time"))


def _columns(variable: xr.DataArray) -> Iterator[tuple[str, Any]]:
    """Columns of a variable, by name."""
    components = [dim for dim in variable.dims if dim != "time"]
    if not components:
        yield str(variable.name), _categories(variable)
        return
    for label in variable[components[0]].values:
        yield f"{variable.name}_{label}", variable.sel({components[0]: label}).values


def _categories(variable: xr.DataArray) -> Any:
    """Values of a variable; flags are replaced by their names."""
    import pandas as pd

    if "flag_meanings" not in variable.attrs:
        return variable.values
    names = variable.attrs["flag_meanings"].split()
    flags = [int(flag) for flag in variable.attrs["flag_values"]]
    codes = [flags.index(int(value)) for value in variable.values]
    return pd.Categorical.from_codes(codes, categories=names)
