"""Rows of the log: position, twist, force and energies at an instant, along the axes of the world."""

from __future__ import annotations

from math import cos, sin, sqrt

from planar_pushing.simulation.legacy.compiled import compiled
from planar_pushing.simulation.legacy.plane import spin_ratio
from planar_pushing.simulation.systems import base
from planar_pushing.simulation.systems.drag import load_work
from planar_pushing.simulation.systems.frame import kinetic_energy
from planar_pushing.simulation.systems.shapes import base as shapes


@compiled
def put(system, state, v_x, v_y, spin, row):
    """Store state, position, twist, spin ratio and energies in a row that already contains the pusher."""
    shape, angle, now = system.shape, state[base.ANGLE], base.pose(system, state)
    row.rod_angle, row.slip, row.gap = angle, state[base.SLIP], state[base.GAP]
    row.work, row.contact_dissipated = state[base.WORK], state[base.LOST]
    row.evaluations, count = system.body.evaluations, len(system.effects)
    for i in range(count):
        row.dissipated[i] = state[len(state) - count + i]
    x, y = shapes.center(
        shape, angle, now, state[base.ALONG], state[base.GAP], row.pusher[0], row.pusher[1]
    )
    row.position[0], row.position[1] = x, y
    row.load_work = potential(system, state, x, y)
    row.twist[0], row.twist[1] = shapes.shown(shape, angle, v_x, v_y)
    row.twist[2] = spin
    row.spin_ratio = spin_ratio(sqrt(v_x * v_x + v_y * v_y), spin)
    row.kinetic_energy = kinetic_energy(system.body, now, v_x, v_y, spin)
    row.contact_position, row.parted = 0.0 - state[base.ALONG], system.body.parted


@compiled
def potential(system, state, x, y):
    """Work of the loads since time 0 if the slider's center is at (x, y) in the world."""
    body = system.body
    c, s = cos(body.start_angle), sin(body.start_angle)
    d_x, d_y = x - body.length * c, y - body.length * s
    return load_work(body, state[base.ANGLE], d_x * c + d_y * s, d_y * c - d_x * s)


@compiled
def write(system, mode, time, state, row):
    """Store an instant of a mode: all quantities of `put`, and the force."""
    now = base.motion(system, mode, time, state)
    put(system, state, now.v_x, now.v_y, now.spin, row)
    row.pivot = now.pivot
    row.force[0], row.force[1] = shapes.shown(system.shape, state[base.ANGLE], now.f_x, now.f_y)
