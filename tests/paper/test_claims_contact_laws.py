"""Claims of Secs. 2 and 5: contact modes, infinite friction and perfectly rough contact."""

from __future__ import annotations

import numpy as np
import pytest

import planar_pushing as pp
from mechanics.builders import (
    BOTH,
    DEFINITION_2,
    EFFECT_SETS,
    FRICTION,
    INFINITE,
    make_scene,
    names,
)

EVERY_EFFECT = pytest.mark.parametrize("effects", EFFECT_SETS.values(), ids=EFFECT_SETS)
DIRECTIONS = np.deg2rad([*np.arange(-172.5, 175, 15.0), 175.0])


def test_definition_1_is_the_closed_interval():
    """Sec. 5: f_n = 0 leaves f_t unrestricted, force angles [0, 180] degrees."""
    cone = pp.friction_cone(make_scene(2.0, INFINITE))
    assert (cone.right, cone.left, cone.closed) == (0.0, np.pi, True)
    assert np.all(cone.contains([0.0, np.pi, -np.pi, 2 * np.pi]))


def test_definition_2_is_the_open_interval():
    """Sec. 5: f_n = 0 => f_t = 0, force angles (0, 180) degrees."""
    cone = pp.friction_cone(make_scene(2.0, DEFINITION_2))
    assert (cone.right, cone.left, cone.closed) == (0.0, np.pi, False)
    assert not np.any(cone.contains([0.0, np.pi]))
    assert np.all(cone.contains([1e-9, np.pi - 1e-9]))


@EVERY_EFFECT
def test_slip_under_definition_1_has_no_normal_force(effects):
    """Sec. 5: zero normal force allows a finite tangential force, against the slip."""
    (slip,) = pp.solve(make_scene(2.0, INFINITE, effects), np.deg2rad(170))
    assert slip.mode is pp.ContactMode.SLIP_RIGHT
    assert slip.force[1] == 0
    assert slip.force[0] * (slip.contact_motion[0] - np.cos(np.deg2rad(170))) < 0


@EVERY_EFFECT
@pytest.mark.parametrize("length", [0.5, 5.0])
def test_where_definition_1_prevents_sticking_so_does_definition_2(effects, length):
    """Sec. 5."""
    first, second = (make_scene(length, law, effects) for law in (INFINITE, DEFINITION_2))
    for angle in DIRECTIONS:
        if pp.ContactMode.STICK not in pp.solve(first, angle).modes:
            assert pp.ContactMode.STICK not in pp.solve(second, angle).modes


@EVERY_EFFECT
def test_definition_2_never_slips(effects):
    """Sec. 5: definition 2 also disallows slipping contact."""
    scene = make_scene(2.0, DEFINITION_2, effects)
    for angle in DIRECTIONS:
        assert set(pp.solve(scene, angle).modes) <= {pp.ContactMode.SEPARATE, pp.ContactMode.STICK}
    assert not pp.slips_while_pushing(scene)


@EVERY_EFFECT
def test_slipping_examples_have_no_solution_under_definition_2(effects):
    """Sec. 5: l = 2, w at 165 degrees."""
    solutions = pp.solve(make_scene(2.0, DEFINITION_2, effects), np.deg2rad(165))
    assert len(solutions) == 0
    assert solutions.outcome is pp.Outcome.INCONSISTENT


@EVERY_EFFECT
@pytest.mark.parametrize("length", [0.0, 0.5, 2.0, 5.0])
def test_perfectly_rough_always_sticks(effects, length):
    """Sec. 5: perfectly rough is a kinematic constraint that prevents slip."""
    scene = make_scene(length, pp.PerfectlyRough(), effects)
    for angle in DIRECTIONS:
        expected = ["STICK"] if np.sin(angle) > 0 else ["SEPARATE", "STICK"]
        assert names(pp.solve(scene, angle)) == expected


@EVERY_EFFECT
def test_perfectly_rough_sometimes_implies_adhesion(effects):
    """Secs. 3.2 and 5: sticking would need a force away from the slider."""
    scene = make_scene(2.0, pp.PerfectlyRough(), effects)
    (stick,) = pp.solve(scene, np.deg2rad(165))
    assert stick.adhesive
    assert stick.force[1] < 0
    (stick,) = pp.solve(scene, np.deg2rad(90))
    assert not stick.adhesive


@EVERY_EFFECT
@pytest.mark.parametrize("length", [0.5, 5.0])
def test_infinite_friction_and_perfectly_rough_are_not_equivalent(effects, length):
    """Secs. 1 and 5: they agree where the rough contact is not adhesive, and only there."""
    rough, infinite = (make_scene(length, law, effects) for law in (pp.PerfectlyRough(), INFINITE))
    disagree = 0
    for angle in DIRECTIONS[np.sin(DIRECTIONS) > 0]:
        (stick,) = pp.solve(rough, angle)
        (found,) = pp.solve(infinite, angle)
        assert (found.mode is pp.ContactMode.STICK) == (not stick.adhesive)
        if not stick.adhesive:
            assert found.force == pytest.approx(stick.force, rel=1e-12, abs=0)
        disagree += stick.adhesive
    assert disagree > 0


@EVERY_EFFECT
@pytest.mark.parametrize("law", [pp.Coulomb(2.0), INFINITE, DEFINITION_2], ids=str)
@pytest.mark.parametrize("length", [0.5, 2.0])
def test_only_a_perfectly_rough_contact_is_adhesive(effects, law, length):
    """Sec. 5, at directions that include both edges of the motion cone exactly."""
    scene = make_scene(length, law, effects)
    cone = pp.motion_cone(scene)
    for angle in [*DIRECTIONS[::5], cone.right, cone.left]:
        assert not any(solution.adhesive for solution in pp.solve(scene, angle))


def test_separation_is_consistent_exactly_when_the_pusher_does_not_approach():
    """Sec. 2 and 3: w_y < 0 breaks contact, w_y = 0 grazes."""
    scene = make_scene(2.0, 0.5)
    for angle in [*DIRECTIONS, 0.0, np.pi, -np.pi]:
        separate = [s for s in pp.solve(scene, angle) if s.mode is pp.ContactMode.SEPARATE]
        assert len(separate) == (np.sin(angle) <= 1e-15)
        for solution in separate:
            assert not np.any(solution.force)
            assert not np.any(solution.contact_motion)


def test_outcomes_are_named_by_the_number_of_solutions():
    """Sec. 2: several solutions are ambiguous, none is inconsistent."""
    scene = make_scene(2.0, 2.0)
    assert pp.solve(scene, np.deg2rad(90)).outcome is pp.Outcome.UNIQUE
    assert pp.solve(scene, np.deg2rad(-10)).outcome is pp.Outcome.AMBIGUOUS
    none = pp.solve(make_scene(2.0, DEFINITION_2), np.deg2rad(165))
    assert none.outcome is pp.Outcome.INCONSISTENT


def test_pulling_while_slipping_is_a_third_solution():
    """l = 2, mu = 2, w at -10 degrees: separate, stick and slip-left are all consistent."""
    solutions = pp.solve(make_scene(2.0, 2.0, FRICTION), np.deg2rad(-10))
    assert names(solutions) == ["SEPARATE", "STICK", "SLIP_LEFT"]


def slip_forces(normal_motion):
    """Magnitudes of the slipping solutions at l = 2, mu = 1.4 with this normal pusher motion."""
    pusher = np.array([10.0, normal_motion])
    solutions = pp.solve(make_scene(2.0, 1.4, BOTH), np.arctan2(*pusher[::-1]), np.hypot(*pusher))
    slips = [s for s in solutions if s.mode is pp.ContactMode.SLIP_LEFT]
    for slip in slips:
        assert slip.contact_motion[1] == pytest.approx(normal_motion, rel=1e-12, abs=1e-14)
        assert slip.force[0] == pytest.approx(1.4 * slip.force[1], rel=1e-14, abs=0)
    return [np.hypot(*slip.force) for slip in slips]


def test_two_slipping_solutions_with_both_effects():
    """l = 2, mu = 1.4, f on the right edge: n . u(|f|) falls to -0.040 and comes back to 0.

    It starts at |f| = 0.912, where friction alone is overcome.
    """
    assert slip_forces(-1e-9) == pytest.approx([0.91208766874, 2.22518486055], abs=1e-6)
    assert len(slip_forces(-0.03)) == 2
    assert slip_forces(-0.0400295) == pytest.approx([1.408, 1.408], abs=0.01)
    assert slip_forces(-0.04003) == []
    assert slip_forces(1e-9) == pytest.approx([2.22518486055], abs=1e-6)


def test_slow_pulling_exists_and_fast_pulling_does_not():
    """l = 2, 1.27 < mu < 1.5: friction alone pulls, inertia alone does not."""
    scene = make_scene(2.0, 1.4, BOTH)
    angle = np.deg2rad(-0.5)
    assert pp.ContactMode.STICK in pp.solve(scene, angle, 0.1).modes
    assert pp.ContactMode.STICK not in pp.solve(scene, angle, 10.0).modes
