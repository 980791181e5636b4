"""The order conditions that the coefficients of DOP853 meet."""

import numpy as np
import pytest

from planar_pushing.simulation.events.tableau import ERRORS, STAGES, STEP, A, C


def test_stages_integrate_a_constant_and_the_result_powers_of_the_time():
    assert A.sum(axis=1) == pytest.approx(C, abs=2e-14)
    for power in range(8):
        assert A[STEP] @ C**power == pytest.approx(1 / (power + 1), abs=1e-14)
    assert len(C) == STAGES
    assert np.abs(ERRORS.sum(axis=1)).max() < 1e-14
