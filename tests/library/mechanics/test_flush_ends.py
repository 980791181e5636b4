"""Contacts at the ends of a side on the fence: those, and only those, that lift the other end."""

from __future__ import annotations

import numpy as np
import pytest

import planar_pushing as pp

SEPARATE, STICK, RIGHT, LEFT = pp.ContactMode
LAWS = [
    pp.Coulomb(0.0), pp.Coulomb(0.01), pp.Coulomb(0.3), pp.Coulomb(1.5), pp.InfiniteFriction(),
    pp.InfiniteFriction("none"), pp.PerfectlyRough(),
]  # fmt: skip
MASS = pp.Inertia(gyration_radius=0.8)
BLOCK = [(-1, -0.8), (1, -0.8), (1, 0.8), (-1, 0.8)]
#: Outlines around the block, with the first side on the fence.
OUTLINES = {
    "a side below the center": BLOCK,
    "a side aside": [(-3, -2), (-1.5, -2), (1.5, -0.9), (1.5, 1), (-2, 1)],
}
LIFTED = {
    "friction": (pp.SupportFriction(support=pp.Polygon(BLOCK)),),
    "feet": (pp.SupportFriction(support=pp.Points(BLOCK, [1, 2, 3, 1])),),
    "inertia": (pp.Inertia(gyration_radius=0.8, center=(0.3, -0.2)),),
    "friction and inertia": (pp.SupportFriction(support=pp.Polygon(BLOCK)), MASS),
    "feet and inertia aside": (
        pp.SupportFriction(support=pp.Points(BLOCK)), pp.Inertia(center=(-0.4, 0.3)),
    ),
    "viscous": (pp.Viscous(support=pp.Polygon(BLOCK)),),
    "a load that friction holds": (
        pp.SupportFriction(support=pp.Polygon(BLOCK)), pp.Load(force=(0.6, -0.7), center=(0.2, 0.1)),
    ),
    "a load that presses": (
        pp.SupportFriction(support=pp.Polygon(BLOCK)), pp.Inertia(center=(0.3, 0.4)),
        pp.Load(force=(0.9, -2.0)),
    ),
    "a load aside that moves it": (
        pp.SupportFriction(support=pp.Points(BLOCK)), MASS,
        pp.Load(force=(-1.5, 0.7), center=(0.5, -0.6)),
    ),
    "inertia and a load": (
        pp.Inertia(gyration_radius=0.3, center=(0.4, -0.7)), pp.Load(force=(1.8, 0.3), center=(0.6, -0.7)),
    ),
    "centers apart and a load": (
        pp.SupportFriction(support=pp.Disc(0.3, (0.2, -0.1))),
        pp.Inertia(gyration_radius=0.3, center=(0.6, -0.1)), pp.Load(force=(0.2, -0.9), center=(0.8, -0.6)),
    ),
}  # fmt: skip
#: Effects and outline. In the last one, the torques of the slowest and of the fastest slip have one sign,
#: and those between have the other.
WITH_ENDS = {
    f"{name}, {place}": (effects, outline)
    for name, effects in LIFTED.items() for place, outline in OUTLINES.items()
} | {
    "two feet and a load beside a side": (
        (pp.SupportFriction(support=pp.Points([(0.93, 0.38), (-0.93, -0.38)]), weight=0.83),
         pp.Load(force=(-0.5, 0.35), center=(-0.6, 0.4))),
        [(-1.9, -0.5), (-0.7, -0.5), (1, 0.4), (0.8, 0.8), (-1.9, 0.8)],
    ),
}  # fmt: skip


def contacts_that_lift(solutions, x):
    """Mode, motion, rotation and force of the contacts at an end, at x, that lift the other end.

    Rotations that are rounding errors of flush contact are left out.
    """
    kept = []
    for solution in solutions:
        motion, spin = solution.contact_motion, solution.twist[2]
        if solution.mode == SEPARATE or solution.flush:
            continue
        place = solution.force_position  # None for a scene of one point
        lifts = -np.sign(x) * spin > 1e-9 * np.hypot(*motion)
        if lifts and (place is None or np.isclose(place, x)):
            kept.append((solution.mode, [*motion, spin, *solution.force]))
    return kept


@pytest.mark.parametrize("name", WITH_ENDS)
def test_every_contact_at_an_end_that_lifts_the_other_is_a_solution(name):
    """The ends as scenes of one point, which know nothing of the side."""
    effects, outline = WITH_ENDS[name]
    (start, y), (end, _) = outline[:2]
    middle, half = (start + end) / 2, (end - start) / 2
    angles = np.deg2rad([*range(-180, 180, 30), -8, 8, 172, -172, 40, 50, 130, 140])
    modes = set()
    for law in LAWS:
        common = {"effects": effects, "contact": law, "outline": outline}
        along = pp.scene_at(side=0, **common)
        points = [(x, pp.scene_at((middle + x, y), (0, 1), **common)) for x in (-half, half)]
        for angle in [*angles, 1e-9, -1e-9, np.pi - 1e-9, 1e-9 - np.pi]:
            for magnitude in (0.3, 3.0):
                solutions = pp.solve(along, angle, magnitude)
                for x, point in points:
                    expected = contacts_that_lift(pp.solve(point, angle, magnitude), x)
                    listed = contacts_that_lift(solutions, x)
                    case = law, angle, magnitude, x, expected, listed
                    assert [mode for mode, _ in listed] == [mode for mode, _ in expected], case
                    for (mode, one), (_, other) in zip(listed, expected, strict=True):
                        assert one == pytest.approx(other, rel=1e-9, abs=1e-9), case
                        modes.add(mode)
    assert STICK in modes
    assert modes & {RIGHT, LEFT}
