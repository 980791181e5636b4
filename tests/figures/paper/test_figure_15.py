"""Figure 15."""

import numpy as np
from numpy.testing import assert_allclose


def test_the_ring_centre_keeps_its_height_in_slip_with_infinite_friction(plotted):
    slip = plotted["figure_15"]
    height = slip.path_position.sel(xy="y")
    assert_allclose(height, 5 * np.sin(np.deg2rad(45)), rtol=0, atol=1e-11)
    sine = np.sin(np.deg2rad(slip.path_rod_angle))
    expected = np.sin(np.deg2rad(45)) - slip.time * np.sin(np.deg2rad(165)) / 5
    assert_allclose(sine, expected, rtol=0, atol=1e-12)
