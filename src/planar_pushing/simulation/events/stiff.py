"""Steps of Radau IIA, an implicit method of order 5, for motions that friction turns fast.

Hairer and Wanner, Solving Ordinary Differential Equations II, Secs. IV.5 and IV.8.
"""

from __future__ import annotations

from math import sqrt

import numpy as np

from planar_pushing.mechanics.compiled import inlined
from planar_pushing.simulation.events.explicit import (
    GROW,
    SAFETY,
    SHRINK,
    first_size,
    least_step,
    norm,
)
from planar_pushing.simulation.events.linear import factorise, solve_factorised
from planar_pushing.simulation.events.run import (
    DENSE,
    IMPLICIT,
    RADAU,
    REACHED,
    SCALES,
    SLOPES,
    STATE,
    TRIAL,
)
from planar_pushing.simulation.systems.base import rates

ROOT = sqrt(6.0)
#: Times and weights of the stages.
C = np.array([(4 - ROOT) / 10, (4 + ROOT) / 10, 1.0])
A = np.array(
    [
        [(88 - 7 * ROOT) / 360, (296 - 169 * ROOT) / 1800, (-2 + 3 * ROOT) / 225],
        [(296 + 169 * ROOT) / 1800, (88 + 7 * ROOT) / 360, (-2 - 3 * ROOT) / 225],
        [(16 - ROOT) / 36, (16 + ROOT) / 36, 1 / 9],
    ]
)
#: Estimate of the error: the real eigenvalue of the inverse of A, and the weights of the stages.
EIGENVALUE = 3 + 3 ** (2 / 3) - 3 ** (1 / 3)
ERROR = np.array([-13 - 7 * ROOT, -13 + 7 * ROOT, -1.0]) / 3
#: Dense output: coefficients of the cubic through the stages.
CUBIC = np.linalg.inv(C[:, None] ** np.arange(1, RADAU + 1))
#: Iterations of Newton's method, and its tolerance in units of that of the step.
ITERATIONS, CONTRACTION = 6, 1.1e-3
#: Relative change of a variable that gives a derivative: the root of the rounding.
DIFFERENCE = 1.5e-8
#: Vectors of the stiff method: changes in the stages, slopes there, and unknowns of the equations.
CHANGES, THERE, UNKNOWN = IMPLICIT, IMPLICIT + RADAU, IMPLICIT + 2 * RADAU


@inlined
def step(system, mode, run, end, rtol):
    """Go on by one step and prepare its dense output; False where no step is small enough."""
    state, reached = run.vectors[STATE], run.vectors[REACHED]
    rates(system, mode, run.time, state, run.vectors[SLOPES])
    if run.fresh:
        run.size, run.last_size = first_size(system, mode, run, end, rtol, RADAU), 0.0
        run.fresh = False
    _differentiate(system, mode, run, rtol)
    least, rejected = least_step(run.time), False
    size = max(run.size, least)
    while size >= least:
        last = run.time + size >= end
        if last:
            size = end - run.time
        run.until = end if last else run.time + size
        iterations = _collocate(system, mode, run, size, rtol)
        if iterations == 0:
            size, rejected = size / 2.0, True
            continue
        for k in range(len(state)):
            reached[k] = state[k] + run.vectors[CHANGES + 2, k]
        error = _error(system, mode, run, size, rtol, rejected or run.last_size == 0.0)
        factor = SAFETY * (2 * ITERATIONS + 1) / (2 * ITERATIONS + iterations)
        factor *= _factor(run, size, error)
        if error < 1.0:
            run.size = size * min(factor, 1.0 if rejected else GROW)
            run.last_size, run.last_error = size, error
            _prepare(run)
            return True
        size, rejected = size * (factor if factor > SHRINK else SHRINK), True
    return False


@inlined
def _differentiate(system, mode, run, rtol):
    """Derivative of the rates by the state, by differences."""
    state, trial, moved = run.vectors[STATE], run.vectors[TRIAL], run.vectors[UNKNOWN]
    slope, scales = run.vectors[SLOPES], run.vectors[SCALES]
    trial[:] = state
    for j in range(len(state)):
        change = DIFFERENCE * max(abs(state[j]), rtol * scales[j])
        trial[j] = state[j] + change
        change = trial[j] - state[j]
        rates(system, mode, run.time, trial, moved)
        for i in range(len(state)):
            run.jacobian[i, j] = (moved[i] - slope[i]) / change
        trial[j] = state[j]


@inlined
def _collocate(system, mode, run, size, rtol):
    """Changes in the stages by Newton's method; its iterations, 0 where it does not converge."""
    changes, last = run.vectors[CHANGES:THERE], 0.0
    _stage_matrix(run, size)
    _extrapolate(run, size, changes)
    for iteration in range(1, ITERATIONS + 1):
        change = _correct(system, mode, run, size, rtol, changes)
        if change == 0.0:
            return iteration
        if iteration > 1:
            ratio = change / last
            if not ratio < 1.0:
                return 0
            if ratio / (1.0 - ratio) * change < CONTRACTION:
                return iteration
            if ratio ** (ITERATIONS - iteration) / (1.0 - ratio) * change > CONTRACTION:
                return 0
        last = change
    return 0


@inlined
def _correct(system, mode, run, size, rtol, changes):
    """One iteration of Newton's method; size of the correction in units of the tolerance."""
    state, trial, slopes = run.vectors[STATE], run.vectors[TRIAL], run.vectors[THERE:UNKNOWN]
    n = len(state)
    unknown = run.vectors[UNKNOWN : UNKNOWN + RADAU].reshape(RADAU * n)
    for i in range(RADAU):
        for k in range(n):
            trial[k] = state[k] + changes[i, k]
        rates(system, mode, run.time + C[i] * size, trial, slopes[i])
    for i in range(RADAU):
        for k in range(n):
            unknown[i * n + k] = -changes[i, k]
            for j in range(RADAU):
                unknown[i * n + k] += size * A[i, j] * slopes[j, k]
    solve_factorised(run.matrix, RADAU * n, run.order, unknown)
    total = 0.0
    for i in range(RADAU):
        correction = run.vectors[UNKNOWN + i]
        total += norm(correction, state, state, rtol, run.vectors[SCALES]) ** 2 / RADAU
        for k in range(n):
            changes[i, k] += correction[k]
    return sqrt(total)


@inlined
def _stage_matrix(run, size):
    """Factors of the matrix of the stages' equations."""
    n = len(run.vectors[STATE])
    for i in range(RADAU):
        for j in range(RADAU):
            for k in range(n):
                for m in range(n):
                    unit = 1.0 if i == j and k == m else 0.0
                    run.matrix[i * n + k, j * n + m] = unit - size * A[i, j] * run.jacobian[k, m]
    factorise(run.matrix, RADAU * n, run.order)


@inlined
def _extrapolate(run, size, changes):
    """First guess of the stages: the dense output of the last step goes on."""
    dense, last = run.vectors[DENSE : DENSE + RADAU], run.last_size
    for i in range(RADAU):
        x = C[i] * size / last if last > 0.0 else 0.0
        for k in range(changes.shape[1]):
            rise = dense[0, k] + dense[1, k] * (2.0 + x) + dense[2, k] * (3.0 + x * (3.0 + x))
            changes[i, k] = x * rise if last > 0.0 else 0.0


@inlined
def _error(system, mode, run, size, rtol, twice):
    """Estimate of the error in units of the tolerance; taken twice where the last one was not good."""
    state, reached, trial = run.vectors[STATE], run.vectors[REACHED], run.vectors[TRIAL]
    error, weighted = run.vectors[UNKNOWN], run.vectors[UNKNOWN + 1]
    n = len(state)
    for k in range(n):
        for m in range(n):
            run.matrix[k, m] = (EIGENVALUE / size if k == m else 0.0) - run.jacobian[k, m]
        weighted[k] = 0.0
        for i in range(RADAU):
            weighted[k] += ERROR[i] * run.vectors[CHANGES + i, k] / size
        error[k] = run.vectors[SLOPES, k] + weighted[k]
    factorise(run.matrix, n, run.order)
    solve_factorised(run.matrix, n, run.order, error)
    total = norm(error, state, reached, rtol, run.vectors[SCALES])
    if twice and total >= 1.0:
        for k in range(n):
            trial[k] = state[k] + error[k]
        rates(system, mode, run.time, trial, error)
        for k in range(n):
            error[k] += weighted[k]
        solve_factorised(run.matrix, n, run.order, error)
        total = norm(error, state, reached, rtol, run.vectors[SCALES])
    return total


@inlined
def _factor(run, size, error):
    """Change of the step's size that the last two errors suggest (Sec. IV.8)."""
    if error == 0.0:
        return GROW
    factor = error**-0.25
    if run.last_size > 0.0 and run.last_error > 0.0:
        factor *= min(1.0, size / run.last_size * (run.last_error / error) ** 0.25)
    return factor


@inlined
def _prepare(run):
    """Coefficients of the dense output."""
    dense, changes = run.vectors[DENSE : DENSE + RADAU], run.vectors[CHANGES:THERE]
    for k in range(changes.shape[1]):
        for i in range(RADAU):
            dense[i, k] = 0.0
            for j in range(RADAU):
                dense[i, k] += CUBIC[i, j] * changes[j, k]
    run.cubic = True
