"""The log of a simulation as arrays: its variables, and the attributes that say where it comes from."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from importlib.metadata import version
from typing import Any, NamedTuple

import numpy as np
import xarray as xr

from planar_pushing.mechanics.angles import RESOLUTION
from planar_pushing.mechanics.contact import ContactMode, Outcome
from planar_pushing.mechanics.errors import InvalidValue
from planar_pushing.mechanics.scene import Scene
from planar_pushing.simulation.problem import Problem
from planar_pushing.simulation.record import NO_MODE, Record
from planar_pushing.study.describe import PACKAGES, to_json
from planar_pushing.study.files import scene_entry


class Variable(NamedTuple):
    """Dimensions after time, type, unit and long name of a variable of the log."""

    dims: tuple[str, ...]
    dtype: str
    units: str
    long_name: str


VARIABLES = {
    "position": Variable(("xy",), "f8", "length", "ring centre, from the contact at time 0"),
    "rod_angle": Variable((), "f8", "degree", "rod angle, not taken modulo a turn"),
    "twist": Variable(
        ("twist_component",), "f8", "length/time",
        "twist of the slider at the ring centre, rotation times radius",
    ),
    "fence": Variable(("xy",), "f8", "length", "displacement of the fence"),
    "slip": Variable((), "f8", "length", "slip of the contact along the fence, accumulated"),
    "gap": Variable((), "f8", "length", "height of the contact point above the fence"),
    "force": Variable(("xy",), "f8", "force", "force of the fence on the slider"),
    "mode": Variable((), "i1", "1", "contact mode"),
    "outcome": Variable((), "i1", "1", "number of consistent solutions: none, one, several"),
    "solutions": Variable((), "i1", "1", "number of consistent solutions"),
    "adhesive": Variable((), "i1", "1", "whether the fence pulls on the slider"),
    "spin_ratio": Variable((), "f8", "1", "spin ratio R omega / v"),
    "dissipated": Variable(
        ("effect",), "f8", "force length", "energy dissipated by each effect, accumulated"
    ),
    "contact_dissipated": Variable(
        (), "f8", "force length", "energy dissipated at the contact, accumulated"
    ),
    "work": Variable((), "f8", "force length", "work of the fence on the slider, accumulated"),
    "kinetic_energy": Variable((), "f8", "force length", "kinetic energy of the slider"),
    "evaluations": Variable(
        ("effect",), "i8", "1", "how often each effect was evaluated, accumulated"
    ),
}  # fmt: skip
TIME = {"units": "time", "long_name": "time"}
MODES = {"NONE": NO_MODE} | {mode.name: int(mode) for mode in ContactMode}
OUTCOMES = {outcome.name: int(outcome) for outcome in Outcome}
FLAGS = {"mode": MODES, "outcome": OUTCOMES}
EFFECTS = {1: "support_friction", 2: "inertia"}
NOTES = {
    "length": "the unit of the scene's lengths",
    "time": "the unit of the simulated duration",
    "force": "the unit of the scene's weight; without friction mass length / time^2",
}


def arrays(records: Sequence[Record]) -> dict[str, Any]:
    """The variables of the log, and `time`; angles in degrees."""
    columns: dict[str, Any] = dict(zip(Record._fields, zip(*records, strict=True), strict=True))
    force = np.array(columns["force"])
    columns["rod_angle"] = np.rad2deg(columns["rod_angle"])
    columns["outcome"] = np.minimum(columns["solutions"], Outcome.AMBIGUOUS)
    columns["adhesive"] = force[:, 1] < -RESOLUTION * np.hypot(force[:, 0], force[:, 1])
    values: dict[str, Any] = {"time": np.array(columns["time"], "f8")}
    return values | {
        name: np.array(columns[name], variable.dtype) for name, variable in VARIABLES.items()
    }


def coordinates(scene: Scene) -> dict[str, list[str]]:
    """Labels along the dimensions other than time."""
    names = [EFFECTS.get(effect.degree, "effect") for effect in scene.effects]
    repeated = [name if names.count(name) == 1 else f"{name}_{i}" for i, name in enumerate(names)]
    return {
        "xy": ["x", "y"],
        "twist_component": ["v_x", "v_y", "R omega"],
        "effect": repeated,
    }


COORDINATES = {
    "xy": "along the fence, normal to the fence",
    "twist_component": "component of the twist",
    "effect": "effect that resists the motion",
}


def variable_attributes(name: str) -> dict[str, Any]:
    """Unit, long name and flags of a variable."""
    variable = VARIABLES[name]
    attributes: dict[str, Any] = {"units": variable.units, "long_name": variable.long_name}
    if name in FLAGS:
        attributes["flag_values"] = np.array(list(FLAGS[name].values()), np.int8)
        attributes["flag_meanings"] = " ".join(FLAGS[name])
    return attributes


@cache
def _versions() -> str:
    return to_json({name: version(name) for name in PACKAGES})


def attributes(problem: Problem, method: str) -> dict[str, Any]:
    """Attributes of the log that are known before the run."""
    pusher = problem.pusher
    return {
        "title": "motion of the pushed slider",
        "source": "Lynch and Mason, Pulling by Pushing, Slip with Infinite Friction, "
        "and Perfectly Rough Surfaces, Secs. 2-5, over time",
        "scene": _scene(problem.scene),
        "pusher": to_json(pusher.pieces) if pusher.pieces else "function of time",
        "duration": problem.duration,
        "initial_twist": np.array(problem.twist),
        "initial_gap": problem.gap,
        "method": method,
        "on_ambiguity": str(problem.on_ambiguity),
        "rtol": problem.rtol,
        "unit_notes": to_json(NOTES),
        "versions": _versions(),
    }


def _scene(scene: Scene) -> str:
    try:
        return to_json(scene_entry(scene))
    except InvalidValue:  # an effect or a law that scene files have no name for
        return repr(scene)


def ending(record: Record) -> dict[str, Any]:
    """Attributes of the log that the last record settles."""
    return {"finished": 1, "stopped": record.stopped, "stopped_time": record.time}


def dataset(problem: Problem, method: str, records: Sequence[Record]) -> xr.Dataset:
    """The log of a run that has ended, in memory."""
    values = arrays(records)
    coords: dict[str, Any] = {"time": ("time", values.pop("time"), TIME)}
    for name, labels in coordinates(problem.scene).items():
        coords[name] = (name, labels, {"units": "1", "long_name": COORDINATES[name]})
    variables = {
        name: (("time", *VARIABLES[name].dims), value, variable_attributes(name))
        for name, value in values.items()
    }
    attrs = attributes(problem, method) | ending(records[-1])
    return xr.Dataset(variables, coords, attrs)
