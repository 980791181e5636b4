"""Time, memory and error of a grid."""

import numpy as np

from planar_pushing.study.store import read_dataset


def test_time_of_a_point_is_the_time_over_the_points(pictures, data):
    study = read_dataset(data, "study")
    ax = pictures["accuracy_study"].axes[0]
    wanted = study.size_seconds.min("repeat") / study["size"] * 1e9
    assert np.allclose(ax.lines[0].get_ydata(), wanted, rtol=1e-14)
