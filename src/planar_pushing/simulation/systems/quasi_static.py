"""Friction of the support alone: the fence's velocity and the rod angle settle the twist (Sec. 3).

The state needs no twist, and the contact stays on the fence because the gap is part of the state.
"""

from __future__ import annotations

from math import copysign, cos, inf, nan, sin, sqrt
from typing import NamedTuple

from planar_pushing.mechanics.compiled import compiled
from planar_pushing.mechanics.effects.base import response
from planar_pushing.mechanics.plane import Direction, Rod
from planar_pushing.mechanics.push import spin_ratio
from planar_pushing.mechanics.reduced.base import stick
from planar_pushing.mechanics.reduced.isotropic import signed_spin_ratio
from planar_pushing.simulation.fence import velocity
from planar_pushing.simulation.systems.base import (
    ALONG,
    ANGLE,
    CLEAR,
    FORCE_ENDS,
    GAP,
    HELD,
    KINK,
    LEAVES_CONE,
    LIES,
    LOST,
    RUBBED,
    SLACK,
    SLIP,
    SLIP_ENDS,
    SLIP_LEFT,
    SLIP_RIGHT,
    STARTS,
    STICK,
    TOUCHES,
    TURNS,
    TURNS_ALONG,
    WORK,
    edge_of,
    margin,
)

#: The fence pushes a slider at rest from this part of its typical speed on.
PUSHES = 2e-10


class Flow(NamedTuple):
    """The motion at an instant: R omega, centre's speed, velocity of the contact over the fence, force.

    `advance` is the normal motion of a slipping contact in a motion of unit size.
    """

    spin: float
    speed: float
    slip: float
    rise: float
    f_x: float
    f_y: float
    advance: float


@compiled
def _flow(system, mode, time, state):
    """The motion at an instant, and the force that it takes."""
    system.body.evaluations += 1
    fence_x, fence_y = velocity(system.fence, mode.during, time)
    if mode.kind == STICK:
        return _sticking(system, state[ANGLE], fence_x, fence_y)
    if mode.kind == SLIP_RIGHT or mode.kind == SLIP_LEFT:
        return _slipping(system, mode.kind, state[ANGLE], fence_x, fence_y)
    return Flow(0.0, 0.0, -fence_x, -fence_y, 0.0, 0.0, 0.0)


@compiled
def _sticking(system, angle, fence_x, fence_y):
    """The contact moves with the fence, the force lies in the friction cone."""
    pace = sqrt(fence_x * fence_x + fence_y * fence_y)
    if pace == 0.0:
        return Flow(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    own = Rod(system.body.length, angle, cos(angle), sin(angle))
    w_x, w_y = fence_x / pace, fence_y / pace
    towards = Direction(nan, w_x, w_y, w_x * own.x + w_y * own.y, w_x * own.y - w_y * own.x)
    moved = stick(system.effects, own, towards)
    speed = pace * sqrt(moved.v_x * moved.v_x + moved.v_y * moved.v_y)
    return Flow(pace * moved.spin, speed, 0.0, 0.0, moved.f_x, moved.f_y, 0.0)


@compiled
def _slipping(system, kind, angle, fence_x, fence_y):
    """The contact moves over the fence, under a force on the opposite edge of the friction cone."""
    own = Rod(system.body.length, angle, cos(angle), sin(angle))
    t_x, t_y = edge_of(system.body, kind)
    edge = Direction(nan, t_x, t_y, t_x * own.x + t_y * own.y, t_x * own.y - t_y * own.x)
    ratio = signed_spin_ratio(system.effects, own, edge)
    speed, spin = (1.0, ratio) if abs(ratio) <= 1.0 else (1.0 / abs(ratio), copysign(1.0, ratio))
    lever = own.length * spin
    advance = speed * t_y - lever * own.x
    scale = fence_y / advance if advance != 0.0 else 0.0
    force = response(system.effects, speed, spin)[0]
    slip = scale * (speed * t_x + lever * own.y) - fence_x
    return Flow(scale * spin, scale * speed, slip, 0.0, force * t_x, force * t_y, advance)


@compiled
def initial(system, angle, gap, twist, state):
    state[:] = 0.0
    state[GAP], state[ANGLE] = gap, angle


@compiled
def scales(system, found):
    length = max(1.0, system.body.length)
    found[:] = length
    found[ANGLE] = 1.0
    found[LOST:] = system.body.weight * length


@compiled
def pace(system, during, time):
    x, y = velocity(system.fence, during, time)
    speed = sqrt(x * x + y * y)
    return max(1.0, system.body.length) / speed if speed > 0.0 else inf


@compiled
def settling(system, during, time, state):
    return 0.0


@compiled
def enter(system, index, state, kind, policy):
    return 0


@compiled
def modes(system, during, time, state, kinds, starts):
    starts[:] = 0.0
    x, y = velocity(system.fence, during, time)
    if state[GAP] > SLACK:
        kinds[0] = CLEAR
        return 1
    kinds[0] = HELD
    if x == 0.0 and y == 0.0 and during.constant:
        return 1
    kinds[1], kinds[2], kinds[3] = STICK, SLIP_RIGHT, SLIP_LEFT
    return 4 if system.body.slips else 2


@compiled
def after(system, cause, mode, time, state, policy):
    if cause == TOUCHES or state[GAP] <= SLACK:
        state[GAP] = 0.0
    return time, 0


@compiled
def rates(system, mode, time, state, found):
    flow = _flow(system, mode, time, state)
    fence_x, fence_y = velocity(system.fence, mode.during, time)
    work, lost = flow.f_x * fence_x + flow.f_y * fence_y, -flow.f_x * flow.slip
    touches = mode.kind == STICK or mode.kind == SLIP_RIGHT or mode.kind == SLIP_LEFT
    found[ALONG], found[GAP], found[ANGLE] = flow.slip, flow.rise, flow.spin
    # A rest over the fence is no slip of the contact.
    found[SLIP] = flow.slip if touches else 0.0
    found[LOST], found[WORK], found[RUBBED] = lost, work, work - lost


@compiled
def guards(system, mode, time, state, found):
    found[:] = nan
    fence_x, fence_y = velocity(system.fence, mode.during, time)
    if mode.kind == CLEAR:
        found[TOUCHES] = state[GAP]
    elif mode.kind == HELD:
        found[STARTS] = PUSHES - fence_y / system.body.speed
        if not mode.during.constant:
            found[TURNS] = 1.0 if fence_x != 0.0 or fence_y != 0.0 else -1.0
    else:
        flow = _flow(system, mode, time, state)
        speed = sqrt(fence_x * fence_x + fence_y * fence_y)
        if mode.kind == STICK:
            rests = flow.f_x == 0.0 and flow.f_y == 0.0
            found[LEAVES_CONE] = -1.0 if rests else margin(system.body, flow.f_x, flow.f_y, 0.0)
        else:
            _guard_slip(system, mode, flow, fence_y, speed, found)
        _guard_contact(system, mode, flow, state, fence_x, fence_y, speed, found)


@compiled
def _guard_slip(system, mode, flow, fence_y, speed, found):
    found[SLIP_ENDS], found[FORCE_ENDS] = -1.0, -1.0
    if speed > 0.0:
        side = 1.0 if mode.kind == SLIP_RIGHT else -1.0
        found[SLIP_ENDS] = side * flow.slip / (speed + abs(flow.slip))
        # A fence that keeps moving along itself moves nothing by slip.
        if fence_y != 0.0 or not mode.during.constant:
            found[FORCE_ENDS] = flow.advance / (1.0 + system.body.length) * fence_y / speed


@compiled
def _guard_contact(system, mode, flow, state, fence_x, fence_y, speed, found):
    """What every mode of contact watches: the ring's centre, the kink on the ring, the fence's turns."""
    if system.body.length > 0.0:
        found[LIES] = sin(state[ANGLE])
    total = abs(flow.spin) + flow.speed
    found[KINK] = (abs(flow.spin) - flow.speed) / total if total > 0.0 else 0.0
    if not mode.during.constant:
        found[TURNS] = fence_y / speed if speed > 0.0 else 0.0
        found[TURNS_ALONG] = fence_x / speed if speed > 0.0 else 0.0


@compiled
def write(system, mode, time, state, row):
    flow = _flow(system, mode, time, state)
    w_x, w_y = velocity(system.fence, mode.during, time)
    length, angle = system.body.length, state[ANGLE]
    e_x, e_y = cos(angle), sin(angle)
    row.position[0] = row.fence[0] + state[ALONG] + length * e_x
    row.position[1] = row.fence[1] + state[GAP] + length * e_y
    moves = flow.speed != 0.0
    row.twist[0] = w_x + flow.slip - length * flow.spin * e_y if moves else 0.0
    row.twist[1] = w_y + flow.rise + length * flow.spin * e_x if moves else 0.0
    row.twist[2] = flow.spin
    row.force[0], row.force[1] = flow.f_x, flow.f_y
    row.spin_ratio = spin_ratio(flow.speed, flow.spin)
    row.kinetic_energy = 0.0
