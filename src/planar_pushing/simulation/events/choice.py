"""The choice of a mode: which ones hold at an instant, and which of them the policy takes."""

from __future__ import annotations

from planar_pushing.mechanics.compiled import compiled, inlined
from planar_pushing.simulation.events.run import LATER, NOW, STATE, TRIAL, candidate
from planar_pushing.simulation.fence import span
from planar_pushing.simulation.systems.base import (
    CAUSES,
    WATCHES,
    contact_mode,
    guards,
    modes,
    pace,
    rank,
    rates,
)

#: A margin this near to zero is judged by where it goes from there.
NEAR = 1e-10
#: How far ahead that is looked, as a part of the time in which the fence moves by one length.
AHEAD = 1e-5
TREND = 1e-12
#: In place of a contact mode where there is none.
NO_KIND = -1


@compiled
def holds(system, mode, time, state, run):
    """Whether the margins of a mode are positive, or zero and not about to fall."""
    now, later = run.guards[NOW], run.guards[LATER]
    guards(system, mode, time, state, now)
    near = False
    for cause in range(CAUSES):
        if not WATCHES[cause]:
            if now[cause] < -NEAR:
                return False
            near = near or now[cause] <= NEAR
    if not near:
        return True
    during = mode.during
    ahead = AHEAD * min(during.end - during.start, pace(system, during, time))
    rates(system, mode, time, state, run.vectors[TRIAL])
    for k in range(len(state)):
        run.vectors[TRIAL][k] = state[k] + ahead * run.vectors[TRIAL][k]
    guards(system, mode, time + ahead, run.vectors[TRIAL], later)
    for cause in range(CAUSES):
        if not WATCHES[cause] and now[cause] <= NEAR and not later[cause] >= now[cause] - TREND:
            return False
    return True


@inlined
def choose(system, run, policy, excluded):
    """Take a consistent mode by the policy, `excluded` apart; whether there is one."""
    during = span(system.fence, run.span)
    run.count = modes(system, during, run.time, run.vectors[STATE], run.kinds, run.starts)
    run.solutions, run.chosen = 0, -1
    best = 0
    for i in range(run.count):
        kind = contact_mode(run.kinds[i])
        if kind == excluded:
            run.kinds[i] = NO_KIND
        elif holds(system, candidate(system, run, i), run.time, run.vectors[STATE], run):
            place = rank(policy, run.kind, kind)
            if run.chosen < 0 or place < best:
                run.chosen, best = i, place
            run.solutions += 1
    before = run.kind
    run.kind = contact_mode(run.kinds[run.chosen]) if run.chosen >= 0 else NO_KIND
    run.changes += 1 if run.kind != before and before != NO_KIND else 0
    return run.chosen >= 0


@compiled
def solutions_now(system, run, time, state):
    """How many modes hold at an instant within a step of the chosen one."""
    count = 1
    for i in range(run.count):
        if i != run.chosen and run.kinds[i] != NO_KIND:
            other = candidate(system, run, i)
            count += 1 if holds(system, other, time, state, run) else 0
    return count
