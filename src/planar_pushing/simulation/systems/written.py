"""What is written down of an instant: place, twist, force and energy, along the axes of the world."""

from __future__ import annotations

from math import sqrt

from planar_pushing.mechanics.compiled import compiled
from planar_pushing.mechanics.solve import spin_ratio
from planar_pushing.simulation.systems import base
from planar_pushing.simulation.systems.motion import kinetic_energy
from planar_pushing.simulation.systems.shapes import base as shapes


@compiled
def put(system, state, v_x, v_y, spin, row):
    """Write down the state, place, twist, spin ratio and energies; the fence is in the row already."""
    shape, angle, now = system.shape, state[base.ANGLE], base.pose(system, state)
    row.rod_angle, row.slip, row.gap = angle, state[base.SLIP], state[base.GAP]
    row.dissipated, row.work = state[base.RUBBED], state[base.WORK]
    row.contact_dissipated, row.evaluations = state[base.LOST], system.body.evaluations
    row.position[0], row.position[1] = shapes.center(
        shape, now.own, angle, state[base.ALONG], state[base.GAP], row.fence[0], row.fence[1]
    )
    row.twist[0], row.twist[1] = shapes.shown(shape, angle, v_x, v_y)
    row.twist[2] = spin
    row.spin_ratio = spin_ratio(sqrt(v_x * v_x + v_y * v_y), spin)
    row.kinetic_energy = kinetic_energy(system.body, now.x, now.y, v_x, v_y, spin)
    row.contact_position, row.parted = 0.0 - state[base.ALONG], system.body.parted


@compiled
def write(system, mode, time, state, row):
    """Write down an instant of a mode: as `put`, and the force."""
    now = base.motion(system, mode, time, state)
    put(system, state, now.v_x, now.v_y, now.spin, row)
    row.force[0], row.force[1] = shapes.shown(system.shape, state[base.ANGLE], now.f_x, now.f_y)
