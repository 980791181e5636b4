"""Friction on a free slider in one step, against the conditions of the least potential."""

import pytest

from planar_pushing.mechanics.effects.base import response
from planar_pushing.mechanics.effects.inertia import Mass
from planar_pushing.mechanics.effects.support_friction import RingSupport
from planar_pushing.mechanics.plane import rod
from planar_pushing.simulation.steps.slowing import slowed

EFFECTS, OWN = (RingSupport(0.7), Mass(1.3, 0.64)), rod(2.0, 0.8)
MOTIONS = [(1.0, 0.5), (0.3, 2.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1e-9), (1e-9, 1.0), (0.02, 0.02)]


@pytest.mark.parametrize("before", MOTIONS, ids=str)
def test_what_a_step_takes_is_the_friction_at_its_end(before):
    speed, across, spin = slowed(EFFECTS, OWN, before[0], 0.0, before[1], 0.01)
    assert across == 0.0
    force, torque = response(EFFECTS[:1], speed, spin)[:2]
    assert 1.3 * (before[0] - speed) == pytest.approx(0.01 * force, rel=1e-10, abs=1e-14)
    assert 1.3 * 0.64 * (before[1] - spin) == pytest.approx(0.01 * torque, rel=1e-10, abs=1e-14)


@pytest.mark.parametrize("before", MOTIONS, ids=str)
def test_friction_stops_what_lies_inside_the_limit_curve(before):
    """Along a ray of motions the momentum leaves the limit curve once."""
    stops = [
        slowed(EFFECTS, OWN, 0.0, part * before[0], part * before[1], 1.0)
        for part in (0.1, 0.2, 10, 100)
    ]
    assert stops[0] == (0.0, 0.0, 0.0)
    assert max(stops[-1]) > 0.0


def test_without_friction_nothing_changes():
    assert slowed(EFFECTS[1:], OWN, 0.4, -0.2, 0.8, 0.01) == (0.4, -0.2, 0.8)
