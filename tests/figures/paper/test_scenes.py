"""Figures 2, 3, 8 and 11."""

import numpy as np
import pytest

from planar_pushing.figures.parts.sketch import Sketch
from planar_pushing.mechanics.contact import ContactMode


def test_figure_02_pushes(plotted):
    data = plotted["figure_02"]
    assert data["mode"].values == [ContactMode.STICK]
    assert data["contact_motion"].sel(xy="y").item() > 0


def test_figure_03_pulls_with_a_force_into_the_slider(plotted):
    data = plotted["figure_03"]
    assert data["mode"].values == [ContactMode.STICK]
    assert data["contact_motion"].sel(xy="y").item() < 0
    assert data["force"].sel(xy="y").item() > 0


@pytest.mark.parametrize("name", ["figure_02", "figure_03"])
def test_the_support_friction_that_is_drawn_balances_the_force(plotted, name):
    data = plotted[name]
    pull = data["support_force"].isel(solution=0).mean("support_angle").values * 2 * np.pi
    assert -pull == pytest.approx(data["force"].values[0], abs=0.03)


def test_figure_08_slips_to_the_right_with_the_force_on_the_left_edge(plotted):
    data = plotted["figure_08"]
    assert data["mode"].values == [ContactMode.SLIP_RIGHT]
    force, motion = data["force"].values[0], data["contact_motion"].values[0]
    assert force[0] < 0
    assert force[1] == 0
    angle = np.rad2deg(np.arctan2(motion[1], motion[0]))
    assert angle == pytest.approx(float(data["motion_cone_left"]))


def test_figure_11_has_its_center_on_the_ring_and_its_line_of_force_tangent(plotted):
    data = plotted["figure_11"]
    sketch = Sketch.of(data)
    assert np.hypot(*(sketch.center - sketch.ring)) == pytest.approx(1)
    assert sketch.foot - sketch.ring == pytest.approx(sketch.ring - sketch.center)
    assert data["contact_motion"].sel(xy="y").item() < 0
