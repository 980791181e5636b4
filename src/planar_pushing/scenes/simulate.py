"""Simulation of scene files, with their section `simulate` as arguments of `simulate`."""

from __future__ import annotations

import math
from typing import Any

import xarray as xr

from planar_pushing.scenes.scene_model import SceneFile
from planar_pushing.scenes.simulate_model import PieceEntry, SimulateEntry
from planar_pushing.simulation.early_end import quietly, warn_of_early_end
from planar_pushing.simulation.pusher import Pusher
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
        "pusher": _pusher(entry),
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


def _pusher(entry: SimulateEntry) -> Pusher:
    """The pusher, from its velocities or its waypoints."""
    kind: dict[str, Any] = {"shape": entry.pusher_shape, "frame": entry.pusher_frame}
    if entry.pusher_radius is not None:
        kind["radius"] = entry.pusher_radius
    if entry.waypoints is not None:
        return Pusher(
            waypoints=[(waypoint.time, (waypoint.x, waypoint.y)) for waypoint in entry.waypoints],
            **kind,
        )
    return Pusher(velocity=[(piece.time, velocity(piece)) for piece in entry.pieces], **kind)


def velocity(piece: PieceEntry) -> tuple[float, float]:
    """Velocity of the fence; directions along and normal to the fence are free of rounding of pi."""
    angle = math.radians(piece.angle % 360)
    x, y = piece.speed * math.cos(angle), piece.speed * math.sin(angle)
    return (0.0 if piece.angle % 180 == 90 else x), (0.0 if piece.angle % 180 == 0 else y)
