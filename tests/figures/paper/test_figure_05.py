"""Figure 5."""

import numpy as np
from numpy.testing import assert_allclose

from planar_pushing.study.store import read_dataset


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


def test_the_line_is_finer_than_the_grid_and_passes_through_its_forces(plotted, grid_figures):
    folder, _ = grid_figures["figure_05"]
    grid = read_dataset(folder / "data/limit_curves.nc")
    curve = plotted["figure_05"]
    assert curve.sizes["force_angle"] == 361 > grid.sizes["force_angle"]
    stored = grid.sel(effects="support_friction", rod_angle=45, rod_length=curve.rod_length)
    for name in ("force_x", "force_y"):
        line = curve[name].sel(force_angle=grid.force_angle)
        assert_allclose(line, stored[name], rtol=1e-13, atol=1e-15)
