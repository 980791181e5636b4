"""Simulation of scene files, with their section `simulate` as arguments of `simulate`."""

from __future__ import annotations

import math
from typing import Any

import xarray as xr

from planar_pushing.scenes.scene_model import SceneFile
from planar_pushing.scenes.simulate_model import SimulateEntry
from planar_pushing.simulation.early_end import quietly, warn_of_early_end
from planar_pushing.simulation.simulate import simulate
from planar_pushing.simulation.until import Until
from planar_pushing.simulation.walls import Wall
from planar_pushing.terms.errors import InvalidValue
from planar_pushing.terms.numbers import in_radians
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


def arguments(entry: SimulateEntry) -> dict[str, Any]:
    """Keyword arguments of `simulate`; angles in radians."""
    twist, pose, until = entry.initial_twist, entry.object_pose, entry.until
    return {
        "pusher": entry.build_pusher(),
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
