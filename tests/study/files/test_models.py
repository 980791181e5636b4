"""What a study holds, and what it computes."""

import numpy as np

from planar_pushing.study.study_file import load_study


def test_paper_study_holds_the_grid_of_the_paper():
    grid = load_study("workflow/config/paper.yaml").grid
    assert {0, 0.25, 0.5, 1, 2, 3, 5, 10} <= set(grid.rod_length)
    assert {15, 45, 90, 165} <= set(grid.rod_angle)
    assert {0, 0.25, 0.5, 1, 1.5, 2, 5, 10, 100, np.inf} <= set(grid.friction_coefficient)
    assert np.diff(grid.force_angle).max() <= 1
    assert np.diff(grid.pusher_angle).max() <= 1
    assert (grid.inertia_share[0], grid.inertia_share[-1]) == (0, 1)
