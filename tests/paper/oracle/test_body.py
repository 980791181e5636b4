"""The wrench is the gradient of the effects' potential, for every support and effect."""

import pytest
from flint import arb, ctx, fmpq
from oracle.cases import SUPPORTS
from oracle.sliders import PIECES

from pulling_by_pushing.oracle.balls import PRECISION, Undecided, dot
from pulling_by_pushing.oracle.body import Body

STEP = arb(2) ** -50
MOTION = (fmpq(3, 10), fmpq(-7, 10), fmpq(2, 5))


@pytest.fixture(autouse=True)
def _precision():
    with ctx.workprec(2 * PRECISION):
        yield


def body(name):
    """Friction, inertia aside, viscous friction and a load."""
    return Body(
        length=fmpq(3, 2), support=PIECES[name], weight=fmpq(2), mass=fmpq(1, 3), gyration=fmpq(1, 2),
        mass_center=(fmpq(1, 5), fmpq(-1, 7)), viscous=fmpq(1, 4), load=(fmpq(1, 9), fmpq(-1, 8), fmpq(1,
        3)),
    )  # fmt: skip


def potential(one, q):
    """W |omega| D(c) and the quadratic and linear parts."""
    center = -q[1] / q[2] - one.length, q[0] / q[2]
    friction = one.weight * abs(q[2]) * one.support.dgh(center)[0]
    return friction + dot(q, [dot(row, q) for row in one.matrix]) / 2 - dot(one.load, q)


def moved(q, i, step):
    return [part + step * (k == i) for k, part in enumerate(q)]


@pytest.mark.parametrize("name", SUPPORTS)
def test_the_wrench_is_the_gradient_of_the_potential(name):
    one = body(name)
    for sense in (1, -1):
        q = [arb(sense * part) for part in MOTION]
        for i, part in enumerate(one.wrench(q).value):
            rise = potential(one, moved(q, i, STEP)) - potential(one, moved(q, i, -STEP))
            assert abs(part - rise / (2 * STEP)) < 1e-24


@pytest.mark.parametrize("omega", ["0.4", "-0.001", "0"])
@pytest.mark.parametrize("name", SUPPORTS)
def test_the_jacobian_is_the_slope_of_the_wrench(name, omega):
    one, q = body(name), [*map(arb, MOTION[:2]), arb(omega)]
    jacobian = one.wrench(q).jacobian
    for k in range(3):
        ends = [one.wrench(moved(q, k, side * STEP)).value for side in (1, -1)]
        for i in range(3):
            assert abs(jacobian[i][k].mid() - (ends[0][i] - ends[1][i]) / (2 * STEP)) < 1e-12


@pytest.mark.parametrize("name", SUPPORTS)
def test_balls_around_a_translation_contain_slow_rotations(name):
    one, width = body(name), arb(2) ** -40
    wide = one.wrench([*map(arb, MOTION[:2]), arb(0, width)])
    for omega in (width, -width / 3):
        narrow = one.wrench([*map(arb, MOTION[:2]), omega])
        assert all(a.contains(b) for a, b in zip(wide.value, narrow.value, strict=True))
        for rows in zip(wide.jacobian, narrow.jacobian, strict=True):
            assert all(a.contains(b) for a, b in zip(*rows, strict=True))


def test_rest_is_undecided():
    with pytest.raises(Undecided):
        body("ring").wrench([arb(0, 1), arb(0, 1), arb(0, 1)])


@pytest.mark.parametrize("name", SUPPORTS)
def test_the_magnitudes_of_terms_bound_the_wrench(name):
    wrench = body(name).wrench([*map(arb, MOTION)])
    assert all(abs(value) < size for value, size in zip(wrench.value, wrench.size, strict=True))
