"""The log of a simulation as arrays: its variables, and the attributes that say where it comes from."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.mechanics.angles import RESOLUTION
from planar_pushing.mechanics.contact import ContactMode, Outcome
from planar_pushing.mechanics.entries import scene_entry, to_json, versions
from planar_pushing.mechanics.scene import Scene
from planar_pushing.simulation.problem import Problem
from planar_pushing.simulation.rows import NO_MODE
from planar_pushing.terms import quantities
from planar_pushing.terms.options import EFFECT_DEGREES

#: Dimensions after time, and type, of the variables of the log.
VARIABLES: dict[str, tuple[tuple[str, ...], str]] = {
    "position": (("xy",), "f8"),
    "rod_angle": ((), "f8"),
    "twist": (("twist_component",), "f8"),
    "fence": (("xy",), "f8"),
    "slip": ((), "f8"),
    "gap": ((), "f8"),
    "force": (("xy",), "f8"),
    "mode": ((), "i1"),
    "outcome": ((), "i1"),
    "solutions": ((), "i1"),
    "adhesive": ((), "?"),
    "spin_ratio": ((), "f8"),
    "dissipated": (("effect",), "f8"),
    "contact_dissipated": ((), "f8"),
    "work": ((), "f8"),
    "kinetic_energy": ((), "f8"),
    "evaluations": (("effect",), "i8"),
}
MODES = {"NONE": NO_MODE} | {mode.name: int(mode) for mode in ContactMode}
OUTCOMES = {outcome.name: int(outcome) for outcome in Outcome}
FLAGS = {"mode": MODES, "outcome": OUTCOMES}


def arrays(rows: Any, scene: Scene) -> dict[str, Any]:
    """The variables of the log, and `time`, from rows in the units of the scene; angles in degrees."""
    force = rows["force"]
    own = {
        "rod_angle": np.rad2deg(rows["rod_angle"]),
        "outcome": np.minimum(rows["solutions"], Outcome.AMBIGUOUS),
        "adhesive": force[:, 1] < -RESOLUTION * np.hypot(force[:, 0], force[:, 1]),
        "dissipated": rows["dissipated"][:, None] * _shares(scene),
        "evaluations": np.repeat(rows["evaluations"][:, None], len(scene.effects), axis=1),
    }
    return {"time": np.array(rows["time"])} | {
        name: np.array(own[name] if name in own else rows[name], dtype)
        for name, (_, dtype) in VARIABLES.items()
    }


def _shares(scene: Scene) -> list[float]:
    """Part of the friction on the support that is each effect's: the core adds effects of one kind."""
    return [float(getattr(effect, "weight", 0.0) / scene.weight) for effect in scene.effects]


def coordinates(scene: Scene) -> dict[str, list[str]]:
    """Labels along the dimensions other than time."""
    names = [str(EFFECT_DEGREES.get(effect.degree, "effect")) for effect in scene.effects]
    repeated = [name if names.count(name) == 1 else f"{name}_{i}" for i, name in enumerate(names)]
    return {
        "xy": ["x", "y"],
        "twist_component": ["v_x", "v_y", "R omega"],
        "effect": repeated,
    }


def variable_attributes(name: str) -> dict[str, Any]:
    """Unit, long name and flags of a variable or a coordinate."""
    attributes: dict[str, Any] = dict(quantities.attributes(quantities.LOG, name))
    if name in FLAGS:
        attributes["flag_values"] = np.array(list(FLAGS[name].values()), np.int8)
        attributes["flag_meanings"] = " ".join(FLAGS[name])
    return attributes


def attributes(problem: Problem, method: str) -> dict[str, Any]:
    """Attributes of the log that are known before the run."""
    pusher = problem.pusher
    return {
        "title": "motion of the pushed slider",
        "source": f"{quantities.PAPER}, Secs. 2-5, over time",
        **quantities.GLOBAL,
        "scene": to_json(scene_entry(problem.scene)),
        "pusher": to_json(pusher.pieces) if pusher.pieces else "function of time",
        "duration": problem.duration,
        "initial_twist": np.array(problem.twist),
        "initial_gap": problem.gap,
        "method": str(method),
        "on_ambiguity": str(problem.on_ambiguity),
        "rtol": problem.rtol,
        "unit_notes": to_json(quantities.LOG_NOTES),
        "versions": versions(),
    }


def ending(stopped: str, time: float) -> dict[str, Any]:
    """Attributes of the log that the end of the run settles."""
    return {"finished": 1, "stopped": stopped, "stopped_time": time}


def dataset(problem: Problem, method: str, rows: Any) -> xr.Dataset:
    """The log of a run in memory, without what its end settles."""
    values = arrays(rows, problem.scene)
    coords: dict[str, Any] = {"time": ("time", values.pop("time"), variable_attributes("time"))}
    for name, labels in coordinates(problem.scene).items():
        coords[name] = (name, labels, variable_attributes(name))
    variables = {
        name: (("time", *VARIABLES[name][0]), value, variable_attributes(name))
        for name, value in values.items()
    }
    return xr.Dataset(variables, coords, attributes(problem, method))
