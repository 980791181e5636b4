"""Drawing of motion over time."""

from planar_pushing.figures.motion.timeline import plotted
from planar_pushing.figures.motion.trajectory import box, faded, last_center


def test_a_far_centre_is_not_shown(logs):
    motion = plotted(logs["figure_15"])
    assert len(last_center(motion)) == 1
    motion["path_center"] += 100
    assert last_center(motion) == []
    assert box(motion)[3] < 10


def test_faded_colours():
    assert (faded("#336699", 1.0), faded("#336699", 0.0)) == ("#336699", "#ffffff")
