"""Figure 12."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from planar_pushing.figures.paper.figure_12 import sectors
from planar_pushing.study.store import read_dataset


def test_cones_are_the_published_ones(plotted):
    data = plotted["figure_12"]
    exact = float(data.exact_cone_right), float(data.exact_cone_left)
    assert exact == pytest.approx((-42.797401838234, 138.83997216476), rel=1e-12, abs=0)
    bound = float(data.conservative_cone_right), float(data.conservative_cone_left)
    assert bound == pytest.approx((-45, 142.06), abs=0.01)


def test_exact_centers_lie_in_the_papers_sectors(plotted):
    data = plotted["figure_12"]
    for _, centers in data[["exact_center_x", "exact_center_y"]].groupby("inertia_share"):
        x = centers.exact_center_x.squeeze() - float(data.ring_center[0])
        y = centers.exact_center_y.squeeze() - float(data.ring_center[1])
        angle, outside = np.rad2deg(np.arctan2(y, x)).values, (np.hypot(x, y) > 1).values
        held = np.zeros(len(angle), bool)
        for each in range(data.sizes["sector"]):
            one = data.isel(sector=each)
            inside = (angle > one.sector_start.item() - 1e-9) & (
                angle < one.sector_stop.item() + 1e-9
            )
            held |= inside & (outside == bool(one.sector_outside))
        assert held.all()


def test_the_boundaries_pass_through_the_centers_of_the_grid(plotted, grid_figures):
    folder, _ = grid_figures["figure_12"]
    grid = read_dataset(folder / "data/acceleration_centers.nc").sel(rod_length=5.0)
    data = plotted["figure_12"]
    assert data.sizes["force_angle"] == 180  # without the translation along the rod
    angles = grid.force_angle[grid.force_angle != 45]
    stored = grid.sel(inertia_share=[0.0, 1.0], force_angle=angles)
    for xy in "xy":
        here = data[f"exact_center_{xy}"].sel(force_angle=angles)
        assert_allclose(here, stored[f"center_{xy}"].transpose(*here.dims), rtol=1e-13, atol=1e-14)


def test_sectors_meet_and_open_with_the_ring_seen_from_the_contact():
    found = sectors(2.0, 45.0, 1.0)
    assert_allclose(found.sector_start, [90, 105, -45, -15], rtol=1e-14)
    assert_allclose(found.sector_stop, [105, 135, -15, 90], rtol=1e-14)


def test_contact_inside_the_ring_leaves_sectors_outside_of_it_alone():
    found = sectors(0.5, 45.0, 1.0)
    assert found.sector_outside.values.tolist() == [1, 1]
    assert_allclose(found.sector_start, [90, -45], rtol=1e-14)
    assert_allclose(found.sector_stop, [135, 90], rtol=1e-14)


def test_scene_slips_for_a_pusher_just_below_180_degrees(plotted):
    data = plotted["figure_12"]
    assert float(data.conservative_cone_left) < float(data.pusher_angle) < 180
    assert float(data.contact_motion[0]) > float(data.pusher_motion[0])
    assert float(data.contact_motion[1]) == pytest.approx(float(data.pusher_motion[1]))
