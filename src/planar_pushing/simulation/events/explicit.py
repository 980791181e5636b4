"""Steps of DOP853, an explicit method of order 8 (Hairer, Norsett and Wanner I, Secs. II.4 and II.10)."""

from __future__ import annotations

from math import sqrt

from planar_pushing.mechanics.compiled import compiled
from planar_pushing.simulation.events import run as at
from planar_pushing.simulation.events.sizes import norm
from planar_pushing.simulation.events.tableau import ERRORS, STAGES, STEP, WEIGHTS, A, C
from planar_pushing.simulation.systems import base

#: Order of the error of a step.
ORDER = 8.0


@compiled
def _sum(weights, count, slopes, found):
    """Write down a weighted sum of slopes."""
    found[:] = 0.0
    for j in range(count):
        weight = weights[j]
        if weight != 0.0:
            for k in range(len(found)):
                found[k] += weight * slopes[j, k]


@compiled
def _stage(system, mode, run, size, i, time, found):
    """State and slope in a stage of the step."""
    slopes, state = run.vectors[at.SLOPES : at.DENSE], run.vectors[at.STATE]
    _sum(A[i], i, slopes, found)
    for k in range(len(state)):
        found[k] = state[k] + size * found[k]
    base.rates(system, mode, time, found, slopes[i])


@compiled
def attempt(system, mode, run, size, rtol):
    """Try a step; the estimate of its error in units of the tolerance (Sec. II.10)."""
    slopes, trial, scales = (
        run.vectors[at.SLOPES : at.DENSE],
        run.vectors[at.TRIAL],
        run.vectors[at.SCALES],
    )
    state, reached = run.vectors[at.STATE], run.vectors[at.REACHED]
    for i in range(1, STEP):
        _stage(system, mode, run, size, i, run.time + C[i] * size, trial)
    _stage(system, mode, run, size, STEP, run.until, reached)
    _sum(ERRORS[0], STEP + 1, slopes, trial)
    fifth = norm(trial, state, reached, rtol, scales) ** 2
    _sum(ERRORS[1], STEP + 1, slopes, trial)
    third = norm(trial, state, reached, rtol, scales) ** 2
    return size * fifth / sqrt(fifth + 0.01 * third) if fifth > 0.0 else 0.0


@compiled
def _prepare(system, mode, run):
    """Coefficients of the dense output, and the stages that only it takes."""
    size = run.until - run.time
    for i in range(STEP + 1, STAGES):
        _stage(system, mode, run, size, i, run.time + C[i] * size, run.vectors[at.TRIAL])
    slopes, dense = run.vectors[at.SLOPES : at.DENSE], run.vectors[at.DENSE : at.IMPLICIT]
    state, reached = run.vectors[at.STATE], run.vectors[at.REACHED]
    dense[0] = reached - state
    dense[1] = size * slopes[0] - dense[0]
    dense[2] = dense[0] - size * slopes[STEP] - dense[1]
    for i in range(len(WEIGHTS)):
        _sum(WEIGHTS[i], STAGES, slopes, dense[3 + i])
        dense[3 + i] *= size
    run.prepared = True


@compiled
def stiffness(run):
    """Step times Jacobian, from the two stages at the end of the step (Hairer and Wanner II, Sec. IV.2)."""
    slopes, trial = run.vectors[at.SLOPES : at.DENSE], run.vectors[at.TRIAL]
    size, state, reached = run.until - run.time, run.vectors[at.STATE], run.vectors[at.REACHED]
    _sum(A[STEP - 1], STEP - 1, slopes, trial)
    apart, change = 0.0, 0.0
    for k in range(len(state)):
        apart += (reached[k] - state[k] - size * trial[k]) ** 2
        change += (slopes[STEP, k] - slopes[STEP - 1, k]) ** 2
    return size * sqrt(change / apart) if apart > 0.0 else 0.0


@compiled
def near_middle(run, found):
    """State about the middle of the step, which needs no dense output: that of a cubic."""
    slopes, state, reached = (
        run.vectors[at.SLOPES : at.DENSE],
        run.vectors[at.STATE],
        run.vectors[at.REACHED],
    )
    eighth = (run.until - run.time) / 8.0
    for k in range(len(found)):
        bulge = eighth * (slopes[0, k] - slopes[STEP, k])
        found[k] = (state[k] + reached[k]) / 2.0 + bulge


@compiled
def interpolate(system, mode, run, time, found):
    """State at a time within the last step, whichever method took it."""
    if not run.prepared:
        _prepare(system, mode, run)
    dense, state = run.vectors[at.DENSE : at.IMPLICIT], run.vectors[at.STATE]
    x = (time - run.time) / (run.until - run.time)
    if not run.explicit:
        for k in range(len(found)):
            found[k] = state[k] + x * (dense[0, k] + x * (dense[1, k] + x * dense[2, k]))
        return
    y = 1.0 - x
    for k in range(len(found)):
        value = dense[4, k] + y * (dense[5, k] + x * dense[6, k])
        value = dense[2, k] + y * (dense[3, k] + x * value)
        found[k] = state[k] + x * (dense[0, k] + y * (dense[1, k] + x * value))
