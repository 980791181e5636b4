"""Work-precision diagrams of the wrench."""

import numpy as np
import pytest

from figures.evidence.conftest import markers
from planar_pushing.evidence.costs import tables
from planar_pushing.figures.evidence.work_precision import LIMITS, TITLES
from planar_pushing.study.store import read_dataset


@pytest.mark.parametrize("index", range(9))
def test_wrench_markers_are_least_times_and_errors_within_the_axis(pictures, data, index):
    one = read_dataset(data, "wrench").isel(spin_ratio=index)
    low, high = LIMITS
    wanted = np.column_stack([one.wrench_seconds.min("repeat"), np.clip(one.error, low, high)])
    shown = markers(pictures["accuracy_wrench"].axes[index])
    assert np.array_equal(shown[np.lexsort(shown.T)], wanted[np.lexsort(wanted.T)])


def test_nan_is_marked_where_it_stands(pictures):
    said = [
        any(text.get_text() == "NaN" for text in ax.texts)
        for ax in pictures["accuracy_wrench"].axes
    ]
    assert said == [k == 1 for k in tables.SPIN_RATIOS]


def test_panels_are_in_the_order_of_the_spin_ratios():
    assert list(TITLES) == tables.SPIN_RATIOS.tolist()
    for k, title in TITLES.items():
        formula = title.split("$")[1].removeprefix("k = ").replace("{", "(").replace("}", ")")
        assert eval(formula.replace("^", "**").replace("10**", "10.0**")) == k
