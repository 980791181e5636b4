"""Enclosed moments of supports: published values, defining integrals, plain quadrature, derivatives."""

import pytest
from flint import arb, ctx, fmpq
from mpmath import mp, mpf

from certified.supports.cases import CENTERS, SQUARE, SUPPORTS, TRIPOD
from planar_pushing.certified.balls import PRECISION, Undecided
from planar_pushing.certified.supports.pressure.integrals import printed
from planar_pushing.certified.supports.pressure.moments import moments
from planar_pushing.certified.supports.pressure.pieces import pieces

ORIGIN = arb(0), arb(0)
#: D, G_x, G_y and the torque about the origin, known from numerical integrals.
PUBLISHED = [
    (
        SQUARE,
        (0.3, 0.2),
        (0.822023641611253, -0.260676603222042, -0.172647824905904, 0.70929109566346),
    ),
    (
        SQUARE,
        (1, 1),
        (1.530391432928425, -0.647793574696319, -0.647793574696319, 0.234804283535787),
    ),
    (SQUARE, (5, 0), (5.03357516526378, -0.993189332404797, 0, 0.067628503239797)),
    (
        TRIPOD,
        (0.3, 0.2),
        (1.033929193673725, -0.135743710409409, -0.144909039717126, 0.964224272607477),
    ),
    (SUPPORTS["ring"], (1, 0), (4 / mp.pi, -2 / mp.pi, 0, 2 / mp.pi)),
]
#: D, |G| and the torque of a disc.
DISCS = [
    (0.5, (0.789670232587264, 0.483843755630126, 0.547748354772201)),
    (1, (32 / (9 * mp.pi), 8 / (3 * mp.pi), 8 / (9 * mp.pi))),
    (100, (100.0012500052084, 0.999987499843745, 0.0025000208339193)),
]


@pytest.fixture(autouse=True)
def _precision():
    with ctx.workprec(PRECISION):
        yield


def at(entry, place):
    """Moments and the torque about the origin."""
    c = tuple(map(arb, place))
    found = moments(pieces(entry), c)
    return found, found.torque(c, ORIGIN)


@pytest.mark.parametrize(("entry", "place", "values"), PUBLISHED)
def test_published_values(entry, place, values):
    found, torque = at(entry, place)
    for ball, value in zip((*found[:3], torque), values, strict=True):
        assert abs(float(ball) - value) < 2e-15


@pytest.mark.parametrize(("place", "values"), DISCS)
def test_published_values_of_a_disc(place, values):
    found, torque = at({"shape": "disc", "radius": 1}, (0, place))
    assert found.x == 0
    for ball, value in zip((found.distance, -found.y, torque), values, strict=True):
        assert abs(float(ball) / value - 1) < 2e-15


def test_the_torque_far_away_keeps_its_digits():
    _, torque = at(SQUARE, (1e6, 0))
    assert abs(float(torque) / 3.333333333334556e-7 - 1) < 4e-16


@pytest.mark.parametrize("place", CENTERS)
@pytest.mark.parametrize("name", SUPPORTS)
def test_closed_forms_overlap_the_defining_integrals(name, place):
    support, c = pieces(SUPPORTS[name]), tuple(map(arb, place))
    for closed, integral in zip(moments(support, c)[:3], printed(support, c), strict=True):
        assert closed.overlaps(integral)
        assert max(closed.rad(), integral.rad()) < arb(10) ** -45


@pytest.mark.parametrize("place", CENTERS)
@pytest.mark.parametrize("name", SUPPORTS)
def test_second_derivatives_are_those_of_the_distance(name, place):
    support, step = pieces(SUPPORTS[name]), arb(2) ** -40
    x, y = map(arb, place)
    found = moments(support, (x, y))
    ends = [moments(support, (x + side * step, y)) for side in (-1, 1)]
    others = [moments(support, (x, y + side * step)) for side in (-1, 1)]
    slopes = [
        (ends[0].x - ends[1].x) / (2 * step),
        (ends[0].y - ends[1].y) / (2 * step),
        (others[0].y - others[1].y) / (2 * step),
    ]
    for second, slope in zip(found[3:], slopes, strict=True):
        assert abs(float(second - slope)) < 1e-18


def test_plain_quadrature_of_a_plate():
    """Means over the square, without any of the formulas."""
    c = mpf("1.7"), mpf("0.4")
    with mp.workdps(16):

        def mean(part):
            def value(x, y):
                rho = mp.hypot(x - c[0], y - c[1])
                return (rho, (x - c[0]) / rho, (y - c[1]) / rho)[part]

            return mp.quad(value, [-1, 1], [-1, 1]) / 4

        found, _ = at(SQUARE, c)
        for part in range(3):
            assert abs(float(found[part]) - mean(part)) < 1e-12


@pytest.mark.parametrize("name", SUPPORTS)
def test_balls_hold_the_values_within(name):
    support, step = pieces(SUPPORTS[name]), arb(2) ** -60
    x, y = map(arb, CENTERS[1])
    wide = moments(support, (x + arb(0, step), y + arb(0, step)))
    for side in (-1, 0, 1):
        narrow = moments(support, (x + side * step, y - side * step))
        assert all(one.contains(other) for one, other in zip(wide, narrow, strict=True))


@pytest.mark.parametrize("name", ["square", "L", "map"])
def test_balls_on_an_edge_are_bounded(name):
    """``h log h`` stays small next to an edge."""
    support = pieces(SUPPORTS[name])
    (a, b), (c, d) = support.edges[0].start, support.edges[0].end
    x, y = (2 * a + c) / 3, (2 * b + d) / 3
    wide = moments(support, (arb(x) + arb(0, 1e-20), arb(y) + arb(0, 1e-20)))
    for shift in (-1e-20, 0.0, 1e-20):
        exact = moments(support, (arb(x) + arb(shift), arb(y) + arb(shift)))
        assert all(one.overlaps(other) for one, other in zip(wide[:3], exact[:3], strict=True))
    assert max(float(each.rad()) for each in wide) < 1e-17


def test_an_atom_at_the_center_has_no_direction():
    found, torque = at(TRIPOD, (1, 0))
    others, _ = at(TRIPOD | {"positions": TRIPOD["positions"][1:], "weights": [1, 1]}, (1, 0))
    assert (3 * found.x / 2).overlaps(others.x)
    assert torque.overlaps(found.distance + found.x)


def test_a_ball_next_to_an_atom_is_open():
    with pytest.raises(Undecided):
        moments(pieces(TRIPOD), (arb(1, 1e-30), arb(0, 1e-30)))


@pytest.mark.parametrize("place", [(0, 2), (0, -1.5)])
def test_a_center_on_the_line_of_a_segment(place):
    support = pieces({"shape": "segment", "start": (0, -1), "end": (0, 1)})
    found = moments(support, tuple(map(arb, place)))
    beside = moments(support, (arb(2) ** -80, arb(place[1])))
    assert (found.x, abs(found.y)) == (0, 1)
    for one, other in zip(found, beside, strict=True):
        assert abs(float(one - other)) < 1e-20


def test_centers_of_pressure_and_extents():
    shape = pieces(SUPPORTS["L"])
    # Two bars, of areas 1 and 3/4 with their middles at (1, 1/4) and (1/4, 5/4).
    assert shape.center == (fmpq(19, 28), fmpq(19, 28))
    assert shape.extent.overlaps(arb(fmpq(37, 28) ** 2 + fmpq(19, 28) ** 2).sqrt())
    assert pieces(SUPPORTS["triangle"]).center == pieces(SUPPORTS["clockwise"]).center
    assert pieces(SUPPORTS["annulus"]).extent == 1


def test_points_at_one_place_are_one():
    twice = {"shape": "points", "positions": [(1, 0), (0, 0), (1, 0)], "weights": [1, 2, 1]}
    assert [point.share for point in pieces(twice).points] == [fmpq(1, 2), fmpq(1, 2)]
