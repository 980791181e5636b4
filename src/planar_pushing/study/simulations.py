"""Scene files simulated: their section `simulate` as arguments of `simulate`."""

from __future__ import annotations

import math
from typing import Any

import xarray as xr

from planar_pushing.simulation.pusher import Pusher
from planar_pushing.simulation.simulate import simulate
from planar_pushing.study.files.replacing import PathLike
from planar_pushing.study.files.scene_model import SceneFile
from planar_pushing.study.files.simulate_model import PieceEntry, SimulateEntry
from planar_pushing.terms.errors import InvalidValue


def simulate_file(
    file: SceneFile, *, path: PathLike | None = None, progress: bool = False
) -> xr.Dataset:
    """Simulate what a scene file holds; parameters and errors as in `simulate`.

    Raises
    ------
    InvalidValue
        Where the file has no section `simulate`.
    """
    if file.simulate is None:
        raise InvalidValue("simulate", None, "a section of the scene file", "add it to the file")
    scene, settings = file.build(), arguments(file.simulate)
    return simulate(scene, **settings, path=path, progress=progress)


def arguments(entry: SimulateEntry) -> dict[str, Any]:
    """Keyword arguments of `simulate`; angles in radians."""
    twist = entry.initial_twist
    return {
        "pusher": Pusher(
            velocity=[(piece.time, velocity(piece)) for piece in entry.pieces],
            shape=entry.pusher_shape,
        ),
        "duration": entry.duration,
        "method": entry.method,
        "rtol": entry.rtol,
        "on_ambiguity": [(piece.time, piece.policy) for piece in entry.policies],
        "twist": (twist.v_x, twist.v_y, math.radians(twist.omega)) if twist else (0.0, 0.0, 0.0),
        "gap": entry.initial_gap,
        "samples": int(entry.samples),
        "step": entry.step,
    }


def velocity(piece: PieceEntry) -> tuple[float, float]:
    """Velocity of the fence; along the fence and across it without the rounding of pi."""
    angle = math.radians(piece.angle % 360)
    x, y = piece.speed * math.cos(angle), piece.speed * math.sin(angle)
    return (0.0 if piece.angle % 180 == 90 else x), (0.0 if piece.angle % 180 == 0 else y)
