"""Frames between the rows of a log."""

import numpy as np
import pytest
from numpy.testing import assert_allclose
from PIL import Image

from figures.conftest import OTHERS
from planar_pushing.figures.motion import animation
from planar_pushing.figures.motion.animation import resampled
from planar_pushing.figures.motion.timeline import plotted


def test_frames_lie_between_rows(logs):
    motion = plotted(logs["figure_15"])
    found = resampled(motion, 7)
    assert_allclose(found.time, np.linspace(0, 3, 7))
    assert_allclose(found.path_rod_angle[[0, -1]], motion.path_rod_angle[[0, -1]])
    exact = np.rad2deg(np.arcsin(np.sin(np.pi / 4) - found.time * np.sin(np.deg2rad(165)) / 5))
    assert_allclose(found.path_rod_angle, exact, rtol=0, atol=1e-4)


def test_the_title_of_a_frame_says_that_the_slider_pivots(others):
    motion = resampled(plotted(others["stool"]), 9)
    said = [animation._status(motion, row) for row in range(9)]
    assert said[0] == "stick"
    assert "slip left, pivots" in said
    assert said[-1] == "stick"


@pytest.mark.parametrize("name", OTHERS)
def test_any_support_is_animated(others, tmp_path, name):
    path = tmp_path / "motion.gif"
    assert animation.animate(others[name], path, frames=3) == 3
    with Image.open(path) as image:
        assert image.n_frames == 3
