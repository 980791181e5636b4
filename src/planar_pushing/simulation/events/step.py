"""A step of the event-driven integrator by either method: sizes are tried until the error is small."""

from __future__ import annotations

from collections.abc import Callable
from math import inf
from typing import Any

from planar_pushing.mechanics.compiled import compiled, generic_owning, inlined
from planar_pushing.mechanics.numerics.copying import copy
from planar_pushing.simulation.events import explicit, sizes, stiff, watch
from planar_pushing.simulation.events import run as at
from planar_pushing.simulation.fence import span
from planar_pushing.simulation.systems import base

#: Step times Jacobian near the bound of stability (Hairer and Wanner II, Sec. IV.2).
STIFF = 4.0
#: Above this error, in units of the tolerance, a step that was tried says nothing.
WILD = 1e5
#: So many steps in a row have to agree before the method changes.
AGREE = 15


@generic_owning
def _stiff(kinds: Any) -> Callable[..., Any]:
    """Try a step of the stiff method, for which only friction with inertia calls; as `stiff.attempt`."""
    return stiff.attempt if len(kinds) > 1 else _never


@compiled
def _never(effects, system, mode, run, size, rtol, again):
    return inf


@inlined
def begin(run):
    """Forget the steps before, but for a kink, behind which the motion is not smooth."""
    run.explicit, run.fresh, run.agree, run.stable = True, True, 0, inf
    run.pivot, run.side = run.time, 1.0 if run.cause == base.KINK else 0.0


@inlined
def _first_slope(system, mode, run, end, rtol, order):
    """Slope at the start of a step, and the size of a first one."""
    if run.explicit and not run.fresh:
        copy(run.vectors[at.FIRST], run.vectors[at.LAST])
    else:
        base.rates(system, mode, run.time, run.vectors[at.STATE], run.vectors[at.FIRST])
    if run.fresh:
        run.planned = sizes.first_size(system, mode, run, end, rtol, order)
        run.last_size, run.fresh = 0.0, False


@inlined
def take(system, mode, run, end, rtol):
    """Go on by one step; False where no step is small enough."""
    order = explicit.ORDER if run.explicit else stiff.ORDER
    if run.side < 0.0 and run.time >= run.pivot:
        run.side = 1.0
    _first_slope(system, mode, run, end, rtol, order)
    least, tried, failed = sizes.least_size(run.time), 0.0, 0.0
    size = max(run.planned, least)
    while size >= least:
        bound = min(end, run.pivot) if run.side < 0.0 else end
        run.until, run.prepared = min(run.time + size, bound), False
        size = run.until - run.time
        if run.explicit:
            error = explicit.attempt(system, mode, run, rtol)
        else:
            error = _stiff(system.effects, system, mode, run, size, rtol, tried > 0.0)
        if error < 1.0:
            planned = sizes.next_size(run, size, error, order)
            run.planned = min(planned, size) if tried > 0.0 else planned
            run.last_size, run.last_error = size, error
            return True
        if run.explicit and run.side >= 0.0 and error < WILD:
            watch.look_for_pivot(system, mode, run)
        smaller = sizes.smaller_size(size, error, tried, failed, order)
        tried, failed, size = size, error, smaller
    return False


@inlined
def move_on(system, run):
    """Go to the end of a step, and change the method where steps in a row say so."""
    during = span(system.fence, run.span)
    settling = base.settling(system, during, run.until, run.vectors[at.REACHED])
    bound = (run.until - run.time) * settling
    changes = bound < run.stable / 2
    if run.explicit:
        changes = bound > 0.0 and explicit.stiffness(run) > STIFF
    run.agree = run.agree + 1 if changes else 0
    run.time = run.until
    copy(run.vectors[at.STATE], run.vectors[at.REACHED])
    if run.agree == AGREE:
        run.explicit, run.stable = not run.explicit, bound
        run.agree, run.fresh, run.last_size = 0, True, 0.0
