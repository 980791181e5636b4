"""Motion centers, and the paper's bound on the motion."""

from __future__ import annotations

import numpy as np
import pytest
from mechanics.builders import BOTH, EVERY_EFFECT, PSI, make_scene

import planar_pushing as pp
from planar_pushing.mechanics.force.centers import Origin, conservative_spin_ratios
from planar_pushing.mechanics.plane import direction


def test_conservative_spin_ratios_follow_the_seven_cases():
    arms = [-2.0, -1.0, -0.5, 0.0, 0.5, 1.0, 2.0]
    near, far = zip(*map(conservative_spin_ratios, arms), strict=True)
    assert near == pytest.approx([-1, -1, 0, 0, 0, 1, 1])
    assert far == pytest.approx([-np.inf, -1, -1, 0, 1, 1, np.inf])


@pytest.mark.parametrize("mu", [0.5, 2.0, np.inf])
@pytest.mark.parametrize("length", [0.0, 0.5, 1.0, 1.3, 5.0, 100.0])
@pytest.mark.parametrize("psi", [0.3, PSI, 1.5, 2.5])
def test_conservative_cone_contains_the_exact_one(mu, length, psi):
    scene = make_scene(length, mu, BOTH, psi)
    bound, exact = pp.conservative_motion_cone(scene), pp.motion_cone(scene)
    assert bound.right <= exact.right + 1e-14
    assert exact.left <= bound.left + 1e-14


@EVERY_EFFECT
def test_centers_are_where_nothing_moves(effects):
    """At the signed distance -R/k along x' from the ring center, in the unit of the lengths."""
    scene = make_scene(3.0, effects=effects, radius=0.5)
    share = 0.3 if effects == BOTH else None
    for phi in (0.2, 1.4, 2.5):
        k = pp.spin_ratio(scene, phi, share)
        from_ring = -0.5 / k * direction(phi - np.pi / 2)
        found = pp.motion_centers(scene, phi, share, origin=Origin.SLIDER_CENTER)
        assert found == pytest.approx(from_ring, rel=1e-13, abs=0)
        found = pp.motion_centers(scene, phi, share)
        assert found == pytest.approx(from_ring + 3.0 * direction(PSI), rel=1e-13, abs=0)


def test_a_translation_has_its_center_at_infinity():
    assert np.all(np.isinf(pp.motion_centers(make_scene(2.0), PSI)))
    assert np.all(np.isinf(pp.motion_centers(make_scene(2.0), PSI, origin=Origin.SLIDER_CENTER)))


def test_the_bound_of_the_paper_holds_every_motion_of_its_cases():
    """Its edges are those of brute force over the force angles and the spin ratios of each case."""
    for length, mu, psi in ((5.0, np.inf, PSI), (0.5, 2.0, 1.0), (1.3, 0.4, 2.2), (1.0, 3.0, 0.4)):
        scene = make_scene(length, mu, BOTH, psi)
        force, bound = pp.friction_cone(scene), pp.conservative_motion_cone(scene)
        angles = []
        for phi in np.linspace(force.right, force.left, 2001):
            near, far = conservative_spin_ratios(length * np.sin(psi - phi))
            for k in (
                np.linspace(near, far, 9) if np.isfinite(far) else (near, 3 * near, 1e9 * near)
            ):
                x = np.cos(phi) + k * length * np.sin(psi)
                y = np.sin(phi) - k * length * np.cos(psi)
                lean = np.arctan2(y, x) - phi
                angles.append(phi + np.remainder(lean + np.pi, 2 * np.pi) - np.pi)
        assert min(angles) == pytest.approx(bound.right, abs=5e-3)
        assert max(angles) == pytest.approx(bound.left, abs=5e-3)
        assert bound.right - 1e-9 <= min(angles)
        assert max(angles) <= bound.left + 1e-9
        assert not bound.closed
