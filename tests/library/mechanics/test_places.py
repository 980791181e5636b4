"""Places that stand for a support where its friction is shown."""

import numpy as np
import pytest
from mechanics.supports.cases import SUPPORTS

import planar_pushing as pp
from planar_pushing.mechanics.force.rubbing import places, pressure_at


@pytest.mark.parametrize("name", SUPPORTS)
def test_places_share_the_weight_about_the_center_of_pressure(name):
    support, _ = SUPPORTS[name]
    found = places(support.pieces())
    assert 3 <= len(found) <= 60
    assert (found[:, 2] > 0).all()
    assert found[:, 2].sum() == pytest.approx(1.0, rel=1e-9)
    mean = found[:, 2] @ found[:, :2]
    assert np.hypot(*(mean - support.center_of_pressure)) < 0.2 * support.extent


def test_support_points_come_first_and_in_their_order():
    feet = [(0.0, 1.0), (2.0, 0.0)]
    support = pp.Composite([(1, pp.Disc(1.0)), (3, pp.Points(feet, [1, 2]))])
    found = places(support.pieces())
    assert found[:2].tolist() == [[0.0, 1.0, 0.25], [2.0, 0.0, 0.5]]
    assert (np.hypot(*found[2:, :2].T) < 1).all()


def test_pressure_is_that_of_the_cell_and_none_outside():
    given = pp.PressureMap([0, 1, 3], [0, 2], [[1, 2]])
    points = np.array([[0.5, 1.0], [2.0, 1.9], [-0.1, 1.0], [3.1, 1.0], [0.5, 2.1], [2.0, -0.1]])
    assert pressure_at(given.pieces(), points) == pytest.approx([0.1, 0.2, 0, 0, 0, 0])


def test_a_hole_and_a_notch_carry_nothing():
    hole = pressure_at(pp.Annulus(0.5, 1.0).pieces(), np.array([[0.4, 0.0], [0.6, 0.0]]))
    assert hole == pytest.approx([0.0, 1 / (0.75 * np.pi)])
    ell = pp.Polygon([(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)])
    notch = pressure_at(ell.pieces(), np.array([[1.5, 1.5], [0.5, 1.5], [1.5, 0.5]]))
    assert notch == pytest.approx([0.0, 1 / 3, 1 / 3])


def test_an_area_that_holds_no_place_has_none():
    needle = pp.Polygon([(-1, -1), (1, 1), (1, 1 + 1e-6)])
    assert places(needle.pieces()).shape[1] == 3
