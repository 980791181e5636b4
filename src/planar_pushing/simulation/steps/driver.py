"""The driver of the time-stepping integrator: steps of order 1, without events.

A step of length h minimizes ``|v+ - v|_M^2 / 2 + h D(v+)`` over the twist v+ at its end, subject to the
contact. This is the problem of a push from rest, with a velocity as the motion and inertia ``M / h`` about
the previous twist. A step uses the rod angle and the contact frame at its start. The contact's normal
motion is at least ``w_n - gap / h``, so that the gap never becomes negative; with a contact force it is
equal.

During contact, the contact point is advanced by its own motion and the slider's center follows from the
rod. A sticking contact therefore does not drift, and the gap is zero to rounding error for any step. A
finger of finite radius also rolls along the side. In flight, the slider's center is advanced. Over a fence,
the contact's path is then above its tangent, so the step's condition on the gap also keeps the true gap
nonnegative. Over a finger, the gap can become negative in flight by the order of the squared step; the next
step corrects it.
"""

from __future__ import annotations

from math import atan2, inf, sqrt
from typing import NamedTuple

from planar_pushing.mechanics.plane import Array
from planar_pushing.simulation.copying import copy
from planar_pushing.simulation.fence import span, way
from planar_pushing.simulation.legacy.compiled import compiled, inlined, kernel
from planar_pushing.simulation.legacy.modes import contact_modes
from planar_pushing.simulation.legacy.plane import Direction, toward
from planar_pushing.simulation.legacy.record import Push
from planar_pushing.simulation.rows import NO_MODE, Stop
from planar_pushing.simulation.steps.clock import seen
from planar_pushing.simulation.steps.energies import account, settle
from planar_pushing.simulation.steps.resisting import stepped
from planar_pushing.simulation.systems import base, contact
from planar_pushing.simulation.systems.frame import contact_motion, frame_of, size_of, to_contact
from planar_pushing.simulation.systems.shapes import base as shapes
from planar_pushing.simulation.systems.written import put
from planar_pushing.terms.options import Event

#: A gap below this value, in radii, is closed.
CLOSED = 1e-12
#: After a finger has left the side permanently, the pusher recedes at this multiple of the typical speed.
FARTHEST = 1e3
#: Maximum number of steps before the driver returns, so that Python can handle an interrupt, and maximum
#: number of rows per step.
STEPS_AT_ONCE, ROOM = 20_000, 2
INCONSISTENT, NO_EVENT = int(Stop.INCONSISTENT), int(Event.NONE)
LAY_DOWN = int(Stop.SLIDER_CENTER_REACHES_FENCE)
PENETRATES, END_OF_SIDE = int(Stop.PENETRATES), int(Stop.END_OF_SIDE)


class Plan(NamedTuple):
    """Intervals of a run: their ends, numbers of steps, and the pieces of the fence in which they begin."""

    ends: Array
    counts: Array
    pieces: Array


@compiled
def ended(plan, run):
    """Whether a run has ended."""
    return run.stopped != 0 or run.mark == len(plan.ends)


@kernel
@compiled
def advance(system, plan, run, rows):
    """Continue a run until its rows are full, it ends, or many steps are done; return the row count."""
    count = 0
    for _ in range(STEPS_AT_ONCE):
        if ended(plan, run) or count + ROOM > len(rows):
            break
        if _choose(system, plan, run):
            count = _log(system, run, rows, count)
        if run.stopped == 0:
            account(system, run)
            _move(system, run)
            _count(plan, run)
            if run.step == 0 or run.stopped != 0:
                count = _log(system, run, rows, count)
    return count


@compiled
def _choose(system, plan, run):
    """Choose a trial of the step by the policy, the first one if several have the same mode.

    Returns whether the mode or the number of trials has changed.
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
    policy = system.fence[plan.pieces[run.mark]].policy
    best = contact.preferred(policy, kind, run.kinds, count)
    run.kind = run.kinds[best]
    copy(run.trials[0], run.trials[best])
    shape, angle, found = system.shape, run.state[base.ANGLE], run.trials[0]
    run.force[0], run.force[1] = shapes.shown(shape, angle, found[3], found[4])
    run.pivot = int(found[5])
    if system.body.mass == 0.0:
        run.twist[0], run.twist[1] = shapes.shown(shape, angle, found[0], found[1])
        run.twist[2] = found[2]
    return run.kind != kind or count != before


@inlined
def _try(system, run):
    """Store the trials of the step; return their number."""
    h, now = run.until - run.time, base.pose(system, run.state)
    gap = base.clearance(system, run.state)
    (v_x, v_y), (x, y) = seen(system, run, run.twist), seen(system, run, run.way)
    x, y, far = x / h, (y - gap) / h, gap > CLOSED
    if far and gap == inf:
        y = -FARTHEST * (system.body.speed + size_of(v_x, v_y, run.twist[2]))
    u_x, u_y = contact_motion(now, v_x, v_y, run.twist[2])
    size, before = sqrt(x * x + y * y), max(sqrt(u_x * u_x + u_y * u_y), abs(run.twist[2]))
    effects, unit = stepped(system, run, now, h, size, before)
    part = size / unit if unit > 0.0 else 0.0
    pusher = toward(now.frame, atan2(y, x))
    if part != 1.0:
        pusher = Direction(
            pusher.angle, part * pusher.x, part * pusher.y, part * pusher.along, part * pusher.aside
        )
    law, found = contact.law_of(system.body), system.room.solutions
    edges = toward(now.frame, law.right), toward(now.frame, law.left)
    push = Push(effects, now.at, now.frame.x, -now.frame.y)
    system.body.evaluations += 1
    count = contact_modes(push, law, edges, pusher, unit > 0.0, system.room.scratch, found)[0]
    return _kept(run, found, count, unit, far)


@inlined
def _kept(run, found, count, unit, far):
    """Store the solutions as trials, in the scene's units; for an open contact, only the flight."""
    for i in range(count):
        run.kinds[i] = found[i].mode
        for k in range(3):
            run.trials[i, k] = unit * found[i].twist[k]
        run.trials[i, 3], run.trials[i, 4] = found[i].force[0], found[i].force[1]
        run.trials[i, 5] = found[i].pivot
        if far and found[i].mode == base.SEPARATE:
            return i + 1
    return count


@inlined
def _move(system, run):
    """Advance the slider and the pusher to the end of the step."""
    h, state, now = run.until - run.time, run.state, base.pose(system, run.state)
    base.confine(system, state)
    (v_x, v_y, spin), (way_x, way_y) = run.trials[0, :3], seen(system, run, run.way)
    if run.kind == base.SEPARATE:
        along, gap, shape = state[base.ALONG], state[base.GAP], system.shape
        state[base.ALONG], state[base.GAP] = shapes.flown(
            shape, now, along, gap, h * v_x, h * v_y, way_x, way_y, h * spin
        )
    else:
        state[base.GAP] = 0.0
        slip = 0.0
        if run.kind != base.STICK:
            slip = h * contact_motion(now, v_x, v_y, spin)[0] - way_x
        state[base.SLIP] += slip
        state[base.ALONG] += shapes.travel(system.shape, slip, h * spin)
    _turn(system, run, v_x, v_y, spin)
    run.fence[0] += run.way[0]
    run.fence[1] += run.way[1]
    run.time = run.until
    settle(system, run)
    _part(system, run)


@inlined
def _turn(system, run, v_x, v_y, spin):
    """Rotate the slider; with inertia, the motion of the center of mass is preserved."""
    body, angle = system.body, run.state[base.ANGLE]
    turned = angle + (run.until - run.time) * spin
    x, y = to_contact(frame_of(angle), body.center[0], body.center[1])
    turned_x, turned_y = to_contact(frame_of(turned), body.center[0], body.center[1])
    v_x, v_y = shapes.shown(system.shape, angle, v_x, v_y)
    run.twist[0], run.twist[1] = v_x + spin * (turned_y - y), v_y - spin * (turned_x - x)
    run.twist[2], run.state[base.ANGLE] = spin, turned


@inlined
def _part(system, run):
    """End the contact at the end of a finger's side; with an outline, stop there or at a fence."""
    state = run.state
    if state[base.GAP] <= CLOSED and shapes.room(system.shape, state[base.ALONG]) < 0.0:
        if len(system.room.corners) > 0:
            run.stopped = END_OF_SIDE
        else:
            system.body.parted = True
    if shapes.upright(system.shape, system.body, state[base.ANGLE], state[base.GAP]) <= 0.0:
        run.stopped = LAY_DOWN
    elif base.height(system, state, run.kind != base.SEPARATE) <= 0.0:
        run.stopped = PENETRATES


@inlined
def _count(plan, run):
    """Count the step, and its interval if it was the last step in it."""
    run.step += 1
    if run.step == plan.counts[run.mark]:
        run.start, run.step, run.mark = plan.ends[run.mark], 0, run.mark + 1


@compiled
def _log(system, run, rows, count):
    """Log the current instant; the last row for an instant replaces previous ones."""
    if count > 0 and rows[count - 1].time == run.time:
        count -= 1
    row = rows[count]
    copy(row.pusher, run.fence)
    copy(row.force, run.force)
    row.time, row.mode, row.solutions, row.stopped = run.time, run.kind, run.solutions, run.stopped
    row.pivot, row.event = run.pivot, NO_EVENT
    v_x, v_y = seen(system, run, run.twist)
    put(system, run.state, v_x, v_y, run.twist[2], row)
    return count + 1
