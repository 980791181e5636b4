"""Two models of the limit surface that robotics uses in the ring's place: ellipsoid and convex quartic.

A model is a polynomial P of the wrench whose level set P = 1 approximates the limit surface; the motion
is its gradient. Forces are in units of W, torques in units of W R. The ring is isotropic, so an even
quartic has three coefficients, ``P = a |f|^4 + b |f|^2 t^2 + c t^4``. It is convex where ``a, c >= 0``
and ``0 <= b <= 6 sqrt(a c)``.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from planar_pushing.mechanics.effects import RingFriction
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.wrench import wrench

#: Twists, uniform on the unit sphere of (v_x, v_y, R omega), that a fit or a mean runs over.
SAMPLES = 20000
GOLDEN_ANGLE = np.pi * (3 - np.sqrt(5))


@dataclass(frozen=True, slots=True, kw_only=True)
class Quartic:
    """An isotropic quartic model of the limit surface."""

    a: float
    b: float
    c: float

    @property
    def convex(self) -> bool:
        """Whether the sublevel sets are convex: the Hessian is nowhere negative."""
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

    def profile(self, spin_ratio: Array) -> tuple[Array, Array]:
        """Force and torque on the model's surface whose gradient has the spin ratio, for k >= 0.

        The moment arm solves a cubic; Newton steps from the ring's own arm settle it.
        """
        small = np.minimum(spin_ratio, 1 / np.maximum(spin_ratio, 1e-300))
        model = Quartic(a=self.c, b=self.b, c=self.a)
        outside = spin_ratio > 1
        arms = [_arm(each, small) for each in (self, model)]
        surfaces = [_on_surface(each, arm) for each, arm in zip((self, model), arms, strict=True)]
        (force, torque), (dual_force, dual_torque) = surfaces
        return np.where(outside, dual_torque, force), np.where(outside, dual_force, torque)


def _arm(model: Quartic, spin_ratio: Array) -> Array:
    """Moment arm in [0, ~1] at a spin ratio in [0, 1]: root of ``2 c h^3 - b k h^2 + b h - 2 a k``."""
    a, b, c, k = model.a, model.b, model.c, spin_ratio
    arm = k * (1 + k) / 2
    for _ in range(6):
        value = ((2 * c * arm - b * k) * arm + b) * arm - 2 * a * k
        arm = arm - value / ((6 * c * arm - 2 * b * k) * arm + b)
    return arm


def _on_surface(model: Quartic, arm: Array) -> tuple[Array, Array]:
    square = arm * arm
    force = (model.a + (model.b + model.c * square) * square) ** -0.25
    return force, force * arm


def ellipsoid_profile(spin_ratio: Array) -> tuple[Array, Array]:
    """Force and torque of the ellipsoid through the ring's largest force and torque, k >= 0."""
    size = np.hypot(1.0, spin_ratio)
    return 1 / size, spin_ratio / size


def sphere(count: int = SAMPLES) -> Array:
    """Unit vectors spread evenly over the sphere along a spiral, shape (count, 3)."""
    index = np.arange(count)
    height = 1 - (2 * index + 1) / count
    around = index * GOLDEN_ANGLE
    radius = np.sqrt(1 - height**2)
    return np.stack([radius * np.cos(around), radius * np.sin(around), height], axis=-1)


def fitted_quartic(twists: Array | None = None) -> Quartic:
    """Quartic of least squares: P = 1 at the ring's wrenches under twists even on the sphere."""
    found = wrench(RingFriction(), sphere() if twists is None else twists)
    square, torque = (found[..., :2] ** 2).sum(axis=-1), found[..., 2] ** 2
    terms = np.stack([square**2, square * torque, torque**2], axis=-1)
    fit, *_ = np.linalg.lstsq(terms, np.ones(len(terms)))
    a, b, c = map(float, fit)
    return Quartic(a=a, b=b, c=c)


def rim_wrench(twist: Array, points: int = 100) -> Array:
    """Wrench of a rim of point supports under twists of shape (n, 3): the mean over the points."""
    angle = 2 * np.pi * (np.arange(points) + 0.5) / points
    place = np.stack([np.cos(angle), np.sin(angle)], axis=-1)
    aside = np.stack([-place[:, 1], place[:, 0]], axis=-1)
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

    Twists are uniform on the unit sphere of (v_x, v_y, R omega); a model sees the rim's wrench and
    predicts the twist. The ellipsoid has the rim's largest force and torque as its axes, so it predicts
    a twist along the wrench.
    """
    twist = sphere()
    felt = rim_wrench(twist, points)
    predictions = {"ellipsoid": felt, "quartic": fitted_quartic().twist(felt)}
    return {name: float(direction_error(each, twist).mean()) for name, each in predictions.items()}
