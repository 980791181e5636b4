"""Feet in the place of a support: where they are, what they carry, and their error."""

from __future__ import annotations

import numpy as np
import pytest

import planar_pushing as pp
from planar_pushing.objects.feet import feet_of, force_errors

SQUARE = pp.Polygon([(-1, -1), (1, -1), (1, 1), (-1, 1)])
ANGLE = pp.Polygon([(0, 0), (3, 0), (3, 1), (1, 1), (1, 2), (0, 2)])
AREAS = [
    SQUARE, ANGLE, pp.Disc(2.0, (1.0, -1.0)), pp.Annulus(0.5, 1.0), pp.Ring(1.5),
    pp.Segment((-1.0, 0.0), (1.0, 0.5)), pp.PressureMap(x=[-1, 0, 1], y=[-0.5, 0.5], pressure=[[1, 3]]),
]  # fmt: skip
#: Spinning torques and centers of feet are those of samples of an area.
SAMPLED = 1e-4


def scene(*supports, weight=1.0, radius=None):
    friction = tuple(pp.SupportFriction(support=each, weight=weight) for each in supports)
    slider = pp.Slider(rod_length=2.0, rod_angle=1.0, radius=radius)
    return pp.Scene(slider=slider, contact=pp.Coulomb(0.5), effects=friction)


def spinning_torque(support):
    """Mean distance from the center of pressure: minus the torque of a spin about it."""
    x, y = support.center_of_pressure
    effect = pp.SupportFriction(support=support)
    f_x, f_y, torque = pp.wrench(effect, [y, -x, 1.0])
    return torque - x * f_y + y * f_x


def by_radius(places):
    return np.sort(np.hypot(*places.T))


def test_points_are_their_own_feet():
    feet = feet_of(scene(pp.Points([(1, 0), (-0.5, 0.8), (-0.5, -0.8)], [2, 1, 1]), weight=8.0), 5)
    assert feet.places.tolist() == [[1, 0], [-0.5, 0.8], [-0.5, -0.8]]
    assert feet.weights.tolist() == [4.0, 2.0, 2.0]


@pytest.mark.parametrize("count", [4, 8, 16])
def test_feet_of_a_ring_are_equal_and_evenly_spaced_on_it(count):
    places, weights = feet_of(scene(pp.Ring()), count)
    np.testing.assert_allclose(weights, 1 / count, rtol=1e-12)
    np.testing.assert_allclose(by_radius(places), 1.0, rtol=1e-12)
    turns = np.diff(np.sort(np.arctan2(*places.T)))
    np.testing.assert_allclose(turns, 2 * np.pi / count, rtol=1e-9)


def test_feet_of_a_square_are_a_grid():
    places, weights = feet_of(scene(SQUARE), 16)
    np.testing.assert_allclose(weights, 1 / 16, rtol=1e-12)
    lines = np.unique(places.round(6))
    assert len(lines) == 4
    np.testing.assert_allclose(np.diff(lines), np.diff(lines)[0], atol=2e-6)
    assert sorted(map(tuple, places.round(6))) == [(x, y) for x in lines for y in lines]


def test_a_ring_without_a_radius_has_the_sliders():
    one = pp.Scene(
        slider=pp.Slider(rod_length=2.0, rod_angle=1.0, radius=3.0), contact=pp.Coulomb(0.5),
        effects=(pp.RingFriction(weight=5.0),),
    )  # fmt: skip
    places, weights = feet_of(one, 4)
    np.testing.assert_allclose(by_radius(places), 3.0, rtol=1e-12)
    assert weights.sum() == pytest.approx(5.0, rel=1e-12)


@pytest.mark.parametrize("support", AREAS, ids=lambda each: type(each).__name__)
@pytest.mark.parametrize("count", [3, 7, 16])
def test_feet_have_the_center_and_the_spinning_torque_of_the_support(support, count):
    places, weights = feet_of(scene(support, weight=2.0), count)
    center = np.array(support.center_of_pressure)
    assert len(places) == count
    assert weights.sum() == pytest.approx(2.0, rel=1e-12)
    np.testing.assert_allclose(weights, 2.0 / count, rtol=0.02)
    np.testing.assert_allclose(weights @ places / 2.0, center, atol=SAMPLED)
    torque = weights @ np.hypot(*(places - center).T) / 2.0
    assert torque == pytest.approx(spinning_torque(support), rel=SAMPLED)


def test_no_foot_is_in_a_hole_or_outside():
    inside = by_radius(feet_of(scene(pp.Annulus(0.8, 1.0)), 64).places)
    assert inside.min() > 0.8
    assert inside.max() < 1.0
    places = feet_of(scene(ANGLE), 64).places
    assert not np.any((places > 1.0).all(axis=1))


def test_a_composite_keeps_its_points_and_shares():
    both = pp.Composite([(3, SQUARE), (1, pp.Points([(1.5, 0.0)], [1.0]))])
    places, weights = feet_of(scene(both, weight=4.0), 9)
    (foot,) = np.flatnonzero((places == (1.5, 0.0)).all(axis=1))
    assert weights[foot] == pytest.approx(1.0)
    np.testing.assert_allclose(np.delete(weights, foot), 3 / 9, rtol=0.02)


def test_several_supports_add_up():
    both = scene(pp.Disc(1.0, (2.0, 0.0)), pp.Points([(-2.0, 0.0)], [1.0]), weight=1.0)
    places, weights = feet_of(both, 3)
    assert weights.tolist()[-1] == 1.0
    np.testing.assert_allclose(weights @ places, 0.0, atol=SAMPLED)


def test_points_have_no_error():
    feet = pp.Points([(1, 0), (-0.5, 0.8), (-0.5, -0.8), (0.2, 0.1)], [2, 1, 1, 3])
    one = scene(feet)
    assert max(force_errors(one, feet_of(one, 3))) < 1e-12


@pytest.mark.parametrize("support", AREAS, ids=lambda each: type(each).__name__)
def test_more_feet_have_smaller_errors(support):
    one = scene(support)
    errors = np.array([force_errors(one, feet_of(one, count)) for count in (4, 16, 64)])
    assert np.all(np.diff(errors, axis=0) < 0)
    assert np.all(errors[:, 0] < errors[:, 1])
    # Beside a foot of share p the wrench jumps by 2 p: the angle falls like 1 / count.
    assert errors[2, 1] < 0.15 * errors[0, 1]


def test_errors_of_four_feet_for_a_ring_are_those_of_the_sums():
    """Against sums over 1,000 points of the ring and over the feet, at random motions."""
    turns = 2 * np.pi * np.arange(1_000) / 1_000
    ring = np.column_stack([np.cos(turns), np.sin(turns)])
    four = np.sqrt(0.5) * np.array([(1, 1), (1, -1), (-1, 1), (-1, -1)])

    def loads(points, motions):
        v_x, v_y, spin = motions.T[:, :, None]
        velocity = np.stack([v_x - spin * points[:, 1], v_y + spin * points[:, 0]], axis=-1)
        force = velocity / np.linalg.norm(velocity, axis=-1, keepdims=True)
        torque = points[:, 0] * force[..., 1] - points[:, 1] * force[..., 0]
        return np.column_stack([force.mean(axis=1), torque.mean(axis=1)])

    motions = np.random.default_rng(1).normal(size=(4_000, 3))
    one, other = (loads(points, motions) for points in (ring, four))
    sines = np.linalg.norm(np.cross(one, other), axis=1)
    errors = np.arctan2(sines, (one * other).sum(axis=1))
    mean, worst = force_errors(scene(pp.Ring(1.0)), feet_of(scene(pp.Ring(1.0)), 4))
    assert mean == pytest.approx(errors.mean(), rel=0.03)
    # The maximum is at rotations about points beside a foot, which few random motions are.
    assert errors.max() <= worst < 1.3 * errors.max()


@pytest.mark.parametrize("size", [1e-3, 1e4])
def test_errors_do_not_depend_on_the_unit_of_length(size):
    corners = size * np.array(ANGLE.vertices)
    one, other = scene(ANGLE), scene(pp.Polygon(corners))
    assert force_errors(other, feet_of(other, 8)) == pytest.approx(
        force_errors(one, feet_of(one, 8)), rel=1e-6
    )
