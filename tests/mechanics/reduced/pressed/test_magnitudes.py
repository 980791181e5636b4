"""Motion cones with friction and inertia under any support: over all magnitudes of the motion."""

import numba
import numpy as np
import pytest

import planar_pushing as pp

#: Without the compiler every fifth scene is looked at, at every fifth share.
EVERY = 5 if numba.config.DISABLE_JIT else 1
#: Shares of inertia, denser at both ends.
SLOW = np.logspace(-9, -1e-12, 300 // EVERY)
SHARES = np.concatenate([[0.0], SLOW, 1.0 - SLOW[SLOW >= 1e-9], [1.0]])


def tripod(rng):
    return pp.Points(rng.normal(size=(3, 2)), rng.uniform(0.2, 1.0, 3))


def box(rng):
    a, b = rng.uniform(0.1, 1.0, 2)
    return pp.Polygon([(-a, -b), (a, -b), (a, b), (-a, b)])


@pytest.mark.parametrize("support", [tripod, box])
def test_a_cone_holds_the_motions_of_all_magnitudes_and_no_more(support):
    rng, bent = np.random.default_rng(4), 0
    for number in range(25):
        slider = pp.Slider(
            rod_length=rng.uniform(0.1, 5.0), rod_angle=rng.uniform(0.1, 3.0), radius=1.0
        )
        center = tuple(0.3 * rng.normal(size=2))
        mass = pp.Inertia(gyration_radius=rng.uniform(0.2, 1.5), center=center)
        scene = pp.Scene(
            slider=slider, contact=pp.Coulomb(rng.uniform(0.05, 2.0)),
            effects=(pp.SupportFriction(support=support(rng)), mass),
        )  # fmt: skip
        if number % EVERY:
            continue
        force, cone = pp.friction_cone(scene), pp.motion_cone(scene)
        right = pp.motion_angle(scene, force.right, SHARES)
        left = pp.motion_angle(scene, force.left, SHARES)
        # The shares that are looked at miss the furthest one, where the angle is flat or has a kink.
        assert -5e-3 < cone.right - right.min() < 1e-12
        assert -5e-3 < left.max() - cone.left < 1e-12
        bent += right.min() < min(right[0], right[-1]) - 1e-4
        bent += left.max() > max(left[0], left[-1]) + 1e-4
    assert bent  # between slow and fast the contact moves further aside than at either
