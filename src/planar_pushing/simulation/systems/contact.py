"""The contact: its friction cone, and forces and impulses on a slider with inertia.

With r from the contact to the center of mass, a force f at the contact accelerates it by
``f / m + (r_y f_x - r_x f_y) (r_y, -r_x) / J``. Impacts are inelastic. Support friction is finite and
therefore contributes no impulse.
"""

from __future__ import annotations

from math import atan2, sqrt

from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.simulation.legacy.compiled import compiled
from planar_pushing.simulation.legacy.record import Law
from planar_pushing.simulation.rows import Stop
from planar_pushing.simulation.systems import base

NO_IMPULSE = int(Stop.NO_IMPULSE)
#: An impulse within this angle, in radians, of an edge of the cone is on the edge.
ON_EDGE = 1e-12
#: Normal acceleration due to a force, relative to its maximum, below which it is rounding error.
NO_LEVER = 1e-12
#: Number of contact modes.
MODES = len(ContactMode)


@compiled
def law_of(body):
    """The contact law."""
    return Law(body.right_angle, body.left_angle, body.slips, body.closed, body.rough)


@compiled
def side_of(kind):
    """Direction of slip as 1 or -1, 0 in a mode without slip."""
    return 1.0 if kind == base.SLIP_RIGHT else -1.0 if kind == base.SLIP_LEFT else 0.0


@compiled
def edge_of(body, kind):
    """Direction of the force in a slipping mode, on the edge that opposes the slip, and its angle."""
    if kind == base.SLIP_RIGHT:
        return body.left[0], body.left[1], body.left_angle
    return body.right[0], body.right[1], body.right_angle


@compiled
def margin(body, f_x, f_y, least):
    """Margin of a force in the friction cone, negative outside.

    It is the angle to the nearer edge, with a weight that is small for forces below `least`, so that the
    margin is smooth and 0 for zero force.
    """
    if body.rough:
        return 1.0
    size = (f_x * f_x + f_y * f_y) ** 0.5
    lean = (body.left_angle - body.right_angle) / 2 - abs(atan2(f_x, f_y))
    return lean * size / (size + least) if size > 0.0 else 0.0


@compiled
def admits(body, p_x, p_y):
    """Whether an impulse lies in the cone of the law; a zero impulse does not."""
    if p_x == 0.0 and p_y == 0.0:
        return False
    return margin(body, p_x, p_y, 0.0) >= (-ON_EDGE if body.closed else ON_EDGE)


@compiled
def moment_of(arm_x, arm_y, f_x, f_y):
    """Torque, about the end of an arm, of a force at its start."""
    return arm_y * f_x - arm_x * f_y


@compiled
def pushed(body, arm_x, arm_y, f_x, f_y):
    """Acceleration of a point due to a force there; the arm is from the point to the center of mass."""
    turn = moment_of(arm_x, arm_y, f_x, f_y) / body.moment
    return f_x / body.mass + turn * arm_y, f_y / body.mass - turn * arm_x


@compiled
def pushing(body, arm_x, arm_y, a_x, a_y):
    """Force at a point that gives it an acceleration."""
    reach = sqrt(arm_x * arm_x + arm_y * arm_y)
    if reach == 0.0:
        return body.mass * a_x, body.mass * a_y
    # The effective mass is the mass along the arm, and less across it; components along these directions
    # avoid cancellation for a long arm.
    x, y = arm_x / reach, arm_y / reach
    along = body.mass * (a_x * x + a_y * y)
    aside = (a_x * y - a_y * x) / (1.0 / body.mass + reach * reach / body.moment)
    return along * x + aside * y, along * y - aside * x


@compiled
def pushed_in(body, arm_x, arm_y, kind, x, y):
    """Force of a mode, and the relative acceleration of the contact with it, given that without it.

    Also the impulse of a mode, and the relative velocity after it, given that before it.
    """
    if kind == base.STICK:
        return *pushing(body, arm_x, arm_y, -x, -y), 0.0, 0.0
    if side_of(kind) == 0.0:
        return 0.0, 0.0, x, y
    e_x, e_y, _ = edge_of(body, kind)
    along, normal = pushed(body, arm_x, arm_y, e_x, e_y)
    # A force without normal acceleration cannot keep the contact closed; the negative size rejects the
    # slip.
    least = NO_LEVER * (1.0 / body.mass + (arm_x * arm_x + arm_y * arm_y) / body.moment)
    size = -y / normal if abs(normal) > least else -body.force
    return size * e_x, size * e_y, x + size * along, 0.0


@compiled
def preferred(policy, previous, kinds, count):
    """Index of the contact mode that a policy prefers, the first of equals; -1 if there is none."""
    best = -1
    for i in range(count):
        place = base.rank(policy, previous, kinds[i])
        if best < 0 or place < base.rank(policy, previous, kinds[best]):
            best = i
    return best


@compiled
def impact(system, during, time, state, kind, policy):
    """Change the twist by the impulse that the policy prefers; return 0, or a `Stop` if there is none."""
    body, x, y = system.body, state[base.OVER], state[base.RISE]
    if max(abs(x), abs(y)) <= base.SLACK * body.speed:
        state[base.OVER], state[base.RISE] = 0.0, 0.0
        return 0
    now, kinds, count = base.pose(system, state), system.room.kinds, 0
    for each in range(MODES):
        if _consistent(body, now, each, x, y):
            kinds[count] = each
            count += 1
    place = preferred(policy, base.contact_mode(kind), kinds, count)
    if place < 0:
        return NO_IMPULSE
    chosen = kinds[place]
    p_x, p_y, after_x, after_y = pushed_in(body, now.arm_x, now.arm_y, chosen, x, y)
    state[base.OVER], state[base.RISE] = after_x, after_y
    state[base.SPIN] += moment_of(now.arm_x, now.arm_y, p_x, p_y) / body.moment
    fence_x, fence_y = base.velocity(system, during, time, state)
    state[base.WORK] += p_x * fence_x + p_y * fence_y
    state[base.LOST] -= p_x * (x + after_x) / 2 + p_y * (y + after_y) / 2
    return 0


@compiled
def _consistent(body, now, kind, x, y):
    """Whether the impulse of a mode lies in the cone and the resulting motion agrees with the mode."""
    slack = base.SLACK * body.speed
    p_x, p_y, after_x, _ = pushed_in(body, now.arm_x, now.arm_y, kind, x, y)
    if kind == base.SEPARATE:
        return y >= -slack
    if kind == base.STICK:
        return admits(body, p_x, p_y)
    e_x, e_y, _ = edge_of(body, kind)
    pushes = p_x * e_x + p_y * e_y > 0.0
    return body.slips and pushes and side_of(kind) * after_x > slack
