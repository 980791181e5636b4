"""Figure 6."""

import numpy as np
import pytest
from numpy.testing import assert_allclose


def test_edges_of_the_cones_are_the_published_ones(plotted):
    data = plotted["figure_06"]
    forces = [90 - np.rad2deg(np.arctan(2)), 45, 90, 90 + np.rad2deg(np.arctan(2))]
    assert_allclose(data.mapped_force_angle, forces, rtol=1e-14)
    edges = data.mapped_motion_angle.isel(map=[0, -1])
    assert_allclose(edges, [-20.038457551638, 140.16416973393], rtol=1e-12)


def test_force_along_the_rod_translates_the_slider(plotted):
    assert float(plotted["figure_06"].mapped_motion_angle[1]) == pytest.approx(45, rel=1e-14, abs=0)


def test_mapped_forces_lie_at_their_angles(plotted):
    data = plotted["figure_06"]
    angles = np.rad2deg(np.arctan2(data.mapped_force_y, data.mapped_force_x))
    assert_allclose(angles, data.mapped_force_angle, rtol=1e-13)
