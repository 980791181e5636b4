"""Claims of Sec. 4: inertia alone, and both effects from rest."""

from __future__ import annotations

import numpy as np
import pytest
from mpmath import mp

import planar_pushing as pp
import reference
from mechanics.builders import BOTH, FRICTION, INERTIA, PSI, make_scene, names
from planar_pushing.mechanics.plane import direction


def wrench_line(effect, center, spin):
    """Force, and signed distance of its line from the ring center, for a motion about `center`."""
    velocity = spin * np.array([center[1], -center[0]])  # omega x (0 - center)
    wrench = pp.wrench(effect, [*velocity, spin])
    return wrench[:2], wrench[2] / np.hypot(*wrench[:2]), velocity


@pytest.mark.parametrize("effects", [FRICTION, INERTIA, BOTH], ids=["friction", "inertia", "both"])
def test_pulling_exists_in_every_kind_of_analysis(effects):
    """Secs. 3 and 4: quasi-static, pure dynamic, and with both effects."""
    for magnitude in (1e-3, 1.0, 1e3):
        solutions = pp.solve(make_scene(5.0, 2.0, effects), np.deg2rad(-10), magnitude)
        stick = next(s for s in solutions if s.mode is pp.ContactMode.STICK)
        assert stick.contact_motion[1] < 0 < stick.force[1]


@pytest.mark.parametrize("effects", [FRICTION, INERTIA, BOTH], ids=["friction", "inertia", "both"])
@pytest.mark.parametrize("magnitude", [1e-3, 1.0, 1e3])
def test_slip_with_infinite_friction_exists_in_every_kind_of_analysis(effects, magnitude):
    """Secs. 3.2 and 4: the only solution is slip, whatever the magnitude (Fig. 12)."""
    solutions = pp.solve(make_scene(5.0, np.inf, effects), np.deg2rad(179), magnitude)
    assert names(solutions) == ["SLIP_RIGHT"]


def test_condition_13_gives_mu_above_1_5():
    """Sec. 4: for psi = 45 deg and l = 2, 3 f_y - 2 mu f_y < 0."""
    threshold = reference.pulling_threshold(reference.inertia_spin_ratio, 2, mp.pi / 4)
    assert float(threshold) == pytest.approx(1.5, rel=1e-15, abs=0)
    assert not pp.can_pull(make_scene(2.0, 1.5, INERTIA))
    assert not pp.can_pull(make_scene(2.0, 1.5 - 1e-9, INERTIA))
    assert pp.can_pull(make_scene(2.0, 1.5 + 1e-9, INERTIA))


@pytest.mark.parametrize("length", [0.25, 1.0, 2.0, 5.0])
@pytest.mark.parametrize("mu", [0.0, 1.0, 5.0, np.inf])
def test_acceleration_cone_lies_within_90_degrees_of_the_friction_cone(length, mu):
    """Sec. 4: the mass matrix is positive definite, f . a_s > 0."""
    scene = make_scene(length, mu, INERTIA)
    phi = np.linspace(pp.friction_cone(scene).right, pp.friction_cone(scene).left, 181)
    motion = pp.motion_angle(scene, phi)
    assert np.all(np.abs(motion - phi) < np.pi / 2)
    assert np.all(np.diff(motion) >= 0)


@pytest.mark.parametrize(("mu", "right", "left"), [
    (2.0, -14.036243467926, 138.81407483429),
    (np.inf, -33.69006752598, 146.30993247402),
])  # fmt: skip
def test_acceleration_cones_of_figure_9(mu, right, left):
    """Sec. 4, Fig. 9: l = 2."""
    scene = make_scene(2.0, mu, INERTIA)
    cone = pp.motion_cone(scene)
    assert np.rad2deg([cone.right, cone.left]) == pytest.approx([right, left], rel=1e-12, abs=0)
    solutions = pp.solve(scene, cone.right / 2)
    assert solutions.outcome is pp.Outcome.AMBIGUOUS
    assert {"SEPARATE", "STICK"} <= set(names(solutions))


def test_slip_is_the_only_solution_outside_the_cone_of_figure_9b():
    """Sec. 4, Fig. 9b: a_p outside the acceleration cone with a_py > 0."""
    scene = make_scene(2.0, np.inf, INERTIA)
    for degrees in (146.4, 160.0, 179.9):
        assert names(pp.solve(scene, np.deg2rad(degrees))) == ["SLIP_RIGHT"]
    assert names(pp.solve(scene, np.deg2rad(146.2))) == ["STICK"]


@pytest.mark.parametrize("gyration_radius", [0.5, 1.0, 2.0])
@pytest.mark.parametrize("mu", [2.0, np.inf])
def test_acceleration_centers_lie_on_one_line(mu, gyration_radius):
    """Sec. 4, Fig. 9: the force dual of the contact, rho^2 / l behind the ring center."""
    scene = make_scene(2.0, mu, [pp.Inertia(gyration_radius=gyration_radius)])
    cone = pp.friction_cone(scene)
    phi = np.linspace(cone.right, cone.left, 51)
    phi = phi[np.abs(phi - PSI) > 1e-3]
    along = pp.motion_centers(scene, phi) @ direction(PSI)
    assert along == pytest.approx(2.0 + gyration_radius**2 / 2.0, rel=1e-11)


@pytest.mark.parametrize("gyration_radius", [0.5, 1.0, 3.0])
@pytest.mark.parametrize("length", [0.3, 1.0, 2.0, 5.0])
def test_ellipse_axes(length, gyration_radius):
    """Sec. 4, Fig. 10: half-lengths c along the rod and c / sqrt(1 + (l / rho)^2) across it."""
    scene = make_scene(length, effects=[pp.Inertia(mass=3.0, gyration_radius=gyration_radius)])
    phi = np.linspace(0, 2 * np.pi, 721)
    curve = pp.limit_curve(scene, phi)
    ratio = 1 / np.sqrt(1 + (length / gyration_radius) ** 2)
    major, minor = pp.limit_curve(scene, [PSI, PSI + np.pi / 2]).magnitude
    assert major == pytest.approx(3.0, rel=1e-14, abs=0)
    assert minor / major == pytest.approx(ratio, rel=1e-14, abs=0)
    x, y = (curve.force @ direction(PSI + turn) for turn in (0.0, np.pi / 2))
    assert (x / major) ** 2 + (y / minor) ** 2 == pytest.approx(1, abs=1e-12)


@pytest.mark.parametrize("length", [0.3, 1.0, 2.0, 5.0])
def test_acceleration_is_normal_to_the_ellipse(length):
    """Sec. 4, Fig. 10."""
    curve = pp.limit_curve(make_scene(length, effects=INERTIA), np.linspace(0, 6.2, 50))
    x, y = (curve.force @ direction(PSI + turn) for turn in (0.0, np.pi / 2))
    normal = np.arctan2((1 + length**2) * y, x) + PSI
    turns = (normal - curve.motion_angle) / (2 * np.pi)
    assert turns == pytest.approx(np.rint(turns), abs=1e-14)


@pytest.mark.parametrize("share", [0.0, 0.2, 0.5, 0.9, 1.0])
def test_center_on_the_ring_pulls(share):
    """Sec. 4, Fig. 11: l = 5, a force tangent to the ring, whatever the relative magnitudes."""
    scene = make_scene(5.0, 2.0, BOTH)
    tangent = PSI - np.arcsin(1 / 5)
    assert pp.friction_cone(scene).contains(tangent)
    assert float(pp.spin_ratio(scene, tangent, share)) == pytest.approx(1.0, abs=2e-14)
    motion = float(pp.motion_angle(scene, tangent, share))
    assert -np.pi / 2 < motion < 0
    center = pp.motion_centers(scene, tangent, share) - 5 * direction(PSI)
    assert np.hypot(*center) == pytest.approx(1.0, abs=2e-14)
    assert center @ direction(tangent) == pytest.approx(0.0, abs=1e-13)


def test_center_on_the_ring_is_found_by_solve():
    """Sec. 4, Fig. 11: the pusher that accelerates like the tangent force's contact."""
    scene = make_scene(5.0, 2.0, BOTH)
    tangent = PSI - np.arcsin(1 / 5)
    pusher = float(pp.motion_angle(scene, tangent, 0.5))
    for magnitude in (0.01, 1.0, 100.0):
        stick = next(
            s for s in pp.solve(scene, pusher, magnitude) if s.mode is pp.ContactMode.STICK
        )
        assert stick.spin_ratio == pytest.approx(1.0, abs=1e-12)
        assert np.arctan2(*stick.force[::-1]) == pytest.approx(tangent, abs=1e-12)


CENTERS = [(0.2, 0.1), (0.0, -0.7), (0.6, 0.8), (-1.0, 0.0), (1.5, -2.0), (30.0, 4.0)]
EFFECTS = [pp.RingFriction(weight=2.0), pp.Inertia(mass=3.0)]


@pytest.mark.parametrize("effect", EFFECTS, ids=["friction", "inertia"])
@pytest.mark.parametrize("center", CENTERS)
@pytest.mark.parametrize("spin", [-0.7, 1.3])
class TestSevenGeometricFacts:
    """Sec. 4, facts 1-7; rho = R. Wrenches are of the pusher, opposite to the lines of force."""

    def test_fact_1_line_is_perpendicular_to_the_line_to_the_center(self, effect, center, spin):
        force, _, _ = wrench_line(effect, center, spin)
        assert abs(force @ np.array(center)) < 1e-14 * np.hypot(*force) * np.hypot(*center) + 1e-15

    def test_fact_2_line_opposes_the_acceleration(self, effect, center, spin):
        force, _, velocity = wrench_line(effect, center, spin)
        assert force @ velocity > 0

    def test_fact_3_both_lines_are_parallel(self, effect, center, spin):
        force, _, _ = wrench_line(effect, center, spin)
        for other in EFFECTS:
            across, _, _ = wrench_line(other, center, spin)
            assert force[0] * across[1] == pytest.approx(force[1] * across[0], abs=1e-12)
            assert force @ across > 0

    def test_fact_4_line_is_opposite_to_the_center(self, effect, center, spin):
        force, arm, _ = wrench_line(effect, center, spin)
        foot = arm * np.array([force[1], -force[0]]) / np.hypot(*force)
        # The torque foot x force is arm |force| for a foot on the side of x' x -arm.
        torque = foot[0] * force[1] - foot[1] * force[0]
        assert torque == pytest.approx(arm * np.hypot(*force), rel=1e-14, abs=0)
        assert foot @ np.array(center) < 0

    def test_facts_5_to_7_line_and_center_swap_inside_and_outside(self, effect, center, spin):
        _, arm, _ = wrench_line(effect, center, spin)
        distance = np.hypot(*center)
        if distance == pytest.approx(1.0, abs=1e-12):
            assert abs(arm) == pytest.approx(1.0, abs=1e-12)
        else:
            assert (abs(arm) < 1) == (distance > 1)


def test_fact_4_fourth_case_force_through_the_center_translates():
    """Sec. 4, the fourth case: the acceleration center is at infinity."""
    scene = make_scene(5.0, np.inf, BOTH)
    assert np.all(pp.spin_ratio(scene, PSI, np.linspace(0, 1, 5)) == 0)
    assert np.all(np.isinf(pp.motion_centers(scene, PSI, 0.5)))
    assert pp.motion_angle(scene, PSI, 0.5) == pytest.approx(PSI, abs=1e-15)


def test_possible_centers_fall_into_the_sectors_of_figure_12():
    """Sec. 4, the seven cases: inside, on or outside the ring as the line is outside, on or in it."""
    scene = make_scene(5.0, np.inf, BOTH)
    phi, share = np.meshgrid(np.linspace(0, np.pi, 181), np.linspace(0, 1, 11))
    k = pp.spin_ratio(scene, phi, share)
    arm = 5.0 * np.sin(PSI - phi)
    inside, through = np.abs(arm) > 1 + 1e-9, np.abs(arm) < 1 - 1e-9
    assert np.all(np.abs(k[inside]) > 1)
    assert np.all(np.abs(k[through]) < 1)
    assert np.all(k * arm >= 0)


def test_bounds_of_figure_12_are_conservative():
    """Sec. 4, Fig. 12: bounds [-45, 142.06...]; the exact analysis is tighter."""
    scene = make_scene(5.0, np.inf, BOTH)
    bound, exact = pp.conservative_motion_cone(scene), pp.motion_cone(scene)
    left = np.pi - np.arctan2(5 * np.sin(PSI), 1 + 5 * np.sin(PSI))
    assert [bound.right, bound.left] == pytest.approx([-PSI, left], rel=1e-14, abs=0)
    assert np.rad2deg(bound.left) == pytest.approx(142.06, abs=0.005)
    assert bound.right < exact.right
    assert exact.left < bound.left < np.pi


def test_exact_cone_of_figure_12():
    """Sec. 4: the tighter bounds that an exact analysis obtains."""
    scene = make_scene(5.0, np.inf, BOTH)
    cone = pp.motion_cone(scene)
    assert np.rad2deg([cone.right, cone.left]) == pytest.approx(
        [-42.797401838234, 138.83997216476], rel=1e-12, abs=0
    )
    phi, share = np.meshgrid(np.linspace(0, np.pi, 181), np.linspace(0.01, 0.99, 21))
    motion = pp.motion_angle(scene, phi, share)
    assert np.all((motion > cone.right) & (motion < cone.left))
    assert not cone.closed


def test_slip_at_every_magnitude_just_below_180_degrees():
    """Sec. 4, Fig. 12: regardless of the magnitude of the acceleration."""
    scene = make_scene(5.0, np.inf, BOTH)
    for degrees in (139.0, 160.0, 179.9):
        for magnitude in (1e-6, 1e-2, 1.0, 1e2, 1e6):
            assert names(pp.solve(scene, np.deg2rad(degrees), magnitude)) == ["SLIP_RIGHT"]
