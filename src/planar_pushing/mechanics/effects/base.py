"""The interface of an effect: a convex potential of the twist, and its gradient.

Every formula works in lengths scaled by the slider's radius: a twist is ``(v_x, v_y, R omega)``, a
wrench ``(f_x, f_y, tau / R)``. Effects add, so a scene lists those that it has and evaluates no other.
"""

from __future__ import annotations

from typing import Protocol

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.planar import Array


class Effect(Protocol):
    """Something that resists the slider's motion."""

    @property
    def degree(self) -> int:
        """Degree of homogeneity of the potential: 1 dissipates energy, 2 stores it."""
        ...

    def scaled(self, length: float, force: float = 1.0) -> Effect:
        """The same effect with lengths in units of `length` and forces in units of `force`."""
        ...

    def potential(self, twist: Array) -> Array:
        """Potential of twists of shape S + (3,), shape S."""
        ...

    def wrench(self, twist: Array) -> Array:
        """Gradient of the potential, shape S + (3,); the subgradient nearest zero at rest."""
        ...


class IsotropicEffect(Effect, Protocol):
    """An effect that sees only the centre's speed and the rotation: its force lies along `v`.

    For such effects one scalar relation, moment arm <-> spin ratio, carries everything.
    """

    @property
    def kinks(self) -> tuple[float, ...]:
        """Positive spin ratios at which the profile is not smooth."""
        ...

    def profile(self, spin_ratio: npt.ArrayLike) -> tuple[Array, Array]:
        """Force along the motion and torque at unit centre speed, for each spin ratio."""
        ...

    def spin_ratio(self, moment_arm: npt.ArrayLike) -> Array:
        """Spin ratio under a force of this moment arm that meets no other effect."""
        ...


def isotropic_wrench(effect: IsotropicEffect, twist: Array) -> Array:
    """Wrench of an isotropic effect of degree 1 from its profile."""
    speed, spin = np.hypot(twist[..., 0], twist[..., 1]), twist[..., 2]
    moving = speed > 0
    with np.errstate(over="ignore"):
        ratio = np.divide(spin, speed, out=np.asarray(np.copysign(np.inf, spin)), where=moving)
    force, torque = effect.profile(np.where((spin == 0) & ~moving, 0.0, ratio))
    heading = np.divide(
        twist[..., :2],
        speed[..., None],
        out=np.zeros(twist[..., :2].shape),
        where=moving[..., None],
    )
    return np.concatenate([force[..., None] * heading, torque[..., None]], axis=-1)
