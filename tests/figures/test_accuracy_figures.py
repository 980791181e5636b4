"""Figures of what accuracy costs, drawn from the stored errors with times made up for the test."""

from pathlib import Path

import numpy as np
import pytest
import xarray as xr

from planar_pushing.accuracy import tables
from planar_pushing.figures import render
from planar_pushing.figures.evidence import (
    accuracy_evaluations,
    accuracy_wrench,
)
from planar_pushing.figures.style import paper_style
from planar_pushing.study.store import read_dataset, write_dataset

GOLDEN = Path(__file__).parents[1] / "accuracy" / "golden_accuracy.nc"
GROUPS = {
    "accuracy_wrench": "wrench",
    "accuracy_cone": "cone",
    "accuracy_study": "study",
    "accuracy_evaluations": "wrench",
    "accuracy_motion": "motion",
}


def made_up_times(*shape):
    return 10 ** np.random.default_rng(2).uniform(-7, -3, shape)


@pytest.fixture(scope="module")
def data(tmp_path_factory):
    wrench, cone = (read_dataset(GOLDEN, name) for name in ("wrench", "cone"))
    points = wrench.sizes["point"], wrench.sizes["spin_ratio"]
    wrench["wrench_seconds"] = ("point", "spin_ratio", "repeat"), made_up_times(*points, 3)
    cone["cone_seconds"] = ("point", "repeat"), made_up_times(cone.sizes["point"], 3)
    study = xr.Dataset(
        {
            "size_seconds": (("size", "repeat"), made_up_times(3, 3)),
            "size_memory": ("size", [10**4, 10**5, 10**6]),
            "point_error": ("size", [1e-14] * 3),
            "interpolation_error": ("size", [1.0, 1e-2, 1e-4]),
            "block_seconds": (("block", "repeat"), made_up_times(2, 3)),
            "block_memory": ("block", [10**4, 10**6]),
        },
        coords={"size": [10**3, 10**4, 10**5], "block": [2**8, 2**16]},
    )
    path = tmp_path_factory.mktemp("data") / "accuracy.nc"
    runs = read_dataset(GOLDEN, "motion")
    points = runs.sizes["point"], runs.sizes["scene"]
    runs["motion_seconds"] = ("point", "scene", "repeat"), 1e3 * made_up_times(*points, 3)
    groups = {"wrench": wrench, "cone": cone, "study": study, "motion": runs}
    write_dataset({name: tables.described(each) for name, each in groups.items()}, path)
    return path


@pytest.fixture(scope="module")
def pictures(data):
    found = {}
    with paper_style():
        for name in GROUPS:
            found[name] = render.picture(name, read_dataset(data, GROUPS[name]))
    return found


def markers(ax):
    """Coordinates of every drawn marker."""
    lines = [np.column_stack(line.get_data()) for line in ax.lines if line.get_marker() != "None"]
    return np.concatenate(lines)


@pytest.mark.parametrize("index", range(9))
def test_wrench_markers_are_least_times_and_errors_within_the_axis(pictures, data, index):
    one = read_dataset(data, "wrench").isel(spin_ratio=index)
    low, high = accuracy_wrench.LIMITS
    wanted = np.column_stack([one.wrench_seconds.min("repeat"), np.clip(one.error, low, high)])
    shown = markers(pictures["accuracy_wrench"].axes[index])
    assert np.array_equal(shown[np.lexsort(shown.T)], wanted[np.lexsort(wanted.T)])


@pytest.mark.parametrize("panel", range(4))
def test_markers_against_evaluations(pictures, data, panel):
    one = read_dataset(data, "wrench").isel(spin_ratio=accuracy_evaluations.SHOWN[panel])
    low, high = accuracy_evaluations.LIMITS
    ax = pictures["accuracy_evaluations"].axes[panel]
    evaluated = one.evaluations.values > 0
    errors = np.clip(one.error.values, low, high)
    wanted = np.column_stack([one.evaluations, errors])[evaluated]
    shown = markers(ax)
    strip = shown[:, 0] <= accuracy_evaluations.STRIP[1]
    rules = shown[~strip]
    assert np.array_equal(rules[np.lexsort(rules.T)], wanted[np.lexsort(wanted.T)])
    assert sorted(shown[strip, 1]) == sorted(errors[~evaluated])
    assert np.unique(shown[strip, 0]).size == np.count_nonzero(~evaluated) == 6
    assert ax.get_title() == accuracy_wrench.TITLES[accuracy_evaluations.SHOWN[panel]].split(",")[0]


def test_what_is_no_number_is_said_where_it_is(pictures):
    said = [
        any(text.get_text() == "no number" for text in ax.texts)
        for ax in pictures["accuracy_wrench"].axes
    ]
    assert said == [k == 1 for k in tables.SPIN_RATIOS]


def test_panels_are_in_the_order_of_the_spin_ratios():
    assert len(accuracy_wrench.TITLES) == tables.SPIN_RATIOS.size
    for k, title in zip(tables.SPIN_RATIOS, accuracy_wrench.TITLES, strict=True):
        formula = title.split("$")[1].removeprefix("k = ").replace("{", "(").replace("}", ")")
        assert eval(formula.replace("^", "**").replace("10**", "10.0**")) == k


def test_cone_markers_and_bars(pictures, data):
    cone = read_dataset(data, "cone")
    left, right = pictures["accuracy_cone"].axes
    wanted = np.column_stack([cone.cone_seconds.min("repeat"), cone.cone_error])
    shown = markers(left)
    assert np.array_equal(shown[np.lexsort(shown.T)], wanted[np.lexsort(wanted.T)])
    assert [bar.get_height() for bar in right.patches] == list(cone.rim_error.values)


@pytest.mark.parametrize("name", ["accuracy_wrench", "accuracy_cone", "accuracy_evaluations"])
def test_the_legend_names_every_method(pictures, data, name):
    (legend,) = pictures[name].legends
    given = set(read_dataset(data, GROUPS[name]).method.values)
    assert {text.get_text() for text in legend.get_texts()} == given


def test_time_of_a_point_is_the_time_over_the_points(pictures, data):
    study = read_dataset(data, "study")
    ax = pictures["accuracy_study"].axes[0]
    wanted = study.size_seconds.min("repeat") / study["size"] * 1e9
    assert np.allclose(ax.lines[0].get_ydata(), wanted, rtol=1e-14)


@pytest.mark.parametrize("name", ["accuracy_study", "accuracy_evaluations"])
def test_pictures_have_the_same_bytes_twice(data, tmp_path, name):
    first, second = ([tmp_path / f"{run}.{kind}" for kind in ("svg", "pdf", "png")] for run in "ab")
    for paths in (first, second):
        render.render_file(name, data, paths)
    assert all(a.read_bytes() == b.read_bytes() for a, b in zip(first, second, strict=True))
