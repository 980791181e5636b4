"""The energies of a step: work of pusher and loads, and dissipation by effects and contact."""

from __future__ import annotations

from planar_pushing.simulation.legacy.compiled import compiled, inlined
from planar_pushing.simulation.steps.clock import seen
from planar_pushing.simulation.systems import base
from planar_pushing.simulation.systems.drag import drag, powers
from planar_pushing.simulation.systems.frame import kinetic_energy, to_body
from planar_pushing.simulation.systems.shapes import base as shapes
from planar_pushing.simulation.systems.written import potential


@inlined
def account(system, run):
    """Add the energies of the step.

    Effects dissipate the power at the end of the step. The rest of the work is attributed to the contact;
    in flight it is the numerical dissipation, which is attributed to friction.
    """
    (v_x, v_y, spin), now = run.trials[0, :3], base.pose(system, run.state)
    h, (x, y) = run.until - run.time, seen(system, run, run.twist)
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
def settle(system, run):
    """Add the work of the loads in the step; in flight, the rest of the energy goes to the first effect."""
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
