"""Work-precision diagram of a motion cone."""

import numpy as np

from figures.evidence.conftest import markers
from planar_pushing.study.store import read_dataset


def test_cone_markers_and_bars(pictures, data):
    cone = read_dataset(data, "cone")
    left, right = pictures["accuracy_cone"].axes
    wanted = np.column_stack([cone.cone_seconds.min("repeat"), cone.cone_error])
    shown = markers(left)
    assert np.array_equal(shown[np.lexsort(shown.T)], wanted[np.lexsort(wanted.T)])
    assert [bar.get_height() for bar in right.patches] == list(cone.rim_error.values)
