"""Friction of any support in the compiled core, against sums over points and differences."""

import numpy as np
import pytest

import planar_pushing as pp
from planar_pushing.mechanics.effects.any_support import Supports, point
from planar_pushing.mechanics.effects.base import gradient, made, wrench_about
from planar_pushing.mechanics.supports.pressure.table import table_of
from planar_pushing.mechanics.supports.ring import ring_response

SQUARE = pp.Polygon([(-1, -1), (1, -1), (1, 1), (-1, 1)])
PLACES = np.array([(1.0, 0.2), (-0.5, 0.9), (-0.4, -0.8), (0.3, -0.1)])
SHARES = np.array([0.4, 0.3, 0.2, 0.1])
POINTS = pp.Points(PLACES, SHARES)
WEIGHT, EXTENT = 1.7, 1.3
#: The last one's centre is so far away that its slopes are known roughly only.
MOTIONS = [
    (0.6, -0.8, 0.5),
    (0.6, -0.8, 0.0),
    (0.0, 0.0, -2.0),
    (1e-9, 0.3, 4.0),
    (3.0, 0.1, 1e-2),
    (3.0, 0.1, 1e-3),
]


def friction(support, extent=EXTENT):
    row = np.array([WEIGHT, 0.0, 0.0, 0.0, 0.0, 0.0, extent])
    (effect,) = made((Supports(table_of([support])),), row)
    return effect


def wrench_of_points(places, shares, x, y, spin):
    """Coulomb friction, one point after the other."""
    speeds = np.array([x, y]) + spin * np.column_stack([-places[:, 1], places[:, 0]])
    forces = WEIGHT * shares[:, None] * speeds / np.hypot(*speeds.T)[:, None]
    torques = places[:, 0] * forces[:, 1] - places[:, 1] * forces[:, 0]
    return [*forces.sum(axis=0), torques.sum()]


def in_radii(support):
    """The places of the points where the support's extent is `EXTENT` radii."""
    return PLACES / support.extent * EXTENT


@pytest.mark.parametrize("motion", MOTIONS, ids=str)
def test_friction_of_points_is_their_sum(motion):
    found = gradient(friction(POINTS), *motion)[:3]
    expected = wrench_of_points(in_radii(POINTS), SHARES, *motion)
    assert found == pytest.approx(expected, rel=1e-13, abs=1e-13)


@pytest.mark.parametrize("motion", MOTIONS, ids=str)
def test_friction_of_a_ring_is_that_of_the_ring(motion):
    found = gradient(friction(pp.Ring(2.0), 1.0), *motion)
    speed, spin = np.hypot(*motion[:2]), abs(motion[2])
    force, torque, _, _, ss = ring_response(speed, spin)
    expected = WEIGHT * np.array([force, np.copysign(torque, motion[2])])
    assert (np.hypot(*found[:2]), found[2]) == pytest.approx(expected, rel=1e-12, abs=1e-15)
    assert found[8] == pytest.approx(WEIGHT * ss, rel=1e-5)


@pytest.mark.parametrize("support", [SQUARE, POINTS, pp.Disc(0.4, center=(0.5, 0.2))], ids=repr)
@pytest.mark.parametrize("motion", MOTIONS[:2] + MOTIONS[3:-1], ids=str)
def test_second_derivatives_are_slopes_of_the_wrench(support, motion):
    effect, step = friction(support), 1e-5
    xx, xy, yy, xs, ys, ss = gradient(effect, *motion)[3:]
    bend = np.array([[xx, xy, xs], [xy, yy, ys], [xs, ys, ss]])
    for axis, unit in enumerate(step * np.eye(3)):
        ends = [gradient(effect, *(np.array(motion) + sign * unit))[:3] for sign in (1, -1)]
        slope = (np.array(ends[0]) - ends[1]) / (2 * step)
        assert slope == pytest.approx(bend[axis], rel=1e-5, abs=1e-7 * np.abs(bend).max())


@pytest.mark.parametrize("support", [SQUARE, POINTS], ids=repr)
def test_the_wrench_does_not_see_the_size_of_the_motion_and_turns_with_its_sign(support):
    effect, motion = friction(support), np.array(MOTIONS[0])
    wrench = gradient(effect, *motion)[:3]
    assert gradient(effect, *(1e-3 * motion))[:3] == pytest.approx(wrench, rel=1e-13, abs=0)
    assert gradient(effect, *-motion)[:3] == pytest.approx(
        [-each for each in wrench], rel=1e-13, abs=0
    )


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_about_a_point_its_own_friction_is_left_out(sign):
    effect, places = friction(POINTS), in_radii(POINTS)
    for i, (x, y) in enumerate(places):
        assert point(effect, i) == pytest.approx((x, y, WEIGHT * SHARES[i]), rel=1e-15, abs=0)
        others, shares = np.delete(places, i, axis=0), np.delete(SHARES, i)
        expected = wrench_of_points(others, shares, sign * y, -sign * x, sign)
        found = wrench_about(effect, i, 2.0 * sign, x, y)
        assert found == pytest.approx(expected, rel=1e-13, abs=1e-14)
