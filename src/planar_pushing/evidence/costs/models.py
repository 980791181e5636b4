"""Two models of the limit surface that robotics uses instead of the ring: ellipsoid and convex quartic.

A model is a polynomial P of the wrench whose level set P = 1 approximates the limit surface; the motion
is its gradient. Forces are in units of W, torques in units of W R. The ring is isotropic, so that an
even quartic has three coefficients, ``P = a |f|^4 + b |f|^2 t^2 + c t^4``.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import numpy as np

from planar_pushing.mechanics.effects import RingFriction
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.wrench import wrench

#: Number of twists, uniform on the unit sphere of (v_x, v_y, R omega), in a fit or a mean.
SAMPLES = 20000
GOLDEN_ANGLE = np.pi * (3 - np.sqrt(5))
#: Newton steps that suffice for the moment arm of a quartic, starting close to that of the ring.
STEPS = 8


@dataclass(frozen=True, slots=True, kw_only=True)
class Quartic:
    """An isotropic quartic model of the limit surface."""

    a: float
    b: float
    c: float

    @property
    def convex(self) -> bool:
        """Whether the Hessian is positive semidefinite everywhere."""
        return min(self.a, self.c) >= 0 and 0 <= self.b <= 6 * np.sqrt(self.a * self.c)

    def twist(self, wrench: Array) -> Array:
        """Direction of the motion under wrenches of shape S + (3,): the gradient."""
        force, torque = wrench[..., :2], wrench[..., 2:]
        square = (force**2).sum(axis=-1, keepdims=True)
        along = (2 * self.a * square + self.b * torque**2) * force
        return np.concatenate([along, (self.b * square + 2 * self.c * torque**2) * torque], axis=-1)

    def spin_ratio(self, arm: Array) -> Array:
        """Spin ratio k from the moment arm h / R."""
        square = arm * arm
        return arm * (self.b + 2 * self.c * square) / (2 * self.a + self.b * square)

    def profile(self, k: Array) -> tuple[Array, Array]:
        """Force and torque on the model's surface at which the gradient has the spin ratio k >= 0."""
        arm, a, b, c = np.where(k > 1, 2 * k * k / (1 + k), k * (1 + k) / 2), self.a, self.b, self.c
        for _ in range(STEPS):
            value = ((2 * c * arm - b * k) * arm + b) * arm - 2 * a * k
            arm = arm - value / ((6 * c * arm - 2 * b * k) * arm + b)
        square = arm * arm
        force = (a + (b + c * square) * square) ** -0.25
        return force, force * arm


def ellipsoid_profile(spin_ratio: Array) -> tuple[Array, Array]:
    """Force and torque of the ellipsoid through the ring's maximum force and torque, k >= 0."""
    size = np.hypot(1.0, spin_ratio)
    return 1 / size, spin_ratio / size


def sphere(count: int = SAMPLES) -> Array:
    """Unit vectors spread uniformly over the sphere along a spiral, shape (count, 3)."""
    index = np.arange(count)
    height = 1 - (2 * index + 1) / count
    radius, around = np.sqrt(1 - height**2), index * GOLDEN_ANGLE
    return np.stack([radius * np.cos(around), radius * np.sin(around), height], axis=-1)


@cache
def fitted_quartic() -> Quartic:
    """Quartic by least squares: P = 1 at the ring's wrenches under twists uniform on the sphere."""
    found = wrench(RingFriction(), sphere())
    square, torque = (found[..., :2] ** 2).sum(axis=-1), found[..., 2] ** 2
    terms = np.stack([square**2, square * torque, torque**2], axis=-1)
    fit, *_ = np.linalg.lstsq(terms, np.ones(len(terms)))
    a, b, c = map(float, fit)
    return Quartic(a=a, b=b, c=c)


def rim_wrench(twist: Array, points: int = 100) -> Array:
    """Wrench of a rim of point supports under twists of shape (n, 3): the mean over the points."""
    angle = 2 * np.pi * (np.arange(points) + 0.5) / points
    aside = np.stack([-np.sin(angle), np.cos(angle)], axis=-1)
    motion = twist[:, None, :2] + twist[:, None, 2:] * aside
    motion /= np.linalg.norm(motion, axis=-1, keepdims=True)
    torque = (motion * aside).sum(axis=-1).mean(axis=-1)
    return np.concatenate([motion.mean(axis=1), torque[:, None]], axis=-1)


def direction_error(predicted: Array, twist: Array) -> Array:
    """Angle between twists of shape (n, 3), degrees."""
    first, second = (each / np.linalg.norm(each, axis=-1)[:, None] for each in (predicted, twist))
    apart, together = (np.linalg.norm(each, axis=-1) for each in (first - second, first + second))
    return np.asarray(np.rad2deg(2 * np.arctan2(apart, together)))


def rim_errors(points: int = 100) -> dict[str, float]:
    """Mean direction error of each model for a rim of point supports, degrees.

    Twists are uniform on the unit sphere of (v_x, v_y, R omega); a model predicts the twist from the
    rim's wrench. The axes of the ellipsoid are the rim's maximum force and torque, so that it predicts
    a twist along the wrench.
    """
    twist = sphere()
    felt = rim_wrench(twist, points)
    predictions = {"ellipsoid": felt, "quartic": fitted_quartic().twist(felt)}
    return {name: float(direction_error(each, twist).mean()) for name, each in predictions.items()}
