"""Supports in balls: published values, defining integrals, plain quadrature, derivatives."""

import pytest
from flint import arb, ctx, fmpq
from mpmath import mp, mpf
from oracle.cases import CENTERS, SQUARE, SUPPORTS, TRIPOD

from pulling_by_pushing.oracle.balls import PRECISION, Undecided
from pulling_by_pushing.oracle.integrals import distance_and_gradient
from pulling_by_pushing.oracle.shapes import support
from pulling_by_pushing.oracle.support import Rim, disc, friction, ring

#: D, G = -grad D, and the torque about the origin, known from numerical integrals.
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


def at(entry, place, skip=-1):
    """D, G and the torque about the origin."""
    c = tuple(map(arb, place))
    distance, x, y, *_ = support(entry).dgh(c, skip)
    return distance, -x, -y, distance - c[0] * x - c[1] * y


@pytest.mark.parametrize(("entry", "place", "values"), PUBLISHED)
def test_published_values(entry, place, values):
    for ball, value in zip(at(entry, place), values, strict=True):
        assert abs(float(ball) - value) < 2e-15


@pytest.mark.parametrize(("place", "values"), DISCS)
def test_published_values_of_a_disc(place, values):
    distance, x, y, torque = at({"shape": "disc", "radius": 1}, (0, place))
    assert x == 0
    for ball, value in zip((distance, -y, torque), values, strict=True):
        assert abs(float(ball) / value - 1) < 2e-15


def test_the_torque_far_away_keeps_its_digits():
    *_, torque = at(SQUARE, (1e6, 0))
    assert abs(float(torque) / 3.333333333334556e-7 - 1) < 4e-16


@pytest.mark.parametrize("k", [1e-9, 0.3, 1.0, 1.7, 1e6])
def test_the_ring_is_self_dual(k):
    """f(k) = t(1 / k), and both are 2 / pi at k = 1."""
    force, torque = friction(arb(k))
    other = friction(1 / arb(k))
    assert force.overlaps(other[1])
    assert torque.overlaps(other[0])
    if k == 1:
        assert force.overlaps(2 / arb.pi())
        assert torque.overlaps(2 / arb.pi())


@pytest.mark.parametrize("place", CENTERS)
@pytest.mark.parametrize("name", SUPPORTS)
def test_closed_forms_overlap_the_defining_integrals(name, place):
    pieces, c = support(SUPPORTS[name]), tuple(map(arb, place))
    integrals = distance_and_gradient(pieces, c)
    for closed, integral in zip(pieces.dgh(c), integrals, strict=False):
        assert closed.overlaps(integral)
        assert max(closed.rad(), integral.rad()) < arb(10) ** -38


@pytest.mark.parametrize("place", CENTERS)
@pytest.mark.parametrize("name", SUPPORTS)
def test_the_hessian_is_the_slope_of_the_gradient(name, place):
    pieces, step = support(SUPPORTS[name]), arb(2) ** -40
    x, y = map(arb, place)
    _, _, _, xx, xy, yy = pieces.dgh((x, y))
    east, west = (pieces.dgh((x + side * step, y)) for side in (1, -1))
    north, south = (pieces.dgh((x, y + side * step)) for side in (1, -1))
    slopes = (east[1] - west[1], east[2] - west[2], north[2] - south[2])
    for second, slope in zip((xx, xy, yy), slopes, strict=True):
        assert abs(float(second - slope / (2 * step))) < 1e-18


def test_plain_quadrature_of_a_plate():
    """Means over the square, without any of the formulas."""
    c = mpf("1.7"), mpf("0.4")
    with mp.workdps(16):

        def mean(part):
            def value(x, y):
                rho = mp.hypot(x - c[0], y - c[1])
                return (rho, (x - c[0]) / rho, (y - c[1]) / rho)[part]

            return mp.quad(value, [-1, 1], [-1, 1]) / 4

        for part, ball in enumerate(at(SQUARE, c)[:3]):
            assert abs(float(ball) - mean(part)) < 1e-12


@pytest.mark.parametrize("name", SUPPORTS)
def test_balls_contain_the_values_within(name):
    pieces, step = support(SUPPORTS[name]), arb(2) ** -60
    x, y = map(arb, CENTERS[1])
    wide = pieces.dgh((x + arb(0, step), y + arb(0, step)))
    for side in (-1, 0, 1):
        narrow = pieces.dgh((x + side * step, y - side * step))
        assert all(one.contains(other) for one, other in zip(wide, narrow, strict=True))


@pytest.mark.parametrize("name", ["square", "L", "map"])
def test_balls_on_an_edge_are_bounded(name):
    """``h log h`` stays small next to an edge."""
    pieces = support(SUPPORTS[name])
    (a, b), (c, d), *_ = pieces.lines[0]
    for x, y in (((2 * a + c) / 3, (2 * b + d) / 3), (a, b)):  # within the edge, and at its end
        wide = pieces.dgh((arb(x) + arb(0, 1e-20), arb(y) + arb(0, 1e-20)))[:3]
        for shift in (-1e-20, 0.0, 1e-20):
            exact = pieces.dgh((arb(x) + arb(shift), arb(y) + arb(shift)))[:3]
            assert all(one.overlaps(other) for one, other in zip(wide, exact, strict=True))
        assert max(float(ball.rad()) for ball in wide) < 1e-17


@pytest.mark.parametrize("profile", [ring, disc])
@pytest.mark.parametrize("place", [(1, 0), (0, -1)])
def test_on_a_rim_there_are_a_gradient_and_no_hessian(profile, place):
    pieces = support({"shape": profile.__name__, "radius": 1})
    distance, x, y, *hessian = pieces.dgh((arb(place[0], 1e-30), arb(place[1], 1e-30)))
    assert max(float(ball.rad()) for ball in (distance, x, y)) < 1e-25
    assert not any(ball.is_finite() for ball in hessian)


def test_a_point_at_the_center_has_no_direction():
    distance, x, _, torque = at(TRIPOD, (1, 0), skip=0)
    others = at(TRIPOD | {"positions": TRIPOD["positions"][1:], "weights": [1, 1]}, (1, 0))
    assert (3 * x / 2).overlaps(others[1])
    assert torque.overlaps(distance + x)


def test_a_ball_next_to_a_point_is_open():
    with pytest.raises(Rim):
        support(TRIPOD).dgh((arb(1, 1e-30), arb(0, 1e-30)))
    assert issubclass(Rim, Undecided)


@pytest.mark.parametrize("place", [(0, 2), (0, -1.5)])
def test_a_center_on_the_line_of_a_segment(place):
    pieces = support({"shape": "segment", "start": (0, -1), "end": (0, 1)})
    on, beside = pieces.dgh(tuple(map(arb, place))), pieces.dgh((arb(2) ** -80, arb(place[1])))
    assert (on[1], abs(on[2])) == (0, 1)
    for one, other in zip(on, beside, strict=True):
        assert abs(float(one - other)) < 1e-20


def test_centers_of_pressure_and_extents():
    shape = support(SUPPORTS["L"])
    # Two bars, of areas 1 and 3/4 with their middles at (1, 1/4) and (1/4, 5/4).
    assert shape.center == (fmpq(19, 28), fmpq(19, 28))
    assert shape.extent.overlaps(arb(fmpq(37, 28) ** 2 + fmpq(19, 28) ** 2).sqrt())
    assert support(SUPPORTS["triangle"]).center == support(SUPPORTS["clockwise"]).center
    assert support(SUPPORTS["annulus"]).extent == 1


@pytest.mark.parametrize(
    ("name", "even"), [("ring", True), ("square", True), ("L", False), ("map", False)]
)
def test_a_support_can_be_its_mirror_image(name, even):
    assert support(SUPPORTS[name]).is_even is even


def test_points_at_one_place_are_one():
    twice = {"shape": "points", "positions": [(1, 0), (0, 0), (1, 0)], "weights": [1, 2, 1]}
    assert [point.share for point in support(twice).points] == [fmpq(1, 2), fmpq(1, 2)]


def test_pieces_at_one_place_add_up_in_a_mirror_image():
    """Two discs above the rod and one below carry different loads; an edge of two plates is none."""
    discs = [
        {"share": share, "support": {"shape": "disc", "radius": 0.5, "center": (0.3, y)}}
        for share, y in ((3, 1), (1, 1), (1, -1))
    ]
    assert not support({"shape": "composite", "members": discs}).is_even
    halves = [
        {"share": 1, "support": {"shape": "polygon", "vertices": vertices}}
        for vertices in ([(-1, 0), (1, 0), (1, 1), (-1, 1)], [(-1, -1), (1, -1), (1, 0), (-1, 0)])
    ]
    assert support({"shape": "composite", "members": halves}).is_even
