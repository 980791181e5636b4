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
