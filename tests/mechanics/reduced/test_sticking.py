"""Motions of a contact that sticks, against the conditions of the least potential."""

import numpy as np
import pytest

from planar_pushing.mechanics.effects.base import response
from planar_pushing.mechanics.effects.inertia import Mass
from planar_pushing.mechanics.effects.support_friction import RingSupport
from planar_pushing.mechanics.plane import contact_motion, rod, toward
from planar_pushing.mechanics.reduced.base import held_on_edge, stick

RING, MASS = RingSupport(0.7), Mass(1.3, 2.5)
KINDS = {"friction": (RING,), "inertia": (MASS,), "both": (RING, MASS)}
LENGTHS = [1e-6, 0.5, 2.0, 1e4]
ANGLES = [-2.5, 0.3, 1.1, 2.9]

every_kind = pytest.mark.parametrize("effects", KINDS.values(), ids=KINDS)


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


@every_kind
@pytest.mark.parametrize("length", LENGTHS)
@pytest.mark.parametrize("angle", ANGLES)
def test_the_contact_moves_as_it_is_told_and_meets_no_torque(effects, length, angle):
    own = rod(length, 0.8)
    found = stick(effects, own, toward(own, angle))
    velocity, spin = np.array([found.v_x, found.v_y]), found.spin
    moved = contact_motion(own, *velocity, spin)
    assert moved == pytest.approx((np.cos(angle), np.sin(angle)), abs=1e-12)
    force, torque = response(effects, np.hypot(*velocity), abs(spin))[:2]
    assert (found.f_x, found.f_y) == pytest.approx(
        tuple(force * velocity / np.hypot(*velocity)), rel=1e-12, abs=1e-14 * force
    )
    arm = length * cross((found.f_x, found.f_y), (own.x, own.y))
    assert arm == pytest.approx(np.copysign(torque, spin), rel=1e-11, abs=2e-15 * length * force)
    assert cross((found.along, found.aside), (own.x * found.f_x + own.y * found.f_y,
                 own.y * found.f_x - own.x * found.f_y)) == pytest.approx(0, abs=1e-13)  # fmt: skip
    assert (found.free_along, found.free_aside, found.pivot) == (0.0, 0.0, -1)


@every_kind
@pytest.mark.parametrize("length", LENGTHS)
def test_a_motion_whose_force_is_on_the_edge_is_held_as_it_is(effects, length):
    own = rod(length, 0.8)
    moved = stick(effects, own, toward(own, 1.1))
    edge = toward(own, np.arctan2(moved.f_y, moved.f_x))
    held = held_on_edge(effects, own, edge, moved)
    for name in ("v_x", "v_y", "spin", "f_x", "f_y"):
        assert getattr(held, name) == pytest.approx(getattr(moved, name), rel=1e-7, abs=1e-10)
    assert cross((held.f_x, held.f_y), (edge.x, edge.y)) == pytest.approx(0, abs=1e-14)


def test_along_the_rod_nothing_turns():
    own = rod(2.0, 0.8)
    found = stick(KINDS["both"], own, toward(own, own.angle))
    assert found.spin == 0.0
    assert np.hypot(found.f_x, found.f_y) == pytest.approx(0.7 + 1.3, rel=1e-15, abs=0)
