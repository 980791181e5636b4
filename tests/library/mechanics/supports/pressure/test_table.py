"""Several pressures in one table."""

import numpy as np
import pytest

import planar_pushing as pp
from planar_pushing.core.supports.multipole import ROWS
from planar_pushing.core.supports.piece_rows import COLUMNS, HEAD
from planar_pushing.core.supports.rows import EFFECT, LAST
from planar_pushing.mechanics.kernels.calls import run
from planar_pushing.mechanics.pressure.table import (
    FEW,
    joined_data,
    moments,
    table_of,
    table_of_pieces,
)

SQUARE = pp.Polygon([(-1, -1), (1, -1), (1, 1), (-1, 1)])
SUPPORTS = [
    SQUARE,
    pp.Points([(0, 0), (2, 1), (1, 3)], [0.2, 0.3, 0.5]),
    pp.Composite([(0.5, pp.Polygon([(0, 0), (4, 0), (0, 3)])), (0.3, SQUARE), (0.2, pp.Ring(1.0))]),
    pp.Annulus(0.5, 1.0),
    pp.Segment((0, -1), (0, 1)),
]
CENTERS = ((0.1, 0.3), (-2.0, 0.4), (50.0, 7.0))


@pytest.mark.parametrize("i", range(len(SUPPORTS)))
def test_each_pressure_is_that_of_its_support(i):
    """In units of its own extent, whatever stands before and behind it."""
    table, support = table_of(SUPPORTS), SUPPORTS[i]
    alone = table_of_pieces(support.pieces(), support.extent)
    center = np.array(support.center_of_pressure) / support.extent
    assert table.centers[i] == pytest.approx(center, rel=1e-15, abs=0)
    for x, y in CENTERS:
        assert moments(table, x, y, i) == moments(alone, x, y)


def test_tables_of_few_supports_are_kept_and_of_many_the_last_alone():
    """A plate's multipoles take 12 kB: a table of 100,000 polygons is more than a gigabyte."""
    few = [table_of([support]) for support in SUPPORTS]
    many, others = (pp.Segment((0, -1), (0, 1)),) * (FEW + 1), (pp.Annulus(0.5, 1.0),) * (FEW + 1)
    first = table_of(many)
    assert table_of(many) is first
    table_of(others)
    assert table_of(many) is not first
    assert all(table_of([each]) is table for each, table in zip(SUPPORTS, few, strict=True))


def test_the_pieces_fill_the_array_without_gaps():
    table = table_of(SUPPORTS)
    head = table.head
    kinds = head.atoms, head.segments, head.rings, head.discs, head.plates, head.edges
    assert head.atoms[0] == HEAD * len(SUPPORTS)
    assert head.atoms[1:].tolist() == head.end[:-1].tolist()
    counts = np.diff(np.column_stack([*kinds, head.end])) // COLUMNS
    assert counts.tolist() == [
        [0, 0, 0, 0, 1, 4], [3, 0, 0, 0, 0, 0], [0, 0, 1, 0, 2, 7], [0, 0, 0, 2, 0, 0],
        [0, 1, 0, 0, 0, 0],
    ]  # fmt: skip
    terms = int(head.end[-1]) + 2 * ROWS * np.array([0, 1, 1, 3, 3])
    assert head.series.tolist() == terms.tolist()
    assert len(table.data) == int(head.end[-1]) + 2 * ROWS * 3
    assert table.atom_counts.tolist() == [0, 3, 0, 0, 0]
    places = np.array(SUPPORTS[1].positions) / SUPPORTS[1].extent
    assert table.atoms(1) == pytest.approx(np.column_stack([places, [0.2, 0.3, 0.5]]), rel=1e-15)
    assert len(table.atoms(0)) == 0


def test_joined_tables_hold_the_effects_and_every_pressure():
    """The same bits from each place of an array."""
    tables = table_of(SUPPORTS), None, table_of(SUPPORTS[:1]), table_of(SUPPORTS[1:3])
    effects = [(7, 3 * i, table) for i, table in enumerate(tables)]
    data = joined_data(effects, 12)
    heads = data[: EFFECT * 5].reshape(5, EFFECT).astype(int).tolist()
    assert [each[:2] for each in heads] == [[7, 0], [7, 3], [7, 6], [7, 9], [LAST, 12]]
    for table, (_, _, place) in zip(tables, heads[:-1], strict=True):
        for i in range(table.count if table else 0):
            rows = [[HEAD * i, x, y] for x, y in CENTERS]
            expected = np.array([moments(table, x, y, i) for x, y in CENTERS])
            assert np.array_equal(run("moments", data[place:], rows, 8), expected)


def test_as_many_effects_as_one_likes_precede_a_table():
    for count in (13, 14, 15, 40):
        table = table_of([*SUPPORTS, pp.Disc(float(count))])  # in whose memory nothing is yet
        data = joined_data([*[(1, i, None) for i in range(count)], (2, count, table)], count + 1)
        place = EFFECT * (count + 2)
        assert data[place - 2 * EFFECT : place - EFFECT].tolist() == [2.0, count, place]
        assert np.array_equal(data[place:], table.data)


def test_joined_tables_are_kept_while_tables_and_kinds_are_the_same():
    table, other = table_of(SUPPORTS), table_of(SUPPORTS[1:])
    data = joined_data([(1, 0, None), (2, 1, table)], 4)
    assert joined_data(((1, 0, None), (2, 1, table)), 4) is data
    before, first = table.data.copy(), data.copy()
    for effects in ([(1, 0, None), (3, 1, table)], [(1, 0, None), (2, 1, other)], [(2, 1, table)]):
        assert joined_data(effects, 4) is not data
    assert joined_data([(1, 0, None), (2, 1, table)], 5) is not data
    assert np.array_equal(table.data, before)
    assert np.array_equal(data, first)
    assert joined_data([], 0).tolist() == [LAST, 0.0, 0.0]


POINT = pp.Points([(1, 2), (1, 2)], [1, 3])
#: Weights that round move its center of pressure off the place.
FEET = pp.Points([(0.1, 0.2)] * 3, [0.3, 0.3, 0.1])
POINTS = [POINT, FEET, pp.Composite([(1, POINT)]), pp.Composite([(0.7, FEET), (0.1, FEET)])]


@pytest.mark.parametrize("support", POINTS)
@pytest.mark.parametrize("radius", [None, 1.0])
def test_a_single_point_is_no_support_of_a_scene(support, radius):
    slider = pp.Slider(rod_length=1.0, rod_angle=1.0, radius=radius)
    with pytest.raises(
        pp.InvalidValue, match="allowed: a support with more than one point; a point"
    ):
        _ = pp.Scene(
            slider=slider, contact=pp.Coulomb(1.0), effects=(pp.SupportFriction(support=support),)
        ).rows  # fmt: skip
