"""Sticking: the motion that takes the contact along with the pusher, the same under every law.

In the axes of the rod the contact moves by ``(along, aside)``; with the moment arm per spin ratio
``h / k = L`` the rotation takes ``l aside / (l^2 + L)`` and leaves the center ``L / (l^2 + L) aside``.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from planar_pushing.certified.doubled.angles import cosine_sine, off_direction, radians
from planar_pushing.certified.doubled.numbers import Doubled, Floats, choose, doubled
from planar_pushing.certified.doubled.ring import wrench
from planar_pushing.evidence.golden.residual.contact_modes.push import Decision, Pushes, decided
from planar_pushing.evidence.golden.residual.motion import Line, line_at, shares
from planar_pushing.terms.options import EffectSet

#: Steps of the fixed point of the centre's speed, each of which removes most of the error.
_STEPS = 60


class Sticking(NamedTuple):
    """Residuals of the sticking motions, and the direction of their force along x and y."""

    spin_error: Floats
    angle_error: Floats
    x: Floats
    y: Floats


def sticking(effects: str, pushes: Pushes, spin_ratio: Any, force_angle: Any) -> Sticking:
    """Put spin ratios and force angles into the equations of the sticking motions."""
    line, length = line_at(pushes.rod_angle, pushes.angle), pushes.length
    leverage = _leverage(effects, pushes, line, np.abs(spin_ratio))
    total = leverage + length**2
    across = line.aside * leverage / total
    speed = (line.along * line.along + across * across).sqrt()
    spin = line.aside * length / total / speed
    error = np.abs((spin - spin_ratio).value())
    size = np.abs(spin_ratio)
    turn = radians(pushes.rod_angle) - radians(force_angle)
    angle = np.abs(off_direction(turn, line.along, across).value())
    cosine, sine = cosine_sine(radians(pushes.rod_angle))
    return Sticking(
        error / np.where(size > 0, size, 1.0),
        np.where((force_angle > -180) & (force_angle <= 180), angle, 2.0),
        ((line.along * cosine + across * sine) / speed).value(),
        ((line.along * sine - across * cosine) / speed).value(),
    )


def _leverage(effects: str, pushes: Pushes, line: Line, k: Floats) -> Doubled:
    """Moment arm per spin ratio at a spin ratio >= 0."""
    force, torque = wrench(k)
    per_spin = choose(k > 0, torque / np.where(k > 0, k, 1.0), 0.5)
    if effects != EffectSet.BOTH:
        return _mixed(effects, pushes, force, per_spin, 1.0)
    speed: Any = pushes.magnitude + 0 * k
    for _ in range(_STEPS):
        near = _mixed(effects, pushes, force, per_spin, speed).value()
        across = near / (pushes.length**2 + near) * line.aside.high
        speed = pushes.magnitude * np.hypot(line.along.high, across)
    return _mixed(effects, pushes, force, per_spin, speed)


def _mixed(effects: str, pushes: Pushes, force: Doubled, per_spin: Doubled, speed: Any) -> Doubled:
    friction, inertia = map(doubled, shares(effects, pushes.slider, speed))
    return (per_spin * friction + inertia * pushes.slider.gyration) / (force * friction + inertia)


def sticks(pushes: Pushes, x: Floats, y: Floats) -> Decision:
    """Where the law transmits the force of the sticking motion."""
    endless = np.isinf(pushes.friction)
    mu = np.where(endless, 0.0, pushes.friction)
    inside = np.where(endless, y, (mu * y - np.abs(x)) / np.hypot(1.0, mu))
    found = decided(np.where(pushes.rough, 1.0, inside), pushes.near)
    return Decision(found.consistent, found.open & ~pushes.rough)
