"""Errors against times."""

import numpy as np
import pytest

from figures.evidence.conftest import markers
from planar_pushing.evidence.costs.times import TIMED
from planar_pushing.figures.evidence.work_precision import LIMITS, SHOWN
from planar_pushing.study.store import read_dataset

PANELS = range(len(SHOWN))


@pytest.fixture
def axes(pictures):
    return pictures["accuracy_time"].axes


def test_the_spin_ratios_are_those_that_are_timed():
    assert np.array_equal(SHOWN, TIMED)


@pytest.mark.parametrize("panel", PANELS)
def test_markers_are_least_times_and_errors_within_the_axis(axes, data, panel):
    one = read_dataset(data, "wrench").sel(spin_ratio=SHOWN[panel])
    wanted = np.column_stack([one.wrench_seconds.min("repeat"), np.clip(one.error, *LIMITS)])
    shown = markers(axes[panel])
    assert np.array_equal(shown[np.lexsort(shown.T)], wanted[np.lexsort(wanted.T)])
    low, high = axes[panel].get_xlim()
    assert low < shown[:, 0].min()
    assert shown[:, 0].max() < high


@pytest.mark.parametrize("panel", PANELS)
def test_hairs_lead_to_the_medians(axes, data, panel):
    one = read_dataset(data, "wrench").sel(spin_ratio=SHOWN[panel])
    hairs = np.concatenate([each.get_segments() for each in axes[panel].collections])
    assert np.array_equal(np.sort(hairs[:, 1, 0]), np.sort(one.wrench_seconds.median("repeat")))


def test_times_are_seconds_and_nan_is_marked(pictures, axes):
    assert pictures["accuracy_time"].get_supxlabel() == "time for one wrench, seconds"
    assert axes[0].get_ylabel() == "relative error"
    said = [any(text.get_text() == "NaN" for text in ax.texts) for ax in axes]
    assert said == [k == 1 for k in SHOWN]


@pytest.mark.parametrize("panel", PANELS)
def test_it_makes_a_pair_with_the_figure_of_evaluations(pictures, axes, panel):
    one, other = axes[panel], pictures["accuracy_evaluations"].axes[panel]
    assert one.get_title() == other.get_title()
    assert one.get_ylim() == other.get_ylim()
    assert one.get_position().bounds == other.get_position().bounds
