"""The arguments of a golden number: slider, effects, and line of force, all exact.

Lengths are in units of R and angles in exact degrees. A double represents exactly its value; the edge
of a Coulomb cone is the direction (mu, 1), so that no angle is rounded.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from enum import StrEnum
from functools import lru_cache, partial

from flint import arb, fmpq

from planar_pushing.certified.balls import (
    Exact,
    cosine_sine,
    exact_cosine,
    exact_direction,
    exact_sine,
    has_exact_direction,
    in_degrees,
    precise,
    rational,
    settle,
)

FRICTION, INERTIA = fmpq(0), fmpq(1)  # shares of inertia


class Effects(StrEnum):
    """Effects that resist the motion, by the names in the datasets."""

    FRICTION = "support_friction"
    INERTIA = "inertia"
    BOTH = "support_friction+inertia"

    @property
    def shares(self) -> tuple[fmpq, ...]:
        """Range of the shares of inertia that the effects allow."""
        ends = {Effects.FRICTION: (FRICTION,), Effects.INERTIA: (INERTIA,)}
        return ends.get(self, (FRICTION, INERTIA))


@dataclass(frozen=True, slots=True)
class Slider:
    """Rod length in units of R, rod angle in degrees, ``gyration = (rho / R)^2``, W and m; all exact."""

    rod_length: fmpq
    rod_angle: fmpq
    gyration: fmpq
    weight: fmpq
    mass: fmpq

    @classmethod
    def of(
        cls,
        rod_length: float,
        rod_angle: float = 45.0,
        *,
        weight: float = 1.0,
        mass: float = 1.0,
        radius: float = 1.0,
        gyration_radius: float = 1.0,
    ) -> Slider:
        """Slider with lengths in one arbitrary unit; doubles are taken as exact."""
        size = rational(radius)
        gyration = (rational(gyration_radius) / size) ** 2
        length = rational(rod_length) / size
        return cls(length, rational(rod_angle), gyration, rational(weight), rational(mass))


@dataclass(frozen=True, slots=True, eq=False)
class Heading:
    """Direction of a force: its angle in degrees and its unit vector, as balls and exactly.

    Compare headings by identity: `heading` and `edge` return the same object for the same direction.

    `rational` is the angle if it is rational, and `exact` returns a positive multiple of the vector.
    """

    degrees: arb
    x: arb
    y: arb
    exact: Callable[[], tuple[Exact, Exact]] | None
    rational: fmpq | None = None


@lru_cache(maxsize=4096)
@precise
def heading(degrees: fmpq | float) -> Heading:
    """Direction at an exact angle."""
    angle = rational(degrees)
    x, y = cosine_sine(angle)
    exact = partial(exact_direction, angle) if has_exact_direction(angle) else None
    return Heading(arb(angle), x, y, exact, angle)


@precise
def direction(degrees: arb) -> Heading:
    """Direction at an angle that is known as a ball."""
    turn = degrees / 180
    return Heading(degrees, turn.cos_pi(), turn.sin_pi(), None)


@lru_cache(maxsize=1024)
@precise
def edge(friction_coefficient: float, side: int) -> Heading:
    """Edge of the friction cone, side 1 for the right and -1 for the left one; also exact at infinity."""
    if math.isinf(friction_coefficient):
        return heading(fmpq(90 - 90 * side))
    mu = rational(friction_coefficient)
    size = arb(1 + mu * mu).sqrt()
    degrees = 90 - side * in_degrees(arb(mu).atan())
    return Heading(degrees, side * mu / size, 1 / size, lambda: (side * mu, fmpq(1)))


@lru_cache(maxsize=1 << 15)
@precise
def lean(slider: Slider, force: Heading) -> tuple[arb, arb]:
    """Cosine and sine of the rod angle minus the force angle; zeros are exact."""
    if force.rational is not None:
        return cosine_sine(slider.rod_angle - force.rational)
    c, s = cosine_sine(slider.rod_angle)

    def exact(turn: int) -> Exact:
        x, y = force.exact()  # type: ignore[misc]
        return x * exact_cosine(slider.rod_angle - turn) + y * exact_sine(slider.rod_angle - turn)

    known = partial(exact, 0), partial(exact, 90)
    cosine = settle(force.x * c + force.y * s, force.exact and known[0])
    sine = settle(force.x * s - force.y * c, force.exact and known[1])
    return cosine, sine if cosine != 0 else sine.sgn()
