"""Forces at the contact of a slider with inertia."""

import numpy as np
import pytest

from planar_pushing.simulation.legacy.motion import contact_at
from planar_pushing.simulation.rows import records
from planar_pushing.simulation.systems import base, contact
from planar_pushing.simulation.systems.frame import contact_motion, frame_of, pose_at

VECTORS = [(1.0, 0.0), (0.0, 1.0), (-0.6, 0.8)]


def slider(length, mu=0.5):
    body = records(base.BODY, 1)[0]
    body.length, body.mass, body.moment, body.slips, body.closed = length, 1.3, 0.8, True, True
    body.right_angle, body.left_angle = np.arctan2(1, mu), np.arctan2(1, -mu)
    for edge, angle in ((body.right, body.right_angle), (body.left, body.left_angle)):
        edge[:] = np.cos(angle), np.sin(angle)
    return body


def pose(length):
    """The slider at an angle, its center of mass at its center."""
    return pose_at(frame_of(0.7), contact_at(-length, 0.0), (0.0, 0.0))


@pytest.mark.parametrize("vector", VECTORS, ids=str)
@pytest.mark.parametrize("length", [0.0, 1e-6, 2.0, 1e4])
def test_the_force_of_a_stick_takes_the_acceleration_away(length, vector):
    body, own = slider(length), pose(length)
    f_x, f_y, *after = contact.pushed_in(body, own.arm_x, own.arm_y, base.STICK, *vector)
    turn = contact.moment_of(own.arm_x, own.arm_y, f_x, f_y) / body.moment
    found = contact_motion(own, f_x / body.mass, f_y / body.mass, turn)
    assert found == pytest.approx(-np.array(vector), abs=1e-8)
    assert found == pytest.approx(contact.pushed(body, own.arm_x, own.arm_y, f_x, f_y), abs=1e-8)
    assert after == [0.0, 0.0]


@pytest.mark.parametrize("kind", [base.SLIP_RIGHT, base.SLIP_LEFT])
def test_the_force_of_a_slip_lies_on_its_edge_and_keeps_the_contact_on_the_fence(kind):
    body, own = slider(2.0), pose(2.0)
    f_x, f_y, a_x, a_y = contact.pushed_in(body, own.arm_x, own.arm_y, kind, 0.3, -1.0)
    pushed = contact.pushed(body, own.arm_x, own.arm_y, f_x, f_y)
    assert np.arctan2(f_y, f_x) == pytest.approx(contact.edge_of(body, kind)[2])
    assert (0.3 + pushed[0], -1.0 + pushed[1]) == pytest.approx((a_x, a_y), abs=1e-15)


def test_only_impulses_in_the_cone_are_admitted():
    body = slider(2.0)
    inside, on_edge, outside = (0.0, 1.0), (0.5, 1.0), (0.6, 1.0)
    assert [contact.admits(body, *p) for p in (inside, on_edge, outside)] == [True, True, False]
    assert not contact.admits(body, 0.0, 0.0)
