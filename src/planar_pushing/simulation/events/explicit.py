"""Steps of DOP853, an explicit method of order 8 (Hairer, Norsett and Wanner I, Secs. II.4 and II.10)."""

from __future__ import annotations

from math import sqrt

from planar_pushing.simulation.events import run as at
from planar_pushing.simulation.events.sizes import norm
from planar_pushing.simulation.events.tableau import ERRORS, STAGES, STEP, WEIGHTS, A, C
from planar_pushing.simulation.legacy.compiled import compiled, inlined
from planar_pushing.simulation.systems import equations

#: Order of the error of a step.
ORDER = 8.0
#: Stage near the middle of a step, with a state close to the motion, and its position in the step.
MIDDLE = 9
PART = float(C[MIDDLE])


@compiled
def _sum(weights, count, slopes, found):
    """Store a weighted sum of slopes in `found`."""
    for k in range(len(found)):
        total = 0.0
        for j in range(count):
            total += weights[j] * slopes[j, k]
        found[k] = total


@inlined
def clock(run, part):
    """Time at a fraction of a step, and its rate.

    Near a pivot time, the square root of the distance to it advances uniformly, which smooths the motion.
    """
    if run.side == 0.0:
        return run.time + part * (run.until - run.time), run.until - run.time
    start, end = sqrt(abs(run.time - run.pivot)), sqrt(abs(run.until - run.pivot))
    root = start + part * (end - start)
    return run.pivot + run.side * root * root, 2.0 * run.side * root * (end - start)


@inlined
def _part(run, time):
    """Fraction of a step completed at a time."""
    if run.side == 0.0:
        return (time - run.time) / (run.until - run.time)
    start, end = sqrt(abs(run.time - run.pivot)), sqrt(abs(run.until - run.pivot))
    return (sqrt(abs(time - run.pivot)) - start) / (end - start)


@compiled
def _stage(system, mode, run, i):
    """Compute the change of state of a stage, and the guards at the middle stage."""
    slopes, state, trial = (
        run.vectors[at.SLOPES : at.DENSE],
        run.vectors[at.STATE],
        run.vectors[at.TRIAL],
    )
    _sum(A[i], i, slopes, trial)
    time, rate = clock(run, C[i])
    for k in range(len(state)):
        trial[k] += state[k]
    if i == MIDDLE:
        equations.rates_and_guards(system, mode, time, trial, slopes[i], run.guards[at.ABOUT])
    else:
        equations.rates(system, mode, time, trial, slopes[i])
    for k in range(len(state)):
        slopes[i, k] *= rate


@compiled
def attempt(system, mode, run, rtol):
    """Try a step; return the estimate of its error in units of the tolerance (Sec. II.10).

    The guards near its middle and at its end are stored.
    """
    slopes, trial = run.vectors[at.SLOPES : at.DENSE], run.vectors[at.TRIAL]
    state, reached, scales = run.vectors[at.STATE], run.vectors[at.REACHED], run.vectors[at.SCALES]
    rate = clock(run, 0.0)[1]
    for k in range(len(state)):
        slopes[0, k] = rate * run.vectors[at.FIRST, k]
    for i in range(1, STEP):
        _stage(system, mode, run, i)
    _sum(A[STEP], STEP, slopes, reached)
    for k in range(len(state)):
        reached[k] += state[k]
    last, end = run.vectors[at.LAST], run.guards[at.END]
    equations.rates_and_guards(system, mode, run.until, reached, last, end)
    rate = clock(run, 1.0)[1]
    for k in range(len(state)):
        slopes[STEP, k] = rate * last[k]
    _sum(ERRORS[0], STEP + 1, slopes, trial)
    fifth = norm(trial, state, reached, rtol, scales) ** 2
    _sum(ERRORS[1], STEP + 1, slopes, trial)
    third = norm(trial, state, reached, rtol, scales) ** 2
    return fifth / sqrt(fifth + 0.01 * third) if fifth > 0.0 else 0.0


@compiled
def _prepare(system, mode, run):
    """Compute the coefficients of the dense output, and the additional stages that it needs."""
    for i in range(STEP + 1, STAGES):
        _stage(system, mode, run, i)
    slopes, dense = run.vectors[at.SLOPES : at.DENSE], run.vectors[at.DENSE :]
    reached, state = run.vectors[at.REACHED], run.vectors[at.STATE]
    for k in range(len(state)):
        dense[0, k] = reached[k] - state[k]
        dense[1, k] = slopes[0, k] - dense[0, k]
        dense[2, k] = dense[0, k] - slopes[STEP, k] - dense[1, k]
    for i in range(len(WEIGHTS)):
        _sum(WEIGHTS[i], STAGES, slopes, dense[3 + i])
    run.prepared = True


@compiled
def interpolate(system, mode, run, time, found):
    """State at a time within the last step."""
    if not run.prepared:
        _prepare(system, mode, run)
    dense, state, x = run.vectors[at.DENSE :], run.vectors[at.STATE], _part(run, time)
    y = 1.0 - x
    for k in range(len(found)):
        value = dense[4, k] + y * (dense[5, k] + x * dense[6, k])
        value = dense[2, k] + y * (dense[3, k] + x * value)
        found[k] = state[k] + x * (dense[0, k] + y * (dense[1, k] + x * value))
