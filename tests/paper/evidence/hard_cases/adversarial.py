"""Random and adversarial inputs of the whole domain: next to boundaries, at its ends, subnormal, zero."""

import numpy as np

import planar_pushing as pp
from planar_pushing.terms.domain import GYRATION, LONGEST, ROUGHEST
from planar_pushing.terms.options import EffectSet

#: Lengths of rods and coefficients of friction go down to this size in even steps, and are 0.
SMALL = 1e-12
#: Torques of a rod still shorter, pushed along the fence but for the smallest double, underflow.
SHORTEST = 1e-50
QUARTERS = np.arange(-2, 3) * (np.pi / 2)
ROD_ANGLES = [5e-324, 1e-300, 1e-12, np.pi / 4, np.pi / 2, np.nextafter(np.pi, 0)]
LAWS = ("coulomb", "infinite", "infinite, none at zero normal", "rough")


def powers(rng, low, high, size):
    """Positive doubles, even in their logarithm from `low` to `high`."""
    exponents = rng.uniform(np.log10(low), np.log10(high), size)
    return np.clip(10.0**exponents, low, high)


def mixed(rng, special, rest):
    """Numbers of which one in five is a special one."""
    return np.where(rng.random(rest.size) < 0.2, rng.choice(special, rest.size), rest)


def neighbors(values, steps=3):
    """Each value with its `steps` next doubles on both sides."""
    down = up = np.asarray(values, dtype=float)
    found = [up]
    for _ in range(steps):
        down, up = np.nextafter(down, -np.inf), np.nextafter(up, np.inf)
        found += [down, up]
    return np.concatenate(found)


def angles(rng, size, *near):
    """Angles: every turn by quarters and `near`, with neighbors, and the rest even over two turns."""
    special = neighbors([*QUARTERS, *near])
    tiny = rng.choice([-1.0, 1.0], size // 8) * 10.0 ** rng.uniform(-300, -1, size // 8)
    around = rng.choice([*QUARTERS, *near], size // 8) + tiny
    rest = rng.uniform(-2 * np.pi, 2 * np.pi, max(0, size - special.size - around.size))
    return np.concatenate([special, around, rest])[:size]


def lengths(rng, size):
    """Lengths of rods in radii."""
    return mixed(rng, [0.0, SHORTEST, 1.0, LONGEST], powers(rng, SMALL, LONGEST, size))


def rod_angles(rng, size):
    return mixed(rng, ROD_ANGLES, rng.uniform(1e-300, np.pi, size))


def coefficients(rng, size):
    return mixed(rng, [0.0, 1e-300, 1.0, ROUGHEST], powers(rng, SMALL, ROUGHEST, size))


def gyrations(rng, size):
    """Radii of gyration in radii of the ring."""
    return mixed(rng, [*GYRATION, 1.0], powers(rng, *GYRATION, size))


def units(rng, size):
    """Powers of two: in these units the ratios are exact."""
    return 2.0 ** rng.integers(-100, 101, size)


def scenes(rng, effects, law, size):
    """Many different scenes of one set of effects and one law."""
    radius = units(rng, size)
    slider = pp.Slider(
        rod_length=radius * lengths(rng, size), rod_angle=rod_angles(rng, size), radius=radius
    )
    contact = {
        "coulomb": pp.Coulomb(coefficients(rng, size)),
        "infinite": pp.InfiniteFriction(),
        "infinite, none at zero normal": pp.InfiniteFriction("none"),
        "rough": pp.PerfectlyRough(),
    }
    friction = pp.RingFriction(weight=units(rng, size))
    inertia = pp.Inertia(mass=units(rng, size), gyration_radius=radius * gyrations(rng, size))
    listed = {
        EffectSet.SUPPORT_FRICTION: (friction,),
        EffectSet.INERTIA: (inertia,),
        EffectSet.BOTH: (friction, inertia),
    }
    return pp.Scene(slider=slider, contact=contact[law], effects=listed[effects])
