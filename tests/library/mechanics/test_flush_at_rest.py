"""The forces at both ends of a side that loads hold at rest, about to slip: they balance the torques."""

from __future__ import annotations

import numpy as np
import pytest

import planar_pushing as pp

SQUARE = pp.Polygon.rectangle(2.0, 2.0)


def about_to_slip(friction, height, along=1.0):
    """A side below a square of weight 1, with a load that needs all friction of both contacts.

    The load is at a height above the fence, on the normal through the center, and presses with 1.
    """
    slider = pp.Slider(rod_length=1.0, rod_angle=np.pi / 2, side=(-3.0, 3.0), flush=True)
    load = pp.Load(force=(along * (1.0 + friction), -1.0), center=(height - 1.0, 0.0))
    effects = (pp.SupportFriction(support=SQUARE), pp.Inertia(gyration_radius=0.8), load)
    return pp.Scene(slider=slider, contact=pp.Coulomb(friction), effects=effects)


@pytest.mark.parametrize("along", [1.0, -1.0])
@pytest.mark.parametrize("height", [0.25, 0.6, 1.0, 1.3, 1.5, 2.2, -0.3])
@pytest.mark.parametrize("friction", [0.0])
def test_the_ends_balance_a_load_that_needs_all_friction(friction, height, along):
    scene = about_to_slip(friction, height, along)
    at_rest = [one for one in pp.solve(scene, np.pi / 2, 0.0) if one.flush and not one.twist.any()]
    assert at_rest
    for one in at_rest:
        assert one.force == pytest.approx([-along * friction, 1.0], abs=1e-9)
        start, end = one.end_forces[:, 0, 1]
        assert start + end == pytest.approx(1.0, abs=1e-9)
        # Friction of the support acts at its center, 1 above the fence; the load acts at its height.
        assert 3.0 * (end - start) == pytest.approx(along * (height - 1.0), abs=1e-9)
