"""Numbers that the report computes from a dataset, against computations without the library."""

import numpy as np
import pytest
from scipy import special
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

import planar_pushing as pp
from pulling_by_pushing.report.derived import bound_reach, pull_end
from pulling_by_pushing.study.store import read_dataset

LOG = "tests/golden/simulations/pulling.nc"
#: Length of its rod.
LENGTH = 3.0


def rough_cones(length):
    """The paper's bound and the exact cone of both effects under infinite friction, degrees."""
    slider = pp.Slider(rod_length=length, rod_angle=np.pi / 4)
    effects = (pp.RingFriction(), pp.Inertia())
    scene = pp.Scene(slider=slider, contact=pp.InfiniteFriction(), effects=effects)
    return pp.conservative_motion_cone(scene).degrees, pp.motion_cone(scene).degrees


@pytest.mark.parametrize(
    ("length", "bound", "slips"),
    [
        (0, 180, False),
        (1e-3, 180, True),
        (1.3, 180, True),
        (np.sqrt(2) - 1e-9, 180, True),
        (np.sqrt(2) + 1e-9, 153.4349488, True),
        (1.5, 152.7642761, True),
    ],
)
def test_the_bound_shows_no_slip_for_rods_up_to_its_reach(length, bound, slips):
    """Left edges: of the bound, up to the square root of two, and of the exact cone."""
    (_, shown), (_, exact) = rough_cones(length)
    assert shown == pytest.approx(bound, abs=1e-7)
    assert (exact < 180) == slips
    reach = bound_reach(read_dataset("tests/golden/acceleration_centers.nc"))
    assert reach == pytest.approx(np.sqrt(2), rel=1e-10)


def spun(ratio, force_angle, rod_angle):
    """Velocity of the contact for a center that moves at 1 along the force."""
    turn, along = ratio * LENGTH, np.array([np.sin(rod_angle), -np.cos(rod_angle)])
    return np.array([np.cos(force_angle), np.sin(force_angle)]) + turn * along


def spin_ratio_of(arm):
    """Spin ratio of a ring with a positive moment arm, from the complete elliptic integrals."""

    def ratio(k):
        first, second = special.ellipk(k**2), special.ellipe(k**2)
        return (second - (1 - k**2) * first) / (k * second)

    if arm > 1:
        return 1 / spin_ratio_of(1 / arm)
    return brentq(lambda k: ratio(k) - arm, 1e-12, np.nextafter(1, 0), xtol=1e-15)


def stuck(rod_angle, pusher_angle):
    """Force angle and angular velocity while the contact sticks.

    A slider that turns to the right is the mirror image, in the rod, of one that turns to the left.
    """
    if pusher_angle > rod_angle:
        force, rate = stuck(rod_angle, 2 * rod_angle - pusher_angle)
        return 2 * rod_angle - force, -rate

    def beside(force_angle):
        ratio = spin_ratio_of(LENGTH * np.sin(rod_angle - force_angle))
        x, y = spun(ratio, force_angle, rod_angle)
        return y * np.cos(pusher_angle) - x * np.sin(pusher_angle), ratio / np.hypot(x, y)

    force = brentq(lambda angle: beside(angle)[0], 1e-3, rod_angle - 1e-6, xtol=1e-15)
    return force, beside(force)[1]


def test_a_pull_ends_where_the_force_leaves_the_cone():
    """By integration of the balance of torque, without the library."""
    push, pull, edge = np.deg2rad(60), np.deg2rad(-20), np.pi / 2 - np.arctan(2)
    options = {"rtol": 1e-10, "atol": 1e-12}

    def margin(_, y):
        return stuck(y[0], pull)[0] - edge

    margin.terminal = True
    start = solve_ivp(lambda _, y: [stuck(y[0], push)[1]], (0, 0.4), [np.deg2rad(35)], **options)
    pulled = solve_ivp(
        lambda _, y: [stuck(y[0], pull)[1]], (0.4, 3), start.y[:, -1], events=margin, **options
    )
    log = read_dataset(LOG)
    assert pull_end(log, "time") == pytest.approx(pulled.t_events[0][0], abs=1e-7)
    angle = np.rad2deg(pulled.y_events[0][0, 0])
    assert pull_end(log, "rod_angle") == pytest.approx(angle, abs=1e-6)


def test_a_pull_that_does_not_end_is_not_printed():
    log = read_dataset(LOG)
    assert np.isnan(pull_end(log.sel(time=slice(0.0, 0.9)), "time"))
