"""Quasi-static motion: published references, independent ones, the policies, hard cases."""

from __future__ import annotations

import math

import mpmath
import numpy as np
import pytest
from mechanics.builders import BOTH, DEFINITION_2, FRICTION, make_scene
from simulation.runs import REFERENCES, check, final, heading, run

import planar_pushing as pp

PULLED = [(0, heading(10)), (0.5, heading(-10))]
METHODS = pytest.mark.parametrize("method", ["event-driven", "time-stepping"])


@pytest.mark.parametrize("reference", REFERENCES, ids=str)
def test_published_references(reference):
    length, mu, angle, psi, duration, rod_angle, slip = reference
    log = check(run(make_scene(length, mu, psi=np.deg2rad(psi)), heading(angle), duration))
    assert final(log, "rod_angle") == pytest.approx(rod_angle, abs=1e-9)
    assert final(log, "slip") == pytest.approx(slip, abs=1e-9)


def inner_spin_ratio(arm):
    """k with H(k) = arm for 0 < arm < 1, from the elliptic integrals."""

    def excess(k):
        e, m = mpmath.ellipe(k * k), k * k
        return (e - (1 - m) * mpmath.ellipk(m)) / (k * e) - arm

    return mpmath.findroot(
        excess, (arm, min(1 - mpmath.mpf(10) ** -12, 2 * arm)), solver="anderson"
    )


def test_slip_under_infinite_friction_in_closed_form():
    """Force along -x: the center keeps its height, so l sin psi falls as the fence rises."""
    length, duration = 5, 3
    w_x, w_y = heading(165)
    log = run(make_scene(length, np.inf), (w_x, w_y), duration)
    height = length * math.sin(math.pi / 4) - w_y * duration
    assert final(log, "rod_angle") == pytest.approx(
        math.degrees(math.asin(height / length)), abs=1e-10
    )

    def slip_speed(time):
        sine = math.sin(math.pi / 4) - w_y * time / length
        omega = -w_y / (length * mpmath.sqrt(1 - sine**2))
        # |k| > 1, and the ring is self-dual: 1 / |k| belongs to the arm's inverse.
        speed = -omega * inner_spin_ratio(1 / (length * sine))
        return -speed + omega * length * sine - w_x

    slip = mpmath.quad(slip_speed, [0, duration / 2, duration])
    assert final(log, "slip") == pytest.approx(float(slip), abs=1e-10)


def test_ring_without_rod_slips_along_the_edge():
    log = check(run(make_scene(0, 0.3), heading(60), 2))
    along = math.sin(math.radians(60)) * 0.3
    assert final(log, "slip") == pytest.approx(2 * (along - math.cos(math.radians(60))), abs=1e-12)
    assert final(log, "rod_angle") == 45


@METHODS
@pytest.mark.parametrize(
    ("policy", "modes"),
    [
        ("keep-contact", [1]), ("stay-in-mode", [1]), ("separate", [0]),
        ("stick", [1]), ("slip-left", [3]), ("slip-right", [1]),
        ([(0, "slip-left"), (0.52, "stick"), (0.55, "separate")], [3, 1, 0]),
        ([(0, "stick"), (0.52, "stay-in-mode"), (0.55, "slip-left")], [1, 3]),
        ([(0, "separate"), (0.5, "slip-left")], [3]),
    ],
    ids=str,
)  # fmt: skip
def test_pulling_takes_the_mode_of_the_policy(policy, modes, method):
    """Three modes are possible from the instant on at which the fence begins to pull."""
    log = check(run(make_scene(2, 2.0), PULLED, 0.6, method=method, on_ambiguity=policy))
    assert set(log.sel(time=slice(None, 0.499)).mode.values) == {1}
    pulled = log.sel(time=slice(0.501, None)).mode.values
    assert [*pulled[:1], *pulled[1:][np.diff(pulled) != 0]] == modes
    turn = np.flatnonzero(log.time == 0.5)[-1]
    assert log.outcome[turn] == pp.Outcome.AMBIGUOUS
    assert log.solutions[turn] == 3
    assert (final(log, "gap") > 0.005) == (modes[-1] == 0)


def test_a_choice_by_hand_changes_the_motion_of_a_pull():
    """Of the pull's three modes a slip to the left is taken for a while, then the contact sticks again."""
    scene = make_scene(2, 2.0, psi=np.deg2rad(30))
    fence, kept = [(0, heading(10)), (0.5, heading(-10))], {"samples": 151}
    by_hand = [(0, "keep-contact"), (0.7, "slip-left"), (1.0, "stick")]
    stuck, chosen = (
        check(run(scene, fence, 1.5, on_ambiguity=policy, **kept))
        for policy in ("keep-contact", by_hand)
    )
    assert set(chosen.sel(time=slice(0.701, 0.999)).mode.values) == {pp.ContactMode.SLIP_LEFT}
    assert set(chosen.sel(time=slice(1.001, None)).mode.values) == {pp.ContactMode.STICK}
    for name in ("position", "rod_angle"):
        before = [log[name].sel(time=slice(None, 0.699)).values for log in (stuck, chosen)]
        assert before[0] == pytest.approx(before[1], abs=1e-9)
    assert final(stuck, "slip") == 0
    assert final(chosen, "slip") < -0.02
    assert abs(final(chosen, "rod_angle") - final(stuck, "rod_angle")) > 0.5
    assert chosen.attrs["on_ambiguity"] == (
        '[[0.0, "keep-contact"], [0.7, "slip-left"], [1.0, "stick"]]'
    )
    starts = np.flatnonzero(chosen.time == 0.7)
    assert [int(chosen.solutions[each]) for each in starts] == [3] * len(starts)


def test_modes_at_the_start_are_those_of_solve():
    for angle in range(-170, 171, 20):
        for scene in (make_scene(2, 2.0), make_scene(5, np.inf), make_scene(0.5, 0.3)):
            log = run(scene, heading(angle), 1e-3, samples=2)
            found = pp.solve(scene, np.deg2rad(angle))
            assert log.solutions[0] == len(found)
            kept = found.solutions[1 if len(found) > 1 else 0]
            assert log.mode[0] == kept.mode
            assert log.force[0].values == pytest.approx(kept.force, abs=1e-10)
            assert log.twist[0].values == pytest.approx(kept.twist, abs=1e-10)


@METHODS
def test_no_consistent_mode_stops_the_run_and_keeps_the_log(method):
    log = run(make_scene(2, DEFINITION_2), heading(165), 1, method=method)
    assert log.sizes["time"] == 1
    assert log.mode[0] == -1
    assert log.outcome[0] == pp.Outcome.INCONSISTENT
    assert log.attrs["stopped"] == "no contact mode is consistent"
    assert log.attrs["stopped_time"] == 0


def test_rod_that_comes_to_lie_along_the_fence_stops_the_run():
    log = check(run(make_scene(2, 2.0, psi=np.deg2rad(20)), heading(80), 8))
    assert "comes down to the fence" in log.attrs["stopped"]
    assert final(log, "rod_angle") == pytest.approx(0, abs=1e-10)


@METHODS
@pytest.mark.parametrize("effects", [FRICTION, BOTH], ids=["friction", "both"])
def test_large_friction_tends_to_infinite_friction_like_its_inverse(effects, method):
    infinite, *finite = (
        final(run(make_scene(5, mu, effects), heading(165), 1.0, method=method), "rod_angle")
        for mu in (np.inf, 1e3, 1e5)
    )
    errors = np.subtract(finite, infinite)
    assert errors[0] / errors[1] == pytest.approx(100, rel=2e-2)


def test_motion_center_crosses_the_ring():
    """Steps are graded towards the crossing, where the rates are no smoother than x / log x."""
    scene = make_scene(1.5, np.inf, psi=np.deg2rad(80))
    log, finer = (check(run(scene, heading(10), 3, samples=2, rtol=r)) for r in (1e-10, 1e-13))
    k = np.abs(log.spin_ratio.values)
    assert k.min() < 0.999 < 1.001 < k.max()
    assert final(log, "rod_angle") == pytest.approx(final(finer, "rod_angle"), abs=1e-8)
    assert final(log, "evaluations")[0] < 550


def test_fence_leaves_stands_and_comes_back():
    log = check(run(make_scene(2, 2.0), [(0, (0, -1)), (1, (0.2, 0)), (2, (0.2, 1))], 4))
    contact = log.time[log.mode != 0]
    assert contact[0] == pytest.approx(3, abs=1e-12)
    before = log.sel(time=slice(None, 2.999))
    assert np.all(before.rod_angle == before.rod_angle[0])
    assert final(log, "rod_angle") != before.rod_angle[0]


def test_fence_of_any_function_of_time_agrees_with_its_pieces():
    pieces = run(make_scene(2, 0.6), [(0, heading(60)), (1, heading(120))], 2)
    pusher = pp.Pusher(velocity=lambda t: heading(60 if t < 1 else 120), breakpoints=(1,))
    function = run(make_scene(2, 0.6), pusher, 2)
    assert final(function, "rod_angle") == pytest.approx(final(pieces, "rod_angle"), abs=1e-10)
    assert final(function, "slip") == pytest.approx(final(pieces, "slip"), abs=1e-10)


def test_smooth_start_turn_and_grazing_of_the_fence():
    def circles(t):
        return math.cos(2 * t), math.sin(2 * t)

    def touches_and_leaves(t):
        return 1.0, 0.3 * math.sin(t) ** 2

    def starts(t):
        return 0.0, t * t

    for velocity in (circles, touches_and_leaves, starts):
        log = check(run(make_scene(2, 0.6), pp.Pusher(velocity=velocity), 1.4))
        assert log.attrs["stopped"] == ""
        assert set(log.mode.values) & {1, 2, 3}
