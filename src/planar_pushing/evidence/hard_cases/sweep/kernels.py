"""Invariants of the vectorised kernels on swept inputs; each check counts the values that break one."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import numpy.typing as npt

from planar_pushing.evidence.hard_cases.sweep.adversarial import (
    REACH,
    Generator,
    angles,
    effects,
    numbers,
    powers,
    rod_angle,
)
from planar_pushing.evidence.internals import (
    Array,
    IsotropicEffect,
    contact_motion_angle,
    is_homogeneous,
    moment_arm,
    ring_profile,
    ring_spin_ratio,
    spin_ratio,
)
from planar_pushing.mechanics.contact import InfiniteFriction
from planar_pushing.mechanics.effects import Inertia, RingFriction
from planar_pushing.mechanics.limit_curve import limit_curve
from planar_pushing.mechanics.scene import Scene, Slider

Wrong = npt.NDArray[np.bool_]
#: Rounding that an invariant may carry.
ROUNDING = 16 * float(np.finfo(float).eps)
#: Steepest slope of log H over log k between doubles next to k = 1.
STEEPEST = 40.0
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
    wrong |= np.signbit(torque) != np.signbit(k)
    same = np.abs(k) > TINY
    # The dual's argument is rounded: by half an ulp times the condition number of f or t.
    wrong |= same & ~(np.abs(force - np.abs(t_dual)) <= STEEPEST * ROUNDING * force + 5e-324)
    wrong |= same & ~(np.abs(np.abs(torque) - f_dual) <= STEEPEST * ROUNDING * f_dual + 5e-324)
    return wrong | _falls(np.abs(k), np.abs(torque)) | _falls(-np.abs(k), force)


def ring_spin_ratios(rng: Generator, size: int) -> Wrong:
    """The spin ratio has the sign of the arm, lies in its bounds, rises with it and gives it back."""
    arm = numbers(rng, size)
    k = ring_spin_ratio(arm)
    h, s = np.abs(arm), np.abs(k)
    # H lies between k / 2 and k below 1 and between k and 2 k above it.
    low, high = np.where(h < 1, h, h / 2), np.where(h < 1, 2 * h, h)
    wrong = (
        (np.signbit(k) != np.signbit(arm))
        | ~(s >= low * (1 - ROUNDING))
        | ~(s <= high * (1 + ROUNDING))
    )
    force, torque = ring_profile(s)
    held = (h > TINY) & (h < 1 / TINY)
    back = np.divide(torque, force, out=np.ones(size), where=held)
    wrong |= held & ~(np.abs(back - np.where(held, h, 1)) <= STEEPEST * ROUNDING * h)
    return np.asarray(wrong | _falls(h, s))


def _spin_ratios(effects: tuple[IsotropicEffect, ...], rng: Generator, arm: Array) -> Array:
    both = not is_homogeneous(effects)
    share = rng.choice([0.0, 1.0, 5e-324, 0.5, 1e-300, 1 - 2.0**-53], arm.shape) if both else None
    return spin_ratio(effects, arm, share)


def motion_angles(rng: Generator, size: int) -> Wrong:
    """The motion lies within 90 degrees of the force, on the side away from the turn of the slider."""
    length, phi = powers(rng, REACH, size), angles(rng, size)
    psi = np.where(rng.random(size) < 0.2, rod_angle(rng), rng.uniform(1e-300, np.pi, size))
    k = _spin_ratios((RingFriction(),), rng, moment_arm(length, psi, phi))
    return _leads_away(phi, k, length, psi)


def _with_inertia(rng: Generator, size: int) -> Iterator[tuple[Inertia, Array, Array, Array]]:
    """Parts of the inputs with one inertia each: it, rod lengths, force angles and rod angles."""
    for part in np.array_split(np.arange(size), max(1, size // 1000)):
        length, phi = powers(rng, REACH, part.size), angles(rng, part.size)
        inertia = Inertia(gyration_radius=float(powers(rng, REACH, 1)[0]))
        yield inertia, length, phi, rng.uniform(1e-300, np.pi, part.size)


def motion_angles_of_inertia(rng: Generator, size: int) -> Wrong:
    """The same for inertia with one radius of gyration for every part of the inputs."""
    parts = []
    for inertia, length, phi, psi in _with_inertia(rng, size):
        k = _spin_ratios((inertia,), rng, moment_arm(length, psi, phi))
        parts.append(_leads_away(phi, k, length, psi))
    return np.concatenate(parts)


def motion_angles_of_both(rng: Generator, size: int) -> Wrong:
    """The same for friction and inertia, and the spin ratio between those of the two alone."""
    parts = []
    for inertia, length, phi, psi in _with_inertia(rng, size):
        arm = moment_arm(length, psi, phi)
        k = _spin_ratios((RingFriction(), inertia), rng, arm)
        ends = np.abs([_spin_ratios((each,), rng, arm) for each in (RingFriction(), inertia)])
        near, far = ends.min(axis=0), ends.max(axis=0)
        between = (np.abs(k) >= near * (1 - ROUNDING)) & (np.abs(k) <= far * (1 + ROUNDING))
        parts.append(~between | _leads_away(phi, k, length, psi))
    return np.concatenate(parts)


def _leads_away(phi: Array, k: Array, length: Array, psi: Array) -> Wrong:
    turn = contact_motion_angle(phi, k, length, psi) - phi
    margin = ROUNDING * (1 + np.abs(phi))
    wrong = ~(np.abs(turn) <= np.pi / 2 + margin)
    expected = -np.sign(k) * np.sign(np.cos(psi - phi))
    return np.asarray(wrong | ((np.abs(turn) > margin) & (np.sign(turn) != expected)))


def cone_edges(rng: Generator, size: int) -> Wrong:
    """The right edge does not pass the left one; without bound on friction they are 180 degrees apart."""
    length, mu = powers(rng, REACH, size), np.abs(numbers(rng, size))
    right = np.arctan2(1.0, mu)
    phi = np.where(np.isinf(mu), [[0.0], [np.pi]], [right, np.pi - right])
    psi = rng.uniform(1e-300, np.pi, size)
    arm = moment_arm(length, psi, phi)
    edges = contact_motion_angle(phi, ring_spin_ratio(arm), length, psi)
    span = edges[1] - edges[0]
    wrong = ~((span >= -ROUNDING) & (span <= np.pi + ROUNDING))
    return np.asarray(wrong | (np.isinf(mu) & ~(np.abs(span - np.pi) <= ROUNDING)))


def limit_curves(rng: Generator, size: int) -> Wrong:
    """Forces between 0 and the sum of both translations', motions within 90 degrees of them."""
    parts = []
    for part in np.array_split(np.arange(size), max(1, size // 1000)):
        length = float(powers(rng, REACH, 1)[0])
        slider = Slider(rod_length=length, rod_angle=rod_angle(rng))
        resisting = effects(rng, 300)
        scene = Scene(slider=slider, contact=InfiniteFriction(), effects=resisting)
        phi = angles(rng, part.size, slider.rod_angle)
        curve = limit_curve(scene, phi)
        most = sum(float(effect.profile(0.0)[0]) for effect in resisting)
        wrong = ~((curve.magnitude >= 0) & (curve.magnitude <= most * (1 + ROUNDING)))
        turn = np.abs(curve.motion_angle - phi)
        parts.append(
            wrong | ~(turn <= np.pi / 2 + ROUNDING * (1 + np.abs(phi))) | np.isnan(curve.spin_ratio)
        )
    return np.concatenate(parts)
