"""How fast: ratios of times on one array of a million spin ratios. Run by `make bench`.

The floor of the wrench and of its inverse is what the wrench cannot do without, `ellipe` and `ellipkm1` on
the same array.
"""

import time

import numpy as np
import pytest
from scipy.special import ellipe, ellipkm1

import planar_pushing as pp
from planar_pushing.evidence.costs.methods.cones import inverses, motion_angles

pytestmark = pytest.mark.benchmark(timer=time.process_time)
COUNT = 10**6
RANDOM = np.random.default_rng(0)
RING = pp.RingFriction()
ARRAYS = {
    "even in direction": np.tan(RANDOM.uniform(0, np.pi / 2, COUNT)),
    "uniform in [0, 2]": RANDOM.uniform(0, 2, COUNT),
    "logarithmic over six decades": 10 ** RANDOM.uniform(-3, 3, COUNT),
    "next to the ring": RANDOM.uniform(0.9, 1.1, COUNT),
}


@pytest.fixture(params=ARRAYS, ids=lambda name: name)
def spin_ratios(request):
    return ARRAYS[request.param]


def two_integrals(k):
    inner = np.minimum(k, 1 / k) ** 2
    return lambda: (ellipe(inner), ellipkm1(inner))


def test_wrench(ratio, spin_ratios):
    assert ratio(lambda: RING.profile(spin_ratios), two_integrals(spin_ratios), 2.0) <= 2.0


def test_inverse_of_the_moment_arm(ratio, spin_ratios):
    force, torque = RING.profile(spin_ratios)
    arm = torque / force
    floor = two_integrals(spin_ratios)
    assert ratio(lambda: RING.spin_ratio(arm), floor, 12.0, rounds=15) <= 12.0


def test_both_edges_of_a_motion_cone(ratio):
    """Half a million Coulomb cones of one slider, each against brentq on quad at quad's tolerance."""
    slider = pp.Slider(rod_length=2.0, rod_angle=np.pi / 4)
    scene = pp.Scene(slider=slider, contact=pp.InfiniteFriction(), effects=(RING,))
    half = np.arctan(10 ** RANDOM.uniform(-2, 2, COUNT // 2))
    edges = np.concatenate([np.pi / 2 - half, np.pi / 2 + half])
    few = np.concatenate([edges[:10], edges[COUNT // 2 : COUNT // 2 + 10]])
    brentq = next(each for each in inverses() if each.name == "brentq on quad")

    def floor():
        motion_angles(brentq, 1e-8, np.full(few.shape, 2.0), few)

    limit, scale = 1e-3, few.size / edges.size
    found = ratio(lambda: pp.motion_angle(scene, edges), floor, limit, scale=scale, rounds=10)
    assert found <= limit
