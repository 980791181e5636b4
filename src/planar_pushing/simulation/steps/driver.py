"""The driver of the time-stepping integrator: steps of order 1, without events.

A step sees the rod angle of its start, and the contact's frame there. While the contact lasts, the
contact point itself is moved by its own motion and the slider's centre follows from the rod: a stick is
then a stick and the gap is closed to rounding, whatever the step. In flight the slider's centre is moved;
over a fence the contact's path is then above its tangent, so the step's condition on the gap keeps the true
gap open as well. Over a finger a flight may end below zero by the square of a step; the next step lifts it.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from planar_pushing.mechanics.compiled import compiled, inlined, kernel
from planar_pushing.mechanics.numerics.copying import copy
from planar_pushing.mechanics.plane import Array, contact_motion
from planar_pushing.mechanics.reduced.base import MOTION
from planar_pushing.simulation.fence import span, way
from planar_pushing.simulation.rows import NO_MODE, Stop
from planar_pushing.simulation.steps.trials import TRIALS, Step, enumerate_trials
from planar_pushing.simulation.systems import base, contact
from planar_pushing.simulation.systems.motion import friction, kinetic_energy, mass_offset, rod_of
from planar_pushing.simulation.systems.shapes import base as shapes
from planar_pushing.simulation.systems.written import put

#: A gap that is this small in radii is closed.
CLOSED = 1e-12
#: Steps until the driver returns in any case, so that an interrupt is heard, and rows that a step writes.
STEPS_AT_ONCE, ROOM = 20_000, 2
INCONSISTENT, LIES = int(Stop.INCONSISTENT), int(Stop.LIES)

#: Where a run is: its time and the end of the step; `mark` and `step` count the intervals between the
#: times that are recorded, from `start` on, and the steps in one; place of the pusher, and its way in the
#: step; state as a system without inertia has it, twist, and mean force of the last step. Way, twist and
#: force are along the axes of the world, trials along those of the contact's frame.
CLOCK = np.dtype(
    [
        ("time", "f8"), ("until", "f8"), ("start", "f8"), ("fence", "f8", (2,)), ("way", "f8", (2,)),
        ("state", "f8", (base.STILL,)), ("twist", "f8", (3,)), ("force", "f8", (2,)),
        ("kind", "i8"), ("solutions", "i8"), ("mark", "i8"), ("step", "i8"), ("stopped", "i8"),
        ("kinds", "i8", (TRIALS,)), ("trials", "f8", (TRIALS, MOTION)),
    ],
    align=True,
)  # fmt: skip


class Plan(NamedTuple):
    """Intervals of a run: ends, steps in each, and pieces of the fence in which they begin."""

    ends: Array
    counts: Array
    pieces: Array


@compiled
def ended(plan, run):
    """Whether a run has nothing more to do."""
    return run.stopped != 0 or run.mark == len(plan.ends)


@kernel
@compiled
def advance(system, plan, run, rows):
    """Go on with a run until its rows are full, it has ended, or many steps are done; the rows written."""
    count = 0
    for _ in range(STEPS_AT_ONCE):
        if ended(plan, run) or count + ROOM > len(rows):
            break
        if _choose(system, plan, run):
            count = _log(system, run, rows, count)
        if run.stopped == 0:
            _account(system, run)
            _move(system, run)
            _count(plan, run)
            if run.step == 0 or run.stopped != 0:
                count = _log(system, run, rows, count)
    return count


@compiled
def _choose(system, plan, run):
    """Take the step that the policy takes, of several in one mode that of the least impulse.

    Returns whether the mode, or the number of trials, changes.
    """
    part = (run.step + 1) / plan.counts[run.mark]
    run.until = run.start + (plan.ends[run.mark] - run.start) * part
    during = span(system.fence, plan.pieces[run.mark])
    run.way[0], run.way[1] = way(system.fence, during, run.time, run.until)
    count, before, kind = _try(system, run), run.solutions, run.kind
    run.solutions = count
    if count == 0:
        run.kind, run.stopped = NO_MODE, INCONSISTENT
        run.force[:] = 0.0
        return True
    policy, h = system.fence[plan.pieces[run.mark]].policy, run.until - run.time
    best = contact.preferred(policy, kind, run.kinds, count)
    run.kind = run.kinds[best]
    copy(run.trials[0], run.trials[best])
    shape, angle, found = system.shape, run.state[base.ANGLE], run.trials[0]
    run.force[0], run.force[1] = shapes.shown(shape, angle, found[3] / h, found[4] / h)
    if system.body.mass == 0.0:
        run.twist[0], run.twist[1] = shapes.shown(shape, angle, found[0], found[1])
        run.twist[2] = found[2]
    return run.kind != kind or count != before


@compiled
def _seen(system, run, vector):
    """A vector of the world in the contact's frame."""
    return shapes.seen(system.shape, run.state[base.ANGLE], vector[0], vector[1])


@inlined
def _try(system, run):
    """Write down the trials of the step; their number."""
    h, now = run.until - run.time, base.pose(system, run.state)
    gap = base.clearance(system, run.state)
    (v_x, v_y), (x, y) = _seen(system, run, run.twist), _seen(system, run, run.way)
    step = Step(h, now, v_x, v_y, run.twist[2], x / h, (y - gap) / h)
    return enumerate_trials(system, step, gap <= CLOSED, run.kinds, run.trials)


@inlined
def _account(system, run):
    """Enter the energies of the step.

    Friction dissipates its potential at the end of the step. What is left of the work belongs to the
    contact; in flight it is the scheme's own loss, which goes to friction.
    """
    (v_x, v_y, spin), now = run.trials[0, :3], base.pose(system, run.state)
    x, y = _seen(system, run, run.twist)
    work = run.force[0] * run.way[0] + run.force[1] * run.way[1]
    left = work + kinetic_energy(system.body, now.x, now.y, x, y, run.twist[2])
    left -= kinetic_energy(system.body, now.x, now.y, v_x, v_y, spin)
    f_x, f_y, torque = friction(now.effects, now.own, v_x, v_y, spin)
    rubbed = (run.until - run.time) * (f_x * v_x + f_y * v_y + torque * spin)
    if run.force[0] == 0.0 and run.force[1] == 0.0:
        rubbed = left
    run.state[base.WORK] += work
    run.state[base.RUBBED] += rubbed
    run.state[base.LOST] += left - rubbed


@inlined
def _move(system, run):
    """Take the slider and the pusher to the end of the step."""
    h, state, own = run.until - run.time, run.state, base.pose(system, run.state).own
    (v_x, v_y, spin), (way_x, way_y) = run.trials[0, :3], _seen(system, run, run.way)
    if run.kind == base.SEPARATE:
        along, gap, shape = state[base.ALONG], state[base.GAP], system.shape
        state[base.ALONG], state[base.GAP] = shapes.flown(
            shape, own, along, gap, h * v_x, h * v_y, way_x, way_y, h * spin
        )
    else:
        state[base.GAP] = 0.0
        if run.kind != base.STICK:
            slip = h * contact_motion(own, v_x, v_y, spin)[0] - way_x
            state[base.SLIP] += slip
            state[base.ALONG] += slip
    _turn(system, run, v_x, v_y, spin)
    run.fence[0] += run.way[0]
    run.fence[1] += run.way[1]
    run.time = run.until
    _part(system, run)


@inlined
def _turn(system, run, v_x, v_y, spin):
    """Turn the slider; what inertia carries on is the motion of the centre of mass."""
    body, angle = system.body, run.state[base.ANGLE]
    turned = angle + (run.until - run.time) * spin
    x, y = mass_offset(body, rod_of(body, angle))
    turned_x, turned_y = mass_offset(body, rod_of(body, turned))
    v_x, v_y = shapes.shown(system.shape, angle, v_x, v_y)
    run.twist[0], run.twist[1] = v_x + spin * (turned_y - y), v_y - spin * (turned_x - x)
    run.twist[2], run.state[base.ANGLE] = spin, turned


@inlined
def _part(system, run):
    """End the contact at the end of a finger's side; stop where the slider lies on a fence."""
    state = run.state
    if state[base.GAP] <= CLOSED and shapes.room(system.shape, state[base.ALONG]) < 0.0:
        system.body.parted = True
    if shapes.upright(system.shape, system.body, state[base.ANGLE], state[base.GAP]) <= 0.0:
        run.stopped = LIES


@inlined
def _count(plan, run):
    """Count the step, and its interval where it was the last of it."""
    run.step += 1
    if run.step == plan.counts[run.mark]:
        run.start, run.step, run.mark = plan.ends[run.mark], 0, run.mark + 1


@compiled
def _log(system, run, rows, count):
    """Write down where the run is; the last row of an instant replaces those before."""
    if count > 0 and rows[count - 1].time == run.time:
        count -= 1
    row = rows[count]
    copy(row.fence, run.fence)
    copy(row.force, run.force)
    row.time, row.mode, row.solutions, row.stopped = run.time, run.kind, run.solutions, run.stopped
    v_x, v_y = _seen(system, run, run.twist)
    put(system, run.state, v_x, v_y, run.twist[2], row)
    return count + 1
