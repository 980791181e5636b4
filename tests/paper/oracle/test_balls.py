"""Signs that are never guessed, exact directions, and what roundings allow."""

import math

import pytest
from flint import arb, ctx, fmpq

from pulling_by_pushing.oracle.balls import (
    PRECISION,
    Number,
    Undecided,
    at_degrees,
    at_radians,
    cone_edge,
    precise,
    rational,
    settle,
    sign,
)


@pytest.fixture(autouse=True)
def _precision():
    with ctx.workprec(PRECISION):
        yield


def test_sign_of_balls():
    assert [sign(arb(x)) for x in (-2, 0, 3)] == [-1, 0, 1]
    with pytest.raises(Undecided):
        sign(arb(0, 1e-30))


def test_a_tie_is_settled_by_exact_arithmetic_only():
    tie, near = arb(0, 1e-30), arb(1e-40, 1e-30)
    sine, other = (at_degrees(angle).exact[1] for angle in (30, 31))
    assert sign(tie, lambda: sine - fmpq(1, 2)) == 0
    with pytest.raises(Undecided):
        sign(near, lambda: sine - other)


def test_rounding_does_not_decide():
    tiny = Number(arb(1e-15), arb(1))
    with pytest.raises(Undecided, match="rounding decides"):
        settle(tiny)
    assert settle(tiny._replace(rounding=arb(1e-3))) == 1
    assert settle(Number(arb(0, 1e-40), arb(1)), lambda: fmpq(0)) == 0


@pytest.mark.parametrize("degrees", [0, 15, 22.5, -170, 359])
@pytest.mark.parametrize("rod", [fmpq(0), fmpq(45), fmpq(165)])
def test_exact_directions_are_unit_vectors_in_any_frame(degrees, rod):
    direction = at_degrees(degrees).about(rod)
    x, y = direction.exact
    assert sign(arb(0, 1), lambda: x * x + y * y - 1) == 0
    angle = math.radians(degrees - float(rod.p) / float(rod.q))
    assert list(map(float, direction.ball)) == pytest.approx([math.cos(angle), math.sin(angle)])


@pytest.mark.parametrize(("mu", "degrees"), [(0.0, 90), (1.0, 45), (math.inf, 0)])
def test_edges_of_a_cone(mu, degrees):
    for side in (1, -1):
        edge = cone_edge(mu, side)
        assert edge.angle.overlaps(arb(90 + side * (degrees - 90)))
        across = edge.about(fmpq(degrees)) if side > 0 else None
        assert across is None or across.sign(lambda _, y: y) == 0


def test_other_directions_are_not_exact():
    assert at_degrees(fmpq(1, 7)).exact is None
    assert at_radians(0.5).exact is None
    assert float(at_radians(0.5).angle) == pytest.approx(math.degrees(0.5))


def test_doubles_are_exact():
    assert rational(0.1) != fmpq(1, 10)
    assert float(rational(0.1).p) / float(rational(0.1).q) == 0.1


def test_what_is_undecided_is_tried_again_at_a_finer_precision():
    tried = []

    @precise
    def third():
        tried.append(ctx.prec)
        if len(tried) == 1:
            raise Undecided("coarse")
        return arb(1) / 3

    assert third().rel_accuracy_bits() > PRECISION
    assert tried[0] == PRECISION < tried[1]
