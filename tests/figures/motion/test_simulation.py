"""Pictures of simulations."""

import pytest
from matplotlib.figure import Figure

from planar_pushing.figures.motion import over_time, simulation
from planar_pushing.figures.motion.timeline import MODES, impacts, pivots, plotted
from planar_pushing.figures.style import paper_style


def test_a_simulation_shows_what_varies(logs):
    labels = {}
    with paper_style():
        for name in ("figure_14b", "figure_15"):
            figure = Figure(figsize=(7.0, 2.9))
            simulation.draw(figure, plotted(logs[name]))
            labels[name] = [ax.get_ylabel() for ax in figure.axes if ax.get_ylabel()]
    assert labels["figure_14b"][1:] == ["gap"]
    assert labels["figure_15"][1:] == ["slip"]


def texts(ax):
    return [text.get_text() for text in ax.texts]


def test_an_impact_is_marked_in_space_and_time(logs):
    log = logs["impact"]
    (row,) = impacts(log)
    assert log.gap[row] == 0 < log.gap[row - 1]
    figure = Figure(figsize=(7.0, 2.9))
    with paper_style():
        simulation.draw(figure, plotted(log), impacts(log))
    assert "impact" in texts(figure.axes[0])
    for ax in figure.axes[1:]:
        assert any(set(line.get_xdata()) == {float(log.time[row])} for line in ax.lines)


@pytest.mark.parametrize("name", ["figure_14a", "figure_14b", "figure_15"])
def test_slow_motion_has_no_impact(logs, name):
    assert impacts(logs[name]) == []


def test_a_fence_that_jumps_strikes_what_it_touches(logs):
    log = logs["pulling_with_inertia"]
    assert [float(log.time[row]) for row in impacts(log)] == [0.5]


def test_hatching_has_a_legend_where_there_is_any(logs):
    found = {}
    with paper_style():
        for name in ("figure_14a", "figure_15"):
            figure = Figure(figsize=(7.0, 2.9))
            simulation.draw(figure, plotted(logs[name]))
            found[name] = figure.axes[-1].get_legend()
    assert [text.get_text() for text in found["figure_14a"].get_texts()] == ["several consistent"]
    assert found["figure_15"] is None


def test_pivots_are_a_bar_on_the_strip_with_a_legend(others):
    motion = plotted(others["stool"])
    figure = Figure(figsize=(7.0, 2.9))
    with paper_style():
        simulation.draw(figure, motion)
    strip = figure.axes[-1]
    (text,) = strip.get_legend().get_texts()
    assert text.get_text() == "pivots about a support point"
    (span,) = pivots(motion)
    (bar,) = (each for each in strip.patches if each.get_height() == over_time.PIVOT)
    times = motion.time.values[[span.start, span.stop]]
    assert (bar.get_x(), bar.get_x() + bar.get_width()) == pytest.approx(tuple(times))


@pytest.mark.parametrize("color", [color for color, _ in MODES.values()])
def test_names_of_modes_are_readable(color):
    def luminance(each):
        return over_time.luminance(each) + 0.05

    pair = luminance(color), luminance(over_time.readable_on(color))
    assert max(pair) / min(pair) > 4
