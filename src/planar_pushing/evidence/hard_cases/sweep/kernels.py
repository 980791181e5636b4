"""Invariants of the functions of arrays on swept inputs; each check counts the values that break one."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from planar_pushing.evidence.hard_cases.sweep.adversarial import (
    Generator,
    angles,
    coefficients,
    effects,
    gyrations,
    lengths,
    numbers,
    rod_angles,
)
from planar_pushing.mechanics.cones import motion_angle, motion_cone, spin_ratio
from planar_pushing.mechanics.contact import ContactLaw, Coulomb, InfiniteFriction
from planar_pushing.mechanics.effects import Effect, Inertia, RingFriction
from planar_pushing.mechanics.limit_curve import limit_curve
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.scene import Scene, Slider
from planar_pushing.mechanics.wrench import ring_profile, ring_spin_ratios
from planar_pushing.terms.options import EffectSet

Wrong = npt.NDArray[np.bool_]
#: Rounding that an invariant may carry.
ROUNDING = 16 * float(np.finfo(float).eps)
#: Steepest slope of log H over log k between doubles next to k = 1.
STEEPEST = 40.0
#: Rod length in radii up to which the errors of results are rounding errors.
LONG = 1e4
#: Below this size a number has no relative accuracy.
TINY = 1e-305


def _falls(x: Array, y: Array) -> Wrong:
    """Where y >= 0 falls along increasing x by more than rounding."""
    order, wrong = np.argsort(x, kind="stable"), np.zeros(x.shape, bool)
    wrong[order[1:]] = y[order[1:]] < y[order[:-1]] * (1 - ROUNDING)
    return wrong


def ring_profiles(rng: Generator, size: int) -> Wrong:
    """0 <= f <= 1, |t| <= 1 with the sign of k, f falling and t rising with |k|, the dual's values."""
    k = numbers(rng, size)
    force, torque = ring_profile(k)
    f_dual, t_dual = ring_profile(
        np.divide(1.0, k, out=np.full(size, np.inf), where=np.abs(k) > TINY)
    )
    wrong = ~((force >= 0) & (force <= 1 + ROUNDING) & (np.abs(torque) <= 1 + ROUNDING))
    wrong |= (np.signbit(torque) != np.signbit(k)) & (k != 0)
    same = np.abs(k) > TINY
    # The dual's argument is rounded: by half an ulp times the condition number of f or t.
    wrong |= same & ~(np.abs(force - np.abs(t_dual)) <= STEEPEST * ROUNDING * force + 5e-324)
    wrong |= same & ~(np.abs(np.abs(torque) - f_dual) <= STEEPEST * ROUNDING * f_dual + 5e-324)
    return wrong | _falls(np.abs(k), np.abs(torque)) | _falls(-np.abs(k), force)


def inverses(rng: Generator, size: int) -> Wrong:
    """The spin ratio has the sign of the arm, lies in its bounds, rises with it and gives it back."""
    arm = numbers(rng, size)
    k = ring_spin_ratios(arm)
    h, s = np.abs(arm), np.abs(k)
    # H lies between k / 2 and k below 1 and between k and 2 k above it.
    low, high = np.where(h < 1, h, h / 2), np.where(h < 1, 2 * h, h)
    wrong = (
        ((np.signbit(k) != np.signbit(arm)) & (arm != 0))
        | ~(s >= low * (1 - ROUNDING))
        | ~(s <= high * (1 + ROUNDING))
    )
    force, torque = ring_profile(s)
    held = (h > TINY) & (h < 1 / TINY)
    back = np.divide(torque, force, out=np.ones(size), where=held)
    wrong |= held & ~(np.abs(back - np.where(held, h, 1)) <= STEEPEST * ROUNDING * h)
    return np.asarray(wrong | _falls(h, s))


def _scene(
    rng: Generator, resisting: tuple[Effect, ...], size: int, law: ContactLaw | None = None
) -> Scene:
    """Sliders with R = 1."""
    slider = Slider(rod_length=lengths(rng, size), rod_angle=rod_angles(rng, size))
    return Scene(slider=slider, contact=law or InfiniteFriction(), effects=resisting)


def motion_angles(rng: Generator, size: int) -> Wrong:
    """The motion lies within 90 degrees of the force, on the side away from the turn of the slider."""
    scene, phi = _scene(rng, (RingFriction(),), size), angles(rng, size)
    return _leads_away(scene, phi)


def motion_angles_of_inertia(rng: Generator, size: int) -> Wrong:
    """The same for inertia."""
    inertia = Inertia(gyration_radius=gyrations(rng, size))
    return _leads_away(_scene(rng, (inertia,), size), angles(rng, size))


def motion_angles_of_both(rng: Generator, size: int) -> Wrong:
    """The same for friction and inertia, and the spin ratio between those of the two alone."""
    parts: tuple[Effect, ...] = (RingFriction(), Inertia(gyration_radius=gyrations(rng, size)))
    scene, phi = _scene(rng, parts, size), angles(rng, size)
    share = rng.choice([0.0, 1.0, 5e-324, 0.5, 1e-300, 1 - 2.0**-53], size)
    alone = [Scene(slider=scene.slider, contact=scene.contact, effects=(each,)) for each in parts]
    ends = np.abs([spin_ratio(each, phi) for each in alone])
    k = np.abs(spin_ratio(scene, phi, share))
    # Of longer rods the backward error counts, which a long rod multiplies.
    rounding = ROUNDING * np.maximum(1.0, scene.slider.length_ratio / LONG)
    near, far = ends.min(axis=0) * (1 - rounding), ends.max(axis=0) * (1 + rounding)
    between = (far < TINY) | ((k >= near) & (k <= far))
    return np.asarray(~between | _leads_away(scene, phi, share))


def _leads_away(scene: Scene, phi: Array, share: Array | None = None) -> Wrong:
    turn, k = motion_angle(scene, phi, share) - phi, spin_ratio(scene, phi, share)
    margin = ROUNDING * (1 + np.abs(phi))
    wrong = ~(np.abs(turn) <= np.pi / 2 + margin)
    expected = -np.sign(k) * np.sign(np.cos(scene.slider.rod_angle - phi))
    return np.asarray(wrong | ((np.abs(turn) > margin) & (np.sign(turn) != expected)))


def cone_edges(rng: Generator, size: int) -> Wrong:
    """The right edge does not pass the left one; without bound on friction they are 180 degrees apart."""
    mu = coefficients(rng, size)
    scene = _scene(rng, (RingFriction(),), size, Coulomb(mu))
    law, cone = scene.law, motion_cone(scene)
    right, left = motion_angle(scene, law.right), motion_angle(scene, law.left)
    wrong = ~((left - right >= -ROUNDING) & (cone.span >= 0) & (cone.span <= np.pi + ROUNDING))
    wrong |= ~(np.abs(cone.right - right) <= ROUNDING) | ~(np.abs(cone.left - left) <= ROUNDING)
    free = Scene(slider=scene.slider, contact=InfiniteFriction(), effects=scene.effects)
    return np.asarray(wrong | ~(np.abs(motion_cone(free).span - np.pi) <= ROUNDING))


def limit_curves(rng: Generator, size: int) -> Wrong:
    """Forces between 0 and the sum of both translations', motions within 90 degrees of them."""
    sizes = [part.size for part in np.array_split(np.arange(size), len(EffectSet))]
    return np.concatenate([_limit_curve(rng, *each) for each in zip(EffectSet, sizes, strict=True)])


def _limit_curve(rng: Generator, names: EffectSet, size: int) -> Wrong:
    scene, phi = _scene(rng, effects(rng, names, 1.0, size), size), angles(rng, size)
    curve = limit_curve(scene, phi)
    most = (scene.weight if scene.friction else 0) + (scene.inertia[0] if scene.masses else 0)
    wrong = ~((curve.magnitude >= 0) & (curve.magnitude <= most * (1 + ROUNDING)))
    turn = np.abs(curve.motion_angle - phi)
    wrong |= ~(turn <= np.pi / 2 + ROUNDING * (1 + np.abs(phi)))
    return np.asarray(wrong | np.isnan(curve.spin_ratio))
