"""Step sizes: the first one of a mode, and the next one based on the error of the last."""

from __future__ import annotations

from math import exp, inf, log, sqrt

import numpy as np

from planar_pushing.simulation.events import run as at
from planar_pushing.simulation.legacy.compiled import compiled, inlined
from planar_pushing.simulation.systems import equations

#: Safety factor, and limits for the change of the step size.
SAFETY, SHRINK, GROW = 0.9, 0.1, 10.0
#: Maximum factor by which a trend of the step size is extrapolated, and by which the first step of a mode
#: exceeds the last step before it, since the motion after a singularity is as hard as before it.
TREND = 2.0
#: The usual first size, multiplied by this factor, gives a step with an error near the tolerance.
CAUTIOUS = 4.0


@compiled
def norm(vector, start, end, rtol, scales):
    """Root mean square of a vector, in units of the tolerance."""
    total = 0.0
    for i in range(len(vector)):
        part = vector[i] / (rtol * (scales[i] + max(abs(start[i]), abs(end[i]))))
        total += part * part
    return sqrt(total / len(vector))


@inlined
def least_size(time):
    """Step size below which rounding of the time matters."""
    return 10.0 * 2.220446049250313e-16 * time + 1e-300


@inlined
def first_size(system, mode, run, end, rtol, order):
    """Size of the first step of a mode with a known first slope (Hairer and Wanner I, Sec. II.4)."""
    state, trial, scales = run.vectors[at.STATE], run.vectors[at.TRIAL], run.vectors[at.SCALES]
    slope, other = run.vectors[at.FIRST], run.vectors[at.PASSING]
    state_size = norm(state, state, state, rtol, scales)
    slope_size = norm(slope, state, state, rtol, scales)
    small = state_size < 1e-5 or slope_size < 1e-5
    size = min(1e-6 if small else 0.01 * state_size / slope_size, end - run.time)
    for k in range(len(state)):
        trial[k] = state[k] + size * slope[k]
    equations.rates(system, mode, run.time + size, trial, other)
    for k in range(len(state)):
        trial[k] = other[k] - slope[k]
    bend = max(slope_size, norm(trial, state, state, rtol, scales) / size)
    better = max(1e-6, 1e-3 * size) if bend <= 1e-15 else exp(log(0.01 / bend) / order)
    most = TREND * run.last_size if run.last_size > 0.0 else inf
    return min(min(100.0 * size, CAUTIOUS * better), most, end - run.time)


@inlined
def next_size(run, size, error, order):
    """Size of the step after one with an error below 1; a steady change of the size continues.

    Gustafsson's prediction (Hairer and Wanner II, Sec. IV.8): near a singularity, step sizes decrease
    before it and increase after it by a constant factor per step.
    """
    if error == 0.0:
        return GROW * size
    factor = SAFETY * exp(-log(error) / order)
    if run.last_size > 0.0:
        trend = exp(log(run.last_error / error) / order) * (size / run.last_size)
        factor *= min(max(trend, 1.0 / TREND), TREND)
    return size * min(max(factor, SHRINK), GROW)


@inlined
def smaller_size(size, error, tried, failed, order):
    """Size of the next trial after an error above 1, given also the error of a larger size, if tried.

    The two errors give the order of the error, which is low where the motion is not smooth.
    """
    if tried > size and failed > error:
        order = min(max(log(failed / error) / log(tried / size), 1.0), order)
    factor = SAFETY * exp(-log(error) / order)
    return size * (factor if factor > SHRINK else SHRINK)
