"""Properties of every figure: its declaration, and that its picture is legible."""

from itertools import combinations

import numpy as np
import pytest
from figures.conftest import FIGURES, NUMBERED
from matplotlib.text import Text

from planar_pushing.drawing.canvas.style import COLUMN, PAGE, paper_style
from pulling_by_pushing.figures.figure import entry
from pulling_by_pushing.figures.studies import OURS

#: Text may leave the figure by this much, points: boxes of letters are larger than the letters.
CUT = 2.0


@pytest.mark.parametrize("name", FIGURES)
def test_a_figure_is_declared_whole(name):
    figure = entry(name)
    assert set(FIGURES) == {*NUMBERED, *OURS}
    assert figure.title
    assert figure.reads
    assert bool(figure.section) == (name in NUMBERED)
    assert bool(figure.promise) == (name <= "figure_12" and name in NUMBERED)
    assert figure.size[0] in (COLUMN, PAGE)


def texts(figure):
    """The texts that are drawn, and their boxes in points."""
    hidden = set()
    for ax in figure.axes:
        for axis in (ax.xaxis, ax.yaxis):
            low, high = sorted(axis.get_view_interval()) if ax.axison else (1, 0)
            for tick in (*axis.get_major_ticks(), *axis.get_minor_ticks()):
                if not low - 1e-9 * (high - low) <= tick.get_loc() <= high + 1e-9 * (high - low):
                    hidden |= {tick.label1, tick.label2}
    found = [text for text in figure.findobj(Text) if text.get_visible() and text.get_text()]
    inches = figure.dpi_scale_trans.inverted()
    with paper_style():
        boxes = [text.get_window_extent().transformed(inches) for text in found]
    return [(t, 72 * b.get_points()) for t, b in zip(found, boxes, strict=True) if t not in hidden]


@pytest.mark.parametrize("name", FIGURES)
def test_no_text_is_cut_small_or_on_another(pictures, name):
    figure = pictures[name]
    size, found = 72 * figure.get_size_inches(), texts(figure)
    assert np.isfinite(size).all()
    assert found
    cut = [
        text.get_text()
        for text, (low, high) in found
        if (low < -CUT).any() or (high > size + CUT).any()
    ]
    assert not cut
    assert min(text.get_fontsize() for text, _ in found) >= 6.5
    for (one, first), (other, second) in combinations(found, 2):
        covered = ((first[0] + 1 < second[1] - 1) & (second[0] + 1 < first[1] - 1)).all()
        assert not covered, (one.get_text(), other.get_text())
