"""Drawing primitives."""

import numpy as np
import pytest
from matplotlib.figure import Figure

from planar_pushing.figures import style
from planar_pushing.figures.parts import arrows, drawing


def line_ends(ax, number=-1):
    return np.asarray(ax.lines[number].get_xydata())[[0, -1]]


@pytest.mark.parametrize("size", [(3.4, 2.0), (2.0, 5.0), (7.0, 7.0)])
def test_a_schematic_has_equal_aspect_and_shows_its_box(size):
    figure = Figure(figsize=size)
    ax = drawing.schematic(figure, (-2, 4, 0, 1), pad=10)
    (x0, y0), (x1, y1) = ax.transData.transform([(-2, 0), (4, 1)])
    assert (x1 - x0) / 6 == pytest.approx(y1 - y0)
    margin = 10 / 72 * figure.dpi - 1e-6
    width, height = size[0] * figure.dpi, size[1] * figure.dpi
    assert margin <= x0 < x1 <= width - margin
    assert margin <= y0 < y1 <= height - margin


def test_a_cone_spans_from_its_right_to_its_left_edge(ax):
    wedge = drawing.cone(ax, (0, 0), -20, 140, 0.5, style.MOTION)
    assert (wedge.theta1, wedge.theta2, wedge.r) == (-20, 140, 0.5)
    assert line_ends(ax)[1] == pytest.approx(0.5 * arrows.unit(140))


def test_a_cone_of_one_direction_is_a_line(ax):
    wedge = drawing.cone(ax, (0, 0), 90, 90, 0.5, style.FORCE)
    assert np.ptp(wedge.get_path().vertices[:, 0]) == pytest.approx(0, abs=1e-12)
    assert len(ax.lines) == 2


@pytest.mark.parametrize("left", [270, 300])
def test_a_cone_of_every_direction_has_no_edges(ax, left):
    wedge = drawing.cone(ax, (0, 0), -90, left, 0.5, style.FORCE)
    assert (wedge.theta1, wedge.theta2) == (0, 360)
    assert not ax.lines


@pytest.mark.parametrize(("start", "stop"), [(0, 45), (10, -30), (0, 0)])
def test_an_arc_joins_its_two_angles(ax, start, stop):
    drawing.angle_arc(ax, (1, 1), start, stop, 0.5, "a")
    assert line_ends(ax) == pytest.approx(
        np.array([1 + 0.5 * arrows.unit(start), 1 + 0.5 * arrows.unit(stop)])
    )


def test_the_fence_is_hatched_below_its_edge(ax):
    drawing.fence(ax, -1, 2, depth=0.1)
    strokes = np.array(ax.collections[0].get_segments())
    assert strokes[:, 0, 1] == pytest.approx(0)
    assert strokes[:, 1, 1] == pytest.approx(-0.1)
    assert strokes[..., 0].min() >= -1 - 1e-12
    assert line_ends(ax).tolist() == [[-1, 0], [2, 0]]


def test_the_slider_has_ring_rod_and_contact(ax):
    drawing.slider(ax, (1, 1), 0.8)
    assert ax.patches[0].radius == 0.8
    assert ax.patches[0].center == (1, 1)
    assert line_ends(ax, 0).tolist() == [[0, 0], [1, 1]]


def test_tints_are_opaque():
    assert (drawing.tint("#336699", 1.0), drawing.tint("#336699", 0.0)) == ("#336699", "#ffffff")


def test_a_cone_covers_what_is_below_it(ax):
    wedge = drawing.cone(ax, (0, 0), -20, 140, 0.5, style.MOTION)
    assert wedge.get_facecolor()[3] == 1
