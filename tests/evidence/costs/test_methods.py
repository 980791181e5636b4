"""Each method against certified values, and how its error falls with its setting."""

import cProfile
import pstats

import numpy as np
import pytest
from mpmath import mp, mpf
from scipy.interpolate import CubicSpline

import reference as straight
from planar_pushing.core.ring import ring_spin_ratio
from planar_pushing.evidence.costs import tables
from planar_pushing.evidence.costs.inverses import ROD_ANGLE, edges, linear, tabulated
from planar_pushing.evidence.costs.methods import METHODS, rows
from planar_pushing.mechanics.wrench import ring_spin_ratios

EPS = np.finfo(float).eps


@pytest.fixture(scope="module")
def errors():
    return tables.accuracy_errors()


def of(errors, quantity, name):
    found = errors[quantity]
    return found.isel(point=np.flatnonzero(found.method.values == name))


# --- Errors are against certified values ---------------------------------------------------------------


def test_wrenches_are_those_of_the_printed_integrals():
    with mp.workdps(40):
        for k, (force, torque) in zip(tables.SPIN_RATIOS, tables.wrenches(), strict=True):
            for ball, exact in ((force, straight.ring_force), (torque, straight.ring_torque)):
                assert abs(mpf(ball.mid().str(35, radius=False)) / exact(mpf(k)) - 1) < 1e-30


def test_motion_angles_are_those_of_the_printed_integrals():
    """A motion whose spin ratio has the arm of its force (Eqs. 7, 10-12)."""
    with mp.workdps(40):
        for length, phi, ball in zip(*edges(), tables.motion_angles(), strict=True):
            angle, psi = mpf(ball.mid().str(35, radius=False)), mpf(ROD_ANGLE)
            turn, lean = mp.tan(mpf(phi) - angle), psi - mpf(phi)
            pull = turn / (mp.cos(lean) - turn * mp.sin(lean))
            k = abs(pull) / mpf(length)
            arm = abs(mpf(length) * mp.sin(lean))
            assert abs(straight.ring_torque(k) / straight.ring_force(k) / arm - 1) < 1e-25


@pytest.mark.parametrize("change", [1e-6, -1e-9])
def test_a_method_that_is_off_has_that_error(monkeypatch, change):
    method = METHODS["wrench"][0]

    def off(k, setting):
        force, torque, count = method.run(k, setting)
        return force * (1 + change), torque, count

    monkeypatch.setitem(METHODS, "wrench", (method._replace(run=off),))
    assert tables.wrench_errors().error.values == pytest.approx(abs(change), rel=1e-5)


def test_an_edge_that_is_off_has_that_error(monkeypatch):
    method = METHODS["cone"][0]

    def off(length, angle, setting):
        found, count = method.run(length, angle, setting)
        return found + 1e-6 * (np.arange(found.size) == 3), count

    monkeypatch.setitem(METHODS, "cone", (method._replace(run=off),))
    assert tables.cone_errors().cone_error.values == pytest.approx(np.rad2deg(1e-6), rel=1e-5)


def test_a_result_that_is_no_number_has_an_infinite_error(errors):
    found = of(errors, "wrench", "textbook E and K").error.sel(spin_ratio=1.0)
    assert np.isinf(found).all()


# --- Orders of convergence -----------------------------------------------------------------------------


def order(settings, errors):
    return np.polyfit(np.log(settings), np.log(errors), 1)[0]


def test_the_trapezoid_rule_is_of_second_order_on_the_ring(errors):
    """The integrand has a kink there."""
    found = of(errors, "wrench", "trapezoid")
    assert order(found.setting, found.error.sel(spin_ratio=1.0)) == pytest.approx(-2, abs=0.02)


@pytest.mark.parametrize("k", [0.1, 3.0])
def test_rules_converge_geometrically_away_from_the_ring(errors, k):
    """Twice the points square the error, down to rounding."""
    for name in ("trapezoid", "Gauss-Legendre"):
        error = of(errors, "wrench", name).error.sel(spin_ratio=k).values
        large = error[:-1][error[1:] > 64 * EPS]
        assert len(large) >= 1
        assert (error[1 : 1 + len(large)] < large**1.7).all()


def test_gauss_legendre_is_regular_on_the_ring(errors):
    """The kink is at an end of its range."""
    error = of(errors, "wrench", "Gauss-Legendre").error.sel(spin_ratio=1.0)
    assert (error[2:] < 64 * EPS).all()


@pytest.mark.parametrize("name", ["quad", "tanhsinh"])
def test_adaptive_rules_keep_their_tolerance_where_the_integrand_is_regular(errors, name):
    found = of(errors, "wrench", name).sel(spin_ratio=[0.1, 0.9, 3.0])
    limit = np.maximum(10 * found.setting, 64 * EPS)
    assert (found.error <= limit).all()


def test_root_finders_keep_their_tolerance(errors):
    for name in ("find_root", "brentq on quad"):
        found = of(errors, "cone", name)
        coarse = found.isel(point=np.flatnonzero(found.setting.values >= 1e-8))
        assert (np.deg2rad(coarse.cone_error) <= 10 * coarse.setting).all()


@pytest.mark.parametrize(("interpolation", "expected"), [(linear, -2), (CubicSpline, -4)])
def test_tables_have_their_order_where_the_inverse_is_smooth(interpolation, expected):
    arms = np.linspace(0.3, 0.6, 301)
    exact, sizes = ring_spin_ratios(arms), [32, 64, 128, 256]
    table = tabulated(interpolation)
    found = [np.abs(table(arms, float(size))[0] - exact).max() for size in sizes]
    assert order(sizes, found) == pytest.approx(expected, abs=0.25)


def test_tables_gain_less_next_to_a_tangent(errors):
    """The slope of the inverse is singular where a line of force touches the ring."""
    for name in ("linear table", "cubic table"):
        found = of(errors, "cone", name)
        assert -2 < order(found.setting, found.cone_error) < -1
        assert (np.diff(found.cone_error) < 0).all()


def test_the_closed_form_is_right_to_rounding(errors):
    assert (errors["wrench"].error[0] <= 4 * EPS).all()
    assert errors["cone"].cone_error[0] < 1e-13


# --- Counts --------------------------------------------------------------------------------------------


def test_methods_that_evaluate_nothing_say_so(errors):
    for quantity, found in errors.items():
        counts = found.evaluations.values.reshape(found.sizes["point"], -1)
        assert ((counts > 0).all(axis=1) == (found.counted.values != "nothing")).all(), quantity


def test_rules_count_both_integrands_at_every_point(errors):
    for name in ("trapezoid", "Gauss-Legendre"):
        found = of(errors, "wrench", name)
        assert (found.evaluations == 2 * found.setting).all()


def test_our_inverse_evaluates_the_ring_once():
    for arm in (1e-8, 0.3, 0.999, 1.0, 1.5, 1e8):
        profile = cProfile.Profile()
        profile.runcall(ring_spin_ratio, arm)
        calls = {name: count for (*_, name), (count, *_) in pstats.Stats(profile).stats.items()}
        assert calls["inner_ring"] == 1


def test_settings_go_from_coarse_to_fine():
    for quantity in METHODS:
        names = [method.name for method, _ in rows(quantity)]
        assert len(set(names)) == len(METHODS[quantity])
        for method in METHODS[quantity]:
            steps = np.diff(method.settings)
            assert (steps > 0).all() or (steps < 0).all()
