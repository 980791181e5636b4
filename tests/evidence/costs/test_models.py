"""The models of the limit surface, and the published mean errors for a rim of points."""

import numpy as np
import pytest

from planar_pushing.evidence.costs import models
from planar_pushing.evidence.costs.models import Quartic
from planar_pushing.mechanics.effects import RingFriction
from planar_pushing.mechanics.wrench import ring_profile, wrench

QUARTIC = models.fitted_quartic()


def test_the_fitted_quartic_is_convex_and_close_to_the_surface():
    assert QUARTIC.convex
    force, torque = ring_profile(np.geomspace(1e-3, 1e3, 200))
    value = QUARTIC.a * force**4 + QUARTIC.b * (force * torque) ** 2 + QUARTIC.c * torque**4
    assert np.abs(value - 1).max() < 0.012


@pytest.mark.parametrize(
    ("b", "convex"), [(0.0, True), (6.0, True), (6.001, False), (-1e-3, False)]
)
def test_convexity_is_that_of_the_hessian(b, convex):
    """Least eigenvalue of the Hessian over directions of (|f|, torque), by differences."""
    model = Quartic(a=1.0, b=b, c=1.0)
    assert model.convex == convex
    angle = np.linspace(0, np.pi / 2, 4001)
    x, y = np.cos(angle), np.sin(angle)
    across = 2 * b * x**2 + 12 * y**2
    hessian = np.array([[12 * x**2 + 2 * b * y**2, 4 * b * x * y], [4 * b * x * y, across]])
    least = np.linalg.eigvalsh(np.moveaxis(hessian, -1, 0)).min()
    assert (least >= -1e-12) == convex


def test_twist_is_the_gradient_of_the_polynomial():
    felt, step = np.array([0.3, -0.5, 0.4]), 1e-6

    def value(w):
        square = w[0] ** 2 + w[1] ** 2
        return QUARTIC.a * square**2 + QUARTIC.b * square * w[2] ** 2 + QUARTIC.c * w[2] ** 4

    slopes = [(value(felt + step * e) - value(felt - step * e)) / (2 * step) for e in np.eye(3)]
    assert models.direction_error(QUARTIC.twist(felt)[None], np.array([slopes])) < 1e-7


@pytest.mark.parametrize("k", [1e-8, 0.3, 0.999, 1.0, 1.5, 1.75, 32.0, 1e6])
def test_profile_lies_on_the_surface_and_has_the_spin_ratio(k):
    force, torque = QUARTIC.profile(np.array([k]))
    value = QUARTIC.a * force**4 + QUARTIC.b * (force * torque) ** 2 + QUARTIC.c * torque**4
    assert value == pytest.approx(1, rel=1e-14, abs=0)
    assert QUARTIC.spin_ratio(torque / force) == pytest.approx(k, rel=1e-12, abs=0)


def test_a_rim_of_many_points_is_the_ring():
    twist = models.sphere(50)
    gap = models.rim_wrench(twist, 4000) - wrench(RingFriction(), twist)
    assert np.abs(gap).max() < 1e-4


def test_direction_errors_for_a_rim_of_100_points():
    """Published for another implementation: 7.9 degrees for an ellipsoid, 0.27 for a convex quartic."""
    errors = models.rim_errors()
    assert errors["ellipsoid"] == pytest.approx(7.9, abs=0.05)
    assert 0.1 < errors["quartic"] < 0.27
