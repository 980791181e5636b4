"""The ellipsoid in place of a support: its constant, its matrix and its errors."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from mechanics.supports.cases import SQUARE, SUPPORTS, TRIPOD, rectangle
from mpmath import mp

from planar_pushing.core.supports.ring import ring_wrench
from planar_pushing.mechanics.effects import RingFriction
from planar_pushing.mechanics.pressure.table import table_of
from planar_pushing.mechanics.supports.disc import Disc
from planar_pushing.mechanics.supports.ellipsoid import (
    ellipsoid_errors,
    fit_ellipsoid,
    spread_motions,
)
from planar_pushing.mechanics.supports.even_ring import Ring
from planar_pushing.mechanics.supports.points import Points
from planar_pushing.mechanics.supports.polygon import Polygon
from planar_pushing.mechanics.supports.segment import Segment
from planar_pushing.terms.errors import InvalidValue

#: Integration constants: numerical integrals, and the disc and the ring by hand.
CONSTANTS = [
    (SQUARE, 0.541075, 1e-6),
    (rectangle(2.0, 1.0), 0.530604, 1e-6),
    (rectangle(4.0, 1.0), 0.514554, 1e-6),
    (Disc(3.0, (1.0, 2.0)), 2 / 3, 1e-15),
    (Ring(2.0), 1.0, 1e-15),
    (Segment((0.0, 1.0), (2.0, 5.0)), 0.5, 1e-15),
    (TRIPOD, 1.0, 1e-15),
    (Points([(-1.0, 0.0), (0.0, 0.0), (1.0, 0.0)], [1.0, 2.0, 1.0]), 0.5, 1e-15),
]


@cache
def fit_of(name):
    return fit_ellipsoid(SUPPORTS[name][0])


@pytest.mark.parametrize(("support", "constant", "error"), CONSTANTS)
def test_integration_constant(support, constant, error):
    found = fit_ellipsoid(support)
    assert found.integration_constant == pytest.approx(constant, abs=error)
    assert found.extent == support.extent
    assert found.center == support.center_of_pressure
    arm = found.integration_constant * found.extent
    assert found.matrix == pytest.approx(np.diag([1.0, 1.0, arm**-2]))


def test_errors_of_a_ring_are_those_of_its_closed_form():
    """Means over the sphere as integrals over the latitude, on which alone they depend for a ring."""

    def error(spin):
        speed = np.sqrt(1 - spin * spin)
        force, torque, _ = ring_wrench(speed, spin)
        return abs(np.arctan2(torque, force) - np.arctan2(spin, speed))

    found = fit_ellipsoid(Ring(2.0))
    mean = float(mp.quad(lambda z: error(float(z)), [0, 0.70710678, 1]))
    worst = max(map(error, np.linspace(0, 1, 20_001)))
    assert found.mean_force_error == pytest.approx(mean, rel=1e-4)
    assert found.worst_force_error == pytest.approx(worst, rel=1e-6)
    # The matrix of a ring of radius 1 is the unit matrix: both errors are the same angle.
    assert found.mean_motion_error == pytest.approx(found.mean_force_error, rel=1e-12, abs=0)
    assert found.worst_motion_error == pytest.approx(found.worst_force_error, rel=1e-12, abs=0)


@pytest.mark.parametrize("name", SUPPORTS)
def test_errors_are_those_of_any_frame_and_unit(name):
    support, found = SUPPORTS[name][0], fit_of(name)
    assert 0 < found.mean_force_error < found.worst_force_error < np.pi / 2
    assert 0 < found.mean_motion_error < found.worst_motion_error < np.pi / 2
    if isinstance(support, Polygon):
        turn = np.array([[0.6, -0.8], [0.8, 0.6]])
        vertices, *holes = (
            100 * np.array(ring) @ turn.T + 7.0 for ring in (support.vertices, *support.holes)
        )
        other = fit_ellipsoid(Polygon(vertices, holes))
        assert other.integration_constant == pytest.approx(
            found.integration_constant, rel=1e-12, abs=0
        )
        assert other.matrix[2, 2] * 1e4 == pytest.approx(found.matrix[2, 2], rel=1e-11)
        for each in ("mean_force_error", "mean_motion_error"):
            assert getattr(other, each) == pytest.approx(getattr(found, each), rel=1e-4)
        for each in ("worst_force_error", "worst_motion_error"):
            assert getattr(other, each) == pytest.approx(getattr(found, each), rel=1e-9)


@pytest.mark.parametrize("width", [0.1, 0.5, 1e-3, 1e-6])
def test_the_spin_torque_of_a_square_frame(width):
    """From the mean distance of a filled square of half side a from its center, C a."""
    constant = (np.sqrt(2) + np.arcsinh(1)) / 3
    inner = 1 - width
    mean = constant * (1 + inner + inner**2) / (1 + inner)
    frame = Polygon(SQUARE.vertices, [inner * np.array(SQUARE.vertices)])
    found = fit_ellipsoid(frame).integration_constant
    assert found == pytest.approx(mean / np.sqrt(2), rel=1e-15 / width, abs=0)
    if width == 0.1:
        assert found == pytest.approx(0.771744, abs=5e-7)


def test_fits_are_values():
    assert fit_ellipsoid(SQUARE) == fit_ellipsoid(SQUARE)
    assert fit_ellipsoid(SQUARE) != fit_ellipsoid(TRIPOD)
    assert fit_ellipsoid(SQUARE) != "ellipsoid"


def test_the_worst_error_of_a_tripod_is_that_of_full_friction_at_a_foot():
    """About a foot the other two feet and the full friction of this one sustain the motion.

    The force is 1, as in a translation, and its angle from the ellipsoid is 30 degrees by symmetry.
    """
    found = fit_ellipsoid(TRIPOD)
    assert np.rad2deg(found.worst_force_error) == pytest.approx(30.0, abs=1e-9)
    assert np.rad2deg(found.worst_motion_error) == pytest.approx(30.0, abs=1e-9)


@pytest.mark.parametrize("name", SUPPORTS)
def test_no_motion_errs_by_more_than_the_worst(name):
    support, found = SUPPORTS[name][0], fit_of(name)
    errors = ellipsoid_errors(
        table_of([support]), found.integration_constant, spread_motions(100_000)
    )
    worst = found.worst_force_error, found.worst_motion_error
    for sampled, error in zip(errors.max(axis=1), worst, strict=True):
        assert sampled <= error + 1e-12
        assert error <= sampled + 0.02


def test_a_point_has_no_ellipsoid():
    with pytest.raises(InvalidValue, match=r"support: Points.*more than one point.*no rotation"):
        fit_ellipsoid(Points([(1.0, 2.0)], [3.0]))


@pytest.mark.parametrize("given", [None, 1.0, RingFriction()], ids=repr)
def test_what_is_no_support_is_refused(given):
    with pytest.raises(InvalidValue, match="a support, such as Disc") as caught:
        fit_ellipsoid(given)
    assert caught.value.allowed == "a support, such as Disc or Polygon"
