"""Figures on how this work computes: errors against costs, hard cases, and times of each effect."""

import numpy as np
import pytest

from planar_pushing.evidence.costs import tables
from planar_pushing.evidence.costs.times import TIMED
from planar_pushing.figures import accuracy_evaluations, effect_counts, effects
from planar_pushing.figures import hard_cases as cases
from planar_pushing.figures.parts.methods import LIMITS, SHOWN, TITLES, setting_text

PANELS = range(len(SHOWN))
#: Figures of work and precision, and how many panels each has.
DIAGRAMS = (
    "accuracy_wrench",
    "accuracy_cone",
    "accuracy_motion",
    "accuracy_evaluations",
    "accuracy_time",
)
ROWS = (
    "accuracy_evaluations",
    "accuracy_time",
    "accuracy_evaluations_column",
    "accuracy_time_column",
)


def markers(ax):
    """Coordinates of every drawn marker, sorted."""
    lines = [np.column_stack(line.get_data()) for line in ax.lines if line.get_marker() != "None"]
    return ordered(np.concatenate(lines))


def ordered(points):
    return points[np.lexsort(points.T)]


def timed(one, name="wrench"):
    """Least times, and errors within the axis."""
    error = np.clip(
        np.nan_to_num(one[f"{name}_error" if name == "cone" else "error"], nan=LIMITS[1]), *LIMITS
    )
    return ordered(np.column_stack([one[f"{name}_seconds"].min("repeat"), error]))


def has_nan(ax):
    return any(text.get_text() == "NaN" for text in ax.texts)


@pytest.mark.parametrize("index", range(9))
def test_wrench_markers_are_least_times_and_errors(pictures, plotted, index):
    ax = pictures["accuracy_wrench"].axes[index]
    one = plotted["accuracy_wrench"].isel(spin_ratio=index)
    assert np.array_equal(markers(ax), timed(one))
    assert has_nan(ax) == (tables.SPIN_RATIOS[index] == 1)


def test_panels_are_in_the_order_of_the_spin_ratios():
    assert list(TITLES) == tables.SPIN_RATIOS.tolist()
    assert np.array_equal(SHOWN, TIMED)
    for k, title in TITLES.items():
        formula = title.split("$")[1].removeprefix("k = ").replace("{", "(").replace("}", ")")
        assert eval(formula.replace("^", "**").replace("10**", "10.0**")) == k


@pytest.mark.parametrize("panel", PANELS)
def test_times_are_least_ones_with_hairs_to_the_medians(pictures, plotted, panel):
    figure, one = pictures["accuracy_time"], plotted["accuracy_time"].sel(spin_ratio=SHOWN[panel])
    ax = figure.axes[panel]
    shown = markers(ax)
    assert np.array_equal(shown, timed(one))
    low, high = ax.get_xlim()
    assert low < shown[:, 0].min()
    assert shown[:, 0].max() < high
    hairs = np.concatenate([each.get_segments() for each in ax.collections])
    assert np.array_equal(np.sort(hairs[:, 1, 0]), np.sort(one.wrench_seconds.median("repeat")))
    assert has_nan(ax) == (SHOWN[panel] == 1)
    assert figure.get_supxlabel() == "time for one wrench, seconds"
    assert figure.axes[0].get_ylabel() == "relative error"
    other = pictures["accuracy_evaluations"].axes[panel]  # it makes a pair with this figure
    assert ax.get_title() == other.get_title()
    assert ax.get_ylim() == other.get_ylim()
    assert ax.get_position().bounds == other.get_position().bounds


@pytest.mark.parametrize("panel", PANELS)
def test_markers_against_evaluations(pictures, plotted, panel):
    one = plotted["accuracy_evaluations"].sel(spin_ratio=SHOWN[panel])
    ax = pictures["accuracy_evaluations"].axes[panel]
    evaluated, errors = (
        one.evaluations.values > 0,
        np.clip(np.nan_to_num(one.error.values, nan=LIMITS[1]), *LIMITS),
    )
    shown = markers(ax)
    strip = shown[:, 0] <= accuracy_evaluations.STRIP[1]
    rules = np.column_stack([one.evaluations, errors])[evaluated]
    assert np.array_equal(shown[~strip], ordered(rules))
    assert sorted(shown[strip, 1]) == sorted(errors[~evaluated])
    assert np.unique(shown[strip, 0]).size == np.count_nonzero(~evaluated) == 6
    assert ax.get_title() == TITLES[SHOWN[panel]].split(",")[0]


def test_cone_markers_and_bars(pictures, plotted):
    cone = plotted["accuracy_cone"]
    left, right = pictures["accuracy_cone"].axes
    assert np.array_equal(markers(left), timed(cone, "cone"))
    assert [bar.get_height() for bar in right.patches] == list(cone.rim_error.values)


@pytest.mark.parametrize("name", DIAGRAMS)
def test_the_legend_names_every_method(pictures, plotted, name):
    (legend,) = pictures[name].legends
    assert {text.get_text() for text in legend.get_texts()} == set(plotted[name].method.values)


@pytest.mark.parametrize("name", ["accuracy_wrench", *ROWS])
def test_no_mark_stands_on_the_frame(pictures, name):
    for ax in pictures[name].axes:
        low, high = ax.get_ylim()
        marks = markers(ax)[:, 1]
        assert marks.min() > 2 * low
        assert marks.max() < high / 2


@pytest.mark.parametrize(
    ("value", "text"),
    [(1e-12, "$10^{-12}$"), (2e-5, r"$2 \times 10^{-5}$"), (16, "16"), (65536, "65\u2009536")],
)
def test_settings_are_written_in_one_way(value, text):
    assert setting_text(value) == text


@pytest.mark.parametrize(
    ("name", "panel", "method", "words"),
    [
        ("accuracy_motion", 0, "event-driven", "tolerance {}"),
        ("accuracy_motion", 1, "time-stepping", "{} steps"),
        ("accuracy_cone", 0, "cubic table", "{} entries"),
    ],
)
def test_the_ends_of_a_line_are_named_by_their_settings(
    pictures, plotted, name, panel, method, words
):
    found = plotted[name]
    ends = found.setting[found.method == method].values[[0, -1]]
    texts = [text.get_text() for text in pictures[name].axes[panel].texts]
    assert {words.format(setting_text(end)) for end in ends} <= set(texts)


@pytest.mark.parametrize(("panel", "scene"), list(enumerate(effects.PANELS)))
def test_times_of_the_effects_are_the_least_ones_within_the_axis(pictures, plotted, panel, scene):
    data, ax = plotted["effects"], pictures["effects"].axes[panel]
    times = 1e3 * data.time[np.flatnonzero(data.scene.values == scene)].min("repeat")
    low, high = ax.get_xlim()
    assert sorted(markers(ax)[:, 0]) == pytest.approx(sorted(times.values), rel=1e-14)
    assert low <= float(times.min())
    assert float(times.max()) <= high


def test_times_by_the_number_of_effects_are_ratios_to_one(pictures, plotted):
    data, ax = plotted["effects"], pictures["effects"].axes[-1]
    divided = data.isel(case=np.flatnonzero(data.scene.values == effects.DIVIDED))
    times = divided.time.min("repeat").values
    proportional, drawn = (np.column_stack(line.get_data()) for line in ax.lines)
    assert proportional.tolist() == [[number, number] for number in divided.number.values]
    assert drawn.tolist() == np.column_stack([divided.number, times / times[0]]).tolist()


@pytest.mark.parametrize("name", ["effect_counts", "effect_counts_column"])
def test_evaluations_are_bars_of_what_is_listed(pictures, plotted, name):
    counts = plotted["effect_counts"].evaluations
    for ax, method in zip(pictures[name].axes, effect_counts.PANELS, strict=True):
        one = counts.sel(integrator=method)
        shown = [one.sel(effects=each).values for each in effect_counts.LISTS]
        assert [bar.get_width() for bar in ax.patches] == np.ravel(shown).tolist()
        numbers = [text.get_text() for text in ax.texts]
        assert numbers == [f"{each}" for each in np.ravel(shown) if each]


@pytest.mark.parametrize("name", ["hard_cases", "hard_cases_column"])
def test_hard_cases_are_drawn_in_groups_from_best_to_worst_condition(pictures, plotted, name):
    data, (ax,) = plotted["hard_cases"], pictures[name].axes
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
