"""One step of a motion in a mode, with a size at which its error is small.

A step that fails is tried again with a smaller size, which its error suggests. The step ends where the
pusher's span, or the piece of the wall that a finger is on, does at the latest, and at a kink.
"""

from __future__ import annotations

from math import sqrt

from planar_pushing.core.motion.integration.event_search import look_for_kink
from planar_pushing.core.motion.integration.explicit import scale_velocities
from planar_pushing.core.motion.integration.integrator import (
    attempt_step,
    begin_steps,
    choose_method,
    count_relaxations,
    keeps_energy,
    next_size,
    smaller_size,
    smallest_size,
)
from planar_pushing.core.motion.kinematics.mode import Mode
from planar_pushing.core.motion.kinematics.system import (
    FIRST_RATES,
    LAST_RATES,
    PENETRATES,
    STATE,
    VALUES,
    System,
    copy_numbers,
    guards_of,
    is_massive,
    vector_of,
)
from planar_pushing.core.motion.kinematics.wall import longest_step
from planar_pushing.core.motion.modes.equations import write_rates

#: Above this error, in units of the tolerance, a trial step gives no information.
WILD = 1e5


def take_small_error_step(system: System, mode: Mode) -> bool:
    """Take one step, with a size at which the error is small; return whether there is one."""
    run, end = system.run, mode.during.end
    if run.kink_side < 0 and run.time >= run.kink:
        run.kink_side = 1
    rates, smallest = vector_of(system, FIRST_RATES), smallest_size(run.time)
    if run.fresh:
        write_rates(system, mode, run.time, vector_of(system, STATE), rates)
        begin_steps(system, mode, end)
    else:
        copy_numbers(rates, vector_of(system, LAST_RATES), system.entries)
        choose_method(run)
    if is_massive(system):
        scale_velocities(system, mode)
    size, last_size, last_error = max(run.planned, smallest), 0.0, 0.0
    speed = sqrt(rates.along * rates.along + rates.gap * rates.gap)
    longest = longest_step(system, mode, guards_of(system, VALUES)[PENETRATES], speed)
    end = min(end, run.time + max(longest, smallest))
    while size >= smallest:
        bound = min(end, run.kink) if run.kink_side < 0 else end
        run.until, run.prepared = min(run.time + size, bound), False
        size = run.until - run.time
        error = attempt_step(system, mode)
        balances: bool = error >= 1.0 or keeps_energy(system, mode)
        if error < 1.0 and balances:
            planned = next_size(run, size, error)
            run.planned = min(planned, size) if last_size > 0.0 else planned
            run.last_size, run.last_error = size, error
            count_relaxations(system)
            return True
        if run.kink_side >= 0 and error < WILD and balances:
            look_for_kink(system, mode)
        smaller = size / 2.0
        if balances:
            smaller = smaller_size(size, error, last_size, last_error)
        last_size, last_error, size = size, error, smaller
    return False
