"""Random and adversarial doubles: even in their logarithm, next to boundaries, subnormal, zero."""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt

from planar_pushing.evidence.internals import LONGEST, Array, IsotropicEffect
from planar_pushing.mechanics.contact import ContactLaw, Coulomb, InfiniteFriction, PerfectlyRough
from planar_pushing.mechanics.effects import Inertia, RingFriction
from planar_pushing.mechanics.scene import Scene, Slider

Generator = np.random.Generator

#: Values at which a formula changes or a function has a singularity.
BOUNDARIES = np.array([0.0, 1e-9, 1e-6, 0.5, 0.9, 1 / 0.9, 1.0, 2.0, 1e9, 1e160])
SUBNORMAL = np.array([5e-324, 1e-320, 2.2250738585072009e-308, 2.2250738585072014e-308])
#: Decimal exponents that the lengths and the sizes of a scene reach.
REACH = math.log10(LONGEST) - 1
QUARTERS = np.arange(-2, 3) * (np.pi / 2)


def powers(rng: Generator, reach: float, size: int) -> Array:
    """Positive doubles, even in their logarithm from 10^-reach to 10^reach."""
    return np.asarray(10.0 ** rng.uniform(-reach, reach, size))


def neighbours(values: npt.ArrayLike, steps: int = 3) -> Array:
    """Each value with its `steps` next doubles on both sides."""
    down = up = np.asarray(values, dtype=float)
    found = [up]
    for _ in range(steps):
        down, up = np.nextafter(down, -np.inf), np.nextafter(up, np.inf)
        found += [down, up]
    return np.concatenate(found)


def numbers(rng: Generator, size: int) -> Array:
    """Numbers of both signs: every special one, a quarter next to 1, the rest from 1e-300 to 1e300."""
    special = np.concatenate([neighbours(BOUNDARIES), SUBNORMAL, [1e300, np.inf, -0.0]])
    close = 1 + rng.choice([-1.0, 1.0], size // 4) * 10.0 ** rng.uniform(-16, -1, size // 4)
    rest = powers(rng, 300, max(0, size - 2 * special.size - close.size))
    mixed = np.concatenate([special, -special, close, rest * rng.choice([-1.0, 1.0], rest.size)])
    return mixed[:size]


def angles(rng: Generator, size: int, *near: float) -> Array:
    """Angles: every turn by quarters and `near`, with neighbours, and the rest even over two turns."""
    special = neighbours([*QUARTERS, *near])
    tiny = rng.choice([-1.0, 1.0], size // 8) * 10.0 ** rng.uniform(-300, -1, size // 8)
    around = rng.choice([*QUARTERS, *near], size // 8) + tiny
    rest = rng.uniform(-2 * np.pi, 2 * np.pi, max(0, size - special.size - around.size))
    return np.concatenate([special, around, rest])[:size]


def rod_angle(rng: Generator) -> float:
    """One rod angle in (0, pi)."""
    special = [5e-324, 1e-300, 1e-12, np.pi / 4, np.pi / 2, np.nextafter(np.pi, 0)]
    return float(rng.choice([*special, *rng.uniform(1e-6, np.pi - 1e-6, 6)]))


def effects(rng: Generator, reach: float, radius: float = 1.0) -> tuple[IsotropicEffect, ...]:
    """Friction, inertia or both."""
    weight, mass = powers(rng, reach, 2)
    gyration = float(rng.choice([1.0, *powers(rng, min(reach, REACH), 2)]))
    friction = RingFriction(weight=float(weight))
    inertia = Inertia(mass=float(mass), gyration_radius=radius * gyration)
    sets: tuple[tuple[IsotropicEffect, ...], ...] = ((friction,), (inertia,), (friction, inertia))
    return sets[int(rng.integers(3))]


def scene(rng: Generator, reach: float) -> Scene:
    """One scene whose lengths, forces and coefficients span 10^-reach to 10^reach."""
    length = float(rng.choice([0.0, 1.0, *powers(rng, min(reach, REACH), 3)]))
    radius = float(rng.choice([1.0, *powers(rng, min(reach, 200.0), 1)]))
    laws: list[ContactLaw] = [
        Coulomb(float(rng.choice([0.0, 1.0, *powers(rng, reach, 4)]))),
        InfiniteFriction(), InfiniteFriction("none"), PerfectlyRough(),
    ]  # fmt: skip
    law = laws[int(rng.choice(4, p=[0.55, 0.25, 0.1, 0.1]))]
    slider = Slider(rod_length=length * radius, rod_angle=rod_angle(rng), radius=radius)
    return Scene(slider=slider, contact=law, effects=effects(rng, reach, radius))
