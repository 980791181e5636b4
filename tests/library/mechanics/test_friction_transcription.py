"""The transcription of friction against published numbers, and against its own definition."""

from __future__ import annotations

import mpmath
import numpy as np
import pytest
from mechanics.degenerate import RANDOM, SQUARE, random_support
from mechanics.friction_transcription import of_area, pressure_of

import planar_pushing as pp

#: Center of rotation, G_x, G_y and the torque about the origin, by quadrature.
SQUARES = [
    ((0.3, 0.2), -0.260676603222042, -0.172647824905904, 0.709291095663460),
    ((1.0, 1.0), -0.647793574696319, -0.647793574696319, 0.234804283535787),
    ((5.0, 0.0), -0.993189332404797, 0.0, 0.0676285032397970),
    ((1e6, 0.0), -1.0, 0.0, 3.333333333334556e-7),
]
#: Distance of the center of rotation, |G| and the torque of the unit disc.
DISCS = [
    (0.5, 0.483843755630126, 0.547748354772201),
    (1.0, 8 / (3 * np.pi), 8 / (9 * np.pi)),
    (100.0, 0.999987499843745, 0.00250002083391930),
]


def of_rotation(support, center):
    """Force and torque of a unit rotation about a center."""
    twist = np.array([[center[1], -center[0], 1.0]])
    parts = [of_area(twist, area) for area in pressure_of(support).areas]
    force, torque = (sum(each) for each in zip(*parts, strict=True))
    return force[0], torque[0]


@pytest.mark.parametrize(("center", "g_x", "g_y", "turns"), SQUARES)
def test_square(center, g_x, g_y, turns):
    force, torque = of_rotation(pp.Polygon(SQUARE), center)
    assert force == pytest.approx([-g_y, g_x], abs=1e-12)
    assert torque == pytest.approx(turns, rel=1e-12 if center[0] < 100 else 1e-9)


@pytest.mark.parametrize(("distance", "pull", "turns"), DISCS)
def test_disc(distance, pull, turns):
    force, torque = of_rotation(pp.Disc(1.0), (distance, 0.0))
    assert force == pytest.approx([0.0, -pull], abs=1e-13)
    assert torque == pytest.approx(turns, rel=1e-12)


def test_ring_is_the_integral_of_the_paper():
    for distance in (0.2, 0.7, 1.5, 2.9, 3.1, 20.0):
        force, torque = of_rotation(pp.Ring(1.0), (distance, 0.0))
        for index, found in ((0, -force[1]), (1, torque)):
            exact = mpmath.quad(
                lambda t, i=index, d=distance: around(t, d)[i], np.pi * np.arange(3)
            )
            assert found == pytest.approx(float(exact) / (2 * np.pi), abs=1e-13)


def around(t, distance):
    """Backward motion and torque of a point of the ring, by a unit rotation about (distance, 0)."""
    x, y = mpmath.cos(t) - distance, mpmath.sin(t)
    return -x / mpmath.hypot(x, y), (x * mpmath.cos(t) + y * mpmath.sin(t)) / mpmath.hypot(x, y)


@pytest.mark.parametrize("kind", sorted(set(RANDOM) - {"points"}))
def test_closed_forms_join_the_gauss_rule_far_away(kind):
    """Across the distance at which one takes over from the other, nothing changes."""
    support = random_support(np.random.default_rng(1), kind)
    for area in pressure_of(support).areas:
        away = np.array([[np.cos(a), np.sin(a)] for a in np.linspace(0, 6, 7)])
        (near, one), (far, two) = (
            of_area(rotations(area.center + part * 3.0 * area.extent * away), area)
            for part in (1 - 1e-13, 1 + 1e-13)
        )
        assert far == pytest.approx(near, abs=1e-12)
        assert two == pytest.approx(one, abs=1e-12)


def rotations(centers):
    return np.column_stack([centers[:, 1], -centers[:, 0], np.ones(len(centers))])
