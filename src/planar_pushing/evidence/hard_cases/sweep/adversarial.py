"""Random and adversarial inputs of the whole domain: next to boundaries, at its ends, subnormal, zero."""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.contact import ContactLaw, Coulomb, InfiniteFriction, PerfectlyRough
from planar_pushing.mechanics.effects import Effect, Inertia, RingFriction
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.scene import Scene, Slider
from planar_pushing.terms.domain import GYRATION, LONGEST, ROUGHEST, Number
from planar_pushing.terms.options import EffectSet

Generator = np.random.Generator

#: Values at which a formula changes or a function has a singularity.
BOUNDARIES = np.array([0.0, 1e-9, 1e-6, 0.5, 0.9, 1 / 0.9, 1.0, 2.0, 1e9, 1e160])
SUBNORMAL = np.array([5e-324, 1e-320, 2.2250738585072009e-308, 2.2250738585072014e-308])
#: Lengths of rods and coefficients of friction go down to this size in even steps, and are 0.
SMALL = 1e-12
#: Torques of a rod still shorter, pushed along the fence but for the smallest double, underflow.
SHORTEST = 1e-50
QUARTERS = np.arange(-2, 3) * (np.pi / 2)
ROD_ANGLES = [5e-324, 1e-300, 1e-12, np.pi / 4, np.pi / 2, np.nextafter(np.pi, 0)]
LAWS = ("coulomb", "infinite", "infinite, none at zero normal", "rough")


def powers(rng: Generator, low: float, high: float, size: int) -> Array:
    """Positive doubles, even in their logarithm from `low` to `high`."""
    exponents = rng.uniform(math.log10(low), math.log10(high), size)
    return np.asarray(np.clip(10.0**exponents, low, high))


def mixed(rng: Generator, special: npt.ArrayLike, rest: Array) -> Array:
    """Numbers of which one in five is a special one."""
    return np.where(rng.random(rest.size) < 0.2, rng.choice(special, rest.size), rest)


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
    rest = powers(rng, 1e-300, 1e300, max(0, size - 2 * special.size - close.size))
    every = np.concatenate([special, -special, close, rest * rng.choice([-1.0, 1.0], rest.size)])
    return every[:size]


def angles(rng: Generator, size: int, *near: float) -> Array:
    """Angles: every turn by quarters and `near`, with neighbors, and the rest even over two turns."""
    special = neighbours([*QUARTERS, *near])
    tiny = rng.choice([-1.0, 1.0], size // 8) * 10.0 ** rng.uniform(-300, -1, size // 8)
    around = rng.choice([*QUARTERS, *near], size // 8) + tiny
    rest = rng.uniform(-2 * np.pi, 2 * np.pi, max(0, size - special.size - around.size))
    return np.concatenate([special, around, rest])[:size]


def lengths(rng: Generator, size: int) -> Array:
    """Lengths of rods in radii."""
    return mixed(rng, [0.0, SHORTEST, 1.0, LONGEST], powers(rng, SMALL, LONGEST, size))


def rod_angles(rng: Generator, size: int) -> Array:
    """Rod angles in (0, pi)."""
    return mixed(rng, ROD_ANGLES, rng.uniform(1e-300, np.pi, size))


def coefficients(rng: Generator, size: int) -> Array:
    """Coefficients of friction at the contact."""
    return mixed(rng, [0.0, 1e-300, 1.0, ROUGHEST], powers(rng, SMALL, ROUGHEST, size))


def gyrations(rng: Generator, size: int) -> Array:
    """Radii of gyration in radii of the ring."""
    return mixed(rng, [*GYRATION, 1.0], powers(rng, *GYRATION, size))


def units(rng: Generator, size: int) -> Array:
    """Powers of two: in these units the ratios are exact."""
    return np.asarray(2.0 ** rng.integers(-100, 101, size))


def effects(rng: Generator, names: EffectSet, radius: Number, size: int) -> tuple[Effect, ...]:
    """Effects of many scenes."""
    friction = RingFriction(weight=units(rng, size))
    inertia = Inertia(mass=units(rng, size), gyration_radius=radius * gyrations(rng, size))
    sets: dict[EffectSet, tuple[Effect, ...]] = {
        EffectSet.SUPPORT_FRICTION: (friction,),
        EffectSet.INERTIA: (inertia,),
        EffectSet.BOTH: (friction, inertia),
    }
    return sets[names]


def law(rng: Generator, name: str, size: int) -> ContactLaw:
    """Contact law of many scenes."""
    laws: tuple[ContactLaw, ...] = (
        Coulomb(coefficients(rng, size)), InfiniteFriction(), InfiniteFriction("none"),
        PerfectlyRough(),
    )  # fmt: skip
    return laws[LAWS.index(name)]


def scenes(rng: Generator, names: EffectSet, contact: str, size: int) -> Scene:
    """Many different scenes of one set of effects and one law."""
    radius = units(rng, size)
    slider = Slider(
        rod_length=radius * lengths(rng, size), rod_angle=rod_angles(rng, size), radius=radius
    )
    return Scene(
        slider=slider,
        contact=law(rng, contact, size),
        effects=effects(rng, names, radius, size),
    )
