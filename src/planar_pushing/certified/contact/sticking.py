"""Sticking motions: the motion of the slider whose contact moves with the pusher."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache

from flint import arb, fmpq

from planar_pushing.certified.balls import (
    Exact,
    cosine_sine,
    exact_direction,
    has_exact_direction,
    in_degrees,
    precise,
    settle,
    sign,
)
from planar_pushing.certified.inverse import spin_of_arm, sticking_rotation
from planar_pushing.certified.setting import Effects, Slider


@dataclass(frozen=True, slots=True)
class Motion:
    """A consistent motion: spin ratio, and force angle in degrees in (-180, 180]; both are 0 at rest."""

    spin_ratio: arb
    force_angle: arb


@dataclass(frozen=True, slots=True)
class Sticking:
    """The sticking motion, and a positive multiple of its force as balls and, if known, exactly."""

    motion: Motion
    force: tuple[arb, arb]
    exact: tuple[Exact, Exact] | None


@lru_cache(maxsize=1 << 16)
@precise
def sticking(slider: Slider, effects: Effects, magnitude: fmpq, pusher_angle: fmpq) -> Sticking:
    """Motion whose contact moves as the pusher does.

    In the frame of the rod the contact moves by (along, aside). The rotation contributes a fraction of
    `aside` and the center the rest; the force is along the motion of the center.
    """
    cosine, sine = cosine_sine(slider.rod_angle - pusher_angle)
    along, aside = magnitude * cosine, magnitude * sine
    exact = _exact_force(slider, effects, pusher_angle, along, aside)
    force = along, _across(slider, effects, along, aside)
    spin = _spin(slider, effects, along, aside, force)
    turn = (along * force[1] - aside * force[0]) / (along * force[0] + aside * force[1])
    normal = None if exact is None else lambda: exact[1]
    degrees = _wrapped(pusher_angle - in_degrees(turn.atan()), normal)
    c, s = cosine_sine(slider.rod_angle)
    towards = force[0] * c + force[1] * s, force[0] * s - force[1] * c
    return Sticking(Motion(spin, degrees), towards, exact)


def _straight(slider: Slider, along: arb, aside: arb) -> bool:
    """Whether the force is along the motion of the contact."""
    return slider.rod_length == 0 or along == 0 or aside == 0


def _across(slider: Slider, effects: Effects, along: arb, aside: arb) -> arb:
    """Component of the force across the rod if `along` is the component along it."""
    if _straight(slider, along, aside):
        return aside
    if effects is Effects.INERTIA:  # the effective mass is smaller across the rod, Eqs. (11)-(12)
        return aside / (1 + slider.rod_length**2 / slider.gyration)
    return aside - slider.rod_length * _rotation(slider, effects, along, aside)


def _exact_force(
    slider: Slider, effects: Effects, pusher_angle: fmpq, along: arb, aside: arb
) -> tuple[Exact, Exact] | None:
    """Positive multiple of the force if it is algebraic."""
    if not has_exact_direction(pusher_angle):
        return None
    x, y = exact_direction(pusher_angle)
    if _straight(slider, along, aside):
        return x, y
    if effects is not Effects.INERTIA or not has_exact_direction(slider.rod_angle):
        return None
    c, s = exact_direction(slider.rod_angle)
    lighter = 1 / (1 + slider.rod_length**2 / slider.gyration)
    first, second = x * c + y * s, (x * s - y * c) * lighter
    return first * c + second * s, first * s - second * c


def _rotation(slider: Slider, effects: Effects, along: arb, aside: arb) -> arb:
    """R omega at which the torque about the contact vanishes, with the sign of `aside`."""
    ratio = slider.mass / slider.weight if effects is Effects.BOTH else fmpq(0)
    return sticking_rotation(along, aside, slider.rod_length, slider.gyration, ratio)


def _spin(slider: Slider, effects: Effects, along: arb, aside: arb, force: tuple[arb, arb]) -> arb:
    """Spin ratio of the sticking motion."""
    if slider.rod_length == 0 or aside == 0:
        return arb(0)
    if along == 0:
        return aside.sgn() * _spin_across(slider, effects, abs(aside))
    speed = (force[0] ** 2 + force[1] ** 2).sqrt()
    if effects is Effects.INERTIA:  # Eq. (10)
        return slider.rod_length / slider.gyration * force[1] / speed
    return (aside - force[1]) / slider.rod_length / speed


def _spin_across(slider: Slider, effects: Effects, aside: arb) -> arb:
    """Spin ratio if the contact moves across the rod: the moment arm is the rod length."""
    if effects is not Effects.BOTH:
        return spin_of_arm(arb(slider.rod_length), slider.gyration, effects.shares[0])
    omega = _rotation(slider, effects, arb(0), aside)
    return omega / (aside - slider.rod_length * omega)


def _wrapped(degrees: arb, exact_normal: Callable[[], Exact] | None) -> arb:
    """Force angle in (-180, 180]; the normal component of the force decides ties with the fence."""
    if degrees.contains(0):
        return settle(degrees, exact_normal)
    if sign(degrees - 180, exact_normal) > 0:
        return degrees - 360
    return degrees if sign(degrees + 180, exact_normal) > 0 else degrees + 360
