"""Friction of the support alone: the fence's velocity and the rod angle settle the twist (Sec. 3).

The state needs no twist, and the contact stays on the fence because the gap is part of the state.
"""

from __future__ import annotations

from math import nan, sqrt

from planar_pushing.mechanics.compiled import compiled
from planar_pushing.mechanics.plane import contact_motion
from planar_pushing.mechanics.reduced.base import edge_motion, stick
from planar_pushing.simulation.systems import base, contact
from planar_pushing.simulation.systems.motion import Motion, at_rest, kink, seen_from
from planar_pushing.simulation.systems.shapes.base import steady


@compiled
def enter(system, index, state, kind, policy):
    return 0


@compiled
def modes(system, during, time, state, kinds, starts):
    starts[:] = 0.0
    x, y = base.velocity(system, during, time, state)
    if base.clearance(system, state) > base.SLACK:
        kinds[0] = base.CLEAR
        return 1
    kinds[0] = base.HELD
    if x == 0.0 and y == 0.0 and during.constant:
        return 1
    kinds[1], kinds[2], kinds[3] = base.STICK, base.SLIP_RIGHT, base.SLIP_LEFT
    return 4 if system.body.slips else 2


@compiled
def after(system, cause, mode, time, state, policy):
    if cause == base.TOUCHES or state[base.GAP] <= base.SLACK:
        state[base.GAP] = 0.0
    return time, 0


@compiled
def motion(system, mode, time, state):
    fence_x, fence_y = base.velocity(system, mode.during, time, state)
    if base.contact_mode(mode.kind) == base.SEPARATE:
        return at_rest(fence_x, fence_y, 0.0, 0.0)
    system.body.evaluations += 1
    now, slip = base.pose(system, state), 0.0
    if mode.kind == base.STICK:
        (x, y, spin, f_x, f_y), size = sticking(now, fence_x, fence_y)
        lift = 0.0
    else:
        (x, y, spin, f_x, f_y), along, lift = _slipping(system, now, mode.kind)
        size = fence_y / lift if lift != 0.0 else 0.0
        slip = size * along - fence_x
    return Motion(
        slip, 0.0, fence_x, fence_y, size * x, size * y, size * spin, abs(size) * sqrt(x * x + y * y),
        f_x, f_y, f_x * fence_x + f_y * fence_y + f_x * slip, 0.0, 0.0, 0.0, lift,
    )  # fmt: skip


@compiled
def sticking(now, x, y):
    """Twist and force of a contact that moves by one unit in the direction of a velocity, and its size."""
    pace = sqrt(x * x + y * y)
    if pace == 0.0:
        return (0.0, 0.0, 0.0, 0.0, 0.0), 0.0
    return stick(now.effects, now.own, seen_from(now.own, x / pace, y / pace))[:5], pace


@compiled
def _slipping(system, now, kind):
    """Twist and force of a slip of unit size, and motion of its contact."""
    x, y, _ = contact.edge_of(system.body, kind)
    moved = edge_motion(now.effects, now.own, seen_from(now.own, x, y))
    along, lift = contact_motion(now.own, moved[0], moved[1], moved[2])
    return moved, along, lift


@compiled
def guard_contact(system, mode, state, now, found):
    kind, speed = mode.kind, sqrt(now.fence_x * now.fence_x + now.fence_y * now.fence_y)
    if kind == base.STICK:
        rests = now.f_x == 0.0 and now.f_y == 0.0
        left = contact.margin(system.body, now.f_x, now.f_y, 0.0)
        found[base.LEAVES_CONE] = -1.0 if rests else left
    elif contact.side_of(kind) != 0.0:
        _guard_slip(system, mode, now, speed, found)
    if kind == base.STICK or contact.side_of(kind) != 0.0:
        found[base.KINK] = _kink(system, kind, base.pose(system, state), now)
    if steady(system.shape, mode.during):
        return
    if kind == base.HELD:
        found[base.TURNS] = 1.0 if speed > 0.0 else -1.0
    elif kind != base.CLEAR:
        found[base.TURNS] = now.fence_y / speed if speed > 0.0 else 0.0
        found[base.TURNS_ALONG] = now.fence_x / speed if speed > 0.0 else 0.0


@compiled
def _kink(system, kind, at, now):
    """Watch of what is not smooth in the motion of a contact."""
    f_x, f_y = nan, nan
    if kind != base.STICK:
        f_x, f_y, _ = contact.edge_of(system.body, kind)
    return kink(at.effects, at.own, seen_from(at.own, f_x, f_y), now.spin, now.speed)


@compiled
def _guard_slip(system, mode, now, speed, found):
    found[base.SLIP_ENDS], found[base.FORCE_ENDS] = -1.0, -1.0
    if speed > 0.0:
        found[base.SLIP_ENDS] = contact.side_of(mode.kind) * now.slip / (speed + abs(now.slip))
        # A fence that keeps moving along itself moves nothing by slip.
        if now.fence_y != 0.0 or not mode.during.constant:
            lift = now.lift / (1.0 + system.body.length)
            found[base.FORCE_ENDS] = lift * now.fence_y / speed
