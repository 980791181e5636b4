"""Each method against certified values, how its error falls with its setting, and what it evaluates."""

import cProfile
import pstats

import numpy as np
import pytest
from evidence.costs.scenes import COUNTS, keep_scenes
from mpmath import mp, mpf

import reference as straight
from planar_pushing.core.supports.ring import ring_spin_ratio
from pulling_by_pushing.evidence.costs import measure
from pulling_by_pushing.evidence.costs.methods import METHODS, ROD_ANGLE, SPIN_RATIOS, edges

EPS = np.finfo(float).eps


@pytest.fixture(scope="module", params=COUNTS)
def accuracy(request):
    with pytest.MonkeyPatch.context() as patch:
        keep_scenes(patch, request.param)
        return measure.accuracy()


def of(accuracy, quantity, name):
    data = accuracy[quantity]
    return data.isel(point=np.flatnonzero(data.method.values == name))


def order(settings, errors):
    return np.polyfit(np.log(settings), np.log(errors), 1)[0]


# --- Certified values, and errors against them ---------------------------------------------------------


def exact(ball):
    return mpf(ball.mid().str(35, radius=False))


def test_wrenches_are_those_of_the_printed_integrals():
    with mp.workdps(40):
        for k in map(float, SPIN_RATIOS):
            force, torque = map(exact, measure.ring_wrench(k))
            assert abs(force / straight.ring_force(mpf(k)) - 1) < 1e-30
            assert abs(torque / straight.ring_torque(mpf(k)) - 1) < 1e-30


def test_motion_angles_are_those_of_the_printed_integrals():
    """A motion whose spin ratio has the arm of its force (Eqs. 7, 10-12)."""
    with mp.workdps(40):
        for length, phi in zip(*edges(), strict=True):
            angle, psi = exact(measure.edge_angle(float(length), float(phi))), mpf(ROD_ANGLE)
            turn, lean = mp.tan(mpf(phi) - angle), psi - mpf(phi)
            pull = turn / (mp.cos(lean) - turn * mp.sin(lean))
            k = abs(pull) / mpf(length)
            arm = abs(mpf(length) * mp.sin(lean))
            assert abs(straight.ring_torque(k) / straight.ring_force(k) / arm - 1) < 1e-25


def test_the_last_rod_angle_is_certified():
    ball = measure.last_rod_angle("slipping")
    assert float(ball.rad()) < 1e-20
    assert float(ball) == pytest.approx(33.4916431996514, abs=1e-12)


@pytest.mark.parametrize("change", [1e-6, -1e-9])
def test_a_wrench_that_is_off_has_that_error(change):
    force, torque = (np.array([float(each)]) for each in measure.ring_wrench(0.3))
    assert measure.wrench_error(0.3, force, torque) <= EPS
    assert measure.wrench_error(0.3, force, torque * (1 + change)) == pytest.approx(
        abs(change), rel=1e-5
    )
    assert measure.wrench_error(0.3, force, np.array([np.nan])) == np.inf


def test_an_edge_or_an_end_that_is_off_has_that_error():
    angles = np.array(
        [float(measure.edge_angle(*map(float, each))) for each in zip(*edges(), strict=True)]
    )
    off = angles + 1e-6 * (np.arange(angles.size) == 3)
    assert measure.cone_error(None, off) == pytest.approx(np.rad2deg(1e-6), rel=1e-5)
    end = float(measure.last_rod_angle("slipping"))  # which is certified once for all tests
    assert measure.motion_error("slipping", end + 1e-5) == pytest.approx(1e-5, rel=1e-5)


# --- Orders of convergence -----------------------------------------------------------------------------


def test_the_library_is_right_to_rounding(accuracy):
    assert (of(accuracy, "wrench", "closed form").wrench_error <= 4 * EPS).all()
    assert (of(accuracy, "cone", "closed form").cone_error < 1e-13).all()
    tight = of(accuracy, "motion", "event-driven").motion_error
    assert (tight[-2:] < 1e-9).all()


def test_the_trapezoid_rule_is_of_second_order_on_the_ring(accuracy):
    """The integrand has a kink there."""
    rule = of(accuracy, "wrench", "trapezoid").sel(spin_ratio=1.0)
    assert order(rule.setting, rule.wrench_error) == pytest.approx(-2, abs=0.02)


@pytest.mark.parametrize("k", [0.1, 3.0])
@pytest.mark.parametrize("name", ["trapezoid", "Gauss-Legendre"])
def test_rules_converge_geometrically_away_from_the_ring(accuracy, name, k):
    """Twice the points square the error, down to rounding."""
    error = of(accuracy, "wrench", name).wrench_error.sel(spin_ratio=k).values
    large = error[:-1][error[1:] > 64 * EPS]
    assert len(large) >= 1
    assert (error[1 : 1 + len(large)] < large**1.7).all()


def test_adaptive_rules_keep_their_tolerance_where_the_integrand_is_regular(accuracy):
    rule = of(accuracy, "wrench", "quad").sel(spin_ratio=[0.1, 0.9, 3.0])
    assert (rule.wrench_error <= np.maximum(10 * rule.setting, 64 * EPS)).all()


def test_a_root_finder_keeps_its_tolerance(accuracy):
    solver = of(accuracy, "cone", "brentq on quad").isel(point=slice(4))
    assert (np.deg2rad(solver.cone_error) <= 10 * solver.setting).all()


def test_steps_are_of_first_order(accuracy):
    steps = of(accuracy, "motion", "time-stepping")
    for error in steps.motion_error.values.T:
        assert order(steps.setting, error) == pytest.approx(-1, abs=0.02)


# --- Counts --------------------------------------------------------------------------------------------


def test_methods_that_evaluate_nothing_say_so(accuracy):
    for quantity, data in accuracy.items():
        counts = data.evaluations.values.reshape(data.sizes["point"], -1)
        assert ((counts > 0).all(axis=1) == (data.counted.values != "nothing")).all(), quantity


@pytest.mark.parametrize("name", ["trapezoid", "Gauss-Legendre"])
def test_rules_count_both_integrands_at_every_point(accuracy, name):
    rule = of(accuracy, "wrench", name)
    assert (rule.evaluations == 2 * rule.setting).all()


def test_our_inverse_evaluates_the_ring_once():
    for arm in (1e-8, 0.3, 0.999, 1.0, 1.5, 1e8):
        profile = cProfile.Profile()
        profile.runcall(ring_spin_ratio, arm)
        calls = {name: count for (*_, name), (count, *_) in pstats.Stats(profile).stats.items()}
        assert calls["inner_ring"] == 1


def test_settings_go_from_coarse_to_fine():
    for methods in METHODS.values():
        assert len({method.name for method in methods}) == len(methods)
        for method in methods:
            steps = np.diff(method.settings)
            assert (steps > 0).all() or (steps < 0).all()


def test_runs_in_a_batch_are_those_of_calls():
    """Of the two kinds of times of a run."""
    (method, *_) = METHODS["motion"]
    for scene in ("slipping", "pulling"):
        alone, batch = (method.run(scene, copies, 1e-6) for copies in (1, 3))
        assert batch == alone
