"""Numbers of the report recomputed from the pressure of the ring, and from its mass, by integration.

The code that recomputes uses scipy alone. A number of the report is read as the report reads it, from data
that stand for the results of the paper's study.
"""

from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import brentq

from pulling_by_pushing.report.parts import mechanics
from pulling_by_pushing.report.results import Results

GOLDEN = Path("tests/golden")
PSI = np.pi / 4
#: Fence of Fig. 8.
PUSHER, LONG = np.deg2rad(165), 5.0


def around_ring(function, *kinks):
    """Mean over the ring of a function of a point of it."""
    kinks = sorted({-np.pi, np.pi, *kinks})
    parts = (
        quad(
            lambda a: function(np.cos(a), np.sin(a)), *ends, epsabs=1e-11, epsrel=1e-10, limit=400
        )[0]
        for ends in pairwise(kinks)
    )
    return sum(parts) / (2 * np.pi)


def friction(spin):
    """Force and torque of the pressure of a ring whose center moves along x with speed 1."""

    def velocity(x, y):
        u, v = 1 - spin * y, spin * x
        return u, v, np.hypot(u, v) or 1.0

    def along(x, y):
        u, _, speed = velocity(x, y)
        return u / speed

    def torque(x, y):
        u, v, speed = velocity(x, y)
        return (x * v - y * u) / speed

    kink = np.pi / 2 if spin > 0 else -np.pi / 2
    return around_ring(along, kink), around_ring(torque, kink)


def inertia(spin):
    """Force and torque of the mass of a ring whose center accelerates along x by 1."""
    return around_ring(lambda x, y: 1 - spin * y), around_ring(
        lambda x, y: x * (spin * x) - y * (1 - spin * y)
    )


def motion_under(effect, length, phi):
    """Spin and contact motion under a line of force through the contact at an angle; the center moves by 1.

    The force acts at the end of the rod; its torque about the center is that of the effect.
    """
    contact = -length * np.array([np.cos(PSI), np.sin(PSI)])
    arm = contact[0] * np.sin(phi) - contact[1] * np.cos(phi)

    def balance(spin):
        force, torque = effect(spin)
        return torque - arm * force

    spin = brentq(balance, -400, 400, xtol=1e-13)
    return spin, np.array([np.cos(phi) - spin * contact[1], np.sin(phi) + spin * contact[0]])


def edge(effect, length, mu, side):
    """Direction of the contact's motion under a force on an edge of the friction cone, degrees."""
    phi = np.pi / 2 - side * np.arctan(mu)
    _, motion = motion_under(effect, length, phi)
    return np.rad2deg(np.arctan2(motion[1], motion[0]))


def across(length):
    """Force at right angles to the rod under which the slider moves."""
    spin, _ = motion_under(friction, length, PSI + np.pi / 2)
    return friction(spin)[0]


def slip_share():
    """Speed of the slip over that of the fence, percent: the force is along the fence, to the left."""
    _, motion = motion_under(friction, LONG, np.pi)
    fence = np.array([np.cos(PUSHER), np.sin(PUSHER)])
    return 100 * abs(motion[0] * fence[1] / motion[1] - fence[0])


RECOMPUTED = {
    "velocity-cone-right": lambda: edge(friction, 2.0, 2.0, 1),
    "velocity-cone-left": lambda: edge(friction, 2.0, 2.0, -1),
    "infinite-cone-right": lambda: edge(friction, 5.0, np.inf, 1),
    "infinite-cone-left": lambda: edge(friction, 5.0, np.inf, -1),
    "first-without-solution": lambda: edge(friction, 2.0, np.inf, -1),
    "slip-motion-angle": lambda: edge(friction, LONG, np.inf, -1),
    "slip-share": slip_share,
    "force-across-rod": lambda: across(2.0),
    "force-across-long-rod": lambda: across(10.0),
    "acceleration-cone-right": lambda: edge(inertia, 2.0, 2.0, 1),
    "acceleration-cone-left": lambda: edge(inertia, 2.0, 2.0, -1),
    "infinite-acceleration-cone-right": lambda: edge(inertia, 2.0, np.inf, 1),
    "infinite-acceleration-cone-left": lambda: edge(inertia, 2.0, np.inf, -1),
    "ellipse-cone-right": lambda: edge(inertia, 1.0, 5.0, 1),
    "ellipse-cone-left": lambda: edge(inertia, 1.0, 5.0, -1),
}
NUMBERS = mechanics.QUASI_STATIC | mechanics.INFINITE_FRICTION | mechanics.DYNAMIC | mechanics.MODES


@pytest.fixture(scope="module")
def results(tmp_path_factory):
    """Results whose data are the golden data."""
    folder = tmp_path_factory.mktemp("results")
    (folder / "data").symlink_to(GOLDEN.resolve())
    return Results(folder, GOLDEN)


@pytest.mark.parametrize("name", RECOMPUTED)
def test_a_number_follows_from_the_integrals(results, name):
    quantity = NUMBERS[name]
    printed, exact = float(quantity.read(results)), RECOMPUTED[name]()
    assert printed == pytest.approx(exact, rel=1e-7)
    assert round(printed, quantity.digits) == pytest.approx(
        exact, abs=0.5001 * 10.0**-quantity.digits
    )


def test_another_rod_has_another_cone():
    assert abs(edge(friction, 2.001, 2.0, 1) - edge(friction, 2.0, 2.0, 1)) > 1e-3
