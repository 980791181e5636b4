"""A log in numbers: the entries, and the scene and the fence that its attributes hold."""

from __future__ import annotations

import json
import math
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt
import xarray as xr

from planar_pushing.evidence.golden.residual.finding import EPSILON
from planar_pushing.evidence.golden.residual.motion import Slider
from planar_pushing.terms.options import EffectSet

Floats = npt.NDArray[np.float64]
SEPARATE, STICK, SLIP_RIGHT, SLIP_LEFT = range(4)


class Log(NamedTuple):
    """Entries of a log over time, lengths in units of R.

    Attributes
    ----------
    slider : Slider
    effects : str
        Name of the set of effects.
    length : float
    friction : float
        Coefficient of friction, infinite for laws without one.
    mode : ndarray of int
    lever : ndarray, shape (n, 2)
        From the contact to the ring center.
    position, velocity : ndarray, shape (n, 2)
        Of the ring center.
    spin : ndarray
        omega, in radians per time.
    fence, fence_velocity : ndarray, shape (n, 2)
    force : ndarray, shape (n, 2)
    """

    slider: Slider
    effects: str
    length: float
    friction: float
    mode: Any
    lever: Floats
    position: Floats
    velocity: Floats
    spin: Floats
    fence: Floats
    fence_velocity: Floats
    force: Floats

    @property
    def contact(self) -> Floats:
        """Position of the contact."""
        return self.position - self.lever

    @property
    def contact_velocity(self) -> Floats:
        """Velocity of the contact."""
        return self.velocity + self.spin[:, None] * self.lever[:, ::-1] * [1.0, -1.0]

    @property
    def pace(self) -> Floats:
        """Size of the velocities that make up the contact's."""
        return np.asarray(np.hypot(*self.velocity.T) + self.length * np.abs(self.spin))


def read(dataset: xr.Dataset) -> tuple[Log, float]:
    """The log and its radius, the unit of its lengths."""
    scene, pieces = json.loads(dataset.attrs["scene"]), json.loads(dataset.attrs["pusher"])
    radius, length = scene["slider"]["radius"], scene["slider"]["rod_length"]
    angle = np.deg2rad(dataset["rod_angle"].values)
    way, velocity = _fence(pieces, dataset["time"].values)
    fence = way - [0.0, dataset.attrs["initial_gap"]]
    twist = dataset["twist"].values
    log = Log(
        *_effects(scene["effects"], radius), length / radius,
        scene["contact"].get("friction_coefficient", math.inf), dataset["mode"].values,
        length / radius * np.stack([np.cos(angle), np.sin(angle)], axis=-1),
        dataset["position"].values / radius, twist[:, :2] / radius, twist[:, 2],
        fence / radius, velocity / radius, dataset["force"].values,
    )  # fmt: skip
    return log, radius


def _effects(entries: list[dict[str, Any]], radius: float) -> tuple[Slider, str]:
    found = {each["type"]: each for each in entries}
    weight = sum(each.get("weight", 0.0) for each in entries)
    inertia = found.get("inertia", {"mass": 0.0, "gyration_radius": radius})
    # Forces are W and m a with lengths in units of R: the mass carries one R.
    slider = Slider(weight, inertia["mass"] * radius, (inertia["gyration_radius"] / radius) ** 2)
    kinds = [EffectSet.SUPPORT_FRICTION] * (weight > 0) + [EffectSet.INERTIA] * ("inertia" in found)
    return slider, "+".join(kinds)


def _fence(pieces: list[Any], time: Floats) -> tuple[Floats, Floats]:
    """Displacement and velocity of the fence, whose velocity is constant from piece to piece."""
    starts = np.array([piece[0] for piece in pieces], dtype=float)
    speeds = np.array([piece[1] for piece in pieces], dtype=float)
    ways = np.concatenate([[[0.0, 0.0]], np.cumsum(np.diff(starts)[:, None] * speeds[:-1], axis=0)])
    piece = np.searchsorted(starts, time, side="right") - 1
    return ways[piece] + (time - starts[piece])[:, None] * speeds[piece], speeds[piece]


def rounding(size: Any, count: float) -> Any:
    """What a count of roundings makes of numbers of a size."""
    return count * EPSILON * np.asarray(size)
