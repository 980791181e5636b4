"""Each kind of support, drawn in its place."""

import numpy as np
import pytest
from matplotlib.colors import to_rgb
from matplotlib.patches import Circle, PathPatch, Polygon

import planar_pushing as pp
from mechanics.supports.cases import SUPPORTS
from planar_pushing.figures.parts.drawing import tint
from planar_pushing.figures.parts.supports import (
    AREA,
    BAR,
    DRAWN,
    HEAVIEST,
    HIGHEST,
    Ink,
    Pose,
    draw_support,
    extents,
)
from planar_pushing.figures.style import SLIDER
from planar_pushing.mechanics.supports import SHAPES

UPRIGHT = Pose((1.0, 2.0), np.pi / 2)
CORNERS = [(-1, -1), (1, -1), (1, 1), (-1, 1)]


def test_every_shape_is_drawn():
    assert set(DRAWN) == set(SHAPES.values())


def test_a_pose_turns_and_moves():
    assert UPRIGHT.at((1.0, 0.5)) == pytest.approx([0.5, 3.0])
    assert UPRIGHT.at([[0, 0], [0, 1]]) == pytest.approx(np.array([[1, 2], [0, 2]]))


def test_a_pose_scales_about_its_origin():
    assert Pose((1.0, 2.0), np.pi / 2, 0.5).at((2.0, 1.0)) == pytest.approx([0.5, 3.0])


def shown(ax):
    """Points of all that was drawn, in the plane."""
    paths = [patch.get_patch_transform().transform_path(patch.get_path()) for patch in ax.patches]
    paths += [path for each in ax.collections for path in each.get_paths()]
    found = [path.to_polygons(closed_only=False)[0] for path in paths]
    return np.concatenate([*found, *(line.get_xydata() for line in ax.lines)])


@pytest.mark.parametrize("name", SUPPORTS)
def test_the_extents_are_those_of_what_is_drawn(ax, name):
    support, _ = SUPPORTS[name]
    pose = Pose((0.3, -0.2), 0.7, 0.5)
    draw_support(ax, support, pose, Ink())
    points, (low, high) = shown(ax), extents(support, pose)
    # Circles are drawn as polygons, maps with their empty cells.
    slack = 0.03 * pose.scale * support.extent
    if name != "peak":
        assert points.min(axis=0) == pytest.approx(low, abs=slack)
        assert points.max(axis=0) == pytest.approx(high, abs=slack)
    assert (points.min(axis=0) <= low + slack).all()
    assert (points.max(axis=0) >= high - slack).all()


def test_a_ring_is_a_circle_of_its_radius(ax):
    draw_support(ax, pp.Ring(0.7), UPRIGHT, Ink())
    (circle,) = ax.patches
    assert (circle.center, circle.radius, circle.get_fill()) == ((1.0, 2.0), 0.7, False)


def test_a_disc_is_shaded_about_its_own_centre(ax):
    draw_support(ax, pp.Disc(0.5, (1.0, 0.0)), UPRIGHT, Ink())
    shade, rim = ax.patches
    for circle in (shade, rim):
        assert isinstance(circle, Circle)
        assert circle.center == pytest.approx((1.0, 3.0))
        assert circle.radius == 0.5
    assert shade.get_facecolor()[:3] == pytest.approx(to_rgb(tint(SLIDER, AREA)))
    assert shade.zorder < 0.5 < rim.zorder


def test_an_annulus_has_a_hole(ax):
    draw_support(ax, pp.Annulus(0.5, 1.0), UPRIGHT, Ink())
    shade, *rims = ax.patches
    assert isinstance(shade, PathPatch)
    outer, inner = shade.get_path().to_polygons()
    areas = [np.sum(x[:-1] * y[1:] - x[1:] * y[:-1]) / 2 for x, y in (outer.T, inner.T)]
    assert areas == pytest.approx([np.pi, -np.pi / 4], rel=0.02)  # opposite turns leave a hole
    assert [rim.radius for rim in rims] == [0.5, 1.0]


def test_a_polygon_is_a_shaded_area_with_an_outline(ax):
    draw_support(ax, pp.Polygon(CORNERS), UPRIGHT, Ink(width=1.5))
    shade, rim = ax.patches
    for each in (shade, rim):
        assert isinstance(each, Polygon)
        assert each.get_xy()[:4] == pytest.approx(UPRIGHT.at(CORNERS))
    assert (shade.get_fill(), rim.get_fill(), rim.get_linewidth()) == (True, False, 1.5)


def test_a_pressure_is_the_shade_of_its_cell(ax):
    draw_support(ax, pp.PressureMap([0, 1, 3], [0, 2], [[1, 4]]), Pose((0, 0), 0.0), Ink())
    (cells,) = ax.collections
    light, dark = cells.get_facecolors()[:, :3]
    assert dark == pytest.approx(to_rgb(tint(SLIDER, HIGHEST)))
    assert light == pytest.approx(to_rgb(tint(SLIDER, HIGHEST / 4)))
    first, second = (path.vertices[:4] for path in cells.get_paths())
    assert (np.ptp(first, axis=0), np.ptp(second, axis=0)) == (
        pytest.approx([1, 2]), pytest.approx([2, 2]),
    )  # fmt: skip


def test_a_cell_without_pressure_is_left_out(ax):
    draw_support(ax, pp.PressureMap([0, 1, 3], [0, 2], [[0, 4]]), UPRIGHT, Ink())
    assert len(ax.collections[0].get_paths()) == 1


def test_a_segment_is_a_bar(ax):
    draw_support(ax, pp.Segment((0, -1), (0, 1)), UPRIGHT, Ink())
    (bar,) = ax.lines
    assert bar.get_xydata() == pytest.approx(np.array([[2, 2], [0, 2]]))
    assert bar.get_linewidth() == pytest.approx(BAR)


def test_areas_of_dots_are_in_the_ratio_of_the_weights(ax):
    draw_support(ax, pp.Points([(1, 0), (0, 1), (-1, 0)], [1, 2, 4]), UPRIGHT, Ink())
    dots = [line for line in ax.lines if line.get_marker() == "o"]
    sizes = np.array([dot.get_markersize() for dot in dots])
    assert sizes**2 == pytest.approx(HEAVIEST**2 * np.array([0.25, 0.5, 1.0]))
    assert dots[0].get_xydata()[0] == pytest.approx(UPRIGHT.at((1, 0)))


def test_a_composite_is_its_parts(ax):
    parts = pp.Composite([(1, pp.Disc(1.0)), (1, pp.Segment((2, 0), (3, 0)))])
    draw_support(ax, parts, UPRIGHT, Ink())
    assert len(ax.patches) == 2
    assert BAR in [line.get_linewidth() for line in ax.lines]
