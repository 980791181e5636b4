"""Figures on how this work computes: errors against times, the cost of each effect, and hard cases."""

import numpy as np
import pytest

from pulling_by_pushing.figures.evidence import accuracy_cone_motion, accuracy_wrench, effects
from pulling_by_pushing.figures.evidence import hard_cases as cases
from pulling_by_pushing.figures.parts.methods import setting_text, with_times, within

#: Figures of work and precision, and their panels: selection of the data, quantity and limits.
WRENCHES = [
    ("accuracy_wrench", panel, {"spin_ratio": k}, "wrench", accuracy_wrench.LIMITS)
    for panel, k in enumerate(accuracy_wrench.PANELS)
]
MOTIONS = [
    ("accuracy_cone_motion", 1 + panel, {"scene": scene}, "motion", accuracy_cone_motion.LIMITS)
    for panel, scene in enumerate(accuracy_cone_motion.TITLES)
]
CONE = ("accuracy_cone_motion", 0, {}, "cone", accuracy_cone_motion.LIMITS)
PANELS = [*WRENCHES, CONE, *MOTIONS]


def markers(ax):
    """Coordinates of every drawn marker, sorted."""
    lines = [np.column_stack(line.get_data()) for line in ax.lines if line.get_marker() != "None"]
    return ordered(np.concatenate(lines))


def ordered(points):
    return points[np.lexsort(points.T)]


@pytest.mark.parametrize(("name", "panel", "where", "quantity", "limits"), PANELS)
def test_markers_are_at_the_least_times_with_hairs_to_the_medians(
    pictures, plotted, name, panel, where, quantity, limits
):
    ax, part = pictures[name].axes[panel], with_times(plotted[name], quantity).sel(where)
    times, errors = part[f"{quantity}_seconds"], within(part[f"{quantity}_error"].values, limits)
    drawn = markers(ax)
    assert np.array_equal(drawn, ordered(np.column_stack([times.min("repeat"), errors])))
    hairs = np.concatenate([each.get_segments() for each in ax.collections])
    assert np.array_equal(np.sort(hairs[:, 1, 0]), np.sort(times.median("repeat")))
    for place, (low, high) in zip(drawn.T, (ax.get_xlim(), ax.get_ylim()), strict=True):
        assert low < place.min()
        assert place.max() < high


@pytest.mark.parametrize(("panel", "k"), list(enumerate(accuracy_wrench.PANELS)))
def test_panels_are_named_by_their_spin_ratios(pictures, panel, k):
    ax = pictures["accuracy_wrench"].axes[panel]
    formula = ax.get_title().strip("$").removeprefix("k = ").replace("{", "(").replace("}", ")")
    assert eval(formula.replace("^", "**").replace("10**", "10.0**")) == k
    assert any(text.get_text() == "NaN" for text in ax.texts) == (k == 1)


@pytest.mark.parametrize("name", ["accuracy_wrench", "accuracy_cone_motion"])
def test_the_legend_names_every_method(pictures, plotted, name):
    (legend,) = pictures[name].legends
    names = {method for each in plotted[name].values() for method in each.method.values}
    assert {text.get_text() for text in legend.get_texts()} == names


@pytest.mark.parametrize(
    ("value", "text"), [(1e-12, "$10^{-12}$"), (16, "16"), (65536, "65\u2009536")]
)
def test_settings_are_written_in_one_way(value, text):
    assert setting_text(value) == text


@pytest.mark.parametrize(
    ("panel", "method", "words"),
    [
        (0, "brentq on quad", "tolerance {}"),
        (1, "event-driven", "tolerance {}"),
        (2, "time-stepping", "{} steps"),
    ],
)
def test_the_ends_of_a_line_are_named_by_their_settings(pictures, plotted, panel, method, words):
    data = plotted["accuracy_cone_motion"][f"accuracy/{'motion' if panel else 'cone'}"]
    settings = data.setting.values[data.method.values == method]
    texts = [text.get_text() for text in pictures["accuracy_cone_motion"].axes[panel].texts]
    assert {words.format(setting_text(end)) for end in settings[[0, -1]]} <= set(texts)


def test_evaluations_are_bars_of_what_is_listed(pictures, plotted):
    counts = plotted["effects"]["effects"].evaluations
    for ax, method in zip(pictures["effects"].axes, effects.PANELS, strict=False):
        one = counts.sel(integrator=method)
        shown = [one.sel(effects=each).values for each in effects.LISTS]
        assert [bar.get_width() for bar in ax.patches] == np.ravel(shown).tolist()
        numbers = [text.get_text() for text in ax.texts]
        assert numbers == [f"{each}" for each in np.ravel(shown) if each]


def test_times_of_the_effects_are_the_least_ones(pictures, plotted):
    times, ax = (
        plotted["effects"]["effects"].computation_seconds.min("repeat"),
        pictures["effects"].axes[2],
    )
    for line, listed in zip(ax.lines, effects.LISTS, strict=True):
        one = 1e3 * times.sel(effects=listed, computation=list(effects.COMPUTATIONS))
        assert line.get_xdata().tolist() == one.values.tolist()
        assert np.round(line.get_ydata()).tolist() == list(range(len(effects.COMPUTATIONS)))


def test_times_by_the_number_of_supports_are_ratios_to_one(pictures, plotted):
    times, ax = (
        plotted["effects"]["effects"].supports_seconds.min("repeat"),
        pictures["effects"].axes[3],
    )
    proportional, drawn = (np.column_stack(line.get_data()) for line in ax.lines)
    assert proportional.tolist() == [[number, number] for number in times.supports.values]
    assert drawn.tolist() == np.column_stack([times.supports, times / times[0]]).tolist()


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
