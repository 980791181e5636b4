"""What happens to a slider with inertia in an instant: impacts, starts from rest, stops."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import TYPE_CHECKING

from planar_pushing.mechanics.candidates import slip_edge
from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.mechanics.response import resistance
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.slipping import slip_motions
from planar_pushing.mechanics.solve import solve
from planar_pushing.simulation.contact_inertia import contact_inertia, impulses
from planar_pushing.simulation.mode import SLACK, Entry, Inconsistent, Mode, State
from planar_pushing.simulation.problem import preference

if TYPE_CHECKING:
    from planar_pushing.simulation.inertial import Inertial

#: Below this part of the typical speed friction holds the slider.
AT_REST = 1e-9
#: A fence slower than this part of it, and hardly accelerated, does not move.
STILL = 1e-10
#: A contact mode and the acceleration (a_x, a_y, R alpha) with which the slider starts in it.
Start = tuple[ContactMode, tuple[float, ...]]
RESTS: Start = (ContactMode.SEPARATE, (0.0, 0.0, 0.0))


def impact(system: Inertial, time: float, state: State, mode: Mode | None) -> None:
    """Change the twist by an inelastic impulse that the contact law admits."""
    at, own, psi = system.at, system.setting, state[Entry.ANGLE]
    before = state[at], state[at + 1]
    slack = SLACK * system.speed
    if max(map(abs, before)) <= slack:
        state[at], state[at + 1] = 0.0, 0.0
        return
    inertia = contact_inertia(own, psi)
    found = impulses(own, inertia, before, slack)
    if not found:
        raise Inconsistent("no impulse at the contact is consistent")
    order = preference(system.problem.on_ambiguity, None if mode is None else mode.kind)
    _, impulse, after = min(found, key=lambda each: order.index(each.kind))
    torque = own.length * (impulse[0] * math.sin(psi) - impulse[1] * math.cos(psi))
    state[at], state[at + 1] = after
    state[at + 2] += torque / own.moment
    fence = system.segment.velocity(time)
    state[Entry.WORK] += impulse[0] * fence[0] + impulse[1] * fence[1]
    means = (before[0] + after[0]) / 2, (before[1] + after[1]) / 2
    state[Entry.CONTACT] -= impulse[0] * means[0] + impulse[1] * means[1]


def starts(system: Inertial, time: float, state: State) -> list[Start]:
    """Every way in which a slider at rest on the fence may start."""
    turn, slip = system.segment.acceleration(time), state[system.at]
    size = math.hypot(*turn)
    # Differences of a velocity leave some noise where the fence is still.
    still = math.hypot(*system.segment.velocity(time)) <= STILL * system.speed
    if size <= (STILL * system.speed / system.pace(time) if still else 0.0):
        return [RESTS]
    if still and abs(turn[1]) <= AT_REST * size:
        turn = turn[0], 0.0
    scene = system.problem.scene
    angle = state[Entry.ANGLE] % (2 * math.pi) if system.setting.length else math.pi / 2
    slider = replace(scene.slider, rod_angle=angle)
    if abs(slip) > AT_REST * system.speed:
        return _slipping_starts(replace(scene, slider=slider), turn[1], slip)
    scale = 1.0, 1.0, slider.radius
    return [
        (each.mode, tuple(float(a) * b for a, b in zip(each.twist, scale, strict=True)))
        for each in solve(replace(scene, slider=slider), math.atan2(turn[1], turn[0]), size)
    ]


def _slipping_starts(scene: Scene, normal: float, slip: float) -> list[Start]:
    """Starts under a fence that already slips along below the slider and begins to push it."""
    found = [] if normal > 0 else [RESTS]
    if not scene.contact.slips:
        return found
    kind = ContactMode.SLIP_RIGHT if slip > 0 else ContactMode.SLIP_LEFT
    edge, slider = slip_edge(scene.contact, kind), scene.slider
    rod = slider.length_ratio, slider.rod_angle
    speed, ratio, exists = slip_motions(resistance(scene.scaled_effects), *rod, edge, normal)
    for v, k in zip(speed[exists].tolist(), ratio[exists].tolist(), strict=True):
        found.append((kind, (v * math.cos(edge), v * math.sin(edge), v * k)))
    return found


def set_off(system: Inertial, time: float, state: State, mode: Mode) -> None:
    """Let a slider at rest keep up with a fence that has just begun to push it."""
    at, order = system.at, preference(system.problem.on_ambiguity, mode.kind)
    state[Entry.GAP] = 0.0
    pushing = [each for each in starts(system, time, state) if each[0] is not ContactMode.SEPARATE]
    if not pushing:
        impact(system, time, state, mode)
    else:
        kind, start = min(pushing, key=lambda each: order.index(each[0]))
        fence, turn = system.segment.velocity(time), system.segment.acceleration(time)
        part = fence[1] / turn[1] if turn[1] else 0.0
        slip = start[0] + system.setting.length * start[2] * math.sin(state[Entry.ANGLE])
        over = 0.0 if kind is ContactMode.STICK else part * slip - fence[0]
        state[at:] = [over, 0.0, part * start[2]]


def stopped(system: Inertial, time: float, state: State, mode: Mode) -> tuple[float, State]:
    """Finish a motion that dies out: speeds fall in proportion to the time that is left.

    The energy then falls with its square, and everything moves on at half its present rate.
    """
    energy, rates = system.kinetic_energy(time, state), mode.rates(time, state)
    lost = sum(rates[Entry.CONTACT : system.at]) - 2 * rates[Entry.WORK]
    if lost <= 0.0:
        return time, state
    left = min(2 * energy / lost, system.segment.end - time)
    fence = system.segment.velocity(time)
    last = system.segment.velocity(time + left)
    for entry in range(system.at):
        state[entry] += rates[entry] * left / 2
    for i, entry in enumerate((Entry.FENCE_X, Entry.FENCE_Y)):
        state[entry] += fence[i] * left / 2
        state[Entry.ALONG + i] -= fence[i] * left / 2
    if system.touches(state):
        state[Entry.GAP] = 0.0
    state[system.at :] = [-last[0], -last[1], 0.0]
    return time + left, state
