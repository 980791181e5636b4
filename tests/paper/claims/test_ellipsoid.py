"""Motion of the contact by the ring and by its ellipsoid: the difference, by the library."""

import numpy as np
import pytest

import planar_pushing as pp

#: The ellipsoid moves as inertia with a radius of gyration of one radius does.
RING, ELLIPSOID = pp.RingFriction(), pp.Inertia(mass=1, gyration_radius=1)
BOUND = np.arcsin(1 / 3)
LENGTHS = np.geomspace(1e-2, 1e3, 61)[:, None]


def turns(lengths, from_rod):
    """Angles by which ring and ellipsoid turn the motion away from a force at an angle from the rod."""
    rods = pp.Slider(rod_length=lengths, rod_angle=np.pi / 2)
    scenes = [
        pp.Scene(slider=rods, contact=pp.InfiniteFriction(), effects=(effect,))
        for effect in (RING, ELLIPSOID)
    ]
    force = np.pi / 2 - from_rod
    return [force - pp.motion_angle(scene, force) for scene in scenes]


def test_they_differ_by_less_than_the_bound_and_nearly_by_as_much():
    from_rod = np.geomspace(1e-6, np.pi / 2, 4001)
    ring, ellipsoid = turns(LENGTHS, from_rod)
    difference = np.abs(ring - ellipsoid)
    assert difference.max() < BOUND
    assert difference.max() > BOUND - 1e-5


@pytest.mark.parametrize(("arm", "sign"), [(0.1, 1), (0.999, 1), (1.001, -1), (2.5, -1)])
def test_the_ring_turns_further_inside_and_less_far_outside(arm, sign):
    lengths = LENGTHS[(arm * 1.01 < LENGTHS[:, 0]), :]
    ring, ellipsoid = turns(lengths, np.arcsin(arm / lengths))
    assert (sign * (ring - ellipsoid) > 0).all()


def test_they_agree_through_the_center_on_a_tangent_and_across_the_rod():
    lengths = LENGTHS[LENGTHS[:, 0] > 1, :]
    for from_rod in (
        np.zeros_like(lengths),
        np.arcsin(1 / lengths),
        np.full_like(lengths, np.pi / 2),
    ):
        ring, ellipsoid = turns(lengths, from_rod)
        assert np.abs(ring - ellipsoid).max() < 1e-12
