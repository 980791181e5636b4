"""Claims of Secs. 2 and 3: support friction alone."""

from __future__ import annotations

import numpy as np
import pytest
from mpmath import mp

import planar_pushing as pp
import reference
from mechanics.builders import BOTH, FRICTION, INERTIA, PSI, make_scene, names
from planar_pushing.mechanics.plane import direction

LENGTHS = [0.25, 0.5, 1.0, 2.0, 5.0, 10.0]
TURN = np.linspace(0, 2 * np.pi, 721)


def test_pulling_exists():
    """Sec. 1 and Fig. 3: the slider keeps contact with a pusher that moves away from it."""
    solutions = pp.solve(make_scene(2.0, 2.0), np.deg2rad(-15))
    stick = next(s for s in solutions if s.mode is pp.ContactMode.STICK)
    assert stick.contact_motion[1] < 0 < stick.force[1]
    assert abs(stick.force[0]) <= 2.0 * stick.force[1]


def test_pushing_figure_2_is_unique():
    """Fig. 2: the pusher moves into the slider and there is nothing unusual about it."""
    solutions = pp.solve(make_scene(2.0, 2.0), np.deg2rad(80))
    assert names(solutions) == ["STICK"]
    assert solutions.outcome is pp.Outcome.UNIQUE


def test_force_on_the_other_side_of_the_center_turns_the_other_way():
    """Sec. 3, Figs. 2-3: a force closely right or left of the ring center."""
    scene = make_scene(2.0)
    below, above = pp.spin_ratio(scene, [PSI - 0.05, PSI + 0.05])
    assert below > 0 > above


@pytest.mark.parametrize("effects", [FRICTION, INERTIA, BOTH], ids=["friction", "inertia", "both"])
@pytest.mark.parametrize("length", [2.0, 5.0])
@pytest.mark.parametrize("mu", [2.0, 10.0, np.inf])
def test_every_pulling_example_is_ambiguous(effects, length, mu):
    """Sec. 3: breaking contact without moving is always a second solution."""
    scene = make_scene(length, mu, effects)
    right = pp.motion_cone(scene).right
    assert right < 0
    for part in (0.02, 0.3, 0.5):
        solutions = pp.solve(scene, part * right)
        assert solutions.outcome is pp.Outcome.AMBIGUOUS
        assert pp.ContactMode.SEPARATE in solutions.modes
        assert any(s.mode is not pp.ContactMode.SEPARATE for s in solutions)


@pytest.mark.parametrize("length", LENGTHS)
def test_force_is_parallel_to_motion_at_four_force_angles_only(length):
    """Sec. 3, Fig. 5: theta_s = phi at 45, 135, 225 and 315 degrees, and nowhere else."""
    scene = make_scene(length)
    deviation = pp.motion_angle(scene, TURN) - TURN
    extremal = np.deg2rad([45.0, 135.0, 225.0, 315.0])
    assert pp.motion_angle(scene, extremal) == pytest.approx(extremal, abs=1e-13)
    elsewhere = np.abs(np.subtract.outer(TURN, extremal)).min(axis=1) > 1e-6
    assert np.all(np.abs(deviation[elsewhere]) > 1e-5)


@pytest.mark.parametrize("length", LENGTHS)
def test_limit_curve_is_extremal_along_and_across_the_rod(length):
    """Sec. 3: maximal at 45 and 225 degrees (translations), minimal at 135 and 315."""
    curve = pp.limit_curve(make_scene(length), TURN)
    degrees = np.rint(np.rad2deg(TURN) * 2) / 2
    assert set(degrees[curve.magnitude > curve.magnitude.max() - 1e-13]) == {45.0, 225.0}
    assert set(degrees[curve.magnitude < curve.magnitude.min() + 1e-13]) == {135.0, 315.0}
    assert pp.limit_curve(make_scene(length), PSI).magnitude == pytest.approx(1.0, rel=1e-15, abs=0)
    assert pp.spin_ratio(make_scene(length), PSI) == 0


@pytest.mark.parametrize("length", [0.5, 1.0, 2.0, 5.0])
def test_limit_curves_are_not_ellipses(length):
    """Sec. 3, Fig. 5: they differ from the ellipse with the same extrema."""
    curve = pp.limit_curve(make_scene(length), TURN)
    x, y = (curve.force @ direction(PSI + turn) for turn in (0.0, np.pi / 2))
    ellipse = (x / np.abs(x).max()) ** 2 + (y / np.abs(y).max()) ** 2
    assert np.abs(ellipse - 1).max() > 5e-3
    dynamic = pp.limit_curve(make_scene(length, effects=INERTIA), TURN)
    x, y = (dynamic.force @ direction(PSI + turn) for turn in (0.0, np.pi / 2))
    assert (x / np.abs(x).max()) ** 2 + (y / np.abs(y).max()) ** 2 == pytest.approx(1, abs=1e-12)


def test_limit_curve_tends_to_a_circle_for_a_short_rod():
    """Sec. 3, Fig. 5: l -> 0, quadratically in l."""
    gaps = [
        np.ptp(pp.limit_curve(make_scene(length), TURN).magnitude) for length in (1e-1, 1e-2, 0)
    ]
    assert gaps[0] == pytest.approx(1e-2, rel=0.03)
    assert gaps[1] == pytest.approx(1e-4, rel=3e-4)
    assert gaps[2] <= 4 * np.finfo(float).eps


def test_limit_curve_tends_to_a_segment_along_the_rod_for_a_long_rod():
    """Sec. 3, Fig. 5: l -> infinity; the torque W bounds the force across the rod by W / l."""
    for length in (1e2, 1e3, 1e4):
        curve = pp.limit_curve(make_scene(length), TURN)
        across = np.abs(curve.force @ direction(PSI + np.pi / 2)).max()
        assert across == pytest.approx(1 / length, rel=1e-3)
        assert np.abs(curve.force @ direction(PSI)).max() == pytest.approx(1.0, rel=1e-12, abs=0)


@pytest.mark.parametrize("length", LENGTHS)
def test_motion_is_normal_to_the_limit_curve(length):
    """Sec. 3: v_s is the outward normal of the limit curve at f."""
    phi = np.linspace(0.01, 6.2, 200)
    step = 1e-5
    tangent = pp.limit_curve(make_scene(length), phi + step).force
    tangent = tangent - pp.limit_curve(make_scene(length), phi - step).force
    curve = pp.limit_curve(make_scene(length), phi)
    unit = tangent / np.linalg.norm(tangent, axis=-1, keepdims=True)
    assert np.abs((unit * curve.contact_motion).sum(axis=-1)).max() < 2e-4
    assert np.all((curve.force * curve.contact_motion).sum(axis=-1) > 0)


@pytest.mark.parametrize("length", LENGTHS)
def test_motion_angle_is_monotone_in_the_force_angle(length):
    """Sec. 3.1: a consequence of the limit curve's convexity."""
    assert np.all(np.diff(pp.motion_angle(make_scene(length), TURN)) > 0)


@pytest.mark.parametrize("length", LENGTHS)
@pytest.mark.parametrize("mu", [0.0, 0.5, 2.0, np.inf])
def test_velocity_cone_lies_within_90_degrees_of_the_friction_cone(length, mu):
    """Sec. 3.1: the pusher does no negative work, f . v_s >= 0."""
    scene = make_scene(length, mu)
    force, motion = pp.friction_cone(scene), pp.motion_cone(scene)
    assert force.right - np.pi / 2 <= motion.right
    assert motion.left <= force.left + np.pi / 2
    curve = pp.limit_curve(scene, TURN)
    assert np.all((curve.force * curve.contact_motion).sum(axis=-1) >= 0)


def test_friction_cone_edges_are_at_the_angle_of_friction():
    """Sec. 3.1: lines at atan(mu) from the contact normal."""
    cone = pp.friction_cone(make_scene(2.0, 2.0))
    assert cone.right == pytest.approx(float(mp.pi / 2 - mp.atan(2)), rel=1e-15, abs=0)
    assert cone.left == pytest.approx(float(mp.pi / 2 + mp.atan(2)), rel=1e-15, abs=0)
    assert cone.closed


@pytest.mark.parametrize("effects", [FRICTION, INERTIA], ids=["friction", "inertia"])
@pytest.mark.parametrize("length", LENGTHS)
def test_infinite_friction_cones_span_180_degrees(length, effects):
    """Sec. 3.2: by the symmetry of the limit curve, the velocity cone spans 180 degrees too."""
    scene = make_scene(length, np.inf, effects)
    assert pp.friction_cone(scene).span == np.pi
    assert pp.motion_cone(scene).span == pytest.approx(np.pi, rel=1e-15, abs=0)


@pytest.mark.parametrize("length", [0.25, 0.5, 1.0, 2.0, 5.0])
def test_contact_slips_just_below_180_degrees_under_infinite_friction(length):
    """Sec. 3.2, Fig. 7: the velocity cones end short of 180 degrees."""
    scene = make_scene(length)
    assert pp.slips_while_pushing(scene)
    assert pp.motion_cone(scene).left < np.pi
    assert names(pp.solve(scene, np.pi - 1e-6)) == ["SLIP_RIGHT"]


def test_slip_of_figure_8():
    """Sec. 3.2, Fig. 8: l = 5; slip to the right, f on the left edge, v_s on the left edge."""
    scene = make_scene(5.0)
    (slip,) = pp.solve(scene, np.deg2rad(179))
    assert slip.mode is pp.ContactMode.SLIP_RIGHT
    assert slip.force[0] < 0
    assert slip.force[1] == 0
    angle = np.arctan2(slip.contact_motion[1], slip.contact_motion[0])
    assert angle == pytest.approx(pp.motion_cone(scene).left, rel=1e-14, abs=0)
    assert slip.contact_motion[1] == pytest.approx(np.sin(np.deg2rad(179)), rel=1e-14, abs=0)
    assert slip.contact_motion[0] > np.cos(np.deg2rad(179))


@pytest.mark.parametrize("psi", [0.05, 0.4, PSI, np.pi / 2, 2.5, 3.1])
@pytest.mark.parametrize("length", [0.0, 0.5, 2.0, 50.0])
@pytest.mark.parametrize("effects", [FRICTION, INERTIA, BOTH], ids=["friction", "inertia", "both"])
def test_a_normal_push_never_slips_under_infinite_friction(length, psi, effects):
    """Sec. 3.2: slip would make the pusher do negative work, whatever resists the motion."""
    solutions = pp.solve(make_scene(length, np.inf, effects, psi), np.pi / 2)
    assert names(solutions) == ["STICK"]


def test_slip_needs_a_cone_that_is_not_aligned():
    """Sec. 3.2: without a rod, or with a rod along the normal, the cones coincide: no slip."""
    assert not pp.slips_while_pushing(make_scene(0.0))
    assert not pp.slips_while_pushing(make_scene(2.0, psi=np.pi / 2))
    assert pp.slips_while_pushing(make_scene(2.0, psi=1.5))


def test_coulomb_slip_directions_oppose_the_friction():
    """Sec. 2: during slip |f_t| = mu f_n, directed opposite to the sliding."""
    scene = make_scene(2.0, 0.2)
    for angle, mode in ((0.3, pp.ContactMode.SLIP_LEFT), (2.9, pp.ContactMode.SLIP_RIGHT)):
        (slip,) = pp.solve(scene, angle)
        assert slip.mode is mode
        assert abs(slip.force[0]) == pytest.approx(0.2 * slip.force[1], rel=1e-14, abs=0)
        assert slip.force[0] * (slip.contact_motion[0] - np.cos(angle)) < 0


def test_pulling_threshold_of_friction():
    """Fig. 6's family: at l = 2 pulling needs mu > 1.2699 under support friction."""
    threshold = reference.pulling_threshold(reference.friction_spin_ratio, 2, mp.pi / 4)
    assert float(threshold) == pytest.approx(1.2698754263747701, rel=1e-15, abs=0)
    assert not pp.can_pull(make_scene(2.0, float(threshold) - 1e-9))
    assert pp.can_pull(make_scene(2.0, float(threshold) + 1e-9))
