"""Friction of any support on a free slider in one step, against the ring and the least potential."""

import numpy as np
import pytest

import planar_pushing as pp
from planar_pushing.mechanics.effects.any_mass import MassAt
from planar_pushing.mechanics.effects.any_support import Supports
from planar_pushing.mechanics.effects.base import gradient, made
from planar_pushing.mechanics.effects.inertia import Mass
from planar_pushing.mechanics.effects.support_friction import RingSupport
from planar_pushing.mechanics.plane import rod
from planar_pushing.mechanics.supports.pressure.table import table_of
from planar_pushing.simulation.steps.slowing import slowed

OWN = rod(2.0, 0.8)
MOTIONS = [(1.0, 0.5, 0.3), (0.3, -0.2, 2.0), (1.0, 0.0, 0.0), (0.0, 0.0, -1.0), (0.02, 0.01, 0.02)]
SQUARE = pp.Polygon([(-1, -1), (1, -1), (1, 1), (-1, 1)])


def effects(support, x=0.0, y=0.0):
    kinds = Supports(table_of([support])), MassAt(1.0, 1.0, 0.0, 0.0)
    return made(kinds, np.array([0.7, 1.3, 0.64, x, y, 0.0, 1.0]))


@pytest.mark.parametrize("before", MOTIONS, ids=str)
@pytest.mark.parametrize("size", [0.01, 1.0])
def test_a_ring_brakes_as_the_ring(before, size):
    found = slowed(effects(pp.Ring(1.0)), OWN, *before, size)
    ring = slowed((RingSupport(0.7), Mass(1.3, 0.64)), OWN, *before, size)
    assert found == pytest.approx(ring, rel=1e-9, abs=1e-10)


@pytest.mark.parametrize("before", MOTIONS, ids=str)
def test_what_a_step_takes_is_the_friction_at_its_end(before):
    friction, mass = effects(SQUARE, 0.3, -0.2)
    after = slowed((friction, mass), OWN, *before, 0.005)
    assert any(after)
    turn = np.array([[OWN.x, OWN.y], [-OWN.y, OWN.x]])  # into the body frame
    lost = turn @ np.subtract(before[:2], after[:2])
    (v_x, v_y), spin = turn @ after[:2], after[2]
    f_x, f_y, torque = gradient(friction, v_x - 0.2 * spin, v_y - 0.3 * spin, spin)[:3]
    assert 1.3 * lost == pytest.approx(0.005 * np.array([f_x, f_y]), rel=1e-8, abs=1e-11)
    about = torque - (0.3 * f_y + 0.2 * f_x)
    assert 1.3 * 0.64 * (before[2] - spin) == pytest.approx(0.005 * about, rel=1e-8, abs=1e-11)


@pytest.mark.parametrize("before", MOTIONS, ids=str)
def test_a_long_step_brings_the_slider_to_rest(before):
    assert slowed(effects(SQUARE, 0.3, -0.2), OWN, *before, 100.0) == (0.0, 0.0, 0.0)
