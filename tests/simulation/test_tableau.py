"""The coefficients of DOP853 against those of SciPy, and the order conditions that they meet."""

import numpy as np
import pytest
from scipy.integrate import DOP853

from planar_pushing.simulation.events.tableau import ERRORS, STAGES, STEP, WEIGHTS, A, C


def test_coefficients_are_those_of_scipy():
    assert (A[:STEP, :STEP] == DOP853.A).all()
    assert (A[STEP, :STEP] == DOP853.B).all()
    assert (A[STEP + 1 :] == DOP853.A_EXTRA).all()
    assert ([*DOP853.C, 1.0, *DOP853.C_EXTRA] == C).all()
    assert (ERRORS[:, : STEP + 1] == [DOP853.E5, DOP853.E3]).all()
    assert (WEIGHTS == DOP853.D).all()


def test_stages_integrate_a_constant_and_the_result_powers_of_the_time():
    assert A.sum(axis=1) == pytest.approx(C, abs=2e-14)
    for power in range(8):
        assert A[STEP] @ C**power == pytest.approx(1 / (power + 1), abs=1e-14)
    assert len(C) == STAGES
    assert np.abs(ERRORS.sum(axis=1)).max() < 1e-14
