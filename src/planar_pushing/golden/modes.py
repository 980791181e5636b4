"""Contact modes: every consistent solution for a pusher motion from rest, by certified decisions.

The conditions are those of the case analysis of Sec. 2. A slip that coincides with stick is stick;
a slip needs a motion. Where the pusher moves along the fence and so does the motion of an edge, the
slips form a family from rest to stick: none of them is counted.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from enum import IntEnum
from functools import lru_cache

from flint import arb, fmpq

from planar_pushing.golden import ring, slips
from planar_pushing.golden.balls import Exact, cosine_sine, exact_cosine, exact_sine, precise, sign
from planar_pushing.golden.balls import in_degrees, rational, settle
from planar_pushing.golden.reference import (
    FRICTION,
    INERTIA,
    Effects,
    Heading,
    Slider,
    contact_motion,
    edge,
    exact_contact_motion,
    heading,
    lean,
    spin_of_arm,
    spin_ratio,
)
from planar_pushing.golden.roots import increasing_root


class Mode(IntEnum):
    """Contact modes in the order of the datasets."""

    SEPARATE = 0
    STICK = 1
    SLIP_RIGHT = 2
    SLIP_LEFT = 3


@dataclass(frozen=True, slots=True)
class Law:
    """Contact law: half-width of the friction cone, whether its edges belong to it and slip.

    `adhesive` transmits every force.
    """

    friction_coefficient: float
    closed: bool = True
    adhesive: bool = False

    @property
    def slips(self) -> bool:
        """Whether the contact slips under a force on an edge."""
        return self.closed and not self.adhesive


def coulomb(friction_coefficient: float) -> Law:
    """Coulomb's law."""
    return Law(friction_coefficient)


INFINITE_FREE = Law(math.inf)  # definition 1
INFINITE_NONE = Law(math.inf, closed=False)  # definition 2
PERFECTLY_ROUGH = Law(math.inf, adhesive=True)


@dataclass(frozen=True, slots=True)
class Motion:
    """A consistent motion: spin ratio and force angle in degrees in (-180, 180]; both 0 at rest."""

    spin_ratio: arb
    force_angle: arb


@dataclass(frozen=True, slots=True)
class Sticking:
    """The motion that takes the contact along, and the direction of its force."""

    motion: Motion
    force: tuple[arb, arb]
    exact: tuple[Exact, Exact] | None


@precise
def contact_modes(
    slider: Slider, effects: Effects, law: Law, magnitude: float, pusher_angle: float
) -> dict[Mode, list[Motion]]:
    """Consistent motions of each mode, slowest first.

    Parameters
    ----------
    slider : Slider
    effects : Effects
    law : Law
    magnitude : float
        Of the pusher's motion, > 0, exact.
    pusher_angle : float
        Degrees, exact.
    """
    pusher = heading(pusher_angle)
    found: dict[Mode, list[Motion]] = {mode: [] for mode in Mode}
    if sign(pusher.y) <= 0:
        found[Mode.SEPARATE] = [Motion(arb(0), arb(0))]
    stick = sticking(slider, effects, rational(magnitude), rational(pusher_angle))
    if law.adhesive or _admits(law, stick):
        found[Mode.STICK] = [stick.motion]
    if law.slips:
        for mode, side in ((Mode.SLIP_RIGHT, -1), (Mode.SLIP_LEFT, 1)):
            found[mode] = _slipping(slider, effects, law, side, rational(magnitude), pusher)
    return found


def _cross(a: Sequence[Exact], b: Sequence[Exact]) -> Exact:
    return a[0] * b[1] - a[1] * b[0]


def _admits(law: Law, stick: Sticking) -> bool:
    """Whether the force lies in the friction cone."""
    sides = []
    for side in (1, -1):
        bound = edge(law.friction_coefficient, side)
        exact = None
        if stick.exact is not None:
            exact = lambda e=bound.exact(): side * _cross(e, stick.exact)  # noqa: E731, B023
        sides.append(sign(side * _cross((bound.x, bound.y), stick.force), exact))
    if not law.closed:
        return min(sides) > 0
    # A cone of one direction: along it, and not against it.
    return min(sides) >= 0 and (law.friction_coefficient > 0 or stick.force[1] > 0)


@lru_cache(maxsize=1 << 16)
def sticking(slider: Slider, effects: Effects, magnitude: fmpq, pusher_angle: fmpq) -> Sticking:
    """Motion whose contact moves as the pusher does.

    In the frame of the rod the contact moves by (along, aside); the rotation takes a part of `aside`,
    the centre the rest, and the force is along the motion of the centre.
    """
    cosine, sine = cosine_sine(slider.rod_angle - pusher_angle)
    along, aside = magnitude * cosine, magnitude * sine
    if slider.rod_length == 0 or along == 0 or aside == 0:
        force, exact = (along, aside), (exact_cosine(pusher_angle), exact_sine(pusher_angle))
    elif effects is Effects.INERTIA:
        force, exact = _inertial(slider, along, aside), _exact_inertial(slider, pusher_angle)
    else:
        force, exact = (along, aside - slider.rod_length * _rotation(slider, effects, along, aside)), None
    spin = _spin(slider, effects, along, aside, force)
    turn = _cross((along, aside), force) / (along * force[0] + aside * force[1])
    degrees = _wrapped(pusher_angle - in_degrees(turn.atan()))
    c, s = cosine_sine(slider.rod_angle)
    towards = force[0] * c + force[1] * s, force[0] * s - force[1] * c
    return Sticking(Motion(spin, degrees), towards, exact)


def _inertial(slider: Slider, along: arb, aside: arb) -> tuple[arb, arb]:
    """Force of inertia: the rod makes the slider lighter across."""
    return along, aside / (1 + slider.rod_length**2 / slider.gyration)


def _exact_inertial(slider: Slider, pusher_angle: fmpq) -> tuple[Exact, Exact]:
    c, s = exact_cosine(slider.rod_angle), exact_sine(slider.rod_angle)
    x, y = exact_cosine(pusher_angle), exact_sine(pusher_angle)
    along = x * c + y * s
    aside = (x * s - y * c) * (1 / (1 + slider.rod_length**2 / slider.gyration))
    return along * c + aside * s, along * s - aside * c


def _rotation(slider: Slider, effects: Effects, along: arb, aside: arb) -> arb:
    """R omega at which the torque about the contact vanishes, of the sign of `aside`."""
    length, size, g = slider.rod_length, abs(aside), slider.gyration
    mass = slider.mass if effects is Effects.BOTH else fmpq(0)

    def torque(omega: arb) -> arb:
        across = size - length * omega
        speed = (along * along + across * across).sqrt()
        force, moment = ring.profile(omega / speed)
        friction = slider.weight * (moment - length * across / speed * force)
        return friction + mass * (g * omega - length * across)

    # The arm of every such force is at least min(1/2, g) k: it leaves the centre a part of `aside`.
    least = min(fmpq(1, 2), g) / 2
    high = size / (length * (1 + least / length**2))
    return aside.sgn() * increasing_root(torque, arb(0), high.upper())


def _spin(
    slider: Slider, effects: Effects, along: arb, aside: arb, force: tuple[arb, arb]
) -> arb:
    """Spin ratio of the sticking motion."""
    if slider.rod_length == 0 or aside == 0:
        return arb(0)
    if along == 0:
        return aside.sgn() * _straight(slider, effects, abs(aside))
    if effects is Effects.INERTIA:
        return slider.rod_length / slider.gyration * force[1] / (force[0] ** 2 + force[1] ** 2).sqrt()
    omega = (aside - force[1]) / slider.rod_length
    return omega / (force[0] ** 2 + force[1] ** 2).sqrt()


def _straight(slider: Slider, effects: Effects, aside: arb) -> arb:
    """Spin ratio where the contact moves across the rod: the moment arm is the rod."""
    length = arb(slider.rod_length)
    if effects is not Effects.BOTH:
        return spin_of_arm(length, slider.gyration, effects.shares[0])
    omega = _rotation(slider, effects, arb(0), aside)
    return omega / (aside - slider.rod_length * omega)


def _wrapped(degrees: arb) -> arb:
    if sign(degrees - 180) > 0:
        return degrees - 360
    return degrees if sign(degrees + 180) > 0 else degrees + 360


def _slipping(
    slider: Slider, effects: Effects, law: Law, side: int, magnitude: fmpq, pusher: Heading
) -> list[Motion]:
    """Motions under a force on the edge `side`, with the contact sliding off it."""
    force = edge(law.friction_coefficient, side)
    _, sine = lean(slider, force)
    if effects is not Effects.BOTH or slider.rod_length == 0 or sine == 0:
        share = effects.shares[0]
        spins = _steady_slip(slider, force, share, side, pusher)
    else:
        normal, tangential = magnitude * pusher.y, magnitude * pusher.x
        spins = _turning_slips(slider, force, side, normal, tangential)
    return [Motion(spin, force.degrees) for spin in spins]


def _steady_slip(
    slider: Slider, force: Heading, share: fmpq, side: int, pusher: Heading
) -> list[arb]:
    """Slip whose direction is that of the edge of the motion cone."""
    spin = spin_ratio(slider, force, share)
    motion, exact = contact_motion(slider, force, spin), exact_contact_motion(slider, force, share)
    towards = sign(motion[1], None if exact is None else lambda: exact[1])
    if towards == 0 or towards != sign(pusher.y):
        return []
    turn = _cross(motion, (pusher.x, pusher.y))
    apart = sign(turn, None if exact is None else lambda: _cross(exact, pusher.exact()))
    # The slider outruns the pusher to the left (side 1) or to the right (side -1).
    return [spin] if apart * towards * side < 0 else []


@lru_cache(maxsize=1024)
def _cover(slider: Slider, friction_coefficient: float, side: int) -> tuple[slips.Edge, list[slips.Part]]:
    force = edge(friction_coefficient, side)
    _, sine = lean(slider, force)
    exact = exact_contact_motion(slider, force, INERTIA)
    normal = contact_motion(slider, force, spin_ratio(slider, force, INERTIA))[1]
    stays = sign(normal, lambda: exact[1]) == 0  # type: ignore[index]
    found = slips.mirrored_edge(slider, force, sine, cosine_sine(slider.rod_angle)[0], stays)
    return found, slips.parts(found)


def _turning_slips(
    slider: Slider, force: Heading, side: int, normal: arb, tangential: arb
) -> list[arb]:
    """Slips with friction and inertia, whose direction changes with the speed."""
    raise NotImplementedError


__all__ = ["FRICTION"]
