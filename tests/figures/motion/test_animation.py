"""Frames between the rows of a log."""

import numpy as np
from numpy.testing import assert_allclose

from planar_pushing.figures.motion.animation import resampled
from planar_pushing.figures.motion.timeline import plotted


def test_frames_lie_between_rows(logs):
    motion = plotted(logs["figure_15"])
    found = resampled(motion, 7)
    assert_allclose(found.time, np.linspace(0, 3, 7))
    assert_allclose(found.path_rod_angle[[0, -1]], motion.path_rod_angle[[0, -1]])
    exact = np.rad2deg(np.arcsin(np.sin(np.pi / 4) - found.time * np.sin(np.deg2rad(165)) / 5))
    assert_allclose(found.path_rod_angle, exact, rtol=0, atol=1e-4)
