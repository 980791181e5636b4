"""Drawing of motion over time."""

import numpy as np
from matplotlib.colors import same_color
from matplotlib.figure import Figure

from planar_pushing.figures.motion.timeline import plotted
from planar_pushing.figures.motion.trajectory import box, last_center, snapshots
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
