"""Random scenes with pushes that are hard for rounding: everything follows from a seed.

Supports are on the contact, on its normal and tangent, on a line through it, or have points at one place;
rods are up to 1e6 radii long; pushes are along the fence, beside it by the smallest numbers there are, at
the edges of the motion cone, and at rest.
"""

from __future__ import annotations

import math

import numpy as np
from mechanics.degenerate import PUSHES, SYMMETRIC, feet_of_contact, random_support, symmetric_feet

import planar_pushing as pp

LENGTHS = (0.0, 1e-9, 0.5, 1.0, 2.0, 1e3, 1e6)
ROD_ANGLES = (
    math.pi / 4, math.pi / 2, 3 * math.pi / 4, 1e-12, 1e-300, math.nextafter(math.pi, 0), 1.0,
    math.nextafter(math.pi / 2, 0),
)  # fmt: skip
LAWS = (
    pp.Coulomb(0.0), pp.Coulomb(1e-12), pp.Coulomb(0.5), pp.Coulomb(1.0), pp.Coulomb(1e9),
    pp.InfiniteFriction(), pp.InfiniteFriction("none"), pp.PerfectlyRough(),
)  # fmt: skip
HOLED = pp.Polygon(
    [(-1, -1), (1.2, -1), (1, 1), (-0.9, 0.7)], [[(-0.7, -0.7), (0.2, -0.6), (-0.6, 0.3)]]
)
BESIDE = (0.0, math.pi, *PUSHES, 1e-300, -1e-300, 5e-324, -5e-324, math.nextafter(math.pi, 0))
#: Forces of loads, of which friction holds the smaller ones.
PULLS = (0.0, 0.0, 0.3, -0.3, 1.0, -2.0, 1e-300)


def hard_support(random, length, psi):
    """A support near the contact, or a random one."""
    match random.integers(12):
        case 0 | 1:
            return feet_of_contact(random, min(length, 10.0), psi)
        case 2 | 3:
            return symmetric_feet(random)
        case 4:
            return _on_line(random, length)
        case 5:
            # Two points at one place, or nearly.
            places = random.normal(size=(3, 2))
            gap = random.choice([0.0, 1e-300, 1e-16, 1e-9, 1e-5])
            weights = random.uniform(0.2, 1.0, 4)
            return pp.Points([*places, places[0] + [gap, 0.0]], weights)
        case 6:
            return pp.Segment((-length - 1, 0), (1 - length, random.choice([0.0, 1e-12, 1e-5, 1])))
        case 7:
            center = tuple(random.choice([0.0, 0.5, 1.0], 2))
            return pp.Annulus(random.choice([0.1, 0.5, 0.999999]), 1.0, center)
        case 8:
            return HOLED
        case 9:
            return SYMMETRIC[random.choice(list(SYMMETRIC))]
    while True:
        try:
            return random_support(random)
        except pp.InvalidValue:  # a polygon whose edges cross
            continue


def _on_line(random, length):
    """Feet on a line through the contact, also exactly along an axis."""
    places = np.cumsum(random.uniform(0.1, 1, random.integers(2, 5))) - 1.0
    turn = random.uniform(0, 3.1)
    axis = [(1.0, 0.0), (0.0, 1.0), (math.cos(turn), math.sin(turn))][random.integers(3)]
    return pp.Points(
        np.array([-length, 0.0]) + places[:, None] * axis, random.integers(1, 4, len(places))
    )


def hard_effects(random, length, psi):
    """Friction, inertia, both, several of each, a film of oil, and loads."""

    def friction():
        weight = random.choice([1.0, 1e-3, 10 ** random.uniform(-6, 6)])
        return pp.SupportFriction(support=hard_support(random, length, psi), weight=weight)

    def inertia():
        center = random.choice([0.0, 0.5, -length, 1.0]), random.choice([0.0, 0.5, random.normal()])
        size = random.choice([1.0, 0.5, 1e-3, 10 ** random.uniform(-3.5, 3.5)])
        mass = random.choice([1.0, 10 ** random.uniform(-5, 5)])
        return pp.Inertia(mass=mass, gyration_radius=size, center=center)

    effects = [
        [friction()], [friction(), friction()], [friction(), inertia()], [inertia()],
        [pp.RingFriction(), friction()], [pp.RingFriction()], [pp.RingFriction(), inertia()],
        [friction(), friction(), inertia(), inertia()],
    ][random.integers(8)]  # fmt: skip
    if random.random() < 0.1:
        coefficient = 10 ** random.uniform(-3, 3)
        support = hard_support(random, length, psi)
        effects.append(pp.Viscous(support=support, coefficient=coefficient))
    if random.random() < 0.3:
        force = tuple(random.choice(PULLS, 2) * random.choice([1.0, 10.0, 1e-6]))
        center = [None, (0.0, 0.0), (-length, 0.0), (0.7, 0.3)][random.integers(4)]
        effects.append(pp.Load(force=force, center=center))
    return effects


def hard_scene(seed):
    """A scene, and a generator of random numbers for its pushes."""
    random = np.random.default_rng(seed)
    length = random.choice([*LENGTHS, 10 ** random.uniform(-2, 5.9)])
    psi = random.choice([*ROD_ANGLES, random.uniform(0.1, 3.0)])
    radius = random.choice([1.0, 0.7, 2.0]) if length < 1e5 else 2.0
    slider = pp.Slider(rod_length=length, rod_angle=psi, radius=radius)
    law, effects = LAWS[random.integers(len(LAWS))], hard_effects(random, length, psi)
    return pp.Scene(slider=slider, contact=law, effects=effects), random


def hard_pushes(scene, random, with_cone):
    """Angles and magnitudes, of which one is zero; with the edges of the motion cone, if it has one."""
    angles = [
        *random.choice(BESIDE, 3), random.uniform(-np.pi, np.pi),
        random.choice(PUSHES) + random.choice([-1, 1]) * 10.0 ** random.integers(-14, -3),
    ]  # fmt: skip
    try:
        cone = pp.motion_cone(scene) if with_cone else None
    except pp.InvalidValue:  # loads without friction, or that friction does not hold
        cone = None
    for edge in (cone.right, cone.left) if cone else ():
        angles += [edge, np.nextafter(edge, 9.0), edge + random.choice([-1e-9, 1e-14, 1e-5])]
    angles = np.clip(np.nan_to_num(angles), -4 * np.pi, 4 * np.pi)
    sizes = [1.0, 10 ** random.uniform(-6, 6), 10 ** random.uniform(-9, 9)]
    return angles, np.append(random.choice(sizes, len(angles) - 1), 0.0)
