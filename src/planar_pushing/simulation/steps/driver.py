"""The driver of the time-stepping integrator: steps of order 1, without events.

A step sees the rod angle of its start. While the contact lasts, the contact point itself is moved by its
own motion and the ring's centre follows from the rod: a stick is then a stick and the gap is
closed to rounding, whatever the step. In flight the ring's centre is moved; the contact's path is then
above its tangent, so the step's condition on the gap keeps the true gap open as well.
"""

from __future__ import annotations

from math import cos, sin, sqrt
from typing import NamedTuple

import numpy as np

from planar_pushing.mechanics.compiled import compiled, inlined
from planar_pushing.mechanics.plane import Array, Rod, contact_motion
from planar_pushing.mechanics.push import spin_ratio
from planar_pushing.simulation.fence import span, velocity
from planar_pushing.simulation.rows import NO_MODE, Stop
from planar_pushing.simulation.steps.trials import TRIALS, Step, enumerate_trials
from planar_pushing.simulation.systems.base import SEPARATE, STICK, rank
from planar_pushing.simulation.systems.inertial_motion import friction

#: A gap that is this small in radii is closed.
CLOSED = 1e-12
#: Steps until the driver returns in any case, so that an interrupt is heard, and rows that a step writes.
STEPS_AT_ONCE, ROOM = 20_000, 2
INCONSISTENT, LIES = int(Stop.INCONSISTENT), int(Stop.LIES)
#: Nodes and weights of the quadrature that turns a velocity into a displacement.
NODES, WEIGHTS = np.polynomial.legendre.leggauss(8)

#: Where a run is: `mark` and `step` count the intervals between the times that are recorded and the
#: steps in one; place of the contact over the fence, fence, rod angle and twist; mean force of the last
#: step, energies so far.
CLOCK = np.dtype(
    [
        ("time", "f8"), ("start", "f8"), ("along", "f8"), ("gap", "f8"), ("slip", "f8"),
        ("fence", "f8", (2,)), ("angle", "f8"), ("twist", "f8", (3,)), ("force", "f8", (2,)),
        ("work", "f8"), ("lost", "f8"), ("rubbed", "f8"), ("kind", "i8"), ("solutions", "i8"),
        ("mark", "i8"), ("step", "i8"), ("stopped", "i8"),
        ("kinds", "i8", (TRIALS,)), ("trials", "f8", (TRIALS, 5)),
    ],
    align=True,
)  # fmt: skip


class Plan(NamedTuple):
    """Intervals of a run: ends, steps in each, pieces of the fence in which they begin; and the policy."""

    ends: Array
    counts: Array
    pieces: Array
    policy: int


@compiled
def begin(system, angle, gap, twist, run):
    """Put a run at its beginning."""
    run.time, run.start, run.along, run.gap, run.slip = 0.0, 0.0, 0.0, gap, 0.0
    run.fence[0], run.fence[1], run.angle = 0.0, -gap, angle
    run.twist[:] = twist
    run.work, run.lost, run.rubbed = 0.0, 0.0, 0.0
    run.kind, run.solutions, run.mark, run.step, run.stopped = NO_MODE, 0, 0, 0, 0
    run.force[:] = 0.0
    system.body.evaluations = 0


@compiled
def ended(plan, run):
    """Whether a run has nothing more to do."""
    return run.stopped != 0 or run.mark == len(plan.ends)


@compiled
def advance(system, plan, run, rows):
    """Go on with a run until its rows are full, it has ended, or many steps are done; the rows written."""
    count = 0
    for _ in range(STEPS_AT_ONCE):
        if ended(plan, run) or count + ROOM > len(rows):
            break
        changes = _choose(system, plan, run)
        if changes:
            count = _log(system, run, rows, count)
        if run.stopped == 0:
            _move(system, plan, run)
            run.step += 1
            if run.step == plan.counts[run.mark]:
                run.start, run.step, run.mark = plan.ends[run.mark], 0, run.mark + 1
            if run.step == 0 or run.stopped != 0:
                count = _log(system, run, rows, count)
    return count


@inlined
def _until(plan, run):
    """End of the next step."""
    part = (run.step + 1) / plan.counts[run.mark]
    return run.start + (plan.ends[run.mark] - run.start) * part


@compiled
def _moved(fence, during, start, end):
    """How far the fence travels between two times of a span."""
    if during.constant:
        x, y = velocity(fence, during, start)
        return x * (end - start), y * (end - start)
    half, middle, x, y = (end - start) / 2.0, (end + start) / 2.0, 0.0, 0.0
    for i in range(len(NODES)):
        v_x, v_y = velocity(fence, during, middle + half * NODES[i])
        x, y = x + half * WEIGHTS[i] * v_x, y + half * WEIGHTS[i] * v_y
    return x, y


@compiled
def _choose(system, plan, run):
    """Take the step that the policy takes; whether the mode, or the number of trials, changes."""
    until = _until(plan, run)
    h = until - run.time
    x, y = _moved(system.fence, span(system.fence, plan.pieces[run.mark]), run.time, until)
    own = Rod(system.body.length, run.angle, cos(run.angle), sin(run.angle))
    twist = run.twist
    step = Step(h, own, twist[0], twist[1], twist[2], x / h, (y - run.gap) / h)
    count = enumerate_trials(system, step, run.gap <= CLOSED, run.kinds, run.trials)
    if count == 0:
        run.kind, run.solutions, run.stopped = NO_MODE, 0, INCONSISTENT
        run.force[:] = 0.0
        return True
    best = _best(run, plan.policy, count)
    changes = run.kinds[best] != run.kind or count != run.solutions
    run.kind, run.solutions = run.kinds[best], count
    run.trials[0] = run.trials[best]
    run.force[0], run.force[1] = run.trials[0, 3] / h, run.trials[0, 4] / h
    if system.body.mass == 0.0:
        run.twist[:] = run.trials[0, :3]
    return changes


@inlined
def _best(run, policy, count):
    """The trial that the policy takes; of several in one mode that of the least impulse."""
    best, first, least = 0, 0, 0.0
    for i in range(count):
        place = rank(policy, run.kind, run.kinds[i])
        size = sqrt(run.trials[i, 3] ** 2 + run.trials[i, 4] ** 2)
        if i == 0 or place < first or (place == first and size < least):
            best, first, least = i, place, size
    return best


@compiled
def _move(system, plan, run):
    """Take the slider and the fence to the end of the step."""
    until, body = _until(plan, run), system.body
    h, length, angle = until - run.time, body.length, run.angle
    x, y = _moved(system.fence, span(system.fence, plan.pieces[run.mark]), run.time, until)
    _account(system, run, x, y, h)
    v_x, v_y, spin = run.trials[0, 0], run.trials[0, 1], run.trials[0, 2]
    turned = angle + h * spin
    if run.kind == SEPARATE:
        c_x = h * v_x - length * (cos(turned) - cos(angle))
        c_y = h * v_y - length * (sin(turned) - sin(angle))
    else:
        own = Rod(length, angle, cos(angle), sin(angle))
        c_x, c_y = x, y - run.gap
        if run.kind != STICK:
            c_x = h * contact_motion(own, v_x, v_y, spin)[0]
            run.slip += c_x - x
    run.along += c_x - x
    run.gap += c_y - y
    run.fence[0], run.fence[1] = run.fence[0] + x, run.fence[1] + y
    run.angle, run.time = turned, until
    run.twist[0], run.twist[1], run.twist[2] = v_x, v_y, spin
    if length > 0.0 and run.gap + length * sin(turned) <= 0.0:
        run.stopped = LIES


@inlined
def _kinetic(body, v_x, v_y, spin):
    return (body.mass * (v_x * v_x + v_y * v_y) + body.moment * spin * spin) / 2.0


@inlined
def _account(system, run, x, y, h):
    """Enter a step of length h, in which the fence moves by (x, y).

    Friction dissipates its potential at the end of the step. What is left of the work belongs to the
    contact; in flight it is the scheme's own loss, which goes to friction.
    """
    body, trial, before = system.body, run.trials[0], run.twist
    work = (trial[3] * x + trial[4] * y) / h
    left = work + _kinetic(body, before[0], before[1], before[2])
    left -= _kinetic(body, trial[0], trial[1], trial[2])
    flight = trial[3] == 0.0 and trial[4] == 0.0
    stops = flight and trial[0] == 0.0 and trial[1] == 0.0 and trial[2] == 0.0
    if stops:
        total = h * _power(system, before[0], before[1], before[2])
    else:
        total = h * _power(system, trial[0], trial[1], trial[2])
    run.rubbed += left if flight and total > 0.0 else total
    run.work += work
    run.lost += 0.0 if flight else left - total


@compiled
def _power(system, v_x, v_y, spin):
    """What friction on the support dissipates at a twist."""
    speed = sqrt(v_x * v_x + v_y * v_y)
    if speed == 0.0 and spin == 0.0:
        return 0.0
    force, torque = friction(system.effects, speed, spin)
    return force * speed + torque * spin


@compiled
def _log(system, run, rows, count):
    """Write down where the run is; the last row of an instant replaces those before."""
    if count > 0 and rows[count - 1].time == run.time:
        count -= 1
    row, length, twist = rows[count], system.body.length, run.twist
    row.time, row.rod_angle, row.slip, row.gap = run.time, run.angle, run.slip, run.gap
    row.fence[0], row.fence[1] = run.fence[0], run.fence[1]
    row.position[0] = run.fence[0] + run.along + length * cos(run.angle)
    row.position[1] = run.fence[1] + run.gap + length * sin(run.angle)
    row.twist[:] = twist
    row.force[:] = run.force
    row.mode, row.solutions, row.stopped = run.kind, run.solutions, run.stopped
    speed = sqrt(twist[0] * twist[0] + twist[1] * twist[1])
    row.spin_ratio = spin_ratio(speed, twist[2])
    row.dissipated, row.contact_dissipated, row.work = run.rubbed, run.lost, run.work
    row.kinetic_energy = _kinetic(system.body, twist[0], twist[1], twist[2])
    row.evaluations = system.body.evaluations
    return count + 1
