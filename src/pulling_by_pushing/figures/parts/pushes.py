"""The pusher's motion over time in words for captions."""

from __future__ import annotations

import json
import math

import xarray as xr

from pulling_by_pushing.figures.parts.data import number


def told(data: xr.Dataset) -> str:
    """Speeds and directions of the pusher, such as "vₚ = 1 at 10°, then 1 at −10° from time 0.5"."""
    pieces = [_piece(*each) for each in json.loads(data.attrs["pusher"])]
    return "vₚ = " + ", ".join(pieces)


def _piece(time: float, velocity: tuple[float, float]) -> str:
    speed, angle = math.hypot(*velocity), math.degrees(math.atan2(velocity[1], velocity[0]))
    motion = f"{number(round(speed, 9))} at {number(round(angle, 9))}°"
    return f"then {motion} from time {number(time)}" if time else motion
