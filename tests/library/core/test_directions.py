"""Directions at the contact and the plane's conventions, against exact angles."""

from __future__ import annotations

import math

import numpy as np
import pytest
from mpmath import mp, mpf

from planar_pushing.core.instant import directions, magnitude
from planar_pushing.mechanics.plane import direction

PSI = math.pi / 4
ROD = directions.rod_at(2.0, PSI)
UPRIGHT = directions.rod_at(2.0, math.pi / 2)


@pytest.mark.parametrize("quarters", range(-4, 5))
def test_direction_is_exact_at_quarter_turns(quarters):
    vector = direction(quarters * (np.pi / 2))
    expected = [(1, 0), (0, 1), (-1, 0), (0, -1)][quarters % 4]
    assert np.array_equal(vector, expected)


def test_direction_elsewhere():
    angle = np.array([[0.3, 1.0], [2.0, np.nextafter(np.pi, 0)]])
    vectors = direction(angle)
    assert vectors.shape == (2, 2, 2)
    # The library of C and that of numpy can differ in the last digit.
    assert vectors[..., 0] == pytest.approx(np.cos(angle), rel=3e-16, abs=0)
    assert vectors[..., 1] == pytest.approx(np.sin(angle), rel=3e-16, abs=0)
    assert vectors[1, 1, 1] > 0


@pytest.mark.parametrize(
    ("x", "nearest"),
    [(0.0, 0.0), (-0.0, -0.0), (0.49, 0.0), (-0.49, -0.0), (0.5, 1.0), (-1.5, -2.0), (7e15, 7e15)],
)
def test_the_nearest_integer_keeps_the_sign(x, nearest):
    found = directions.nearest_integer(x)
    assert (found, math.copysign(1.0, found)) == (nearest, math.copysign(1.0, nearest))


def test_a_force_right_of_the_center_has_a_positive_moment_arm():
    """It turns the slider counterclockwise: the rod's part across the force, times its length."""
    for angle, arm in ((0.0, math.sqrt(2)), (math.pi / 2, -math.sqrt(2)), (PSI, 0.0)):
        assert ROD.length * directions.direction_at(ROD, angle).across == pytest.approx(arm)


@pytest.mark.parametrize("angle", [0.0, np.pi, 5e-324, np.nextafter(np.pi, 0)])
def test_parts_along_an_upright_rod_are_exact(angle):
    found = directions.direction_at(UPRIGHT, angle)
    assert (found.along, found.across) == (found.y, found.x)
    assert (found.x, found.y) == tuple(direction(angle))


@pytest.mark.parametrize("quarters", range(-2, 3))
def test_parts_of_a_direction_along_an_axis_are_those_of_the_rod(quarters):
    x, y = direction(quarters * (np.pi / 2))
    found = directions.direction_at(ROD, quarters * (math.pi / 2))
    assert found.along == x * ROD.x + y * ROD.y
    assert found.across == x * ROD.y - y * ROD.x


@pytest.mark.parametrize("psi", [PSI, 1e-3, 2.5])
@pytest.mark.parametrize(
    "turn",
    [-7.3, -np.pi, -np.pi / 2 - 1e-12, -np.pi / 2, -0.3, -1e-9, -1e-13, 0.0, 1e-3, 1.0, np.pi / 2, np.pi],
)  # fmt: skip
def test_parts_along_a_rod_are_those_of_the_exact_angles(psi, turn):
    """Across and along the rod a part is as small as the rounding of the angles' difference."""
    angle = psi + turn
    found = directions.direction_at(directions.rod_at(1.0, psi), angle)
    with mp.workdps(40):
        lean = mpf(psi) - mpf(angle)
        assert abs(found.along - mp.cos(lean)) <= 1e-15 * abs(mp.cos(lean))
        assert abs(found.across - mp.sin(lean)) <= 1e-15 * abs(mp.sin(lean))


@pytest.mark.parametrize(("x", "y"), [(3.0, 4.0), (0.0, -2.0), (0.0, 0.0), (-1.0, 1e-200)])
@pytest.mark.parametrize("size", [1e-320, 1e-300, 1e-160, 1e-145, 1.0, 1e150])
def test_the_length_of_a_vector_does_not_underflow(x, y, size):
    found = directions.length_of(size * x, size * y)
    assert found == pytest.approx(math.hypot(size * x, size * y), rel=4e-16, abs=0)


def test_infinite_spin_ratio_moves_the_contact_across_the_rod():
    for angle, ratio, across in ((0.1, math.inf, -1), (2.0, -math.inf, 1)):
        force = directions.direction_at(ROD, angle)
        found = magnitude.ring_motion_angle(ROD, force, ratio)
        assert found == pytest.approx(PSI + across * np.pi / 2)


@pytest.mark.parametrize("ratio", [-3.0, 0.0, 0.4, 1e9])
def test_contact_moves_along_the_force_and_across_the_rod(ratio):
    """Along ``f + k l (sin psi, -cos psi)``."""
    force = directions.direction_at(ROD, PSI - np.sign(ratio) * 0.6)
    x, y = force.x + 2 * ratio * np.sin(PSI), force.y - 2 * ratio * np.cos(PSI)
    found = magnitude.ring_motion_angle(ROD, force, ratio)
    assert found == pytest.approx(np.arctan2(y, x), rel=1e-14, abs=0)


@pytest.mark.parametrize(
    ("v_x", "v_y", "center"),
    [
        (0.3, 0.4, (-math.inf, math.inf)), (0.3, -0.4, (math.inf, math.inf)),
        (1.0, 0.0, (0.0, math.inf)), (-1.0, 0.0, (0.0, -math.inf)), (-1.0, 1e-16, (0.0, -math.inf)),
        (0.0, 1.0, (-math.inf, 0.0)), (1e-16, -1.0, (math.inf, 0.0)),
    ],
)  # fmt: skip
def test_the_center_of_a_translation_is_at_infinity_across_it(v_x, v_y, center):
    """A rotation within the rounding of the translation has no say."""
    for spin in (0.0, 1e-16, -1e-16):
        found = directions.motion_center(v_x, v_y, spin)
        assert tuple(found) == center


def test_the_center_of_a_spin_is_its_point():
    assert tuple(directions.motion_center(0.0, 0.0, 1.5)) == (0.0, 0.0)


@pytest.mark.parametrize("spin", [1.7, -0.3, 3e-15])
def test_motion_center_is_where_nothing_moves(spin):
    v_x, v_y = 0.4, -0.9
    x, y = directions.motion_center(v_x, v_y, spin)
    assert [v_x - spin * y, v_y + spin * x] == pytest.approx([0, 0], abs=1e-15)


@pytest.mark.parametrize(
    ("twist", "ratio"),
    [
        ((0.0, 0.0, 0.0), 0.0), ((3.0, 4.0, 0.0), 0.0), ((3.0, 4.0, -10.0), -2.0),
        ((0.0, 0.0, 1e-300), math.inf), ((0.0, 0.0, -2.0), -math.inf), ((3e-200, 4e-200, 5e-200), 1.0),
    ],
)  # fmt: skip
def test_spin_ratio(twist, ratio):
    assert directions.spin_ratio(*twist) == pytest.approx(ratio, rel=1e-15, abs=0)
