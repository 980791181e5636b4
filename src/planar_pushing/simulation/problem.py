"""A motion to be simulated: scene, fence, initial state, and what decides between contact modes.

The fence is the line ``y = Y(t)`` of a frame whose origin is the contact at time 0, and its
displacement is ``(X, Y)``. The rod angle is any real number. The contact is the rod's free end alone, so
the model holds as long as the ring's centre is above the fence; where it comes down to it, the rod
lies along the fence or under it, and a simulation stops there.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from planar_pushing.mechanics.scene import Scene
from planar_pushing.simulation.pusher import Pusher
from planar_pushing.terms.domain import required
from planar_pushing.terms.errors import InvalidValue, require_number
from planar_pushing.terms.options import TOLERANCE, Policy


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
        Initial twist at the ring centre, where inertia is an effect.
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
        for name, kind in (("scene", Scene), ("pusher", Pusher)):
            if not isinstance(getattr(self, name), kind):
                raise InvalidValue(name, getattr(self, name), f"a {kind.__name__}", "construct one")
        required("duration", self.duration)
        required("gap", self.gap)
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
    try:
        return Policy(str(given))
    except ValueError:
        raise InvalidValue(
            "on_ambiguity", given, ", ".join(Policy), "name one of these policies"
        ) from None


def no_twist(twist: Sequence[Any]) -> None:
    """Refuse an initial twist of scenes without inertia."""
    if any(np.any(np.asarray(each) != 0) for each in twist):
        raise InvalidValue(
            "twist", twist, "(0, 0, 0) for a scene without inertia",
            "leave the twist out: the fence determines a quasi-static motion",
        )  # fmt: skip


def _twist(given: object) -> tuple[float, float, float]:
    try:
        twist = tuple(float(each) for each in given)  # type: ignore[attr-defined]
    except (TypeError, ValueError):
        twist = ()
    if len(twist) != 3 or not all(map(math.isfinite, twist)):
        raise InvalidValue("twist", given, "three finite numbers", "give (v_x, v_y, omega)")
    return twist
