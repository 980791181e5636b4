"""Drawing of motion over time."""

import numpy as np
import pytest
from matplotlib.colors import same_color
from matplotlib.figure import Figure
from matplotlib.patches import Polygon

from figures.conftest import OTHERS
from planar_pushing.figures.motion.timeline import pivots, plotted
from planar_pushing.figures.motion.trajectory import box, last_center, pose, snapshots
from planar_pushing.figures.parts.bodies import body_of
from planar_pushing.figures.parts.supports import extents
from planar_pushing.figures.style import CENTER


def test_a_far_centre_is_not_shown(logs):
    motion = plotted(logs["figure_15"])
    assert len(last_center(motion)) == 1
    motion["path_center"] += 100
    assert last_center(motion) == []
    assert box(motion)[3] < 10


def test_the_path_of_the_centre_stays_in_the_picture_and_says_where_it_leaves(logs):
    motion = plotted(logs["pulling_with_inertia"])
    ax = snapshots(Figure(figsize=(4, 3)), motion, (0, 0, 1, 1), box(motion), 5)
    path = [
        line.get_xydata()
        for line in ax.lines
        if line.get_color() == CENTER and line.get_linewidth() == 0.9
    ]
    drawn = np.concatenate(path)
    drawn = drawn[np.isfinite(drawn).all(axis=1)]
    (left, right), (low, high) = ax.get_xlim(), ax.get_ylim()
    assert ((drawn >= [left, low]) & (drawn <= [right, high])).all()
    heads = [each for each in ax.patches if getattr(each, "get_arrowstyle", None)]
    assert any(same_color(each.get_edgecolor(), CENTER) for each in heads)


@pytest.mark.parametrize("name", OTHERS)
def test_the_picture_holds_the_whole_support(others, name):
    motion = plotted(others[name])
    left, right, low, high = box(motion)
    for row in range(motion.sizes["time"]):
        (x0, y0), (x1, y1) = extents(body_of(motion).support, pose(motion, row))
        assert left <= x0 <= x1 <= right
        assert low <= y0 <= y1 <= high


def drawn(motion):
    ax = snapshots(Figure(figsize=(4, 3)), motion, (0, 0, 1, 1), box(motion), 3)
    return ax, [text.get_text() for text in ax.texts]


def test_a_pivot_is_marked_where_it_is(others):
    motion = plotted(others["stool"])
    ax, words = drawn(motion)
    assert words.count("pivot") == 1
    (span,) = pivots(motion)
    place = ax.texts[words.index("pivot")].xy
    assert place == pytest.approx(motion.path_center.values[span.start])
    assert ax.get_legend() is None


def test_centres_are_named_in_a_legend(others):
    ax, words = drawn(plotted(others["box"]))
    assert "pivot" not in words
    names = [text.get_text() for text in ax.get_legend().get_texts()]
    assert names == ["centre of pressure", "centre of mass"]
    assert sum(isinstance(each, Polygon) for each in ax.patches) == 6
