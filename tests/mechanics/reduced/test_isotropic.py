"""Both effects join friction alone as s -> 0 and inertia alone as s -> inf, at the rates of the theory.

To first order ``k(s) - k(0) = s (h - g k) / (t' - h f')`` and ``k(s) - k(inf) = (h f - t) / (g s)`` at the
inertia value; the first slope is finite but for k = 1, where t' is infinite and both effects agree.
"""

import numpy as np
import pytest

import planar_pushing as pp
from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.mechanics.wrench import ring_profile

FRICTION, INERTIA = pp.RingFriction(), pp.Inertia()
DECADES = 10.0 ** np.arange(-9, -2.5, 0.5)
#: Force angles with moment arms of either sign, below and above the radius, next to the tangent.
FORCE_ANGLES = np.deg2rad([2.0, 14.9, 15.1, 30.0, 60.0, 75.05, 120.0, 170.0])


def scene(*effects, contact=None, length=2.0):
    slider = pp.Slider(rod_length=length, rod_angle=np.deg2rad(45))
    return pp.Scene(slider=slider, contact=contact or pp.Coulomb(2.0), effects=effects)


def rate(parameter, difference):
    """Least-squares slope of log |difference| over log parameter."""
    return np.polyfit(np.log(parameter), np.log(np.abs(difference)), 1)[0]


@pytest.mark.parametrize("quantity", [pp.spin_ratio, pp.motion_angle])
@pytest.mark.parametrize("phi", FORCE_ANGLES)
@pytest.mark.parametrize("fast", [False, True])
def test_motion_joins_the_pure_ones_at_first_order(quantity, phi, fast):
    pure = scene(INERTIA if fast else FRICTION)
    share = 1 - DECADES if fast else DECADES
    found = quantity(scene(FRICTION, INERTIA), phi, share) - quantity(pure, phi)
    resolved = np.abs(found) > 1e-12  # the rest is rounding of an angle
    assert resolved.sum() >= 6
    assert rate(DECADES[resolved], found[resolved]) == pytest.approx(1.0, abs=0.02)


@pytest.mark.parametrize("phi", np.deg2rad([2.0, 30.0, 120.0]))
def test_slope_at_small_s_is_that_of_the_theory(phi):
    k, h = pp.spin_ratio(scene(FRICTION), phi), 2.0 * np.sin(np.pi / 4 - phi)
    step = 1e-6
    (f, t), (f_up, t_up) = ring_profile(k), ring_profile(k + step)
    slope = (h - k) / ((t_up - t) / step - h * (f_up - f) / step)
    share = 1e-7
    found = (pp.spin_ratio(scene(FRICTION, INERTIA), phi, share) - k) / (share / (1 - share))
    assert found == pytest.approx(slope, rel=1e-5)


def test_next_to_the_ring_the_slope_falls_like_one_over_the_logarithm():
    """``(h - k) / (k(s) - k) s = (1 + h k) t'``, and t' grows like ``log(1 / |1 - k|) / pi``."""
    stiffness, distance, share = [], [], 1e-3
    for gap in 10.0 ** -np.arange(3, 9):
        phi = np.pi / 4 - np.arcsin(0.5 * (1 - gap))  # misses the tangent by the gap
        k = pp.spin_ratio(scene(FRICTION), phi)
        moved = pp.spin_ratio(scene(FRICTION, INERTIA), phi, share) - k
        stiffness.append((1 - gap - k) * share / moved)
        distance.append(np.log(1 / (1 - k)))
    growth = np.diff(stiffness) / np.diff(distance)
    assert growth == pytest.approx(2 / np.pi, rel=0.02)


def test_on_the_ring_both_effects_agree_at_every_share():
    share = np.array([0.0, 1e-9, 0.5, 1 - 1e-9, 1.0])
    tangent = scene(FRICTION, INERTIA, length=1.0)  # across the rod: h = R, so k = 1
    assert pp.spin_ratio(tangent, np.deg2rad(-45.0), share) == pytest.approx(1.0, rel=4e-16, abs=0)


@pytest.mark.parametrize("law", [pp.Coulomb(2.0), pp.Coulomb(0.3), pp.InfiniteFriction()])
@pytest.mark.parametrize("fast", [False, True])
def test_contact_modes_join_the_pure_ones(law, fast):
    """Away from the edges of the pure cone the modes are the same, and the motions join like s."""
    pure, both = (
        scene(INERTIA if fast else FRICTION, contact=law),
        scene(FRICTION, INERTIA, contact=law),
    )
    cone = pp.motion_cone(pure)
    for angle in np.deg2rad(np.arange(-170.0, 181.0, 10.0)):
        if min(abs(angle - edge) for edge in (cone.right, cone.left, 0.0, np.pi)) < 0.02:
            continue
        expected = pp.solve(pure, angle)
        for size in (1e6, 1e8) if fast else (1e-6, 1e-8):
            found = pp.solve(both, angle, size)
            assert found.modes == expected.modes
            for one, other in zip(found, expected, strict=True):
                gap = np.abs(one.contact_motion / size - other.contact_motion).max()
                assert gap <= 20 * (1 / size if fast else size)


@pytest.mark.parametrize("fast", [False, True])
def test_the_rate_of_the_sticking_force(fast):
    """The force of a sticking push joins that of one effect like s or 1 / s."""
    angle, sizes = np.deg2rad(100.0), 10.0 ** np.arange(-7, -2)
    pure, both = scene(INERTIA if fast else FRICTION), scene(FRICTION, INERTIA)
    reference = {s.mode: s.force for s in pp.solve(pure, angle)}[ContactMode.STICK]
    gaps = []
    for size in 1 / sizes if fast else sizes:
        force = {s.mode: s.force for s in pp.solve(both, angle, size)}[ContactMode.STICK]
        gaps.append(np.linalg.norm(force / (size if fast else 1.0) - reference))
    assert rate(sizes, gaps) == pytest.approx(1.0, abs=0.02)
