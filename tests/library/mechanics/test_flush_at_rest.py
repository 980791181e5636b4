"""The forces at both ends of a side that loads hold at rest, about to slip: they balance the torques."""

from __future__ import annotations

import numpy as np
import pytest

import planar_pushing as pp

#: Supports of which all points are on the normal through the slider's center, and the square. On the first
#: ones a torque, however small, needs more friction: at the verge of a slip only the exact one is held.
SUPPORTS = [
    pp.Points([(0.5, 0.0), (-0.5, 0.0)]),
    pp.Points([(0.5, 0.0), (-0.5, 0.0), (0.2, 0.0)], [1.0, 2.0, 1.0]),
    pp.Segment((-0.5, 0.0), (0.5, 0.0)),
    pp.Polygon.rectangle(2.0, 2.0),
]


@pytest.mark.parametrize("along", [1.0, -1.0])
@pytest.mark.parametrize(("weight", "height"), [(1.0, 0.25), (0.37, 0.6), (1.38, 1.3), (1.0, 2.2)])
@pytest.mark.parametrize("support", SUPPORTS, ids=str)
def test_the_ends_balance_a_load_that_needs_all_friction(support, weight, height, along):
    """Without friction at the fence: that of the support alone is as large as the load along the fence."""
    slider = pp.Slider(rod_length=1.0, rod_angle=np.pi / 2, side=(-3.0, 3.0), flush=True)
    load = pp.Load(force=(along * weight, -1.0), center=(height - 1.0, 0.0))
    friction = pp.SupportFriction(support=support, weight=weight)
    effects = (friction, pp.Inertia(gyration_radius=0.8), load)
    scene = pp.Scene(slider=slider, contact=pp.Coulomb(0.0), effects=effects)
    (one,) = pp.solve(scene, np.pi / 2, 0.0)
    assert one.flush
    assert not one.twist.any()
    assert one.force == pytest.approx([0.0, 1.0], abs=1e-9)
    start, end = one.end_forces[:, 0, 1]
    assert start + end == pytest.approx(1.0, abs=1e-9)
    # The body's x is along the normal, and its origin 1 above the fence.
    lever = height - 1.0 - support.center_of_pressure[0]
    assert 3.0 * (end - start) == pytest.approx(along * weight * lever, abs=1e-9)


def on_feet(rng, mirror):
    """A side on the fence, feet and loads of all kinds; the image swaps left and right."""
    sign = -1.0 if mirror else 1.0
    feet = rng.uniform(-1.0, 1.0, size=(4, 2)) * [1.0, sign]
    start, end = rng.uniform(-1.2, -0.1), rng.uniform(0.1, 1.2)
    side = (-end, -start) if mirror else (start, end)
    force, center = rng.normal(size=2), rng.uniform(-1.0, 1.0, size=2)
    friction = pp.SupportFriction(support=pp.Points(feet, rng.uniform(0.2, 1.0, size=4)))
    slider = pp.Slider(rod_length=1.0, rod_angle=np.pi / 2, side=side, flush=True)
    law = pp.Coulomb(rng.uniform(0.05, 0.8))
    # The force has the axes of the fence, its point those of the body, whose x is along the normal.
    force, center = force * [sign, 1.0], center * [1.0, sign]

    def rests(size):
        load = pp.Load(force=tuple(size * force), center=tuple(center))
        effects = (friction, pp.Inertia(gyration_radius=0.8), load)
        scene = pp.Scene(slider=slider, contact=law, effects=effects)
        solutions = pp.solve(scene, np.pi / 2, 0.0)
        return any(not one.twist.any() for one in solutions)

    return rests


def largest_size(rests):
    """The largest load that leaves a side at rest on the fence, by bisection."""
    low, high = 0.01, 30.0
    for _ in range(45):
        middle = (low * high) ** 0.5
        low, high = (middle, high) if rests(middle) else (low, middle)
    return low


@pytest.mark.parametrize("seed", range(12))
def test_the_image_of_a_side_holds_the_same_load(seed):
    """Whichever edge of the cone, and whichever end of the side, needs the least friction."""
    one, other = (largest_size(on_feet(np.random.default_rng(seed), mirror)) for mirror in (0, 1))
    assert one == pytest.approx(other, rel=1e-9)


@pytest.mark.parametrize("aside", [-1.2, 1.2])
def test_infinite_friction_holds_a_side_only_with_a_normal_force(aside):
    """By the second definition; a force along the fence would leave the most to the support."""
    slider = pp.Slider(rod_length=1.0, rod_angle=np.pi / 2, side=(-3.0, 3.0), flush=True)
    effects = (
        pp.SupportFriction(support=pp.Polygon.rectangle(2.0, 2.0)),
        pp.Inertia(gyration_radius=0.8),
        pp.Load(force=(aside, 0.0), center=(-1.0, 0.0)),
    )
    scene = pp.Scene(slider=slider, contact=pp.InfiniteFriction("none"), effects=effects)
    (one,) = pp.solve(scene, np.pi / 2, 0.0)
    assert not one.twist.any()
    assert one.force[0] == pytest.approx(-aside, abs=1e-9)
    assert 0.1 < one.force[1] <= 1.0
