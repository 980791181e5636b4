"""Supports on one line: one force for an interval of motions, and what cones and modes make of it."""

import numpy as np
import pytest

import planar_pushing as pp

ACROSS = pp.Segment((0, -1), (0, 1))
FEET = pp.Points([(0, -1), (0, 0.5), (0, 1)], [1.5, 1, 1])
#: Halfway from the line's middle to its nearer end a rotation moves the contact by twice the rod's length.
END = np.arctan2(1, 2)


def scene(support, law, psi=np.pi / 2, rod_length=2.0, extra=()):
    slider = pp.Slider(rod_length=rod_length, rod_angle=psi, radius=1.0)
    effects = (pp.SupportFriction(support=support), *extra)
    return pp.Scene(slider=slider, contact=law, effects=effects)


@pytest.mark.parametrize("support", [ACROSS, FEET], ids=["segment", "points"])
def test_without_friction_the_cone_is_the_corner(support):
    cone = pp.motion_cone(scene(support, pp.Coulomb(0.0)))
    assert cone.closed
    np.testing.assert_allclose([cone.right, cone.left], [END, np.pi - END], rtol=1e-14)


@pytest.mark.parametrize("support", [ACROSS, FEET], ids=["segment", "points"])
def test_a_corner_at_the_right_edge(support):
    cone = pp.motion_cone(scene(support, pp.Coulomb(1.0), np.pi / 4))
    assert cone.closed
    assert cone.right == pytest.approx(END - np.pi / 4, abs=1e-14)


def test_a_corner_at_the_left_edge():
    cone = pp.motion_cone(scene(ACROSS, pp.Coulomb(1.0), 3 * np.pi / 4))
    assert cone.left == pytest.approx(np.pi - END + np.pi / 4, abs=1e-14)


@pytest.mark.parametrize("beside", [1e-9, 1e-6, 1e-3, 0.1])
@pytest.mark.parametrize("support", [ACROSS, FEET], ids=["segment", "points"])
def test_beside_a_corner_motions_are_beyond_its_ends(support, beside):
    smooth = scene(support, pp.PerfectlyRough())
    right, middle, left = pp.motion_angle(smooth, np.pi / 2 + beside * np.array([-1, 0, 1]))
    assert right <= END + 1e-12
    assert middle == pytest.approx(np.pi / 2)
    assert left >= np.pi - END - 1e-12
    assert right + left == pytest.approx(np.pi, abs=1e-9)
    assert abs(right - END) < 2 * beside


def test_without_friction_slips_are_a_continuum_about_the_stick():
    solutions = pp.solve(scene(ACROSS, pp.Coulomb(0.0)), np.pi / 3)
    assert [each.mode.name for each in solutions] == ["STICK", "SLIP_RIGHT", "SLIP_LEFT"]
    assert [each.continuum for each in solutions] == [False, True, True]
    normal = np.sin(np.pi / 3)
    for each, sign in zip(solutions, (None, 1, -1), strict=True):
        np.testing.assert_allclose(each.force, [0, 1], atol=1e-15)
        np.testing.assert_allclose(each.twist[:2], [0, normal], atol=1e-15)
        if sign:
            np.testing.assert_allclose(each.contact_motion, [2 * sign * normal, normal], rtol=1e-14)


def test_beyond_the_corner_a_slip_has_both_ends():
    solutions = pp.solve(scene(ACROSS, pp.Coulomb(0.0)), np.deg2rad(20))
    assert [each.mode.name for each in solutions] == ["SLIP_LEFT", "SLIP_LEFT"]
    assert all(each.continuum for each in solutions)
    along = sorted(each.contact_motion[0] for each in solutions)
    np.testing.assert_allclose(along, np.sin(np.deg2rad(20)) * np.array([-2, 2]), rtol=1e-14)


@pytest.mark.parametrize("angle", np.deg2rad([30.0, 75.0, 90.0, 140.0]))
def test_motions_of_a_corner_stick_under_its_force(angle):
    (stick,) = pp.solve(scene(ACROSS, pp.Coulomb(0.5)), angle)
    assert (stick.mode, stick.continuum) == (pp.ContactMode.STICK, False)
    np.testing.assert_allclose(stick.force, [0, 1], atol=1e-14)


@pytest.mark.parametrize("turn", [-0.5, 0.0, 0.5])
@pytest.mark.parametrize("sign", [1, -1])
def test_a_corner_under_one_edge_alone_sticks_and_slips(sign, turn):
    """The rod lies along the edge; a motion of its corner sticks, and the end beyond it slips."""
    psi = np.pi / 2 - sign * np.pi / 4
    stick, slip = pp.solve(scene(ACROSS, pp.Coulomb(1.0), psi), psi + turn)
    assert stick.mode is pp.ContactMode.STICK
    assert slip.mode is (pp.ContactMode.SLIP_LEFT if sign > 0 else pp.ContactMode.SLIP_RIGHT)
    assert (stick.continuum, slip.continuum) == (False, True)
    for each in (stick, slip):
        np.testing.assert_allclose(each.force, np.sqrt(0.5) * np.array([sign, 1]), rtol=1e-14)
    normal = np.sin(psi + turn)
    np.testing.assert_allclose(slip.contact_motion, [-sign * normal / 3, normal], rtol=1e-13)


def test_with_inertia_a_corner_keeps_the_nearest_motion():
    law, mass = pp.Coulomb(0.0), (pp.Inertia(),)
    both = pp.motion_cone(scene(ACROSS, law, extra=mass))
    np.testing.assert_allclose([both.right, both.left], np.pi / 2, rtol=1e-15)
    # The mass alone turns about a place within the support's ends.
    heavy = (pp.Inertia(center=(0.0, 0.5), gyration_radius=0.1),)
    far = pp.motion_cone(scene(ACROSS, law, extra=heavy))
    assert far.right == pytest.approx(np.arctan2(0.52, 2.0), abs=1e-12)
    assert far.left == pytest.approx(END, abs=1e-12)


@pytest.mark.parametrize("angle", [-1e-2, -1e-6, 0.0, 1e-9, 1e-6, 1e-2])
def test_a_contact_on_the_line_of_its_support(angle):
    """Across the line the centre of rotation is on it: (x + l)^2 = (1 + l^2) / 2 + l x, |f| = x."""
    along = scene(pp.Segment((-1, 0), (1, 0)), pp.InfiniteFriction(), rod_length=0.5)
    force = pp.limit_curve(along, angle).force
    assert np.hypot(*force) == pytest.approx(
        (np.sqrt(5) - 1) / 2, abs=2e-4 if angle**2 > 1e-5 else 1e-9
    )


def test_a_class_is_no_support():
    with pytest.raises(pp.InvalidValue, match="support"):
        pp.SupportFriction(support=pp.Disc)
