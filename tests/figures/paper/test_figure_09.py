"""Figure 9."""

import numpy as np
import pytest


def test_figure_09_has_the_duals_of_the_edges_on_one_line_of_centers(plotted):
    data = plotted["figure_09"]
    rod = np.array([np.cos(np.pi / 4), np.sin(np.pi / 4)])
    beyond = 2 + 1 / 2  # rod length, and squared radius of gyration over rod length
    for side in ("right", "left"):
        assert data[f"center_{side}"].values @ rod == pytest.approx([beyond, beyond])
    assert data["friction_coefficient"].values == pytest.approx([2, np.inf])
