"""Steps of Radau IIA, an implicit method of order 5, for motions that friction turns fast.

Hairer and Wanner, Solving Ordinary Differential Equations II, Secs. IV.5 and IV.8.
"""

from __future__ import annotations

from math import inf, sqrt

import numpy as np

from planar_pushing.mechanics.compiled import compiled, inlined, owning
from planar_pushing.mechanics.numerics.copying import copy
from planar_pushing.simulation.events import run as at
from planar_pushing.simulation.events.sizes import norm
from planar_pushing.simulation.systems import base

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
#: Estimate of the error: its order, the real eigenvalue of the inverse of A, the weights of the stages.
ORDER = 4.0
EIGENVALUE = 3 + 3 ** (2 / 3) - 3 ** (1 / 3)
ERROR = np.array([-13 - 7 * ROOT, -13 + 7 * ROOT, -1.0]) / 3
#: Dense output: coefficients of the cubic through the stages.
CUBIC = np.linalg.inv(C[:, None] ** np.arange(1, at.RADAU + 1))
#: Iterations of Newton's method, and its tolerance in units of that of the step.
ITERATIONS, CONTRACTION = 6, 1.1e-3
#: Relative change of a variable that gives a derivative: the root of the rounding.
DIFFERENCE = 1.5e-8
#: Vectors of the stiff method: changes in the stages, slopes there, and corrections.
CHANGES, THERE, UNKNOWN = at.IMPLICIT, at.IMPLICIT + at.RADAU, at.IMPLICIT + 2 * at.RADAU


@inlined
def _differentiate(system, mode, run, rtol):
    """Derivative of the rates by the state, by differences; the first slope is known."""
    state, trial, moved = run.vectors[at.STATE], run.vectors[at.TRIAL], run.vectors[UNKNOWN]
    copy(trial, state)
    for j in range(len(state)):
        change = DIFFERENCE * max(abs(state[j]), rtol * run.vectors[at.SCALES, j])
        trial[j] = state[j] + change
        base.rates(system, mode, run.time, trial, moved)
        for k in range(len(state)):
            run.jacobian[k, j] = (moved[k] - run.vectors[at.FIRST, k]) / (trial[j] - state[j])
        trial[j] = state[j]


@owning
def attempt(effects, system, mode, run, size, rtol, again):
    """Try a step; the estimate of its error in units of the tolerance, infinite without a solution.

    In a trial again, from the same state, the derivative is known.
    """
    if not again:
        _differentiate(system, mode, run, rtol)
    if not _collocate(system, mode, run, size, rtol):
        return inf
    _add(run.vectors[at.STATE], run.vectors[CHANGES + at.RADAU - 1], run.vectors[at.REACHED])
    error = _error(system, mode, run, size, rtol, again)
    if error < 1.0:
        _prepare(run)
    return error


@compiled
def _add(one, other, found):
    """Write down a sum of vectors."""
    for k in range(len(found)):
        found[k] = one[k] + other[k]


@inlined
def _collocate(system, mode, run, size, rtol):
    """Changes of the state in the stages by Newton's method; whether it converges."""
    inverse, last = np.linalg.inv(_matrix(run.jacobian, size)), 0.0
    _extrapolate(run, size)
    for iteration in range(ITERATIONS):
        change = _correct(system, mode, run, size, rtol, inverse)
        if change == 0.0:
            return True
        if iteration > 0:
            if not change < last:
                return False
            if change / (last - change) * change < CONTRACTION:
                return True
        last = change
    return False


@owning
def _matrix(jacobian, size):
    """The identity less the step times the Kronecker product of A and the derivative."""
    entries = len(jacobian)
    found = np.eye(at.RADAU * entries)
    for i in range(len(found)):
        for j in range(len(found)):
            part = A[i // entries, j // entries] * jacobian[i % entries, j % entries]
            found[i, j] -= size * part
    return found


@inlined
def _extrapolate(run, size):
    """First guess of the changes: the dense output of the last step goes on."""
    dense, last = run.vectors[at.DENSE : at.DENSE + at.RADAU], run.last_size
    for i in range(at.RADAU):
        x = C[i] * size / last if last > 0.0 else 0.0
        for k in range(len(dense[0])):
            rise = dense[0, k] + dense[1, k] * (2.0 + x) + dense[2, k] * (3.0 + x * (3.0 + x))
            run.vectors[CHANGES + i, k] = x * rise


@inlined
def _correct(system, mode, run, size, rtol, inverse):
    """One iteration of Newton's method; size of the correction in units of the tolerance."""
    state, changes = run.vectors[at.STATE], run.vectors[CHANGES:THERE]
    slopes, total = run.vectors[THERE:UNKNOWN], 0.0
    for i in range(at.RADAU):
        _add(state, changes[i], run.vectors[at.TRIAL])
        base.rates(system, mode, run.time + C[i] * size, run.vectors[at.TRIAL], slopes[i])
    missing = size * np.dot(A, slopes) - changes
    corrections = np.dot(inverse, missing.reshape(missing.size)).reshape(missing.shape)
    for i in range(at.RADAU):
        total += norm(corrections[i], state, state, rtol, run.vectors[at.SCALES]) ** 2 / at.RADAU
    changes += corrections
    return sqrt(total)


@inlined
def _error(system, mode, run, size, rtol, again):
    """Estimate of the error in units of the tolerance; taken twice in a trial again, or at the start."""
    state, reached, trial = run.vectors[at.STATE], run.vectors[at.REACHED], run.vectors[at.TRIAL]
    inverse = np.linalg.inv(EIGENVALUE / size * np.eye(len(state)) - run.jacobian)
    weighted = np.dot(ERROR / size, run.vectors[CHANGES:THERE])
    error = np.dot(inverse, run.vectors[at.FIRST] + weighted)
    total = norm(error, state, reached, rtol, run.vectors[at.SCALES])
    if total >= 1.0 and (again or run.last_size == 0.0):
        _add(state, error, trial)
        base.rates(system, mode, run.time, trial, run.vectors[UNKNOWN])
        error = np.dot(inverse, run.vectors[UNKNOWN] + weighted)
        total = norm(error, state, reached, rtol, run.vectors[at.SCALES])
    return total


@inlined
def _prepare(run):
    """Coefficients of the dense output."""
    dense = run.vectors[at.DENSE : at.DENSE + at.RADAU]
    np.dot(CUBIC, run.vectors[CHANGES:THERE], dense)
    run.prepared = True
