"""Supports as they press on the plane."""

import numpy as np
import pytest
from matplotlib.figure import Figure

import planar_pushing as pp
from planar_pushing.figures.parts.outlines import DRAWINGS, outline
from planar_pushing.mechanics.supports import SHAPES

BOX = pp.Polygon([(0, 0), (2, 0), (2, 1), (0, 1)])
EVERY = [
    pp.Ring(1.0), pp.Disc(1.0, (0.5, 0)), pp.Annulus(0.5, 1.0), BOX, pp.Points([(0, 0), (1, 1)], [1, 2]),
    pp.Segment((0, 0), (1, 0)), pp.PressureMap([0, 1, 2], [0, 1], [[1, 3]]),
    pp.Composite([(0.5, BOX), (0.5, pp.Disc(1.0))]),
]  # fmt: skip


def test_every_support_has_its_drawing():
    assert set(DRAWINGS) == set(SHAPES.values()) == {type(each) for each in EVERY}


@pytest.mark.parametrize("support", EVERY)
def test_a_support_leaves_a_mark(support):
    ax = Figure().add_subplot()
    outline(ax, support, (1.0, 2.0), 30.0)
    assert [*ax.patches, *ax.lines, *ax.collections]


def test_a_support_is_turned_scaled_and_placed():
    ax = Figure().add_subplot()
    outline(ax, BOX, (1.0, 2.0), 90.0, scale=0.5)
    (patch,) = ax.patches
    expected = [(1, 2), (1, 3), (0.5, 3), (0.5, 2)]
    np.testing.assert_allclose(patch.get_xy()[:4], expected, atol=1e-15)


def test_a_higher_pressure_is_darker():
    ax = Figure().add_subplot()
    outline(ax, EVERY[6], (0.0, 0.0), 0.0)
    light, dark = ax.collections[0].get_facecolors()
    assert (light[:3] > dark[:3]).all()
