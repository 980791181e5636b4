"""Inertia with a centre of mass of its own, against Newton's law about that centre."""

import numpy as np
import pytest

from planar_pushing.mechanics.effects.any_mass import MassAt
from planar_pushing.mechanics.effects.base import gradient, made, scaled, wrench_about

MASS = MassAt(2.0, 0.49, 0.4, -0.3)
MOTIONS = np.random.default_rng(5).normal(size=(4, 3))


def energy(x, y, spin):
    """Kinetic energy: of the centre of mass, and of the rotation about it."""
    mass, gyration, c_x, c_y = MASS
    v_x, v_y = x - spin * c_y, y + spin * c_x
    return mass * (v_x * v_x + v_y * v_y + gyration * spin * spin) / 2


@pytest.mark.parametrize("motion", MOTIONS, ids=str)
def test_the_wrench_is_the_slope_of_the_kinetic_energy(motion):
    found = gradient(MASS, *motion)
    for axis, unit in enumerate(np.eye(3)):  # of a quadratic potential differences are slopes
        slope = (energy(*(motion + unit)) - energy(*(motion - unit))) / 2
        assert found[axis] == pytest.approx(slope, rel=1e-13, abs=1e-13)
    assert np.dot(found[:3], motion) == pytest.approx(2 * energy(*motion), rel=1e-13, abs=0)


@pytest.mark.parametrize("motion", MOTIONS, ids=str)
def test_the_second_derivatives_are_the_mass_matrix(motion):
    f_x, f_y, torque, xx, xy, yy, xs, ys, ss = gradient(MASS, *motion)
    matrix = np.array([[xx, xy, xs], [xy, yy, ys], [xs, ys, ss]])
    assert matrix @ motion == pytest.approx([f_x, f_y, torque], rel=1e-13, abs=0)
    assert np.linalg.eigvalsh(matrix).min() > 0


def test_a_rotation_about_the_centre_of_mass_takes_no_force():
    _, gyration, c_x, c_y = MASS
    assert wrench_about(MASS, 0, 3.0, c_x, c_y) == pytest.approx(
        (0.0, 0.0, 2.0 * gyration * 3.0), abs=1e-15
    )


def test_a_row_of_scenes_holds_the_mass():
    row = np.array([9.0, *MASS, 7.0, 8.0])
    assert made((MassAt(1.0, 1.0, 0.0, 0.0),), row) == (MASS,)
    assert scaled(MASS, 3.0) == (6.0, *MASS[1:])
