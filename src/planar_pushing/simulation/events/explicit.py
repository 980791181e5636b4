"""Steps of DOP853, an explicit method of order 8 (Hairer, Norsett and Wanner I, Secs. II.4 and II.10)."""

from __future__ import annotations

from math import inf, sqrt

import numpy as np

from planar_pushing.mechanics.compiled import compiled, inlined
from planar_pushing.simulation.events.run import (
    DENSE,
    IMPLICIT,
    PASSING,
    REACHED,
    SCALES,
    SLOPES,
    STATE,
    TRIAL,
)
from planar_pushing.simulation.events.tableau import ERRORS, STAGES, STEP, WEIGHTS, A, C
from planar_pushing.simulation.systems.base import rates

#: Limits of the change of a step's size, and the part of it that is taken.
SAFETY, SHRINK, GROW = 0.9, 0.2, 10.0


@compiled
def norm(vector, start, end, rtol, scales):
    """Root mean square of a vector in units of the tolerance."""
    total = 0.0
    for i in range(len(vector)):
        part = vector[i] / (rtol * (scales[i] + max(abs(start[i]), abs(end[i]))))
        total += part * part
    return sqrt(total / len(vector))


@inlined
def least_step(time):
    """Step below which rounding of the time matters."""
    return 10.0 * (np.nextafter(time, inf) - time)


@inlined
def first_size(system, mode, run, end, rtol, order):
    """Size of the first step of a mode; its first slope is known (Sec. II.4)."""
    state, trial, scales = run.vectors[STATE], run.vectors[TRIAL], run.vectors[SCALES]
    slope, other = run.vectors[SLOPES], run.vectors[PASSING]
    span = end - run.time
    state_size = norm(state, state, state, rtol, scales)
    slope_size = norm(slope, state, state, rtol, scales)
    small = state_size < 1e-5 or slope_size < 1e-5
    size = min(1e-6 if small else 0.01 * state_size / slope_size, span)
    for k in range(len(state)):
        trial[k] = state[k] + size * slope[k]
    rates(system, mode, run.time + size, trial, other)
    for k in range(len(state)):
        trial[k] = other[k] - slope[k]
    bend = norm(trial, state, state, rtol, scales) / size
    if slope_size <= 1e-15 and bend <= 1e-15:
        better = max(1e-6, 1e-3 * size)
    else:
        better = (0.01 / max(slope_size, bend)) ** (1.0 / (order + 1))
    return min(min(100.0 * size, better), span)


@compiled
def _sum(weights, count, slopes, found):
    found[:] = 0.0
    for j in range(count):
        weight = weights[j]
        if weight != 0.0:
            for k in range(len(found)):
                found[k] += weight * slopes[j, k]


@inlined
def _move(state, size, slope):
    """Turn the mean slope of a step into the state at its end."""
    for k in range(len(state)):
        slope[k] = state[k] + size * slope[k]


@compiled
def _stage(system, mode, run, size, i, time, found):
    """State and slope in a stage of the step."""
    slopes = run.vectors[SLOPES:DENSE]
    _sum(A[i], i, slopes, found)
    _move(run.vectors[STATE], size, found)
    rates(system, mode, time, found, slopes[i])


@inlined
def _error(run, size, rtol):
    """Estimate of the error in units of the tolerance (Sec. II.10)."""
    slopes, trial, scales = run.vectors[SLOPES:DENSE], run.vectors[TRIAL], run.vectors[SCALES]
    state, reached = run.vectors[STATE], run.vectors[REACHED]
    _sum(ERRORS[0], STEP + 1, slopes, trial)
    fifth = norm(trial, state, reached, rtol, scales) ** 2
    if fifth == 0.0:
        return 0.0
    _sum(ERRORS[1], STEP + 1, slopes, trial)
    third = norm(trial, state, reached, rtol, scales) ** 2
    return size * fifth / sqrt(fifth + 0.01 * third)


@compiled
def step(system, mode, run, end, rtol):
    """Go on by one step and prepare its dense output; False where no step is small enough."""
    slopes, trial = run.vectors[SLOPES:DENSE], run.vectors[TRIAL]
    if run.fresh:
        rates(system, mode, run.time, run.vectors[STATE], slopes[0])
        run.size = first_size(system, mode, run, end, rtol, 7)
        run.fresh = False
    else:
        slopes[0] = slopes[STEP]
    least, rejected = least_step(run.time), False
    size = max(run.size, least)
    while size >= least:
        last = run.time + size >= end
        if last:
            size = end - run.time
        run.until = end if last else run.time + size
        for i in range(1, STEP):
            _stage(system, mode, run, size, i, run.time + C[i] * size, trial)
        _stage(system, mode, run, size, STEP, run.until, run.vectors[REACHED])
        error = _error(run, size, rtol)
        factor = GROW if error == 0.0 else SAFETY * error ** (-1.0 / 8.0)
        if error < 1.0:
            run.size = size * min(factor, 1.0 if rejected else GROW)
            _prepare(system, mode, run, size)
            return True
        size *= factor if factor > SHRINK else SHRINK
        rejected = True
    return False


@inlined
def _prepare(system, mode, run, size):
    """Coefficients of the dense output."""
    for i in range(STEP + 1, STAGES):
        _stage(system, mode, run, size, i, run.time + C[i] * size, run.vectors[TRIAL])
    slopes, dense = run.vectors[SLOPES:DENSE], run.vectors[DENSE:IMPLICIT]
    state, reached = run.vectors[STATE], run.vectors[REACHED]
    for k in range(len(state)):
        change = reached[k] - state[k]
        dense[0, k] = change
        dense[1, k] = size * slopes[0, k] - change
        dense[2, k] = change - size * slopes[STEP, k] - dense[1, k]
    for i in range(len(WEIGHTS)):
        _sum(WEIGHTS[i], STAGES, slopes, dense[3 + i])
        for k in range(len(state)):
            dense[3 + i, k] *= size
    run.cubic = False


@compiled
def stiffness(run):
    """Step times Jacobian, from the two stages at the end of the step (Hairer and Wanner II, Sec. IV.2)."""
    slopes, trial = run.vectors[SLOPES:DENSE], run.vectors[TRIAL]
    size, state, reached = run.until - run.time, run.vectors[STATE], run.vectors[REACHED]
    _sum(A[STEP - 1], STEP - 1, slopes, trial)
    apart, change = 0.0, 0.0
    for k in range(len(state)):
        apart += (reached[k] - state[k] - size * trial[k]) ** 2
        change += (slopes[STEP, k] - slopes[STEP - 1, k]) ** 2
    return size * sqrt(change / apart) if apart > 0.0 else 0.0


@compiled
def interpolate(run, time, found):
    """State at a time within the last step, whichever method took it."""
    dense, state = run.vectors[DENSE:IMPLICIT], run.vectors[STATE]
    x = (time - run.time) / (run.until - run.time)
    if run.cubic:
        for k in range(len(found)):
            found[k] = state[k] + x * (dense[0, k] + x * (dense[1, k] + x * dense[2, k]))
        return
    y = 1.0 - x
    for k in range(len(found)):
        value = dense[4, k] + y * (dense[5, k] + x * dense[6, k])
        value = dense[2, k] + y * (dense[3, k] + x * value)
        found[k] = state[k] + x * (dense[0, k] + y * (dense[1, k] + x * value))
