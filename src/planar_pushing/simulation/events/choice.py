"""The choice of a mode: the consistent modes at an instant, and the one that the policy prefers."""

from __future__ import annotations

from planar_pushing.simulation.events import run as at
from planar_pushing.simulation.fence import span
from planar_pushing.simulation.legacy.compiled import compiled, inlined
from planar_pushing.simulation.systems import base, equations

#: A margin this close to zero is judged by its trend.
NEAR = 1e-10
#: Time over which the trend is evaluated, as a fraction of the time in which the fence moves by one length.
AHEAD = 1e-5
TREND = 1e-12
#: Placeholder where there is no contact mode.
NO_KIND = -1


@compiled
def holds(system, mode, time, state, run):
    """Whether the margins of a mode are positive, or zero and not decreasing."""
    now, later, trial = run.guards[at.NOW], run.guards[at.LATER], run.vectors[at.TRIAL]
    equations.guards(system, mode, time, state, now)
    near = False
    for cause in range(base.CAUSES):
        if not base.WATCHES[cause]:
            if now[cause] < -NEAR:
                return False
            near = near or now[cause] <= NEAR
    if not near:
        return True
    during = mode.during
    ahead = AHEAD * min(during.end - during.start, base.pace(system, during, time))
    equations.rates(system, mode, time, state, trial)
    for k in range(len(state)):
        trial[k] = state[k] + ahead * trial[k]
    equations.guards(system, mode, time + ahead, trial, later)
    for cause in range(base.CAUSES):
        margin = not base.WATCHES[cause] and now[cause] <= NEAR
        if margin and not later[cause] >= now[cause] - TREND:
            return False
    return True


@inlined
def choose(system, run, policy, excluded):
    """Choose a consistent mode other than `excluded` by the policy; return whether there is one."""
    state, before = run.vectors[at.STATE], run.kind
    run.count = base.modes(
        system, span(system.fence, run.span), run.time, state, run.kinds[:], run.feet[:],
        run.hinged[:], run.starts[:],
    )  # fmt: skip
    run.solutions, run.chosen, run.kind = 0, -1, NO_KIND
    for i in range(run.count):
        kind = base.contact_mode(run.kinds[i])
        if kind == excluded:
            run.kinds[i] = NO_KIND
        elif holds(system, at.candidate(system, run, i), run.time, state, run):
            place, best = base.rank(policy, before, kind), base.rank(policy, before, run.kind)
            if run.chosen < 0 or place < best:
                run.chosen, run.kind = i, kind
            run.solutions += 1
    run.changes += 1 if run.kind != before and before != NO_KIND else 0
    return run.chosen >= 0


@compiled
def solutions_now(system, run, time, state):
    """Number of consistent modes at an instant within a step; one if the contact is open."""
    count = 1
    if base.clearance(system, state) > base.SLACK:
        return count
    for i in range(run.count):
        if i != run.chosen and run.kinds[i] != NO_KIND:
            other = at.candidate(system, run, i)
            count += 1 if holds(system, other, time, state, run) else 0
    return count
