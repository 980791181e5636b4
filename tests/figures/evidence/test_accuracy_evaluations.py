"""Errors against evaluations."""

import numpy as np
import pytest

from figures.evidence.conftest import markers
from planar_pushing.figures.evidence import accuracy_evaluations
from planar_pushing.figures.evidence.work_precision import LIMITS, SHOWN, TITLES
from planar_pushing.study.store import read_dataset


@pytest.mark.parametrize("panel", range(4))
def test_markers_against_evaluations(pictures, data, panel):
    one = read_dataset(data, "wrench").sel(spin_ratio=SHOWN[panel])
    low, high = LIMITS
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
    assert ax.get_title() == TITLES[SHOWN[panel]].split(",")[0]
