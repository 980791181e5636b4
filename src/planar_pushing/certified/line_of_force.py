"""Motion of the slider under one line of force, enclosed: spin ratio, motion, limit force, center.

`share` is the share of inertia, as in `inverse`.
"""

from __future__ import annotations

from functools import lru_cache

from flint import arb, fmpq

from planar_pushing.certified import ring
from planar_pushing.certified.balls import (
    Exact,
    cosine_sine,
    exact_cosine,
    exact_sine,
    fold,
    has_exact_direction,
    in_degrees,
    precise,
    settle,
    sign,
)
from planar_pushing.certified.inverse import spin_of_arm
from planar_pushing.certified.roots import increasing_root
from planar_pushing.certified.setting import FRICTION, INERTIA, Effects, Heading, Slider, lean


@lru_cache(maxsize=1 << 17)
def _spin_of_lean(length: fmpq, gyration: fmpq, share: fmpq, degrees: fmpq) -> arb:
    return spin_of_arm(length * arb.sin_pi_fmpq(degrees / 180), gyration, share)


@lru_cache(maxsize=1 << 15)
@precise
def spin_ratio(slider: Slider, force: Heading, share: fmpq) -> arb:
    """Spin ratio k = R omega / v under a line of force."""
    _, sine = lean(slider, force)
    if force.rational is not None:
        folded = fold(slider.rod_angle - force.rational)
        size = _spin_of_lean(slider.rod_length, slider.gyration, share, folded)
    else:
        size = spin_of_arm(slider.rod_length * abs(sine), slider.gyration, share)
    return -size if sine < 0 else size


@precise
def contact_motion(slider: Slider, force: Heading, spin: arb) -> tuple[arb, arb]:
    """Motion of the contact per unit speed of the center."""
    c, s = cosine_sine(slider.rod_angle)
    pull = spin * slider.rod_length
    return force.x + pull * s, force.y - pull * c


@lru_cache(maxsize=1 << 13)
def exact_contact_motion(slider: Slider, force: Heading, share: fmpq) -> tuple[Exact, Exact] | None:
    """Positive multiple of the contact's motion if it is algebraic, otherwise None.

    It is algebraic for inertia, Eqs. (11)-(12), if friction and inertia agree on the spin ratio, and
    for a force across the rod, along which the contact then moves.
    """
    if force.exact is None:
        return None
    x, y = force.exact()
    if slider.rod_length == 0 or lean(slider, force)[0] == 0:
        return x, y
    if not has_exact_direction(slider.rod_angle):
        return None
    if share != INERTIA and not is_steady(slider, force):
        return None
    c, s = exact_cosine(slider.rod_angle), exact_sine(slider.rod_angle)
    turn = (x * s - y * c) * (slider.rod_length**2 / slider.gyration)
    return x + turn * s, y - turn * c


def is_steady(slider: Slider, force: Heading) -> bool:
    """Whether friction and inertia agree, exactly, on the spin ratio."""
    return bool(spin_ratio(slider, force, FRICTION) == spin_ratio(slider, force, INERTIA))


@precise
def motion_degrees(slider: Slider, force: Heading, spin: arb) -> arb:
    """Angle of the contact's motion in degrees, on the branch within 90 degrees of the force."""
    cosine, sine = lean(slider, force)
    pull = spin * slider.rod_length
    return force.degrees - in_degrees((pull * cosine / (1 + pull * sine)).atan())


@precise
def motion_angle(slider: Slider, force: Heading, share: fmpq) -> arb:
    """Angle of the contact's motion in degrees; an exact zero if the motion is along the fence."""
    degrees = motion_degrees(slider, force, spin_ratio(slider, force, share))
    if not degrees.contains(0):
        return degrees
    exact = exact_contact_motion(slider, force, share)
    return settle(degrees, None if exact is None else lambda: exact[1])


@precise
def limit_point(slider: Slider, effects: Effects, force: Heading) -> tuple[arb, arb]:
    """Force magnitude and spin ratio of the limit curve at a force angle.

    The motion has the kinetic energy of a unit translation, ``v = 1 / sqrt(1 + g k^2)``.
    """
    if effects is not Effects.BOTH:
        k = spin_ratio(slider, force, effects.shares[0])
        if effects is Effects.FRICTION:
            return slider.weight * ring.profile(abs(k))[0], k
        return slider.mass * _energetic_speed(slider, k), k
    _, sine = lean(slider, force)
    if force.rational is not None:
        size = _limit_spin(slider, fold(slider.rod_angle - force.rational))
    else:
        size = _limit_spin_of_arm(slider, slider.rod_length * abs(sine))
    friction = slider.weight * ring.profile(size)[0]
    return friction + slider.mass * _energetic_speed(slider, size), -size if sine < 0 else size


def _energetic_speed(slider: Slider, k: arb) -> arb:
    return (1 + slider.gyration * k * k).rsqrt()


@lru_cache(maxsize=1 << 15)
def _limit_spin(slider: Slider, degrees: fmpq) -> arb:
    return _limit_spin_of_arm(slider, slider.rod_length * arb.sin_pi_fmpq(degrees / 180))


def _limit_spin_of_arm(slider: Slider, arm: arb) -> arb:
    if arm == 0:
        return arb(0)

    def balance(k: arb) -> arb:
        force, torque = ring.profile(k)
        inertial = slider.mass * _energetic_speed(slider, k) * (slider.gyration * k - arm)
        return slider.weight * (torque - arm * force) + inertial

    low, high = (float(arm.lower()) / 4, float(arm.upper()) * 4)
    g = float(slider.gyration.p) / float(slider.gyration.q)
    return increasing_root(balance, arb(low / max(1, g)), arb(high / min(1, g)))


@precise
def motion_center(slider: Slider, force: Heading, spin: arb) -> tuple[arb, arb]:
    """Motion center relative to the ring center in units of R, at -1/k along x'.

    A translation is the limit k -> 0+: coordinates are infinite where x' has a nonzero component.
    """
    along = force.y, -force.x
    if sign(spin) == 0:
        return tuple(arb(0) if each == 0 else arb.neg_inf() * each.sgn() for each in along)  # type: ignore[return-value]
    return -along[0] / spin, -along[1] / spin
