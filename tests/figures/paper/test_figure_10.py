"""Figure 10."""

import numpy as np
from numpy.testing import assert_allclose


def test_ellipses_have_their_minor_axis_across_the_rod(plotted):
    data = plotted["figure_10"].sel(force_angle=[45.0, 135.0])
    lengths = data.rod_length.values
    size = np.hypot(data.force_x, data.force_y)
    assert_allclose(size.isel(force_angle=0), 1, rtol=1e-14)
    assert_allclose(size.isel(force_angle=1), 1 / np.sqrt(1 + lengths**2), rtol=1e-14)


def test_accelerations_are_those_of_the_equations(plotted):
    data = plotted["figure_10"]
    phi = np.deg2rad(data.mapped_force_angle.values)
    x, y = np.cos(phi), np.sin(phi)  # Eqs. (11) and (12) for l = 1, psi = 45 degrees
    angle = np.rad2deg(np.arctan2(1.5 * y - 0.5 * x, 1.5 * x - 0.5 * y))
    assert_allclose(data.mapped_motion_angle, angle, rtol=1e-12)
