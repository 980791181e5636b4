"""Times of each set of effects."""

import numpy as np
import pytest

from figures.evidence.conftest import markers
from planar_pushing.figures import render
from planar_pushing.figures.evidence.effects import PANELS
from report.costs import effects


@pytest.mark.parametrize(("panel", "scene"), list(enumerate(PANELS)))
def test_markers_are_the_least_times_within_the_axis(panel, scene):
    data = effects("{}")
    picture = render.picture("effects", data)
    ax = picture.axes[panel]
    times = 1e3 * data.time[np.flatnonzero(data.scene.values == scene)].min("repeat")
    low, high = ax.get_xlim()
    assert sorted(markers(ax)[:, 0]) == pytest.approx(sorted(times.values), rel=1e-14)
    assert low <= float(times.min())
    assert float(times.max()) <= high
