"""Public values of supports: center and extent, what they keep of what is given, and what they refuse."""

from __future__ import annotations

import math

import numpy as np
import pytest
from mechanics.supports.cases import SUPPORTS, TRIPOD, rectangle, rows_of

import planar_pushing as pp
from planar_pushing.mechanics.pressure.table import extents_of, moments, table_of_pieces
from planar_pushing.mechanics.supports.annulus import Annulus
from planar_pushing.mechanics.supports.base import Support
from planar_pushing.mechanics.supports.composite import Composite
from planar_pushing.mechanics.supports.disc import Disc
from planar_pushing.mechanics.supports.even_ring import Ring
from planar_pushing.mechanics.supports.points import Points
from planar_pushing.mechanics.supports.polygon import Polygon
from planar_pushing.mechanics.supports.pressure_map import PressureMap
from planar_pushing.mechanics.supports.segment import Segment
from planar_pushing.terms.errors import InvalidValue

#: Of each support its center of pressure and its extent.
SHAPES = [
    (Ring(), (0, 0), 1),
    (Ring(2), (0, 0), 2),
    (Disc(2, (1, -1)), (1, -1), 2),
    (Annulus(1, 3, (0, 1)), (0, 1), 3),
    (Points([(0, 0), (4, 0)], [3, 1]), (1, 0), 3),
    (Segment((0, 0), (6, 8)), (3, 4), 5),
    (rectangle(3, 4), (0, 0), 5),
    (Polygon([(0, 0), (0, 3), (3, 0)]), (1, 1), math.sqrt(5)),
    (
        Polygon([(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)]),
        (5 / 6, 5 / 6),
        math.hypot(5, 7) / 6,
    ),
    (Polygon([(0, 0), (4, 0), (4, 4), (0, 4)], [[(0.5, 0.5), (3.5, 0.5), (3.5, 3.5), (0.5, 3.5)]]),
     (2, 2), math.sqrt(8)),
    (Polygon([(0, 0), (4, 0), (4, 4), (0, 4)], [[(2, 1), (2, 3), (3, 3), (3, 1)]]),
     (27 / 14, 2), math.hypot(29 / 14, 2)),
    (PressureMap([0, 1, 3], [0, 2], [[0, 5]]), (2, 1), math.sqrt(2)),
    (PressureMap([0, 1, 3], [0, 2, 4], [[3, 0], [0, 0.5]]), (0.875, 1.5), math.hypot(2.125, 2.5)),
    (Composite([(3, Disc(1)), (1, Points([(4, 0)], [7]))]), (1, 0), 3),
    (Composite([(1, Ring(1)), (1, Composite([(2, Disc(1, (2, 0)))]))]), (1, 0), 2),
]  # fmt: skip


@pytest.mark.parametrize(("support", "center", "extent"), SHAPES)
def test_center_of_pressure_and_extent(support, center, extent):
    assert isinstance(support, Support)
    assert support.center_of_pressure == pytest.approx(center, abs=1e-15)
    assert support.extent == pytest.approx(extent, rel=1e-15, abs=0)
    table = table_of_pieces(support.pieces(), 2.0)
    assert table.centers[0] * 2.0 == pytest.approx(center, abs=1e-15)
    assert extents_of([support]) == pytest.approx([extent], rel=1e-15, abs=0)


@pytest.mark.parametrize("name", SUPPORTS)
def test_supports_are_plain_values(name):
    support, _ = SUPPORTS[name]
    again = eval(repr(support), {name: getattr(pp, name) for name in pp.__all__})
    assert again == support
    assert hash(again) == hash(support)


@pytest.mark.parametrize("name", SUPPORTS)
def test_shares_add_to_1(name):
    table = table_of_pieces(SUPPORTS[name][0].pieces(), 1.0)
    shares = {"atoms": 2, "segments": 5, "rings": 3, "discs": 3, "plates": 3}
    whole = sum(rows_of(table, kind)[:, column].sum() for kind, column in shares.items())
    assert whole == pytest.approx(1.0, rel=1e-14, abs=0)


def test_a_ring_is_the_unit_of_length_or_has_its_own_radius():
    for ring, radius in ((Ring(), 1.0), (Ring(3.5), 3.5)):
        (row,) = rows_of(table_of_pieces(ring.pieces(), 1.0), "rings").tolist()
        assert row == [0.0, 0.0, radius, 1.0, 0.0, 0.0]


def test_the_direction_of_a_polygon_and_the_unit_of_weights_do_not_matter():
    there, back = SUPPORTS["L"][0], Polygon(SUPPORTS["L"][0].vertices[::-1])
    assert moments(table_of_pieces(back.pieces(), 1.0), 0.3, 0.2) == pytest.approx(
        moments(table_of_pieces(there.pieces(), 1.0), 0.3, 0.2)
    )
    heavy = table_of_pieces(Points(TRIPOD.positions, [5.0, 5.0, 5.0]).pieces(), 1.0)
    assert np.array_equal(heavy.data, table_of_pieces(TRIPOD.pieces(), 1.0).data)
    loud = table_of_pieces(PressureMap([0, 1, 3], [0, 2], [[1e-300, 2e-300]]).pieces(), 1.0)
    quiet = table_of_pieces(PressureMap([0, 1, 3], [0, 2], [[1e300, 2e300]]).pieces(), 1.0)
    assert np.allclose(
        *(each.data[: int(each.head.end[0])] for each in (loud, quiet)), rtol=1e-14, atol=0
    )


NAN, INF = math.nan, math.inf
TILE, HOLE = [(0, 0), (4, 0), (4, 4), (0, 4)], [(1, 1), (1, 3), (3, 3)]
BOW_TIE = [(0, 0), (2, 2), (2, 0), (0, 3)]
#: Of what is refused, words of the message: the name, what was given, what is allowed, what to do.
REFUSED = [
    (lambda: Ring(INF), ["radius: inf given"]),
    (lambda: Disc(NAN), ["radius: nan given"]),
    (lambda: Disc(1.0, (0.0, NAN)), ["center[1]: nan given", "finite"]),
    (lambda: Annulus(1.0, 1.0), ["inner: 1.0 given", "less than outer, 1.0", "use Ring"]),
    (lambda: Annulus(2.0, 1.0), ["inner: 2.0 given", "less than outer, 1.0"]),
    (lambda: Points([(1.0, NAN)], [1.0]), ["positions[0][1]: nan given", "finite"]),
    (lambda: Points([(1.0, 2.0, 3.0)], [1.0]), ["positions[0]: ", "two finite numbers"]),
    (lambda: Points([(1.0, 2.0)], []), ["weights: () given", "1 weight;", "one weight"]),
    (lambda: Points([(0, 0), (1, 0)], [1, -1]), ["weights[1]: -1.0 given", "> 0", "leave out"]),
    (lambda: Points([(0, 0)], ["heavy"]), ["weights[0]: 'heavy' given"]),
    (lambda: Segment((0, 0), (0.0, 0.0)), ["end: (0.0, 0.0) given", "other than the start", "Points"]),
    (lambda: Segment((0, INF), (1, 0)), ["start[1]: inf given"]),
    (lambda: Polygon([(0, 0), (1, 0)]), ["vertices: ", "at least three vertices", "in order"]),
    (lambda: Polygon([(0, 0), (1, 0), (1, NAN)]), ["vertices[2][1]: nan given", "finite"]),
    (lambda: Polygon("square"), ["vertices: 'square' given", "pairs of finite numbers"]),
    (lambda: Polygon(BOW_TIE), ["edges 0 and 2, from (0, 0) to (2, 2) and from (2, 0) to (0, 3)",
                                "do not cross", "order the vertices"]),
    (lambda: Polygon(np.pi * np.array(BOW_TIE)), ["edges 0 and 2, from (0, 0) to (6.283, 6.283)"]),
    (lambda: Polygon([(0, 0), (4, 0), (4, 2), (2, 0), (0, 2)]), ["edges 0 and 2", "touch"]),
    (lambda: Polygon([(0, 0), (2, 0), (1, 0), (1, 1)]), ["edges 0 and 1", "touch"]),
    (lambda: Polygon([(0, 0), (1, 0), (1, 0), (0, 1)]), ["edges 0 and 1"]),
    (lambda: Polygon([(0, 0), (1, 0), (0, 0)]), ["vertices: ", "at least three vertices"]),
    (lambda: Polygon([(0, 0), (1, 0), (0, 1), (0, 0), (0, 0)]), ["edges 0 and 2", "each once"]),
    (lambda: Polygon(TILE, [(1, 1), (2, 1), (1, 2)]), ["holes[0][0]: 1 given", "two finite"]),
    (lambda: Polygon(TILE, [BOW_TIE]), ["holes[0]: ", "do not cross"]),
    (lambda: Polygon(TILE, [[(1, 1), (5, 1), (1, 2)]]),
     ["holes[0]: 'from (1, 1) to (5, 1), which meets from (4, 0) to (4, 4)' given", "inside", "Composite"]),
    (lambda: Polygon(TILE, [[(0, 0), (2, 1), (1, 2)]]), ["holes[0]: 'from (0, 0) to (2, 1), which meets"]),
    (lambda: Polygon(TILE, [[(5, 5), (6, 5), (5, 6)]]), ["holes[0]: [[5.0, 5.0],", "inside of"]),
    (lambda: Polygon(TILE, [TILE]), ["holes[0]: 'from (0, 0) to (4, 0), which meets"]),
    (lambda: Polygon(TILE, [HOLE, [(1.2, 1.2), (1.5, 1.2), (1.2, 1.5)]]), ["holes[1]: ", "apart from"]),
    (lambda: Polygon(TILE, [[(1.2, 1.2), (1.5, 1.2), (1.2, 1.5)], HOLE]), ["holes[1]: ", "apart from"]),
    (lambda: Polygon.rectangle(1.0, 1.0, angle=NAN), ["angle: nan given", "radians"]),
    (lambda: Polygon.regular(3.5, 1.0), ["count: 3.5 given"]),
    (lambda: Points.disc(0, 1.0), ["count: 0 given", ">= 1"]),
    (lambda: Points.regular(3, -1.0), ["radius: -1.0 given"]),
    (lambda: Points([(0, 0), (1, 0)], names=["a"]), ["names: ('a',) given", "2 names"]),
    (lambda: Points([(0, 0), (1, 0)], names="ab"), ["names: 'ab' given"]),
    (lambda: Ring(None, (1, 0)), ["radius: None given", "Ring(1.0)"]),
    (lambda: Ring(1.0, (1, NAN)), ["center[1]: nan given"]),
    (lambda: PressureMap([0, 1], [0, 1], [[1]], (0, NAN)), ["origin[1]: nan given"]),
    (lambda: Polygon([(0, 0), (1, 1), (3, 3)]), ["vertices: ", "simple"]),
    (lambda: Polygon([(0, 0), (1, 1), (2, 2 + 1e-14)]), ["vertices: ", "area is not zero", "Segment"]),
    (lambda: PressureMap([0, 1], [0, 1], [[1, 2]]), ["pressure: ", "1 row of 1 number,", "the edges"]),
    (lambda: PressureMap([0], [0, 1], [[]]), ["x: [0.0] given", "at least two increasing"]),
    (lambda: PressureMap([0, 1, 2], [0, 1], [[1, INF]]), ["pressure[0][1]: inf given", "finite"]),
    (lambda: PressureMap([0, 1, 2], [0, 1], [[0, 0]]), ["pressure: 0.0 given", "at least one"]),
    (lambda: Composite([(1, "disc")]), ["members[0]: 'disc' given", "a support, such as"]),
    (lambda: Composite([Disc(1.0)]), ["members: ", "pair of a share and a support"]),
    (lambda: Composite([(1, Ring())]), ["members: Ring(radius=None, center=None) given", "Ring(1.0)"]),
    (lambda: Composite([(1, Disc(1)), (0, Disc(2))]), ["share[1]: 0.0 given", "> 0"]),
    (lambda: Composite([(1, Disc(1)), (NAN, Disc(2))]), ["share[1]: nan given"]),
    (lambda: Composite([("2", Disc(1))]), ["share[0]: '2' given"]),
    (lambda: Points([(np.datetime64("2020-01-01"), 0), (1, 1)]), ["positions[0]: ", "two finite"]),
    (lambda: Points([(1 + 3j, 0), (1, 1)]), ["positions[0]: ", "two finite"]),
    (lambda: Points([(True, 0), (1, 1)]), ["positions[0]: ", "two finite"]),
    (lambda: Points([(10**400, 0), (1, 1)]), ["positions[0]: ", "two finite"]),
    (lambda: Points(np.ma.masked_array([(1, 0), (1, 1)], [(1, 1), (0, 0)])), ["positions: ", "masked"]),
    (lambda: Points([(0, 0), (1, 1)], [1e308, 1e308]), ["weights: 1e+308 given", "a finite sum"]),
    (lambda: PressureMap([0, 1, 2], [0, 1], np.ma.masked_array([[1, 99]], [[0, 1]])),
     ["pressure: ", "masked"]),
    (lambda: Disc(np.ma.masked), ["radius: masked given"]),
    *((lambda size=size: Disc(size), [f"radius: {size!r} given", "a size in [1e-140, 1e+140]"])
      for size in (5e-324, 0.9e-140, 1.1e140, 1e160)),
    (lambda: Ring(5e-324), ["radius: 5e-324 given", "a size in"]),
    (lambda: Annulus(1e-200, 2e-200), ["inner: 1e-200 given", "a size in", "another unit"]),
    (lambda: Annulus(1.0, 1e200), ["outer: 1e+200 given", "a size in"]),
    (lambda: Segment((0, 0), (1e308, 1e308)), ["end[0]: 1e+308 given", "at most 1e+140"]),
    (lambda: Segment((0, 0), (1e-200, 0)), ["end: 1e-200 given", "a size in"]),
    (lambda: Points([(0, 0), (1e308, 0)]), ["positions[1][0]: 1e+308 given", "at most 1e+140"]),
    (lambda: Points([(0, 0), (1e-200, 0)]), ["positions: 1e-200 given", "a size in"]),
    (lambda: Polygon([(0, 0), (1e308, 0), (1e308, 1e308)]), ["vertices[1][0]: 1e+308 given", "at most"]),
    (lambda: Polygon([(0, 0), (1e-200, 0), (0, 1e-200)]), ["vertices: 1e-200 given", "a size in"]),
    (lambda: PressureMap([0, 1e308], [0, 1], [[1]]), ["x[1]: 1e+308 given", "at most 1e+140"]),
    (lambda: PressureMap([0, 1], [0, 1e-200], [[1]]), ["y: 1e-200 given", "a size in"]),
    (lambda: Polygon.rectangle(1e-200, 1), ["width: 1e-200 given", "a size in"]),
    *((lambda angle=angle: Polygon.rectangle(1, 1, angle=angle), ["angle: ", "radians in [-4 pi, 4 pi]"])
      for angle in (90, np.float64(90), np.int64(-90), np.array(90.0), [0.1], np.array([0.1, 0.2]), "1")),
    (lambda: Points.regular(3, 1.0, angle=np.float32(45)), ["angle: 45.0 given", "np.deg2rad"]),
]  # fmt: skip


@pytest.mark.parametrize(("make", "words"), REFUSED)
def test_bad_input_is_refused_with_what_was_given_and_what_to_do(make, words):
    with pytest.raises(InvalidValue) as caught:
        make()
    message = str(caught.value)
    assert all(word in message for word in [*words, "allowed: "]), message


@pytest.mark.parametrize("size", [1e-140, 1e-100, 1e100, 0.5e140])
@pytest.mark.parametrize("make", [
    Disc, Ring, lambda r: Annulus(r, 2 * r), lambda r: Polygon.rectangle(r, r),
    lambda r: Segment((-r, 0), (r, 0)), lambda r: Points([(-r, 0), (r, 0)]),
    lambda r: PressureMap([0, r], [0, r], [[1]]),
])  # fmt: skip
def test_sizes_far_from_one_are_computed_without_a_warning(make, size):
    one, other = (
        [*extents_of([make(each)]) / each, *table_of_pieces(make(each).pieces(), each).spreads[0]]
        for each in (size, 1.0)
    )
    assert one == pytest.approx(other, rel=1e-12, abs=0)


@pytest.mark.parametrize("size", [1e-9, 1.0, 1e9])
def test_polygons_of_any_size_are_simple_or_not_alike(size):
    Polygon(size * np.array(SUPPORTS["star"][0].vertices))
    with pytest.raises(InvalidValue):
        Polygon(size * np.array(BOW_TIE))
