"""Impacts: inelastic impulses at the contact that its law admits.

Friction of the support is finite and has no part in an impulse.
"""

from __future__ import annotations

from math import cos, sin

from planar_pushing.mechanics.compiled import compiled
from planar_pushing.simulation.fence import velocity
from planar_pushing.simulation.rows import Stop
from planar_pushing.simulation.systems.base import (
    ANGLE,
    LOST,
    OVER,
    RISE,
    SEPARATE,
    SLACK,
    SLIP_LEFT,
    SLIP_RIGHT,
    SPIN,
    STICK,
    WORK,
    contact_mode,
    edge_of,
    margin,
    rank,
)
from planar_pushing.simulation.systems.contact_inertia import (
    contact_inertia,
    force_of,
    motion_of,
)

NO_IMPULSE = int(Stop.NO_IMPULSE)
#: An impulse this near to an edge of the cone is on it, radians.
ON_EDGE = 1e-12
#: Greatest rank of a mode, and one more.
NONE = 9


@compiled
def impact(system, during, time, state, kind, policy):
    """Change the twist by the impulse that the policy takes; 0, or the `Stop` where there is none."""
    body, before_x, before_y = system.body, state[OVER], state[RISE]
    if max(abs(before_x), abs(before_y)) <= SLACK * body.speed:
        state[OVER], state[RISE] = 0.0, 0.0
        return 0
    best, p_x, p_y, after_x, after_y = _impulse(
        body, state[ANGLE], before_x, before_y, contact_mode(kind), policy
    )
    if best == NONE:
        return NO_IMPULSE
    state[OVER], state[RISE] = after_x, after_y
    torque = body.length * (p_x * sin(state[ANGLE]) - p_y * cos(state[ANGLE]))
    state[SPIN] += torque / body.moment
    fence_x, fence_y = velocity(system.fence, during, time)
    state[WORK] += p_x * fence_x + p_y * fence_y
    state[LOST] -= p_x * (before_x + after_x) / 2 + p_y * (before_y + after_y) / 2
    return 0


@compiled
def _impulse(body, angle, before_x, before_y, previous, policy):
    """Rank, impulse, and velocity of the contact after it, of the impulse that the policy takes.

    It is none, one that ends the relative motion, or one on an edge of the cone after which the contact
    slips away from it.
    """
    slack = SLACK * body.speed
    inertia = contact_inertia(body, angle)
    best = NONE, 0.0, 0.0, before_x, before_y
    if before_y >= -slack:
        best = rank(policy, previous, SEPARATE), 0.0, 0.0, before_x, before_y
    p_x, p_y = force_of(inertia, -before_x, -before_y)
    if margin(body, p_x, p_y, 0.0) >= (-ON_EDGE if body.closed else ON_EDGE):
        if rank(policy, previous, STICK) < best[0]:
            best = rank(policy, previous, STICK), p_x, p_y, 0.0, 0.0
    elif body.slips:
        for kind in (SLIP_RIGHT, SLIP_LEFT):
            x, y = edge_of(body, kind)
            along, normal = motion_of(inertia, x, y)
            size = -before_y / normal if normal != 0.0 else 0.0
            after = before_x + size * along
            slips = after if kind == SLIP_RIGHT else -after
            if size > 0.0 and slips > slack and rank(policy, previous, kind) < best[0]:
                best = rank(policy, previous, kind), size * x, size * y, after, 0.0
    return best
