"""A motion to be simulated: scene, fence, initial state, and what decides between contact modes.

The fence is the line ``y = Y(t)`` of a frame whose origin is the contact at time 0, and its
displacement is ``(X, Y)``. The rod angle is any real number. The contact is the rod's free end alone, so
the model holds as long as the ring's centre is above the fence; where it comes down to it, the rod
lies along the fence or under it, and a simulation stops there.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import isfinite
from typing import Any

import numpy as np

from planar_pushing.mechanics.scene import Scene, required_scene, required_single
from planar_pushing.simulation.pusher import Pusher
from planar_pushing.terms.domain import SPEEDS, required
from planar_pushing.terms.errors import (
    InvalidValue,
    as_floats,
    require_kind,
    require_number,
    require_option,
)
from planar_pushing.terms.options import TOLERANCE, Policy

#: What an initial twist may be.
TWIST = f"three finite numbers of at most {SPEEDS[1]:g}"


@dataclass(frozen=True, slots=True, kw_only=True)
class Problem:
    """What is to be simulated.

    Parameters
    ----------
    scene : Scene
        Its rod angle is the initial one; its parameters are numbers.
    pusher : Pusher
    duration : float
        > 0.
    twist : (v_x, v_y, omega)
        Initial twist at the ring centre, omega in radians per time, where inertia is an effect.
    gap : float
        Initial height of the contact point above the fence, >= 0.
    on_ambiguity : str or Policy
    rtol : float
        Relative tolerance of the motion.

    Raises
    ------
    InvalidValue
        Where a value is out of range, or a twist is given that the scene's effects determine.
    """

    scene: Scene
    pusher: Pusher
    duration: float
    twist: Sequence[float] = (0.0, 0.0, 0.0)
    gap: float = 0.0
    on_ambiguity: Policy = Policy.KEEP_CONTACT
    rtol: float = 1e-10

    def __post_init__(self) -> None:
        required_single(required_scene(self.scene))
        require_kind("pusher", self.pusher, Pusher)
        for name in ("duration", "gap"):
            require_number(
                name, required(name, getattr(self, name)), isfinite, "one number", "give one"
            )
        object.__setattr__(self, "rtol", tolerance(self.rtol))
        object.__setattr__(self, "twist", _twist(self.twist))
        object.__setattr__(self, "on_ambiguity", policy(self.on_ambiguity))
        if not self.scene.stores_energy:
            no_twist(self.twist)


def tolerance(given: object) -> float:
    """A relative tolerance, or `InvalidValue`."""
    return require_number(
        "rtol", given, TOLERANCE.holds, TOLERANCE.allowed,
        "choose a tolerance that double precision can hold",
    )  # fmt: skip


def policy(given: object) -> Policy:
    """A policy from its name, or `InvalidValue`."""
    return require_option("on_ambiguity", given, Policy, "name one of these policies")


def no_twist(twist: Sequence[Any]) -> None:
    """Refuse an initial twist of scenes without inertia."""
    if any(np.any(np.asarray(each) != 0) for each in twist):
        raise InvalidValue(
            "twist", twist, "(0, 0, 0) for a scene without inertia",
            "leave the twist out: the fence determines a quasi-static motion",
        )  # fmt: skip


def _twist(given: object) -> tuple[float, float, float]:
    twist = as_floats(given)
    if len(twist) != 3 or not all(abs(each) <= SPEEDS[1] for each in twist):
        raise InvalidValue("twist", given, TWIST, "give (v_x, v_y, omega)")
    return twist
