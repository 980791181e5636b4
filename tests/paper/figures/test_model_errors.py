"""The figure on which effects a push calls for draws the values of its datasets."""

import numpy as np
import pytest

from planar_pushing.assessment.estimate import FACTOR
from pulling_by_pushing.figures.evidence import model_errors


@pytest.fixture
def panels(pictures):
    return pictures["model_errors"].axes


def lines(ax, color, style):
    return [
        line for line in ax.lines if line.get_color() == color and line.get_linestyle() == style
    ]


@pytest.mark.parametrize(("name", "color"), [(k, v[0]) for k, v in model_errors.SUPPORTS.items()])
def test_lines_are_medians(panels, plotted, name, color):
    errors = plotted["model_errors"]["model_errors"].sel(support=name)
    for left_out, style in (("inertia", "-"), ("friction", "--")):
        (line,) = lines(panels[0], color, style)
        drawn = np.median(1e3 * errors.pose_error.sel(left_out=left_out), axis=0)
        assert line.get_xdata().tolist() == errors.speed.values.tolist()
        assert line.get_ydata() == pytest.approx(drawn, rel=1e-12)
    (both,), (alone,) = lines(panels[1], color, "-"), lines(panels[1], color, "--")
    assert both.get_ydata() == pytest.approx(np.median(errors.evaluations, axis=0))
    friction = errors.evaluations_alone.sel(left_out="inertia")
    assert alone.get_ydata() == pytest.approx(np.full(2, np.median(friction)))


def test_the_first_push_on_the_base_is_marked(panels, plotted):
    errors = plotted["model_errors"]["model_errors"]
    (mark,) = (line for line in panels[0].lines if line.get_marker() == "o")
    drawn = errors.pose_error.sel(support="base", left_out="inertia").isel(push=0)
    assert mark.get_ydata() == pytest.approx(1e3 * drawn.sel(speed=mark.get_xdata()).values)


def test_the_upper_axis_is_the_coasting_length_over_the_way(panels, plotted):
    """At the speed at which the box coasts as far as it is pushed, this is 1."""
    errors, (upper,) = plotted["model_errors"]["model_errors"], panels[0].child_axes
    speed = np.sqrt(2 * 0.3 * 9.80665 * 0.08)
    forward, backward = upper._functions
    assert forward(speed) == pytest.approx(1.0)
    assert backward(1.0) == pytest.approx(speed)
    assert float(model_errors.coasting_length(errors, speed)) == pytest.approx(0.08)


def test_every_random_push_is_drawn_below_the_line(panels, plotted):
    estimates = plotted["model_errors"]["model_estimates"]
    drawn = {line.get_color(): line for line in panels[2].lines if len(line.get_xdata()) > 2}
    assert len(drawn) == len(model_errors.EFFECTS)
    for name, (color, _, _) in model_errors.EFFECTS.items():
        x, y = drawn[color].get_data()
        assert x == pytest.approx(1e3 * estimates.estimate.sel(effect=name).values)
        lowest = model_errors.ERRORS[0]
        assert y == pytest.approx(np.maximum(1e3 * estimates.pose_error.sel(effect=name), lowest))
        assert (y <= np.maximum(FACTOR * x, lowest)).all()


def test_lines_and_marks_are_within_the_axes(panels):
    """But for the lines of closed forms, which leave them."""
    for ax in panels[:3]:
        for line in ax.lines:
            if line.get_linestyle() == "-" and line.get_color() != "#333333":
                x, y = map(np.asarray, line.get_data())
                (left, right), (low, high) = ax.get_xlim(), ax.get_ylim()
                assert (left <= x).all()
                assert (x <= right).all()
                assert (low <= y).all()
                assert (y <= high).all()
