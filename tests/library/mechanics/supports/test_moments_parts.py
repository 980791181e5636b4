"""A support in two parts is the same support."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from mechanics.supports.cases import regular, rows_of
from mechanics.supports.test_moments_invariants import (
    at,
    centers,
    places,
    same,
    segments,
    shares,
    sizes,
    supports,
)

from planar_pushing.mechanics.pressure.table import table_of_pieces
from planar_pushing.mechanics.supports.annulus import Annulus
from planar_pushing.mechanics.supports.composite import Composite
from planar_pushing.mechanics.supports.disc import Disc
from planar_pushing.mechanics.supports.points import Points
from planar_pushing.mechanics.supports.polygon import Polygon
from planar_pushing.mechanics.supports.pressure_map import PressureMap
from planar_pushing.mechanics.supports.segment import Segment

cuts = st.floats(0.1, 0.9)


def agree(parts, support, c):
    """Whether a mixture of parts has the moments of the support, away from where they jump."""
    together = Composite(parts)
    assert together.center_of_pressure == pytest.approx(support.center_of_pressure, abs=1e-14)
    atoms = rows_of(table_of_pieces(support.pieces(), 1.0), "atoms")[:, :2]
    if not len(atoms) or np.hypot(*(atoms - c).T).min() > 1e-6:
        found, expected = at(together, c), at(support, c)
        same(found[:4], expected[:4], np.hypot(*c))


@given(supports, cuts, centers)
def test_a_support_shares_the_weight_with_itself(support, cut, c):
    agree([(cut, support), (1 - cut, support)], support, c)


@given(segments(), cuts, centers)
def test_a_segment_is_its_two_parts(support, cut, c):
    middle = (1 - cut) * np.array(support.start) + cut * np.array(support.end)
    agree([(cut, Segment(support.start, middle)), (1 - cut, Segment(middle, support.end))],
          support, c)  # fmt: skip


@given(places, st.lists(sizes, min_size=4, max_size=8), st.integers(2, 6), centers)
def test_a_polygon_is_its_two_parts(middle, reach, cut, c):
    """Cut from the middle to the first and to another vertex."""
    vertices = middle + regular(len(reach)) * np.array(reach)[:, None]
    cut = 1 + cut % (len(reach) - 2)
    halves = [
        Polygon([middle, *vertices[: cut + 1]]),
        Polygon([middle, *vertices[cut:], vertices[0]]),
    ]
    turned = np.asarray(reach) * np.roll(reach, -1)
    agree([(turned[:cut].sum(), halves[0]), (turned[cut:].sum(), halves[1])],
          Polygon(vertices), c)  # fmt: skip


@given(sizes, cuts, places, centers)
def test_a_disc_is_a_smaller_one_and_an_annulus(radius, cut, middle, c):
    inner = cut * radius
    parts = [(cut**2, Disc(inner, middle)), (1 - cut**2, Annulus(inner, radius, middle))]
    agree(parts, Disc(radius, middle), c)


@given(
    st.lists(st.tuples(places, shares), min_size=2, max_size=6, unique_by=lambda x: x[0]), centers
)
def test_points_are_two_groups_of_them(feet, c):
    def group(some):
        return Points([place for place, _ in some], [share for _, share in some])

    halves = [feet[::2], feet[1::2]]
    agree([(sum(share for _, share in half), group(half)) for half in halves], group(feet), c)


@given(cuts, cuts, centers)
def test_a_cell_is_its_four_parts(along, across, c):
    whole = PressureMap([-1.0, 1.0], [-0.5, 0.7], [[1.0]])
    x, y = -1 + 2 * along, -0.5 + 1.2 * across
    agree([(1.0, PressureMap([-1.0, x, 1.0], [-0.5, y, 0.7], np.ones((2, 2))))], whole, c)
