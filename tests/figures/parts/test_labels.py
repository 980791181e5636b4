"""Labels."""

import pytest

from planar_pushing.figures.parts import arrows, labels
from planar_pushing.figures.parts.labels import declutter


def boxes(ax):
    return [text.get_window_extent() for text in ax.texts]


def test_decluttering_parts_labels_that_cover_each_other(ax):
    for _ in range(4):
        labels.label(ax, (0, 0), "label", offset=(9, 0))
    declutter(ax)
    found = boxes(ax)
    assert not any(a.overlaps(b) for i, a in enumerate(found) for b in found[:i])


def test_decluttering_moves_a_label_off_an_arrow_and_into_the_frame(ax):
    arrows.force_arrow(ax, (0, 0), (0, 2))
    text = labels.label(ax, (0, 1), "on the shaft", offset=(0, 9))
    edge = labels.label(ax, (ax.get_xlim()[1], 1), "edge", offset=(9, 0))
    declutter(ax)
    low, high = (
        ax.transData.inverted().transform(p) for p in text.get_window_extent().get_points()
    )
    assert low[0] > 0 or high[0] < 0
    assert edge.get_window_extent().x1 <= ax.get_window_extent().x1


def test_decluttering_leaves_labels_without_an_offset_and_free_ones(ax):
    fixed = labels.label(ax, (0, 0), "a")
    free = labels.label(ax, (1, 1), "b", offset=(0, 9))
    declutter(ax)
    assert fixed.xyann == (0, 0)
    assert free.xyann == pytest.approx((0, 9))
