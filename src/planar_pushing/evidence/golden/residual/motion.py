"""The equations of Secs. 2-4 with 32 digits: the line of force, the spin ratio, the contact's motion.

Lengths are in units of R. Rotations and moment arms have a sign, as in the paper.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from planar_pushing.certified.doubled.angles import cosine_sine, off_direction, radians
from planar_pushing.certified.doubled.numbers import Doubled, Floats, choose, doubled, settled
from planar_pushing.certified.doubled.ring import wrench
from planar_pushing.evidence.golden.residual.finding import EPSILON
from planar_pushing.terms.options import EffectSet

#: A motion lies within 90 degrees of its force; further off than this it is on another branch.
BRANCH = 100.0


class Slider(NamedTuple):
    """Weight, mass, and the square of the radius of gyration in units of R."""

    weight: float
    mass: float
    gyration: float


class Line(NamedTuple):
    """Unit vector of a line of force along the rod and along its right-hand normal (Eq. 10)."""

    along: Doubled
    aside: Doubled


def line_at(rod_angle: Any, force_angle: Any) -> Line:
    """Line of force at an angle in degrees."""
    return Line(*cosine_sine(radians(rod_angle) - radians(force_angle)))


def line_on_edge(rod_angle: Any, friction_coefficient: Any, side: int) -> Line:
    """Line of force on an edge of the friction cone, side 1 for the right and -1 for the left one.

    An edge that only the rounding of its angle tells from the rod lies along the rod.
    """
    x, y = edge(friction_coefficient, side)
    cosine, sine = cosine_sine(radians(rod_angle))
    parts = x * cosine + y * sine, x * sine - y * cosine
    return Line(*(settled(part, 4 * EPSILON) for part in parts))


def edge(friction_coefficient: Any, side: int) -> tuple[Doubled, Doubled]:
    """Unit vector on an edge of the friction cone."""
    mu = np.asarray(friction_coefficient, dtype=float)
    endless = np.isinf(mu)
    finite = doubled(np.where(endless, 0.0, mu))
    size = (finite * finite + 1.0).sqrt()
    return choose(endless, side, finite / size * side), choose(endless, 0.0, 1.0 / size)


class Shares(NamedTuple):
    """Forces of friction and of inertia in a translation at a speed, the same for every k."""

    friction: Any
    inertia: Any


def shares(effects: str, slider: Slider, speed: Any = 1.0) -> Shares:
    """Forces of a set of effects in a translation; of those that are absent zero."""
    rubs, stores = effects != EffectSet.INERTIA, effects != EffectSet.SUPPORT_FRICTION
    return Shares(slider.weight if rubs else 0.0, slider.mass * speed if stores else 0.0)


def force_and_torque(parts: Shares, gyration: float, k: Any) -> tuple[Doubled, Doubled]:
    """Size of the force and torque at a spin ratio (Eqs. 2-3 and 8-9, and their sum)."""
    size = abs(doubled(k))
    force, torque = wrench(size if isinstance(k, Doubled) else size.value())
    inertia = doubled(parts.inertia)
    torque = torque * parts.friction + inertia * gyration * size
    return force * parts.friction + inertia, choose(doubled(k).high < 0, -torque, torque)


def torque_error(parts: Shares, gyration: float, k: Any, arm: Doubled) -> Floats:
    """Relative residual of ``torque = h force`` (Eq. 7)."""
    force, torque = force_and_torque(parts, gyration, k)
    carried = arm * force
    scale = np.abs(torque.high) + np.abs(carried.high)
    return np.abs((torque - carried).value()) / np.where(scale > 0, scale, 1.0)


def contact_motion(line: Line, length: Any, k: Any) -> tuple[Doubled, Doubled]:
    """Motion of the contact per speed of the center, along the force and to its right (Eqs. 11-12)."""
    pull = doubled(k) * length
    return pull * line.aside + 1.0, pull * line.along


def angle_error(motion_angle: Any, force_angle: Any, line: Line, length: Any, k: Any) -> Floats:
    """Residual in radians of the angle of the contact's motion, both angles in degrees."""
    ahead, right = contact_motion(line, length, k)
    turn = radians(motion_angle) - radians(force_angle)
    sine = np.abs(off_direction(turn, ahead, -right).value())
    apart = np.abs(np.asarray(motion_angle, dtype=float) - force_angle)
    return np.where(apart < BRANCH, sine, 2.0)
