"""Values in captions and labels, from the coordinates and variables of datasets."""

from __future__ import annotations

import re
from itertools import groupby
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    import xarray as xr

    from planar_pushing.mechanics.plane import Array

#: Velocities that differ by less are the same.
ROUNDING = 1e-9

#: Symbols of quantities in captions, and the sign after their values.
SYMBOLS = {
    "rod_length": ("l", ""),
    "rod_angle": ("ψ", "°"),
    "friction_coefficient": ("μ", ""),
    "pusher_angle": ("θₚ", "°"),
    "radius": ("R", ""),
    "weight": ("W", ""),
    "mass": ("m", ""),
    "gyration_radius": ("ρ", ""),
}


def values(data: xr.Dataset, *names: str) -> str:
    """Values of quantities for a caption, such as "l = 3, ψ = 45°"."""
    return ", ".join(
        f"{SYMBOLS[name][0]} = {_text(data[name].values, SYMBOLS[name][1])}" for name in names
    )


def _text(numbers: Any, sign: str) -> str:
    texts = [f"{number(float(value))}{sign}" for value in np.atleast_1d(numbers)]
    return texts[0] if len(texts) == 1 else f"{', '.join(texts[:-1])} and {texts[-1]}"


def acceleration(data: xr.Dataset) -> float:
    """Magnitude of the pusher's acceleration in units of mu_s g, where W = mu_s m g."""
    return float(data.pusher_magnitude * data.mass / data.weight)


def number(value: float, digits: int = 6) -> str:
    """Number as text, with signs for infinity and minus."""
    if np.isinf(value):
        return "∞" if value > 0 else "−∞"
    return f"{value:.{digits}g}".replace("-", "−")


def mathematical(value: float) -> str:
    """Number as mathematical text of a label, with a sign for infinity."""
    return r"\infty" if np.isinf(value) else f"{value:g}"


def degrees(angle: float) -> str:
    """Angle as mathematical text, to a tenth of a degree."""
    return rf"${angle:.1f}^\circ$"


def words(name: str) -> str:
    """Name of a support in prose: rectangle_2_1 is "rectangle 2:1", l_shape "L shape"."""
    parts = re.sub(r"(\d)_(?=\d)", r"\1:", name).split("_")
    return " ".join(part.upper() if len(part) == 1 else part for part in parts)


def crosses(slider: xr.Dataset) -> bool:
    """Whether the ring of a slider crosses the fence, which then passes above the ring."""
    height = float(slider.rod_length) * np.sin(np.deg2rad(float(slider.rod_angle)))
    return bool(height < float(slider.radius))


def pusher_motion(log: xr.Dataset) -> str:
    """Speeds and directions of the pusher, such as "vₚ = 1 at 10°, then 1 at −10° from time 0.5"."""
    times = log.time.values
    velocity = np.diff(log.pusher.values, axis=0) / np.diff(times)[:, None]
    turns = np.any(np.abs(np.diff(velocity, axis=0)) > ROUNDING, axis=1)
    starts = [0, *(np.flatnonzero(turns) + 1)]
    # Around an event, times are so close that the velocity is inexact, but its text is the same.
    motions = groupby(starts, key=lambda row: _motion(velocity[row]))
    first, *others = [(motion, number(times[next(rows)])) for motion, rows in motions]
    return ", ".join(
        [f"vₚ = {first[0]}", *(f"then {motion} from time {time}" for motion, time in others)]
    )


def _motion(velocity: Array) -> str:
    speed, angle = np.hypot(*velocity), np.rad2deg(np.arctan2(*velocity[::-1]))
    return f"{number(round(float(speed), 9))} at {number(round(float(angle), 9))}°"
