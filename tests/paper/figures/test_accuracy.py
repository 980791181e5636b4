"""Figures on how this work computes: errors against times, the cost of each effect, and hard cases."""

import numpy as np
import pytest
from matplotlib.figure import Figure

from pulling_by_pushing.figures.evidence import accuracy
from pulling_by_pushing.figures.evidence import hard_cases as cases
from pulling_by_pushing.figures.parts.methods import setting_text, with_times, within

#: Panels of the figure in order: selection of the data, quantity and limits.
WRENCHES = [({"spin_ratio": k}, "wrench", accuracy.RELATIVE) for k in accuracy.SPIN_RATIOS]
MOTIONS = [({"scene": scene}, "motion", accuracy.DEGREES) for scene in accuracy.SCENES]
PANELS = [*WRENCHES, ({}, "cone", accuracy.DEGREES), *MOTIONS]
CONE = len(WRENCHES)


def markers(ax):
    """Coordinates of every drawn marker, sorted."""
    lines = [np.column_stack(line.get_data()) for line in ax.lines if line.get_marker() != "None"]
    return ordered(np.concatenate(lines))


def ordered(points):
    return points[np.lexsort(points.T)]


@pytest.mark.parametrize(
    ("panel", "selection", "quantity", "limits"),
    [(panel, *rest) for panel, rest in enumerate(PANELS)],
)
def test_markers_are_at_the_least_times_with_hairs_to_the_medians(
    pictures, plotted, panel, selection, quantity, limits
):
    ax = pictures["accuracy"].axes[panel]
    part = with_times(plotted["accuracy"], quantity).sel(selection)
    times, errors = part[f"{quantity}_seconds"], within(part[f"{quantity}_error"].values, limits)
    ours = np.isin(part.method.values, ["closed form", "event-driven"])
    calls = part[f"{quantity}_call_seconds"].min("repeat").values[ours]
    drawn = markers(ax)
    shown = np.column_stack([times.min("repeat"), errors])
    expected = np.concatenate([shown, np.column_stack([calls, errors[ours]])])
    assert np.array_equal(drawn, ordered(expected))
    hairs = np.concatenate([lines.get_segments() for lines in ax.collections])
    assert np.array_equal(np.sort(hairs[:, 1, 0]), np.sort(times.median("repeat")))
    for values, (low, high) in zip(drawn.T, (ax.get_xlim(), ax.get_ylim()), strict=True):
        assert low < values.min()
        assert values.max() < high


@pytest.mark.parametrize(("panel", "k"), list(enumerate(accuracy.SPIN_RATIOS)))
def test_panels_are_named_by_their_spin_ratios(pictures, panel, k):
    ax = pictures["accuracy"].axes[panel]
    formula = ax.get_title().strip("$").removeprefix("k = ").replace("{", "(").replace("}", ")")
    assert eval(formula.replace("^", "**").replace("10**", "10.0**")) == k
    assert any(text.get_text() == "NaN" for text in ax.texts) == (k == 1)


def test_an_error_of_zero_has_a_tick(plotted):
    data = plotted["accuracy"]
    wrench = data["accuracy/wrench"]
    exact = {**data, "accuracy/wrench": wrench.assign(wrench_error=0 * wrench.wrench_error)}
    for errors, ticks in ((data, []), (exact, ["0"])):
        figure = Figure(figsize=accuracy.FIGURE.size)
        accuracy.draw(figure, errors)
        labels = [text.get_text() for text in figure.axes[0].get_yticklabels()]
        assert labels[:-5] == ticks


def test_every_method_is_named(pictures, plotted):
    """Those of the wrench in the legend, the others in their panels."""
    (legend,) = pictures["accuracy"].legends
    data = plotted["accuracy"]
    assert {text.get_text() for text in legend.get_texts()} == {
        *data["accuracy/wrench"].method.values, "one call"
    }  # fmt: skip
    for panel, (_, quantity, _) in list(enumerate(PANELS))[CONE:]:
        words = " ".join(text.get_text() for text in pictures["accuracy"].axes[panel].texts)
        assert all(name in words for name in data[f"accuracy/{quantity}"].method.values)


def test_times_without_arrays_are_those_of_calls(plotted):
    data = plotted["accuracy"]
    for quantity in ("wrench", "cone", "motion"):
        shown, times = with_times(data, quantity), data[f"accuracy_time/{quantity}"]
        alone = np.isnan(times[f"{quantity}_seconds"])
        expected = times[f"{quantity}_call_seconds"].where(alone, times[f"{quantity}_seconds"])
        assert alone.any()
        assert np.array_equal(shown[f"{quantity}_seconds"], expected)


def test_the_largest_error_of_the_ellipsoid_and_the_time_of_a_log_are_lines(pictures, plotted):
    lines = [line.get_ydata()[0] for line in pictures["accuracy"].axes[CONE].lines]
    assert np.rad2deg(np.arcsin(1 / 3)) in lines
    times = plotted["accuracy"]["accuracy_time/motion"].log_seconds
    for panel, scene in enumerate(accuracy.SCENES, CONE + 1):
        lines = [line.get_xdata()[0] for line in pictures["accuracy"].axes[panel].lines]
        assert float(times.sel(scene=scene).min()) in lines


@pytest.mark.parametrize(
    ("value", "text"), [(1e-12, "$10^{-12}$"), (16, "16"), (65536, "65\u2009536")]
)
def test_settings_are_written_in_one_way(value, text):
    assert setting_text(value) == text


@pytest.mark.parametrize(
    ("panel", "method", "words"),
    [
        (CONE, "brentq on quad", "tolerance {}"),
        (CONE + 1, "event-driven", "tolerance {}"),
        (CONE + 2, "time-stepping", "{} steps"),
    ],
)
def test_the_ends_of_a_line_are_named_by_their_settings(pictures, plotted, panel, method, words):
    data = plotted["accuracy"][f"accuracy/{PANELS[panel][1]}"]
    first, last = data.setting.values[data.method.values == method][[0, -1]]
    texts = [text.get_text() for text in pictures["accuracy"].axes[panel].texts]
    assert any(text.endswith(words.format(setting_text(first))) for text in texts)
    assert setting_text(last) in texts


def test_hard_cases_are_drawn_in_groups_from_best_to_worst_condition(pictures, plotted):
    data, (ax,) = plotted["hard_cases"]["hard_cases"], pictures["hard_cases"].axes
    strokes, usual, ill = (np.column_stack(line.get_data()) for line in ax.lines[:3])
    order = np.lexsort((data.condition.values, data.line.values))
    assert strokes[:, 1].tolist() == data.condition.values[order].tolist()
    errors = np.maximum(data.error_ulp.values[order], cases.FLOOR)
    is_ill = data.ill_conditioned.values[order] > 0
    assert usual[:, 1].tolist() == errors[~is_ill].tolist()
    assert ill[:, 1].tolist() == errors[is_ill].tolist()
    assert np.diff(strokes[:, 0]).tolist() == [
        1 + cases.GAP * gap for gap in np.diff(data.line.values[order])
    ]
