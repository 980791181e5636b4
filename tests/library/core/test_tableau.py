"""The coefficients of DOP853 and of collocation, against scipy and the conditions for their orders."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import DOP853
from scipy.special import roots_jacobi

from planar_pushing.core.motion.integration.collocation import (
    MIDDLE_NODE,
    NODE_LEGENDRE,
    NODE_TIMES,
    NODE_WEIGHTS,
    NODES,
)
from planar_pushing.core.motion.integration.tableau import (
    DENSE_WEIGHTS,
    FIFTH_ERROR,
    STAGE_TIMES,
    STAGE_WEIGHTS,
    STEP_STAGES,
    THIRD_ERROR,
)

STAGES = len(STAGE_TIMES)
C = np.array(STAGE_TIMES)


def weights():
    """Weights of the earlier stages in each stage as a square matrix."""
    matrix = np.zeros((STAGES, STAGES))
    matrix[np.tril_indices(STAGES, -1)] = STAGE_WEIGHTS
    return matrix


A, B = weights(), weights()[STEP_STAGES]


def test_they_are_those_of_scipy_to_the_last_bit():
    assert DOP853.n_stages == STEP_STAGES
    np.testing.assert_array_equal(C, [*DOP853.C, 1.0, *DOP853.C_EXTRA])
    np.testing.assert_array_equal(A[:STEP_STAGES, :STEP_STAGES], DOP853.A)
    np.testing.assert_array_equal(B[:STEP_STAGES], DOP853.B)
    np.testing.assert_array_equal(A[STEP_STAGES + 1 :], DOP853.A_EXTRA)
    np.testing.assert_array_equal(FIFTH_ERROR, DOP853.E5)
    np.testing.assert_array_equal(THIRD_ERROR, DOP853.E3)
    np.testing.assert_array_equal(np.reshape(DENSE_WEIGHTS, (4, STAGES)), DOP853.D)


def test_a_step_integrates_powers_of_the_time():
    """The conditions of order 8 on quadratures, and on quadratures of quadratures."""
    assert A.sum(axis=1) == pytest.approx(C, abs=2e-14)
    for power in range(8):
        assert B @ C**power == pytest.approx(1 / (power + 1), abs=1e-14)
    for outer in range(7):
        for power in range(7 - outer):
            inner = A @ C**power
            exact = 1 / ((power + 1) * (power + outer + 2))
            assert (B * C**outer) @ inner == pytest.approx(exact, abs=1e-13), (outer, power)
    # No method of twelve stages has order 9.
    assert abs(B @ C**8 - 1 / 9) > 1e-6


def test_errors_of_a_constant_rate_are_zero():
    for error in (FIFTH_ERROR, THIRD_ERROR):
        assert sum(error) == pytest.approx(0, abs=1e-14)
        assert np.dot(error, C[: len(error)]) == pytest.approx(0, abs=1e-14)


def test_the_nodes_are_those_of_radau():
    """Zeros of a Jacobi polynomial, and the right end."""
    zeros, _ = roots_jacobi(NODES - 1, 1, 0)
    assert pytest.approx([*(zeros + 1) / 2, 1.0], abs=1e-15) == NODE_TIMES
    assert abs(NODE_TIMES[MIDDLE_NODE] - 0.5) == min(abs(np.array(NODE_TIMES) - 0.5))


def test_collocation_integrates_polynomials():
    """Up to each node those of degree 6, and over the step those of degree 12."""
    nodes, weights = np.array(NODE_TIMES), np.reshape(NODE_WEIGHTS, (NODES, NODES))
    for degree in range(2 * NODES - 1):
        integrals = weights @ nodes**degree - nodes ** (degree + 1) / (degree + 1)
        assert np.abs(integrals if degree < NODES else integrals[-1:]).max() < 1e-15


def test_the_coefficients_of_legendre_polynomials_give_the_values_at_the_nodes():
    values = np.polynomial.legendre.legvander(2 * np.array(NODE_TIMES) - 1, NODES - 1)
    np.testing.assert_allclose(
        values @ np.reshape(NODE_LEGENDRE, (NODES, NODES)), np.eye(NODES), atol=1e-14
    )
