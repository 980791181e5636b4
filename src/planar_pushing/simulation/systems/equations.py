"""The equations of a system in a mode: the derivative of its state, and the guards of the mode."""

from __future__ import annotations

from math import inf, nan

from planar_pushing.simulation.legacy.compiled import compiled
from planar_pushing.simulation.systems import base
from planar_pushing.simulation.systems.drag import powers
from planar_pushing.simulation.systems.frame import frame_of, to_body
from planar_pushing.simulation.systems.shapes import base as shapes


@compiled
def rates(system, mode, time, state, found):
    """Store the derivative of the state."""
    _rates(system, mode, state, base.motion(system, mode, time, state), found)


@compiled
def guards(system, mode, time, state, found):
    """Store margins and watches by cause, NaN for causes without one."""
    _guards(system, mode, state, base.motion(system, mode, time, state), found)


@compiled
def rates_and_guards(system, mode, time, state, found, guarded):
    """Store the derivative and the guards, with one evaluation of the motion."""
    now = base.motion(system, mode, time, state)
    _rates(system, mode, state, now, found)
    _guards(system, mode, state, now, guarded)


@compiled
def _rates(system, mode, state, now, found):
    found[base.ALONG] = shapes.travel(system.shape, now.slip, now.spin)
    found[base.GAP], found[base.ANGLE] = now.rise, now.spin
    # The contact does not slip while the slider rests or is in flight.
    found[base.SLIP] = now.slip if base.contact_mode(mode.kind) != base.SEPARATE else 0.0
    found[base.LOST] = -now.f_x * now.slip - now.f_y * now.rise
    found[base.WORK] = now.f_x * now.fence_x + now.f_y * now.fence_y
    count = len(system.effects)
    if len(found) >= base.MOVING + count:
        found[base.OVER], found[base.RISE], found[base.SPIN] = now.a_x, now.a_y, now.turn
    angle = shapes.frame_angle(system.shape, state[base.ANGLE])
    x, y = to_body(frame_of(angle), now.v_x, now.v_y)
    powers(system.effects, x, y, now.spin, now.rubbed, found, len(found) - count)


@compiled
def _guards(system, mode, state, now, found):
    body = system.body
    found[:] = nan
    if mode.kind == base.HELD or mode.kind == base.PROPPED:
        found[base.PUSH_STARTS] = base.PUSHES - now.fence_y / body.speed
    elif base.contact_mode(mode.kind) == base.SEPARATE:
        height = base.clearance(system, state)
        found[base.TOUCHES] = height if height < inf else nan
    if mode.kind < base.CLEAR:
        above = shapes.upright(system.shape, body, state[base.ANGLE], state[base.GAP])
        found[base.CENTER_REACHES_FENCE] = above
    free = mode.kind == base.SEPARATE or mode.kind == base.CLEAR or state[base.GAP] > base.SLACK
    if not free:
        found[base.END_OF_SIDE] = shapes.room(system.shape, state[base.ALONG])
    found[base.PENETRATES] = base.height(system, state, not free)
    base.guard_contact(system, mode, state, now, found)
