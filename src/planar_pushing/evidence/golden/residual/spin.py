"""Spin ratios for moment arms, where a dataset holds none."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from planar_pushing.certified.doubled.numbers import Doubled, choose, doubled
from planar_pushing.evidence.golden.residual.motion import Shares, Slider, force_and_torque, shares
from planar_pushing.terms.options import EffectSet

#: Halvings of the bracket, steps of the secant from its ends at most, and the step that ends it.
_HALVINGS, _STEPS, _LAST = 8, 16, 1e-20
#: Least and greatest moment arm per spin ratio under friction; the ends of H / k, a little apart.
_LEAST, _GREATEST = 0.49, 2.1

#: Forces of the effects in a translation, at a spin ratio.
Parts = Callable[[Doubled], Shares]


def steady(effects: str, slider: Slider) -> Parts:
    """Effects of one kind, at any speed."""
    found = shares(effects, slider)
    return lambda _: found


def on_limit_curve(effects: str, slider: Slider) -> Parts:
    """Effects on the limit curve: the kinetic energy is that of a unit translation."""
    if effects == EffectSet.SUPPORT_FRICTION:
        return steady(effects, slider)
    return lambda k: shares(effects, slider, 1.0 / (k * k * slider.gyration + 1.0).sqrt())


def spin_ratio(parts: Parts, slider: Slider, arm: Doubled) -> Doubled:
    """Spin ratio under a moment arm: the root of ``torque = h force``, which increases with k."""
    if not parts(doubled(1.0)).friction:  # Eq. (10)
        return arm / slider.gyration
    shape, flat = arm.high.shape, abs(Doubled(arm.high.ravel(), arm.low.ravel()))
    _, first, place = np.unique(flat.high, return_index=True, return_inverse=True)
    each = flat[first]
    moves = each.high > 0
    found = choose(moves, _root(parts, slider, choose(moves, each, 1.0)), 0.0)[place.reshape(shape)]
    return choose(arm.high < 0, -found, found)


def _root(parts: Parts, slider: Slider, arm: Doubled) -> Doubled:
    """The root for moment arms > 0: halvings of a bracket, then the secant from its ends."""

    def lack(k: Doubled) -> Doubled:
        force, torque = force_and_torque(parts(k), slider.gyration, k)
        return torque - arm * force

    low = arm.high / max(_GREATEST, slider.gyration * 1.05)
    high = arm.high / min(_LEAST, slider.gyration * 0.95)
    for _ in range(_HALVINGS):
        middle = np.sqrt(low * high)
        below = lack(doubled(middle)).high < 0
        low, high = np.where(below, middle, low), np.where(below, high, middle)
    return _secant(lack, doubled(low), doubled(high))


def _secant(function: Callable[[Doubled], Doubled], one: Doubled, other: Doubled) -> Doubled:
    first, second = function(one), function(other)
    for _ in range(_STEPS):
        rise = second - first
        still = (rise.high == 0) | (second.high == 0)
        step = second * (other - one) / choose(still, 1.0, rise)
        one, other = other, choose(still, other, other - step)
        if np.all(still | (np.abs(step.high) <= _LAST * other.high)):
            break
        first, second = second, function(other)
    return other
