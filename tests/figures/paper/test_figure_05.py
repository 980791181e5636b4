"""Figure 5."""

import numpy as np
from numpy.testing import assert_allclose


def test_without_a_rod_the_curve_is_a_circle(plotted):
    curve = plotted["figure_05"].sel(rod_length=0.0)
    assert_allclose(np.hypot(curve.force_x, curve.force_y), 1, rtol=1e-15)


def test_velocity_is_parallel_to_the_four_special_forces(plotted):
    data = plotted["figure_05"]
    assert data.parallel_angle.values.tolist() == [45, 135, 225, 315]
    angles = data.parallel_motion_angle.broadcast_like(data.parallel_force)
    assert_allclose(angles, data.parallel_angle.broadcast_like(angles), rtol=1e-13)


def test_infinite_rod_is_the_segment_along_it(plotted):
    half = np.sqrt(0.5)
    assert_allclose(plotted["figure_05"].infinite_rod_x, [half, -half], rtol=1e-14)
    assert_allclose(plotted["figure_05"].infinite_rod_y, [half, -half], rtol=1e-14)
