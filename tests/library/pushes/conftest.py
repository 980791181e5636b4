"""Simulated pushes that several tests write to files."""

import pytest
from pushes.written import TRIANGLE, feet

import planar_pushing as pp


@pytest.fixture(scope="session")
def pushes():
    """Twelve pushes of the triangle on three feet, without noise."""
    return pp.simulate_pushes(feet(), TRIANGLE, 12, seed=4)


@pytest.fixture(scope="session")
def squares():
    """Pushes of the first rectangle, whose finger is given the radius of the tip."""
    support = pp.SupportFriction(support=pp.Polygon([(-45, -45), (45, -45), (45, 45), (-45, 45)]))
    found = pp.simulate_pushes((support,), support.support.vertices, 6, seed=1)
    found["finger_radius"][:] = 4.75
    return found
