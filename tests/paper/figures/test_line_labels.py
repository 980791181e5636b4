"""Labels at the lines of a panel."""

import numpy as np
import pytest
from matplotlib.figure import Figure

from planar_pushing.drawing.canvas.style import paper_style
from pulling_by_pushing.figures.parts.line_labels import label_lines, named_lines

X = np.linspace(0.1, 10, 2000)
CURVES = {
    "spread": {"low": X, "middle": 2 + X, "high": 4 + X},
    "bundle": {f"curve {k}": 10 / (1 + X) ** (1 + 0.2 * k) for k in range(5)},
    "gaps": {"jump": np.where((X > 4) & (X < 5), np.nan, 3 + X), "level": 0 * X + 3},
}


@pytest.fixture(scope="module", params=CURVES)
def panel(request):
    with paper_style():
        figure = Figure(figsize=(3.0, 2.0))
        ax = figure.subplots()
        for name, heights in CURVES[request.param].items():
            ax.plot(X, heights, label=name)
        ax.plot([5.0], [1.0], "o")
        label_lines(ax, named_lines(ax))
        figure.draw_without_rendering()
    return ax


def on_display(line):
    return line.get_transform().transform(line.get_xydata())


def distance(point, line):
    return np.nanmin(np.hypot(*(on_display(line) - point).T))


def test_each_named_line_has_one_label_in_its_color(panel):
    lines = named_lines(panel)
    assert {text.get_text(): text.get_color() for text in panel.texts} == {
        name: line.get_color() for name, line in lines.items()
    }


def test_a_label_or_its_leader_is_at_its_line(panel):
    lines = named_lines(panel)
    leaders = {
        line.get_color(): on_display(line) for line in panel.lines if line.get_label() == "_leader"
    }
    for text in panel.texts:
        line = lines[text.get_text()]
        box = text.get_window_extent()
        start = leaders.get(text.get_color(), [np.mean(box.get_points(), axis=0)])[0]
        assert min(lines.values(), key=lambda other, start=start: distance(start, other)) is line
        assert distance(start, line) < (2.0 if text.get_color() in leaders else box.width)


def test_labels_cover_no_line_and_no_marker(panel):
    for text in panel.texts:
        (left, low), (right, high) = text.get_window_extent().get_points()
        for line in panel.lines:
            if line.get_label() == "_leader":
                continue
            x, y = on_display(line).T
            assert not ((left < x) & (x < right) & (low < y) & (y < high)).any()
