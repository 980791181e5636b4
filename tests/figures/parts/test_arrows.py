"""Arrows."""

import matplotlib
import numpy as np
import pytest
from matplotlib.patches import ArrowStyle, FancyArrowPatch

from planar_pushing.figures import style
from planar_pushing.figures.parts import arrows


def heads(ax):
    return [type(p.get_arrowstyle()) for p in ax.patches if isinstance(p, FancyArrowPatch)]


def test_a_force_has_a_filled_head(ax):
    patch = arrows.force_arrow(ax, (0, 0), (1, 1), "f")
    assert isinstance(patch.get_arrowstyle(), ArrowStyle.get_styles()["-|>"])
    assert matplotlib.colors.same_color(patch.get_facecolor(), style.FORCE)


def test_motions_have_open_heads(ax):
    arrows.motion_arrow(ax, (0, 0), (1, 1), "v")
    arrows.turning(ax, (0, 0), 1, 0.5)
    arrows.coordinate_axes(ax, (0, 0), 0, 1, ("x", "y"))
    assert heads(ax) == 4 * [ArrowStyle.get_styles()["->"]]


@pytest.mark.parametrize("angle", [-170.0, -90.0, 0.0, 33.0, 180.0])
@pytest.mark.parametrize("arrow", [arrows.force_arrow, arrows.motion_arrow])
def test_an_arrow_keeps_its_direction_exactly(ax, arrow, angle):
    patch = arrow(ax, (0.3, 0.2), 1.5 * arrows.unit(angle))
    ends = patch.get_path().vertices[:2]
    along = ends[1] - ends[0]
    assert ends[0] == pytest.approx([0.3, 0.2])
    assert np.hypot(*along) * arrows.unit(angle) == pytest.approx(along)


@pytest.mark.parametrize(("sense", "side"), [(1.0, -1.0), (-1.0, 1.0)])
def test_a_turn_to_the_left_ends_on_the_left(ax, sense, side):
    shaft = arrows.turning(ax, (0, 0), sense, 0.5).get_path().vertices
    assert np.sign(shaft[0, 0]) == -side
