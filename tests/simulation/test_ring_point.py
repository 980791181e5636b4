"""The ring for one motion at a time against its elementwise closed form, and against 40 digits."""

from __future__ import annotations

import mpmath
import numpy as np
import pytest
from planar_pushing.mechanics.effects.ring_point import inner_point, ring_point

import planar_pushing as pp

RATIOS = [1e-12, 1e-5, 0.1, 0.2499, 0.25, 0.5, 0.9, 1 - 1e-9, 1 - 1e-15]


@pytest.mark.parametrize("k", RATIOS)
def test_profile_and_slope_to_a_few_places(k):
    with mpmath.workdps(60):
        m = mpmath.mpf(k) ** 2
        e, full = mpmath.ellipe(m), mpmath.ellipk(m)
        exact = 2 * e / mpmath.pi, 2 * (e - (1 - m) * full) / k / mpmath.pi
        slope = 2 * (full - e) / m / mpmath.pi
    force, torque, bend = inner_point(k)
    assert force == pytest.approx(float(exact[0]), rel=2e-15)
    assert torque == pytest.approx(float(exact[1]), rel=2e-14)
    assert bend == pytest.approx(float(slope), rel=1e-13)


@pytest.mark.parametrize("spin", [-1e8, -2.0, -1.0, -0.3, 0.0, 0.3, 1.0, 2.0, 1e8])
def test_wrench_is_that_of_the_effect(spin):
    force, torque, _ = ring_point(1.0, spin)
    expected = pp.RingFriction().wrench(np.array([1.0, 0.0, spin]))
    assert [force, torque] == pytest.approx([expected[0], expected[2]], rel=1e-14, abs=1e-16)


@pytest.mark.parametrize("spin", [-3.0, -0.4, 0.4, 3.0])
def test_curvature_is_the_second_derivative(spin):
    step = 1e-5
    (_, before, _), (_, after, _) = ring_point(1.5, spin - step), ring_point(1.5, spin + step)
    assert ring_point(1.5, spin)[2] * 1.5**2 == pytest.approx((after - before) / 2 / step, rel=1e-8)
