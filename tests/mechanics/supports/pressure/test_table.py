"""Several pressures in one table."""

import numpy as np
import pytest

import planar_pushing as pp
from planar_pushing.mechanics.supports.moments import moments
from planar_pushing.mechanics.supports.pressure.assembly import assembled
from planar_pushing.mechanics.supports.pressure.table import FEW, pressure_of, table_of

SQUARE = pp.Polygon([(-1, -1), (1, -1), (1, 1), (-1, 1)])
SUPPORTS = [
    SQUARE,
    pp.Points([(0, 0), (2, 1), (1, 3)], [0.2, 0.3, 0.5]),
    pp.Composite([(0.5, pp.Polygon([(0, 0), (4, 0), (0, 3)])), (0.3, SQUARE), (0.2, pp.Ring(1.0))]),
    pp.Annulus(0.5, 1.0),
    pp.Segment((0, -1), (0, 1)),
]


@pytest.mark.parametrize("i", range(len(SUPPORTS)))
def test_each_pressure_is_that_of_its_support(i):
    """In units of its own extent, whatever stands before and behind it."""
    found, support = pressure_of(table_of(SUPPORTS), i), SUPPORTS[i]
    alone = assembled(support.pieces(), support.extent)
    center = found.center_x, found.center_y
    assert center == pytest.approx(
        np.array(support.center_of_pressure) / support.extent, rel=1e-15, abs=0
    )
    for x, y in ((0.1, 0.3), (-2.0, 0.4), (50.0, 7.0)):
        assert moments(found, x, y) == moments(alone, x, y)


def test_tables_of_few_supports_are_kept_and_of_many_the_last_alone():
    """A plate's multipoles take 12 kB: a table of 100,000 polygons is more than a gigabyte."""
    few = [table_of([support]) for support in SUPPORTS]
    many, others = (pp.Segment((0, -1), (0, 1)),) * (FEW + 1), (pp.Annulus(0.5, 1.0),) * (FEW + 1)
    first = table_of(many)
    assert table_of(many) is first
    table_of(others)
    assert table_of(many) is not first
    assert all(table_of([each]) is table for each, table in zip(SUPPORTS, few, strict=True))


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
        ).kinds  # fmt: skip
