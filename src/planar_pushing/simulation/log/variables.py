"""The log of a simulation as arrays: its variables, and attributes that describe its origin."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.mechanics.angles import RESOLUTION
from planar_pushing.mechanics.contact import Outcome
from planar_pushing.mechanics.effects import Inertia, Load, Viscous
from planar_pushing.mechanics.entries import scene_entry, to_json, versions
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.status import FLAGS as RESULTS
from planar_pushing.mechanics.status import flag_attributes
from planar_pushing.simulation.problem import Problem
from planar_pushing.simulation.rows import NO_MODE, Stop
from planar_pushing.simulation.systems.setup import order_of
from planar_pushing.terms import quantities
from planar_pushing.terms.options import EffectKind, Event, Shape
from planar_pushing.terms.quantities import LOG_TWIST_UNITS
from planar_pushing.terms.units import Units, unit_names, with_units

#: Dimensions after time, and types, of the variables of the log.
VARIABLES: dict[str, tuple[tuple[str, ...], str]] = {
    "position": (("xy",), "f8"),
    "rod_angle": ((), "f8"),
    "twist": (("twist_component",), "f8"),
    "pusher": (("xy",), "f8"),
    "slip": ((), "f8"),
    "gap": ((), "f8"),
    "force": (("xy",), "f8"),
    "mode": ((), "i1"),
    "pivot": ((), "i4"),
    "event": ((), "i1"),
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
#: Additional variables for a finger.
FINGER: dict[str, tuple[tuple[str, ...], str]] = {
    "contact_position": ((), "f8"),
    "parted": ((), "?"),
}
#: Additional variables for an object with a given pose in the world.
PLACED: dict[str, tuple[tuple[str, ...], str]] = {
    "object_position": (("xy",), "f8"),
    "object_angle": ((), "f8"),
    "pusher_position": (("xy",), "f8"),
}
#: Additional variables for a slider with loads.
LOADED: dict[str, tuple[tuple[str, ...], str]] = {"load_work": ((), "f8")}
#: Names and numbers of flags, in logs and in batches.
FLAGS: dict[str, Mapping[str, int]] = {
    "mode": {"NONE": NO_MODE, **RESULTS["mode"]},
    "outcome": RESULTS["outcome"],
    "event": Event.__members__,
    "stopped": Stop.__members__,
}


def variables(problem: Problem) -> dict[str, tuple[tuple[str, ...], str]]:
    """Dimensions after time, and types, of the variables of a problem's log."""
    finger = FINGER if problem.shape == Shape.FINGER else {}
    placed = {} if problem.object_pose is None else PLACED
    return VARIABLES | finger | (LOADED if problem.scene.loads else {}) | placed


def arrays(rows: Any, problem: Problem) -> dict[str, Any]:
    """Variables of the log, and `time`, from rows in the units of the scene; angles in degrees."""
    force, scene = rows["force"], problem.scene
    own = {
        "rod_angle": np.rad2deg(rows["rod_angle"]),
        "outcome": np.minimum(rows["solutions"], Outcome.AMBIGUOUS),
        "adhesive": _pressure(rows, problem) < -RESOLUTION * np.hypot(force[:, 0], force[:, 1]),
        "dissipated": _dissipated(rows["dissipated"], scene),
        "evaluations": np.repeat(rows["evaluations"][:, None], len(scene.effects), axis=1),
    }
    own |= _placed(rows, problem)
    return {"time": np.array(rows["time"])} | {
        name: np.array(own[name] if name in own else rows[name], dtype)
        for name, (_, dtype) in variables(problem).items()
    }


def _placed(rows: Any, problem: Problem) -> dict[str, Any]:
    """Poses of the object and positions of the pusher in the world."""
    if problem.world is None:
        return {}
    position, angle = problem.world.object_pose(rows["position"], rows["rod_angle"])
    return {
        "object_position": position,
        "object_angle": angle,
        # At time 0 the center of a finger is one radius below the contact.
        "pusher_position": problem.world.fence.point_out(
            rows["pusher"] - (0.0, problem.pusher.radius)
        ),
    }


def _pressure(rows: Any, problem: Problem) -> Any:
    """Normal component of the pusher's force; the normal of a finger's side rotates with the slider."""
    if problem.shape == Shape.FENCE:
        return rows["force"][:, 1]
    turned = rows["rod_angle"] - problem.scene.slider.rod_angle
    return rows["force"][:, 1] * np.cos(turned) - rows["force"][:, 0] * np.sin(turned)


def _dissipated(energies: Any, scene: Scene) -> Any:
    """Energy dissipated by each effect, zero for nondissipative ones; shape (rows, effects)."""
    found = np.zeros((len(energies), len(scene.effects)))
    for i, index in enumerate(order_of(scene)):
        if index >= 0:
            found[:, i] = energies[:, index]
    return found


def _name_of(effect: Any) -> EffectKind:
    """Kind of an effect."""
    kinds = {Inertia: EffectKind.INERTIA, Viscous: EffectKind.VISCOUS, Load: EffectKind.LOAD}
    return kinds.get(type(effect), EffectKind.SUPPORT_FRICTION)


def coordinates(problem: Problem) -> dict[str, tuple[str, list[str]]]:
    """Labels along the dimensions other than time, each with its dimension, and units of components."""
    names = [str(_name_of(effect)) for effect in problem.scene.effects]
    repeated = [name if names.count(name) == 1 else f"{name}_{i}" for i, name in enumerate(names)]
    return {
        "xy": ("xy", ["x", "y"]),
        "twist_component": ("twist_component", list(quantities.TWIST)),
        "twist_unit": ("twist_component", unit_names(LOG_TWIST_UNITS, problem.scene.units)),
        "effect": ("effect", repeated),
    }


def table_of(shape: Shape) -> quantities.Quantities:
    """Units and long names in the log for a pusher of this shape."""
    return quantities.FINGER if shape == Shape.FINGER else quantities.LOG


def described(
    table: quantities.Quantities, name: str, units: Units | None = None
) -> dict[str, Any]:
    """Unit, long name and flags of a variable or a coordinate."""
    attributes: dict[str, Any] = with_units(quantities.attributes(table, name), units)
    if name in FLAGS:
        attributes |= flag_attributes(FLAGS[name])
    return attributes


def attributes(problem: Problem, method: str) -> dict[str, Any]:
    """Attributes of the log that are known before the run."""
    pusher, policies = problem.pusher, problem.on_ambiguity
    finger = {"pusher_shape": str(problem.shape)} if problem.shape == Shape.FINGER else {}
    radius: Any = pusher.radius
    disc = {"pusher_radius": float(radius)} if radius else {}
    placed = {} if problem.object_pose is None else _pose_attributes(problem)
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
        "method": str(method),
        "on_ambiguity": policies[0][1].value if len(policies) == 1 else to_json(policies),
        "rtol": float(problem.rtol),
        "unit_notes": to_json({} if problem.scene.units else quantities.LOG_NOTES),
        "versions": versions(),
    }


def _pose_attributes(problem: Problem) -> dict[str, Any]:
    """The object's pose at time 0 as it is given, in radians, and its units."""
    units = unit_names(("length", "length", "radian"), problem.scene.units)
    return {
        "object_pose": np.array(problem.object_pose, float),
        "object_pose_units": ", ".join(units),
    }


def beginning(problem: Problem, method: str) -> dict[str, Any]:
    """Attributes of the log of a run that has not ended."""
    return attributes(problem, method) | {"finished": np.int8(0)}


def ending(stopped: str, time: float) -> dict[str, Any]:
    """Attributes of the log that are known at the end of the run."""
    return {"finished": np.int8(1), "stopped": stopped, "stopped_time": float(time)}


def dataset(problem: Problem, method: str, rows: Any, stopped: str) -> xr.Dataset:
    """The log in memory of a run that has ended, with the reason for an early end."""
    values, table = arrays(rows, problem), table_of(problem.shape)
    given, units = {"time": ("time", values["time"])} | coordinates(problem), problem.scene.units
    coords = {
        name: (dim, each, described(table, name, units)) for name, (dim, each) in given.items()
    }
    found = {
        name: (("time", *dims), values[name], described(table, name, units))
        for name, (dims, _) in variables(problem).items()
    }
    known = attributes(problem, method) | ending(stopped, rows["time"][-1])
    return complete(xr.Dataset(found, coords, known))


def complete(dataset: xr.Dataset) -> xr.Dataset:
    """A log or a batch whose coordinates are written without a fill value, since none is missing."""
    for coordinate in dataset.coords.values():
        coordinate.encoding["_FillValue"] = None
    return dataset
