"""Equations without inertia: the pusher's velocity and the rod angle determine the twist (Sec. 3).

The state contains no twist. It contains the gap, so that the contact stays exactly on the fence.
"""

from __future__ import annotations

from collections.abc import Callable
from math import copysign, inf, nan, sqrt
from typing import Any

from planar_pushing.simulation.legacy.base import KINDS
from planar_pushing.simulation.legacy.compiled import compiled, generic
from planar_pushing.simulation.legacy.load import Wrench
from planar_pushing.simulation.legacy.motion import NOWHERE
from planar_pushing.simulation.legacy.plane import toward
from planar_pushing.simulation.legacy.psi import psi, spin_guess
from planar_pushing.simulation.legacy.slips import slips_along
from planar_pushing.simulation.legacy.under import moved_at, pushed
from planar_pushing.simulation.legacy.way import (
    Way,
    at_infinity,
    crossing,
    first_node,
)
from planar_pushing.simulation.systems import base, contact
from planar_pushing.simulation.systems.drag import kink, with_loads
from planar_pushing.simulation.systems.frame import Motion, at_rest, to_body, to_contact
from planar_pushing.simulation.systems.shapes.base import steady

#: Range of the search for slips along the fence, in normal motions: margin before the stick, and maximum.
BEFORE, FARTHEST = 1e-3, 1e3


@compiled
def enter(system, index, state, kind, policy):
    return 0


@compiled
def modes(system, during, time, state, kinds, feet, hinged, starts):
    starts[:], feet[:], hinged[:] = 0.0, -1, 0
    x, y = base.velocity(system, during, time, state)
    if base.clearance(system, state) > base.SLACK:
        kinds[0] = base.CLEAR
        return 1
    kinds[0] = base.HELD
    if x == 0.0 and y == 0.0 and during.constant:
        return 1
    kinds[1], count = base.STICK, 2
    if system.body.slips:
        for kind in (base.SLIP_RIGHT, base.SLIP_LEFT):
            count = candidates(with_kinds(system), system, state, kind, x, y, kinds, starts, count)
    return count


@compiled
def with_kinds(system):
    """Effects and loads, whose kinds select functions."""
    return (*system.effects, *system.loads)


@compiled
def after(system, cause, mode, time, state, policy):
    if cause == base.TOUCHES or state[base.GAP] <= base.SLACK:
        state[base.GAP] = 0.0
    return time, 0


@compiled
def motion(system, mode, time, state):
    fence_x, fence_y = base.velocity(system, mode.during, time, state)
    stays = base.contact_mode(mode.kind) == base.SEPARATE
    if stays or (mode.kind == base.STICK and fence_x == 0.0 and fence_y == 0.0):
        return at_rest(fence_x, fence_y, 0.0, 0.0, 0.0, 0.0)
    system.body.evaluations += 1
    now = base.pose(system, state)
    effects = with_loads(system.loads, system.effects, system.body, state[base.ANGLE])
    if mode.kind == base.STICK:
        u_x, u_y = to_body(now.frame, fence_x, fence_y)
        found = psi(effects, now.at, u_x, u_y, spin_guess(effects, now.at, u_x, u_y), NOWHERE, 0.0)
        v_x, v_y = to_contact(now.frame, found.v_x, found.v_y)
        f_x, f_y = to_contact(now.frame, found.f_x, found.f_y)
        spin, slip, lift, pivot = found.spin, 0.0, 0.0, found.point
    else:
        moved, size, lift = slipping(
            with_kinds(system), system, effects, now, mode, fence_x, fence_y
        )
        u_x, _ = to_contact(now.frame, moved.u_x, moved.u_y)
        v_x, v_y = to_contact(now.frame, size * moved.v_x, size * moved.v_y)
        f_x, f_y = to_contact(now.frame, moved.f_x, moved.f_y)
        spin, slip, pivot = size * moved.spin, size * u_x - fence_x, moved.point
    pull = base.load_power(system, now, state, v_x, v_y, spin)
    return Motion(
        slip, 0.0, fence_x, fence_y, v_x, v_y, spin, sqrt(v_x * v_x + v_y * v_y), f_x, f_y,
        f_x * (fence_x + slip) + f_y * fence_y + pull, 0.0, 0.0, 0.0, lift, pivot, 1.0,
    )  # fmt: skip


def _is_plain(kinds: tuple[Any, ...]) -> bool:
    """Whether there is only friction, so that the direction of the force determines that of the motion."""
    return all(KINDS[kind].DEGREE == 1 for kind in kinds) and Wrench not in kinds


@generic
def candidates(kinds: Any) -> Callable[..., Any]:
    """Store candidate slips. Arguments: kinds, system, state, mode, fence velocity, kinds, starts."""
    return _one if _is_plain(kinds) else _several


@compiled
def _one(given, system, state, kind, x, y, kinds, starts, count):
    kinds[count] = kind
    return count + 1


@compiled
def _several(given, system, state, kind, x, y, kinds, starts, count):
    """As `candidates`, for forces that depend on the speed: one candidate for each slip under the edge."""
    side, now, scratch = contact.side_of(kind), base.pose(system, state), system.room.scratch
    effects = with_loads(system.loads, system.effects, system.body, state[base.ANGLE])
    # The parameter s is the contact's motion along the fence, in the direction of the slip.
    way, unit = _along(system, effects, now, kind, y, side), max(abs(y), abs(x))
    first = side * x - BEFORE * unit
    found, _ = slips_along(way, abs(y), first, first + FARTHEST * unit, scratch)
    for i in range(found):
        if count < len(kinds):
            kinds[count], starts[count, 0] = kind, side * scratch[i, 0]
            count += 1
    return count


@compiled
def _along(system, effects, now, kind, y, side):
    """Line of contact motions along the fence, with the force on an edge of the friction cone."""
    edge = toward(now.frame, contact.edge_of(system.body, kind)[2])
    n_x, n_y = to_body(now.frame, 0.0, y)
    t_x, t_y = to_body(now.frame, side, 0.0)
    return Way(effects, now.at, edge.along, -edge.aside, n_x, n_y, t_x, t_y)


@generic
def slipping(kinds: Any) -> Callable[..., Any]:
    """A slip, the scale factor of its motion, and a number that is positive while the slip lasts.

    Arguments: kinds, system, effects, pose, mode, and velocity of the fence.
    """
    return _scaled if _is_plain(kinds) else _nearest


@compiled
def _scaled(given, system, effects, now, mode, fence_x, fence_y):
    """Slip of unit magnitude, its scale factor, and its component normal to the fence."""
    edge = toward(now.frame, contact.edge_of(system.body, mode.kind)[2])
    moved = pushed(effects, now.at, edge.along, -edge.aside, 1.0)
    lift = to_contact(now.frame, moved.u_x, moved.u_y)[1]
    return moved, fence_y / lift if lift != 0.0 else 0.0, lift


@compiled
def _nearest(given, system, effects, now, mode, fence_x, fence_y):
    """Slip closest to the one at the start of the mode or of its last step, and its force."""
    way = _along(system, effects, now, mode.kind, fence_y, 1.0)
    here = first_node(way, mode.x)
    sense = copysign(1.0, here.slope)
    root = crossing(way, at_infinity(-inf, -sense), at_infinity(inf, sense), here)
    moved = moved_at(way, root.s, root.spin, False, NOWHERE)
    edge_x, edge_y = way.e_x, way.e_y
    force = edge_x * moved.f_x + edge_y * moved.f_y
    return moved, 1.0 if root.found else nan, force


@compiled
def remember(system, time, state, mode, start):
    _remember(with_kinds(system), system, time, state, mode, start)


@generic
def _remember(kinds: Any) -> Callable[..., Any]:
    return _nothing if _is_plain(kinds) else _note_slip


@compiled
def _nothing(given, system, time, state, mode, start):
    pass


@compiled
def _note_slip(given, system, time, state, mode, start):
    if contact.side_of(mode.kind) != 0.0:
        now = motion(system, mode, time, state)
        start[0] = now.fence_x + now.slip


@compiled
def guard_contact(system, mode, state, now, found):
    kind, speed = mode.kind, sqrt(now.fence_x * now.fence_x + now.fence_y * now.fence_y)
    if kind == base.STICK:
        rests = now.f_x == 0.0 and now.f_y == 0.0
        left = contact.margin(system.body, now.f_x, now.f_y, 0.0)
        # The force of a pivot can be any in an interval, so the trend of the margin decides.
        found[base.LEAVES_CONE] = -1.0 if rests else 0.0 if now.pivot >= 0 else left
    elif contact.side_of(kind) != 0.0:
        _guard_slip(system, mode, now, speed, found)
    if kind == base.STICK or contact.side_of(kind) != 0.0:
        found[base.KINK] = kink(system.effects, now, kind != base.STICK)
    if steady(system.shape, mode.during):
        return
    if kind == base.HELD:
        found[base.NORMAL_REVERSES] = 1.0 if speed > 0.0 else -1.0
    elif kind != base.CLEAR:
        found[base.NORMAL_REVERSES] = now.fence_y / speed if speed > 0.0 else 0.0
        found[base.TANGENTIAL_REVERSES] = now.fence_x / speed if speed > 0.0 else 0.0


@compiled
def _guard_slip(system, mode, now, speed, found):
    found[base.SLIP_ENDS], found[base.FORCE_ENDS] = -1.0, -1.0
    if speed > 0.0:
        found[base.SLIP_ENDS] = contact.side_of(mode.kind) * now.slip / (speed + abs(now.slip))
        # A slipping contact transmits no motion from a fence that only moves along its own line.
        if now.fence_y != 0.0 or not mode.during.constant:
            found[base.FORCE_ENDS] = force_margin(with_kinds(system), system, now, speed)


@generic
def force_margin(kinds: Any) -> Callable[..., Any]:
    """Margin for the force of a slip to be a push. Arguments: kinds, system, motion, fence speed."""
    return _margin_of_lift if _is_plain(kinds) else _margin_of_force


@compiled
def _margin_of_lift(given, system, now, speed):
    return now.lift / (1.0 + system.body.length) * now.fence_y / speed


@compiled
def _margin_of_force(given, system, now, speed):
    return now.lift / (abs(now.lift) + system.body.force)
