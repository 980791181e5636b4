"""Simulation of scene files, with their section `simulate` as arguments of `simulate`."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import xarray as xr

from planar_pushing.mechanics.entries import to_json
from planar_pushing.mechanics.scene import Scene
from planar_pushing.scenes.contacts_model import ContactsFile
from planar_pushing.scenes.scene_model import SceneFile
from planar_pushing.scenes.simulate_model import SimulateEntry
from planar_pushing.simulation.early_end import quietly, warn_of_early_end
from planar_pushing.simulation.pusher import Pusher
from planar_pushing.simulation.simulate import simulate
from planar_pushing.simulation.until import Until
from planar_pushing.simulation.walls import Wall
from planar_pushing.simulation.world import world_of
from planar_pushing.terms.errors import InvalidValue
from planar_pushing.terms.netcdf import write_dataset
from planar_pushing.terms.numbers import in_radians
from planar_pushing.terms.options import Policy, PusherFrame
from planar_pushing.terms.replacing import PathLike


@warn_of_early_end
def simulate_file(
    file: SceneFile, *, path: PathLike | None = None, progress: bool = False
) -> xr.Dataset:
    """Simulate the scene of a file; parameters and errors as in `simulate`.

    Raises
    ------
    InvalidValue
        If the file has no section `simulate`.
    """
    if file.simulate is None:
        raise InvalidValue("simulate", None, "a section of the scene file", "add it to the file")
    scene, settings = file.build(), arguments(file.simulate)
    return quietly(simulate)(scene, **settings, path=path, progress=progress)


@warn_of_early_end
def simulate_contacts_file(file: ContactsFile, path: PathLike | None = None) -> xr.Dataset:
    """Simulate the contacts of a file, and write the log; errors as in `simulate_contacts`.

    Raises
    ------
    InvalidValue
        If the file has no section `simulate`.
    """
    if file.simulate is None:
        raise InvalidValue(
            "simulate", None, "a section of the scene file",
            "add it to the file, as in simulate: {pushers: [{angle: 90}], duration: 1}",
        )  # fmt: skip
    # Several contacts import scipy.integrate, which takes longer than most simulations.
    from planar_pushing.objects.several.simulate_contacts import simulate_contacts

    log = quietly(simulate_contacts)(**file.arguments(file.simulate))
    log = log.assign_attrs(scene=to_json(file.model_dump(exclude_none=True)))
    if path is not None:
        write_dataset(log, path)
    return log


def arguments(entry: SimulateEntry) -> dict[str, Any]:
    """Keyword arguments of `simulate`; angles in radians."""
    twist, pose, until = entry.initial_twist, entry.object_pose, entry.until
    return {
        "pusher": Pusher(**entry.arguments_of_pusher),
        "duration": entry.duration,
        "method": entry.method,
        "rtol": entry.rtol,
        "on_ambiguity": [(piece.time, piece.policy) for piece in entry.policies],
        "twist": (twist.v_x, twist.v_y, math.radians(twist.omega)) if twist else (0.0, 0.0, 0.0),
        "gap": entry.initial_gap,
        "samples": int(entry.samples),
        "step": entry.step,
        "until": (until.event or until.mode or Until(**until.goals)) if until else None,
        "walls": [
            Wall(wall.point, wall.normal, wall.contact.build()) for wall in entry.walls or ()
        ],
        "object_pose": (pose.x, pose.y, float(in_radians(pose.angle))) if pose else None,
    }


#: Settings of a simulation that an assessment does not take, with their defaults.
NOT_ASSESSED = {
    "initial_twist": None, "initial_gap": 0.0, "walls": None, "until": None,
    "on_ambiguity": Policy.KEEP_CONTACT,
}  # fmt: skip


class AssessedPush(NamedTuple):
    """A push of a scene file to assess.

    Attributes
    ----------
    scene : Scene
    pusher : Pusher
        With its motion in the fence frame, or as given without an `object_pose`.
    duration : float
    candidates : dict
        Effects by the names of their types, numbered if there are several of a type.
    """

    scene: Scene
    pusher: Pusher
    duration: float
    candidates: dict[str, Any]


def assessed_push(file: SceneFile) -> AssessedPush:
    """The push in the section `simulate` of a file, and the effects that may matter besides.

    Raises
    ------
    InvalidValue
        If the file has no section `simulate`, or this has a setting that an assessment does not take.
    """
    entry = file.simulate
    if entry is None:
        raise InvalidValue("simulate", None, "a section of the scene file", "add it to the file")
    for name, default in NOT_ASSESSED.items():
        if (value := getattr(entry, name)) != default:
            parts = value if isinstance(value, tuple) else (value,)
            written = [
                part.model_dump(exclude_none=True) if hasattr(part, "model_dump") else part
                for part in parts
            ]
            raise InvalidValue(
                f"simulate.{name}", written if isinstance(value, tuple) else written[0],
                "a push from rest and in contact, without this key",
                "take it out: the push itself is assessed",
            )  # fmt: skip
    scene, settings = file.build(), arguments(entry)
    pusher, pose = settings["pusher"], settings["object_pose"]
    if pose is not None and pusher.frame == PusherFrame.WORLD:
        pusher = pusher.in_fence_frame(world_of(scene, pose).fence)
    kinds = [effect.type for effect in entry.candidates or ()]
    names = [kind if kinds.count(kind) == 1 else f"{kind}_{i}" for i, kind in enumerate(kinds)]
    effects = (effect.build() for effect in entry.candidates or ())
    return AssessedPush(scene, pusher, settings["duration"], dict(zip(names, effects, strict=True)))
