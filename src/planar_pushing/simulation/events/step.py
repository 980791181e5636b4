"""A step of the event-driven integrator, with the size reduced until the error is small."""

from __future__ import annotations

from math import sqrt

from planar_pushing.simulation.copying import copy
from planar_pushing.simulation.events import explicit, sizes, watch
from planar_pushing.simulation.events import run as at
from planar_pushing.simulation.legacy.compiled import inlined
from planar_pushing.simulation.systems import base, equations

#: Above this error, in units of the tolerance, a trial step gives no information.
WILD = 1e5


@inlined
def begin(run):
    """Forget the previous steps, except a kink, after which the motion is not smooth."""
    run.fresh = True
    run.pivot, run.side = run.time, 1.0 if run.cause == base.KINK else 0.0


@inlined
def _first_slope(system, mode, run, end, rtol):
    """Compute the slope at the start of a step, and the size of a first step."""
    if run.fresh:
        equations.rates(system, mode, run.time, run.vectors[at.STATE], run.vectors[at.FIRST])
        run.planned = sizes.first_size(system, mode, run, end, rtol, explicit.ORDER)
        run.last_size, run.fresh = 0.0, False
    else:
        copy(run.vectors[at.FIRST], run.vectors[at.LAST])


@inlined
def _stride(system, mode, run):
    """Longest step that cannot pass through a part of the outline."""
    slope = run.vectors[at.FIRST]
    speed = sqrt(slope[base.ALONG] ** 2 + slope[base.GAP] ** 2)
    return base.stride(system, mode, run.guards[at.VALUES, base.PENETRATES], speed)


@inlined
def take(system, mode, run, end, rtol):
    """Take one step; return False if no step is small enough."""
    if run.side < 0.0 and run.time >= run.pivot:
        run.side = 1.0
    _first_slope(system, mode, run, end, rtol)
    least, tried, failed = sizes.least_size(run.time), 0.0, 0.0
    size = max(run.planned, least)
    end = min(end, run.time + max(_stride(system, mode, run), least))
    while size >= least:
        bound = min(end, run.pivot) if run.side < 0.0 else end
        run.until, run.prepared = min(run.time + size, bound), False
        size = run.until - run.time
        error = explicit.attempt(system, mode, run, rtol)
        if error < 1.0:
            planned = sizes.next_size(run, size, error, explicit.ORDER)
            run.planned = min(planned, size) if tried > 0.0 else planned
            run.last_size, run.last_error = size, error
            return True
        if run.side >= 0.0 and error < WILD:
            watch.look_for_pivot(system, mode, run)
        smaller = sizes.smaller_size(size, error, tried, failed, explicit.ORDER)
        tried, failed, size = size, error, smaller
    return False


@inlined
def move_on(run):
    """Advance to the end of a step."""
    run.time = run.until
    copy(run.vectors[at.STATE], run.vectors[at.REACHED])
