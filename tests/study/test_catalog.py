"""Names of datasets and labels of numbers."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from planar_pushing.study.files.sliders_model import SlidersGrid

from planar_pushing.study.catalog import (
    AXES,
    DIMS,
    SLIDERS_AXES,
    dataset_file,
    number_label,
)
from planar_pushing.study.files.study_model import Grid


def test_axes_are_those_of_the_grid():
    assert {axis for axes in AXES.values() for axis in axes} == set(Grid.model_fields)
    named = {axis for axes in SLIDERS_AXES.values() for axis in axes}
    assert named == set(SlidersGrid.model_fields)
    assert set(AXES) | set(SLIDERS_AXES) == set(DIMS)
    assert "contact_friction_coefficient" in AXES["contact_modes"]


def test_scenes_share_a_file_and_simulations_have_one_each():
    assert dataset_file("scenes/figure_08") == "data/scenes.nc"
    assert dataset_file("simulations/figure_15") == "data/simulations/figure_15.nc"


@pytest.mark.parametrize(
    ("number", "label"),
    [(1.4, "1.4"), (2, "2"), (1.4000001, "1.4000001"), (np.float64(0.3), "0.3"), (np.inf, "inf")],
)
def test_a_label_is_short(number, label):
    assert number_label(number) == label


@given(st.floats(0, 1e3), st.integers(1, 3))
def test_a_label_tells_neighbours_apart(number, steps):
    other = number
    for _ in range(steps):
        other = float(np.nextafter(other, np.inf))
    assert float(number_label(number)) == number
    assert number_label(number) != number_label(other)
