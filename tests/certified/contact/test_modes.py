"""Contact modes: published cases, ties, every law, and completeness against a dense scan of signs."""

import math
from itertools import pairwise

import pytest
from flint import arb, ctx

from planar_pushing.certified import ring
from planar_pushing.certified.balls import PRECISION
from planar_pushing.certified.contact import modes, slips
from planar_pushing.certified.contact.modes import Mode, contact_modes, coulomb
from planar_pushing.certified.line_of_force import contact_motion
from planar_pushing.certified.setting import Effects, Slider, direction, edge, heading

SEPARATE, STICK, RIGHT, LEFT = Mode


@pytest.fixture(autouse=True)
def _precision():
    with ctx.workprec(PRECISION):
        yield


def counts(found):
    return [len(found[mode]) for mode in Mode]


def solve(length, effects, law, magnitude, angle, rod_angle=45, **parameters):
    slider = Slider.of(length, rod_angle, **parameters)
    return contact_modes(slider, Effects(effects), law, magnitude, angle)


@pytest.mark.parametrize("effects", list(Effects))
def test_pulling_has_three_solutions(effects):
    found = solve(2, effects, coulomb(2.0), 1, -10)
    assert counts(found) == [1, 1, 0, 1]
    assert modes.outcome(found) == 2
    assert found[LEFT][0].force_angle.overlaps(edge(2.0, 1).degrees)


@pytest.mark.parametrize("effects", list(Effects))
def test_infinite_friction_slips_by_its_first_definition_only(effects):
    assert counts(solve(2, effects, modes.INFINITE_FREE, 1, 165)) == [0, 0, 1, 0]
    nothing = solve(2, effects, modes.INFINITE_NONE, 1, 165)
    assert (counts(nothing), modes.outcome(nothing)) == ([0, 0, 0, 0], 0)
    rough = solve(2, effects, modes.PERFECTLY_ROUGH, 1, 165)
    assert counts(rough) == [0, 1, 0, 0]
    assert -180 < rough[STICK][0].force_angle < 0


@pytest.mark.parametrize("effects", list(Effects))
@pytest.mark.parametrize("length", [0, 0.25, 1, 5, 10])
@pytest.mark.parametrize("law", [modes.INFINITE_FREE, modes.INFINITE_NONE])
def test_a_normal_push_never_slips(effects, length, law):
    assert counts(solve(length, effects, law, 1, 90)) == [0, 1, 0, 0]


def test_slow_pulling_without_fast_pulling():
    slow, fast = (solve(2, Effects.BOTH, coulomb(1.4), size, -2) for size in (0.1, 10))
    assert counts(slow) == [1, 1, 0, 1]
    assert counts(fast) == [1, 0, 0, 0]


def test_two_slips_past_the_minimum_of_the_normal_motion():
    """mu = 1.4, l = 2: n . u falls to -0.0400 at |f| = 1.409 and is back at 0 at |f| = 2.225."""
    slider, force = Slider.of(2), edge(1.4, 1)
    motions, parts = modes.cover(slider, 1.4, 1)
    assert [part.rise for part in parts] == [-1, 0, 1]
    assert abs(parts[1].start + arb("0.0400")) < 5e-5
    k = parts[1].low
    size = motions.speed(k) + ring.profile(k)[0]
    assert abs(size - 1.409) < 5e-4
    (level,) = slips.slip_spins(motions, parts, arb(0))
    assert abs(motions.speed(level) + ring.profile(level)[0] - 2.225) < 5e-4
    found = solve(2, Effects.BOTH, coulomb(1.4), 1.42, -1)
    assert counts(found) == [1, 0, 0, 2]
    slow, fast = found[LEFT]
    assert motions.speed(slow.spin_ratio) < motions.speed(fast.spin_ratio)
    for motion in found[LEFT]:
        normal = contact_motion(slider, force, motion.spin_ratio)[1]
        pusher = 1.42 * heading(-1).y
        assert (motions.speed(motion.spin_ratio) * normal).overlaps(pusher)


@pytest.mark.parametrize("mu", [0.5, 1.2, 1.3, 1.4, 1.45, 1.5, 2.0, math.inf])
@pytest.mark.parametrize("side", [1, -1])
@pytest.mark.parametrize("length", [0.5, 2, 5])
def test_slips_are_complete_against_a_dense_scan(mu, side, length):
    """The certified parts and a scan of signs at 2,000 speeds count the same motions."""
    motions, parts = modes.cover(Slider.of(length), mu, side)
    start, end = (float(each) for each in motions.ends)
    grid = [
        start + (end - start) * (1 - math.cos(math.pi * (i + 0.5) / 2000)) / 2 for i in range(2000)
    ]
    values = [float(motions.normal_motion(arb(k))) for k in grid]
    for target in (-1.0, -0.3, -0.04, -0.01, 0.013, 0.5, 3.0):
        signs = [value > target for value in values]
        changes = sum(a != b for a, b in pairwise(signs))
        assert len(slips.slip_spins(motions, parts, arb(target))) == changes


@pytest.mark.parametrize("gyration_radius", [0.25, 3.0])
def test_a_kink_on_the_ring_inside_the_segment(gyration_radius):
    """Away from rho = R the spin ratio of the ring itself, where t' is infinite, can lie between."""
    slider = Slider.of(2, 45, gyration_radius=gyration_radius)
    motions, parts = modes.cover(slider, 3.0 if gyration_radius < 1 else 20.0, 1)
    low, high = sorted(motions.ends, key=float)
    assert low < 1 < high
    assert sum(part.rise != 0 for part in parts) >= 1


def test_an_edge_along_the_fence_has_no_slip_of_its_own():
    for angle in (0, 180, 90, -90):
        found = solve(2, Effects.INERTIA, coulomb(1.5), 1, angle)
        assert not found[LEFT]
    assert counts(solve(2, Effects.INERTIA, coulomb(1.5), 1, 0)) == [1, 1, 0, 0]


def test_normal_motion_stays_finite_where_the_inertial_edge_is_along_the_fence():
    motions, parts = modes.cover(Slider.of(2), 1.5, 1)
    assert motions.stays
    assert len(parts) == 1
    assert -0.25 < parts[0].start < -0.249
    assert not slips.slip_spins(motions, parts, arb(-0.26))
    assert len(slips.slip_spins(motions, parts, arb(-0.24))) == 1


def test_no_motion_leaves_the_fence_across_a_normal_rod_under_an_edge_along_it():
    assert counts(solve(4, Effects.BOTH, modes.INFINITE_FREE, 0.5, 150, rod_angle=90)) == [
        0,
        1,
        0,
        0,
    ]


@pytest.mark.parametrize("effects", list(Effects))
@pytest.mark.parametrize("magnitude", [0.1, 10])
def test_slip_that_coincides_with_stick_counts_once(effects, magnitude):
    """mu = 1: the right edge is along the rod, the left one across it, whatever the effects."""
    for angle in (45, 135):
        assert counts(solve(2, effects, coulomb(1.0), magnitude, angle)) == [0, 1, 0, 0]
    assert counts(solve(0, effects, modes.INFINITE_FREE, magnitude, 0)) == [1, 1, 0, 0]
    assert counts(solve(0, effects, modes.INFINITE_NONE, magnitude, 0)) == [1, 0, 0, 0]
    assert counts(solve(0, effects, coulomb(0.0), magnitude, 90)) == [0, 1, 0, 0]
    assert counts(solve(0, effects, coulomb(0.0), magnitude, -90)) == [1, 0, 0, 0]


def test_force_angles_end_at_plus_180():
    for angle in (180, -180):
        found = solve(0, Effects.FRICTION, modes.INFINITE_FREE, 1, angle)
        assert found[STICK][0].force_angle.overlaps(arb(180))


@pytest.mark.parametrize("effects", list(Effects))
@pytest.mark.parametrize("angle", [-100, 10, 44, 46, 134, 170])
@pytest.mark.parametrize("rod_angle", [45, 70])
def test_sticking_motions_balance_the_torque(effects, angle, rod_angle):
    """The stored force angle and spin ratio move the contact as the pusher does, Eqs. (6)-(7) hold."""
    slider = Slider.of(2, rod_angle)
    found = contact_modes(slider, effects, modes.PERFECTLY_ROUGH, 1, angle)[STICK][0]
    force, k = direction(found.force_angle), abs(found.spin_ratio)
    u = contact_motion(slider, force, found.spin_ratio)
    pusher = heading(angle)
    speed = 1 / (u[0] ** 2 + u[1] ** 2).sqrt()
    assert (u[0] * speed - pusher.x).contains(0)
    assert (u[1] * speed - pusher.y).contains(0)
    arm = 2 * abs(((rod_angle - found.force_angle) / 180).sin_pi())
    f, t = ring.profile(k)
    friction = 0 if effects is Effects.INERTIA else t - arm * f
    inertia = 0 if effects is Effects.FRICTION else speed * (k - arm)
    residual = friction + inertia
    assert residual.contains(0)
    assert residual.rad() < 1e-30


def test_one_effect_has_no_scale_and_two_have_one():
    for effects in (Effects.FRICTION, Effects.INERTIA):
        one, other = (solve(2, effects, coulomb(2.0), size, -10) for size in (0.1, 10))
        assert counts(one) == counts(other)
        for mode in Mode:
            for first, second in zip(one[mode], other[mode], strict=True):
                assert first.spin_ratio.overlaps(second.spin_ratio)
                assert first.force_angle.overlaps(second.force_angle)
    slow, fast = (solve(2, Effects.BOTH, coulomb(2.0), size, -10)[STICK][0] for size in (1e-9, 1e9))
    friction, inertia = (
        solve(2, each, coulomb(2.0), 1, -10)[STICK][0] for each in list(Effects)[:2]
    )
    assert abs(slow.spin_ratio - friction.spin_ratio) < 1e-8
    assert abs(fast.spin_ratio - inertia.spin_ratio) < 1e-8
