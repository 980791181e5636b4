"""Limit curves against the transcription of the paper."""

from __future__ import annotations

import numpy as np
import pytest
from mechanics.builders import PSI, make_scene
from mpmath import mp, mpf

import planar_pushing as pp
import reference
from planar_pushing.mechanics.force.limit_curve import curve_of_unit_motions

RADIANS = 1e-12


@pytest.mark.parametrize("phi", [0.2, 0.9, 2.6])
@pytest.mark.parametrize("length", [0.3, 2.0, 20.0])
def test_limit_curve_with_both_effects(length, phi):
    """W f + m v with v = 1 / sqrt(1 + rho^2 k^2), on the line of force h."""
    weight, mass, rho = 2.0, 3.0, 0.7
    effects = [pp.RingFriction(weight=weight), pp.Inertia(mass=mass, gyration_radius=rho)]
    curve = curve_of_unit_motions(make_scene(length, effects=effects), phi)
    k = mpf(float(curve.spin_ratio))
    speed = 1 / mp.sqrt(1 + mpf(rho) ** 2 * k**2)
    force = weight * reference.ring_force(k) + mass * speed
    torque = weight * reference.ring_torque(k) + mass * speed * mpf(rho) ** 2 * k
    assert float(curve.magnitude) == pytest.approx(float(force), rel=1e-14, abs=0)
    assert float(torque / force) == pytest.approx(length * np.sin(PSI - phi), rel=1e-13, abs=0)
    exact = reference.motion_angle(length, phi, PSI, k)
    assert float(curve.motion_angle) == pytest.approx(float(exact), abs=RADIANS)


@pytest.mark.parametrize("phi", [0.2, PSI, 2.6])
@pytest.mark.parametrize("length", [1e-3, 1.0, 1e3])
def test_limit_curve_of_friction(length, phi):
    curve = pp.limit_curve(make_scene(length, effects=[pp.RingFriction(weight=2.0)]), phi)
    k = reference.friction_spin_ratio(reference.moment_arm(length, phi, PSI))
    assert float(curve.magnitude) == pytest.approx(
        float(2 * reference.ring_force(k)), rel=1e-13, abs=0
    )


@pytest.mark.parametrize("more", [pp.Inertia(), pp.Viscous(support=pp.Disc(1.0))], ids=repr)
@pytest.mark.parametrize("length", [0.0, 2.0, np.array([1.0, 2.0])], ids=repr)
def test_forces_of_every_magnitude_have_no_one_curve(length, more):
    scene = make_scene(length, effects=[pp.RingFriction(), more])
    name = f"'RingFriction and {type(more).__name__}'"
    said = (
        f"limit_curve: {name} given; allowed: a scene whose forces do not depend on the magnitude"
    )
    with pytest.raises(pp.InvalidValue, match=rf"^{said}.*; leave out one effect,.*force_ratio="):
        pp.limit_curve(scene, 1.0)
    for effect in scene.effects:
        pp.limit_curve(make_scene(length, effects=[effect]), 1.0)
