"""Enclosed sticking motions: the inverse of the motions under a line of force, and pivots."""

import pytest
from flint import arb, ctx, fmpq

from certified.supports.cases import SQUARE, SUPPORTS, TRIPOD
from planar_pushing.certified.balls import PRECISION, in_degrees, rational
from planar_pushing.certified.supports.moving import moved
from planar_pushing.certified.supports.pressure.pieces import pieces
from planar_pushing.certified.supports.push import at_angle
from planar_pushing.certified.supports.sticking import stuck, torque


@pytest.fixture(autouse=True)
def _precision():
    with ctx.workprec(PRECISION):
        yield


def along(entry, length, turn):
    support = pieces(entry)
    return stuck(lambda: at_angle(support, rational(length), fmpq(0), rational(turn)))


@pytest.mark.parametrize("name", ["ring", "square", "L", "map", "points", "segment", "composite"])
@pytest.mark.parametrize("turn", [-100, 20, 75, 160])
def test_the_force_of_a_sticking_motion_causes_it(name, turn):
    support, found = pieces(SUPPORTS[name]), along(SUPPORTS[name], 2, turn)
    x, y = found.force
    angle = in_degrees(arb.atan2(y, x))
    force = rational(float(angle))
    back = moved(lambda: at_angle(support, fmpq(2), fmpq(0), force))
    motion = float(force) + float(back.turns[0])
    assert abs((motion - turn + 180) % 360 - 180) < 1e-11


def test_no_torque_about_the_contact():
    found = along(SQUARE, 2, 30)
    push = at_angle(pieces(SQUARE), fmpq(2), fmpq(0), fmpq(30))
    balance, _ = torque(push, found.spin.mid())
    assert abs(float(balance)) < 1e-40


def test_a_motion_along_the_rod_of_a_centred_slider_is_a_translation():
    found = along(SQUARE, 2, 0)
    assert (found.spin, found.force, found.free) == (0, (1, 0), (0, 0))


def test_a_pivot_leaves_the_force_open():
    """Across the line from the contact to the first foot; its share is a third."""
    found, support = along(TRIPOD, 2, 90), pieces(TRIPOD)
    assert found.pivot == 0
    assert abs(float(found.spin) - -1 / 3) < 1e-15
    for side in (-1, 1):
        x, y = (f + side * free for f, free in zip(found.force, found.free, strict=True))
        off = float(in_degrees(arb.atan2(y, x))) - 90
        for part, pivot in ((0.999, 0), (1.001, -1)):
            push = at_angle(support, fmpq(2), fmpq(0), rational(90 + part * off))
            assert moved(lambda push=push: push).pivot == pivot


@pytest.mark.parametrize("turn", [10, 45, 90 - 45, -30])
def test_beyond_a_corner_the_force_is_across_the_line(turn):
    segment = {"shape": "segment", "start": (0, -1), "end": (0, 1)}
    found = along(segment, 1, turn)
    assert found.force == (1, 0)


def test_within_the_ends_of_a_line_it_is_not():
    segment = {"shape": "segment", "start": (0, -1), "end": (0, 1)}
    found = along(segment, 1, 50)
    assert abs(found.force[1]) > arb(10) ** -4
