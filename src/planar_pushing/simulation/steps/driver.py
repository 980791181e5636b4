"""The driver of the time-stepping integrator: steps of order 1, without events.

A step of length h minimizes ``|v+ - v|_M^2 / 2 + h D(v+)`` over the twist v+ at its end, subject to the
contact: it is the push from rest whose motion is a velocity, with inertia ``M / h`` about the twist before.
A step sees the rod angle of its start, and the contact's frame there. The contact's normal motion is at
least ``w_n - gap / h``, so that the gap never closes past zero; a contact mode takes it for equal.

While the contact lasts, the contact point itself is moved by its own motion and the slider's center follows
from the rod: a stick is then a stick and the gap is closed to rounding, whatever the step. In flight the
slider's center is moved; over a fence the contact's path is then above its tangent, so the step's condition
on the gap keeps the true gap open as well. Over a finger a flight may end below zero by the square of a
step; the next step lifts it.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from math import atan2, inf, sqrt
from typing import Any, NamedTuple

import numpy as np

from planar_pushing.mechanics.compiled import compiled, generic, inlined, kernel
from planar_pushing.mechanics.effects.inertia import Mass
from planar_pushing.mechanics.effects.load import Wrench
from planar_pushing.mechanics.modes import MOST, Push, contact_modes
from planar_pushing.mechanics.plane import Array, Direction, toward
from planar_pushing.simulation.copying import copy
from planar_pushing.simulation.fence import span, way
from planar_pushing.simulation.rows import NO_MODE, Event, Stop
from planar_pushing.simulation.systems import base, contact
from planar_pushing.simulation.systems.drag import drag, load_at, powers, scaled_films, with_loads
from planar_pushing.simulation.systems.frame import (
    contact_motion,
    frame_of,
    kinetic_energy,
    size_of,
    to_body,
    to_contact,
)
from planar_pushing.simulation.systems.shapes import base as shapes
from planar_pushing.simulation.systems.written import potential, put

#: A gap that is this small in radii is closed.
CLOSED = 1e-12
#: A pusher that has left a finger's side for good is this many speeds away.
FARTHEST = 1e3
#: Steps until the driver returns in any case, so that an interrupt is heard, and rows that a step writes.
STEPS_AT_ONCE, ROOM = 20_000, 2
INCONSISTENT, LIES, NO_EVENT = int(Stop.INCONSISTENT), int(Stop.LIES), int(Event.NONE)


@cache
def clock_type(entries: int) -> np.dtype[Any]:
    """A run whose state has so many entries, of which those of inertia are not used.

    Its time and the end of the step; `mark` and `step` count the intervals between the times that are
    recorded, from `start` on, and the steps in one; position of the pusher, and its displacement in the
    step; twist, and mean force and pivot of the last step; work of the loads, and energy lost at the
    contact. Displacement, twist and force are along the axes of the world; trials, each a twist, a force
    and a pivot, along those of the contact's frame.
    """
    return np.dtype(
        [
            ("time", "f8"), ("until", "f8"), ("start", "f8"), ("fence", "f8", (2,)), ("way", "f8", (2,)),
            ("state", "f8", (entries,)), ("twist", "f8", (3,)), ("force", "f8", (2,)), ("pulled", "f8"),
            ("lost", "f8"),
            ("kind", "i8"), ("solutions", "i8"), ("mark", "i8"), ("step", "i8"), ("stopped", "i8"),
            ("pivot", "i8"), ("kinds", "i8", (MOST,)), ("trials", "f8", (MOST, 6)),
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
    """Take the step that the policy takes, of several in one mode the first.

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
    """Write down the solutions as trials, in the scene's units; of a contact that is open, the flight."""
    for i in range(count):
        run.kinds[i] = found[i].mode
        for k in range(3):
            run.trials[i, k] = unit * found[i].twist[k]
        run.trials[i, 3], run.trials[i, 4] = found[i].force[0], found[i].force[1]
        run.trials[i, 5] = found[i].pivot
        if far and found[i].mode == base.SEPARATE:
            return i + 1
    return count


@compiled
def _quasi_static_step(system, run, now, h, size, before):
    """Effects of a step without inertia, which does not remember the twist before, and its unit."""
    effects = (*system.friction, *scaled_films(system.films, size))
    return with_loads(system.loads, effects, system.body, run.state[base.ANGLE]), size


@compiled
def _inertial_step(system, run, now, h, size, before):
    """Effects of a step with inertia, which pulls towards the twist before, and its unit of motion."""
    body, (v_x, v_y), spin = system.body, _seen(system, run, run.twist), run.twist[2]
    load, (x, y) = load_at(body, run.state[base.ANGLE]), to_body(now.frame, v_x, v_y)
    c_x, c_y = body.center
    # Momentum over the time of the step, of the center of mass, and about the slider's center.
    p_x, p_y = body.mass * (x - spin * c_y) / h, body.mass * (y + spin * c_x) / h
    turn = body.moment * spin / h + (c_x * p_y - c_y * p_x)
    pull = Wrench(load.x + p_x, load.y + p_y, load.torque + turn)
    push = h * sqrt(load.x * load.x + load.y * load.y) / body.mass
    unit = max(size, before, push)
    mass = Mass(unit * body.mass / h, body.moment / body.mass, c_x, c_y)
    return (*system.friction, *scaled_films(system.films, unit), mass, pull), unit


@generic
def stepped(kind: Any) -> Callable[..., Any]:
    """Effects of a step and their unit: system, run, pose, length, speeds of pusher and contact."""
    return _inertial_step if kind is base.Inertial else _quasi_static_step


@inlined
def _account(system, run):
    """Enter the energies of the step.

    Effects dissipate the power at the end of the step. What is left of the work belongs to the contact; in
    flight it is the scheme's own loss, which goes to friction.
    """
    (v_x, v_y, spin), now = run.trials[0, :3], base.pose(system, run.state)
    h, (x, y) = run.until - run.time, _seen(system, run, run.twist)
    work = run.force[0] * run.way[0] + run.force[1] * run.way[1]
    left = work + kinetic_energy(system.body, now, x, y, run.twist[2])
    left -= kinetic_energy(system.body, now, v_x, v_y, spin)
    x, y = to_body(now.frame, v_x, v_y)
    found, rates, count = drag(system.effects, x, y, spin), system.room.rates, len(system.effects)
    total = found.f_x * x + found.f_y * y + found.torque * spin
    powers(system.effects, x, y, spin, total, rates, 0)
    for i in range(count):
        run.state[len(run.state) - count + i] += h * rates[i]
    run.state[base.WORK] += work
    run.state[base.LOST] += left - h * total


@compiled
def _settle(system, run):
    """Enter the work of the loads in the step; in flight what is left of all goes to the first effect."""
    x, y = _center(system, run)
    now = potential(system, run.state, x, y)
    run.state[base.LOST] += now - run.pulled
    run.pulled, count = now, len(system.effects)
    if run.force[0] == 0.0 and run.force[1] == 0.0 and count > 0:
        run.state[len(run.state) - count] += run.state[base.LOST] - run.lost
        run.state[base.LOST] = run.lost
    run.lost = run.state[base.LOST]


@compiled
def _center(system, run):
    """Position of the slider's center."""
    now, state = base.pose(system, run.state), run.state
    angle, along, gap = state[base.ANGLE], state[base.ALONG], state[base.GAP]
    return shapes.center(system.shape, angle, now, along, gap, run.fence[0], run.fence[1])


@inlined
def _move(system, run):
    """Take the slider and the pusher to the end of the step."""
    h, state, now = run.until - run.time, run.state, base.pose(system, run.state)
    (v_x, v_y, spin), (way_x, way_y) = run.trials[0, :3], _seen(system, run, run.way)
    if run.kind == base.SEPARATE:
        along, gap, shape = state[base.ALONG], state[base.GAP], system.shape
        state[base.ALONG], state[base.GAP] = shapes.flown(
            shape, now, along, gap, h * v_x, h * v_y, way_x, way_y, h * spin
        )
    else:
        state[base.GAP] = 0.0
        if run.kind != base.STICK:
            slip = h * contact_motion(now, v_x, v_y, spin)[0] - way_x
            state[base.SLIP] += slip
            state[base.ALONG] += slip
    _turn(system, run, v_x, v_y, spin)
    run.fence[0] += run.way[0]
    run.fence[1] += run.way[1]
    run.time = run.until
    _settle(system, run)
    _part(system, run)


@inlined
def _turn(system, run, v_x, v_y, spin):
    """Turn the slider; inertia carries on the motion of the center of mass."""
    body, angle = system.body, run.state[base.ANGLE]
    turned = angle + (run.until - run.time) * spin
    x, y = to_contact(frame_of(angle), body.center[0], body.center[1])
    turned_x, turned_y = to_contact(frame_of(turned), body.center[0], body.center[1])
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
    row.pivot, row.event = run.pivot, NO_EVENT
    v_x, v_y = _seen(system, run, run.twist)
    put(system, run.state, v_x, v_y, run.twist[2], row)
    return count + 1
