"""A flat side on the fence that holds the slider at rest under loads.

At rest the friction of the support is undetermined. The contact holds the slider if its forces leave a load
that friction holds; of these forces, the one that needs friction least is the solution.
"""

from __future__ import annotations

from math import fabs
from typing import NamedTuple

from planar_pushing.core.instant.cone import HALVES
from planar_pushing.core.instant.directions import Direction
from planar_pushing.core.instant.flush_force import (
    FlushPush,
    SideForce,
    is_between_ends,
    write_flush,
)
from planar_pushing.core.instant.solution import (
    STICK,
)
from planar_pushing.core.numbers import INFINITY, Numbers
from planar_pushing.core.supports.descent import (
    continue_descent,
    is_found,
    lowest_number,
    open_descent,
)
from planar_pushing.core.supports.free import Level, friction_share
from planar_pushing.core.supports.roots import ITERATIONS
from planar_pushing.core.supports.rows import Vector
from planar_pushing.core.supports.tolerances import RESOLUTION, SHARE


class Facet(NamedTuple):
    """Two forces on the side, each at an abscissa of the fence; multiples of them span a set of forces.

    Multiples are not negative; of a force along the fence under infinite friction they can be.
    """

    one_x: float
    one_y: float
    one_position: float
    other_x: float
    other_y: float
    other_position: float
    any_sign: bool


class Hold(NamedTuple):
    """A wrench on the side, with the torque about its origin, and the share of friction that it needs."""

    f_x: float
    f_y: float
    torque: float
    share: float
    one: float
    twist: Vector


def write_side_at_rest(
    flush: FlushPush, mode: int, edge: Direction, solutions: Numbers, count: int
) -> int:
    """Write the slider at rest if the contact holds it, with forces on an edge in a slip."""
    law, still = flush.law, flush.translation
    load, size = still.load, fabs(still.load.x) + fabs(still.load.y)
    hold = Hold(
        f_x=-load.x, f_y=-load.y, torque=-load.spin, share=0.0, one=0.0, twist=Vector(0.0, 0.0, 0.0)
    )
    held: bool = law.rough or _transmits(flush, mode, edge, hold, size)
    if not held and still.weight > 0.0:
        hold = _least_friction(flush, mode, edge)
        if mode == STICK and not law.closed:
            hold = _hold_in_open_cone(flush, hold, size)
        if hold.share > 1.0 + SHARE and law.right.y > 0.0:
            hold = _smaller_share(hold, _hold_on_verge(flush, mode, edge, size))
        held = hold.share <= 1.0 + SHARE
    if not held:
        return count
    force = SideForce(s=0.0, f_x=hold.f_x + 0.0, f_y=hold.f_y + 0.0, torque=hold.torque, size=size)
    return write_flush(flush, mode, force, False, solutions, count)


def _hold_on_verge(flush: FlushPush, mode: int, edge: Direction, size: float) -> Hold:
    """The wrench of a side about to slip, which friction holds at the center of pressure.

    At the end of a slip the least share of friction is one, and its rounding error decides. Here it is
    exact.
    """
    law, still = flush.law, flush.translation
    load, f_y = still.load, -still.load.y
    low, high = f_y * (law.left.x / law.left.y), f_y * (law.right.x / law.right.y)
    f_x = min(max(-load.x, low), high)
    if mode != STICK:
        f_x = f_y * (edge.x / edge.y)
    rest = load.x + f_x  # friction is opposite to it
    torque = -load.spin - rest * (still.weight_y / still.weight)
    force = SideForce(0.0, f_x, f_y, torque, size)
    bears: bool = f_y > 0.0 and is_between_ends(flush, force)
    share = fabs(rest) / still.weight if bears else INFINITY
    return Hold(f_x, f_y, torque, share, 0.0, Vector(0.0, 0.0, 0.0))


def _transmits(flush: FlushPush, mode: int, slip: Direction, hold: Hold, size: float) -> bool:
    """Whether the law transmits a wrench at rest; in a slip, whether it is on the edge."""
    law, noise = flush.law, RESOLUTION * size
    for i in range(2):
        edge, side = law.right if i == 0 else law.left, 1.0 if i == 0 else -1.0
        inside = side * (edge.x * hold.f_y - edge.y * hold.f_x)
        if inside < -noise or (not law.closed and inside <= noise):
            return False
    if mode != STICK and (
        fabs(slip.x * hold.f_y - slip.y * hold.f_x) > noise
        or slip.x * hold.f_x + slip.y * hold.f_y <= 0.0
    ):
        return False
    force = SideForce(0.0, hold.f_x, hold.f_y, hold.torque, size)
    return is_between_ends(flush, force)


def _least_friction(flush: FlushPush, mode: int, edge: Direction) -> Hold:
    """The wrench of the contact that needs the smallest share of friction to balance the loads.

    It is on the boundary of those that the law transmits, because it is not opposite to the loads: on an
    edge, or at an end of the side.
    """
    law, a, b = flush.law, flush.side.start, flush.side.end
    if mode != STICK:
        return _minimum_on_facet(flush, _facet_between(edge, a, edge, b), edge.y > 0.0)
    right, left = law.right, law.left
    if right.y == 0.0:
        best = _minimum_on_facet(flush, _facet_at(a), True)
        return _smaller_share(best, _minimum_on_facet(flush, _facet_at(b), True))
    best = _minimum_on_facet(flush, _facet_between(right, a, right, b), True)
    # The other edge of the cone, and the cones at both ends.
    for k in range(0 if right.x == left.x else 3):
        one, here, there = left if k == 0 else right, b if k == 2 else a, a if k == 1 else b
        facet = _facet_between(one, here, left, there)
        best = _smaller_share(best, _minimum_on_facet(flush, facet, True))
    return best


def _facet_between(one: Direction, position: float, other: Direction, there: float) -> Facet:
    """The forces between one along an edge at a position and one along an edge at another position."""
    return Facet(
        one_x=one.x,
        one_y=one.y,
        one_position=position,
        other_x=other.x,
        other_y=other.y,
        other_position=there,
        any_sign=False,
    )


def _facet_at(position: float) -> Facet:
    """All forces at a position, and those along the fence."""
    return Facet(
        one_x=1.0,
        one_y=0.0,
        one_position=0.0,
        other_x=0.0,
        other_y=1.0,
        other_position=position,
        any_sign=True,
    )


def _smaller_share(one: Hold, other: Hold) -> Hold:
    return other if other.share < one.share else one


def _hold_with(flush: FlushPush, facet: Facet, one: float, other: float) -> Hold:
    """The wrench of multiples of the forces of a facet."""
    push, contact = flush.push, flush.push.contact
    f_x, f_y = one * facet.one_x + other * facet.other_x, one * facet.one_y + other * facet.other_y
    torque = one * facet.one_position * facet.one_y + other * facet.other_position * facet.other_y
    b_x, b_y = push.t_x * f_x - push.t_y * f_y, push.t_x * f_y + push.t_y * f_x
    turn = torque + contact.x * b_y - contact.y * b_x
    level: Level = friction_share(push.effects, Vector(b_x, b_y, turn))
    return Hold(f_x, f_y, torque, level.value, one, level.twist)


def _power_of(flush: FlushPush, hold: Hold, x: float, y: float, position: float) -> float:
    """Power of a force on the side in the motion that friction resists."""
    push, contact, twist = flush.push, flush.push.contact, hold.twist
    v_x, v_y = twist.x - twist.spin * contact.y, twist.y + twist.spin * contact.x
    u_x, u_y = push.t_x * v_x + push.t_y * v_y, push.t_x * v_y - push.t_y * v_x
    return x * u_x + y * (u_y + position * twist.spin)


def _minimum_along_first(flush: FlushPush, facet: Facet, other: float, unit: float) -> Hold:
    """The smallest share over all multiples of the first force: there its power in the motion is zero."""
    x, y, position = facet.one_x, facet.one_y, facet.one_position
    there = _hold_with(flush, facet, 0.0, other)
    power = _power_of(flush, there, x, y, position)
    sense = -1.0 if power > 0.0 and facet.any_sign else 1.0
    descent = open_descent(sense * power, unit, INFINITY)
    for _ in range(ITERATIONS):
        if is_found(descent):
            break
        there = _hold_with(flush, facet, sense * descent.trial, other)
        descent = continue_descent(descent, sense * _power_of(flush, there, x, y, position))
    return _hold_with(flush, facet, sense * lowest_number(descent), other)


def _minimum_on_facet(flush: FlushPush, facet: Facet, both: bool) -> Hold:
    """The smallest share over all multiples of both forces of a facet, or of the first one."""
    x, y, position, load = (
        facet.other_x,
        facet.other_y,
        facet.other_position,
        flush.translation.load,
    )
    unit = fabs(load.x) + fabs(load.y) + fabs(load.spin)
    there = _minimum_along_first(flush, facet, 0.0, unit)
    if not both:
        return there
    descent = open_descent(_power_of(flush, there, x, y, position), unit, INFINITY)
    for _ in range(ITERATIONS):
        if is_found(descent):
            break
        there = _minimum_along_first(flush, facet, descent.trial, unit)
        descent = continue_descent(descent, _power_of(flush, there, x, y, position))
    return _minimum_along_first(flush, facet, lowest_number(descent), unit)


def _hold_in_open_cone(flush: FlushPush, hold: Hold, size: float) -> Hold:
    """A wrench inside an open cone, from one on its boundary, if friction has anything to spare.

    A normal force in the middle of the side is added, the largest of `HALVES` that friction bears.
    """
    law = flush.law
    if law.right.x * hold.f_y - law.right.y * hold.f_x > RESOLUTION * size:
        return hold
    middle, part = (flush.side.start + flush.side.end) / 2.0, size
    facet = Facet(
        one_x=hold.f_x,
        one_y=hold.f_y,
        one_position=0.0,
        other_x=0.0,
        other_y=1.0,
        other_position=middle,
        any_sign=False,
    )
    inner = Hold(hold.f_x, hold.f_y, hold.torque, share=INFINITY, one=0.0, twist=hold.twist)
    for _ in range(HALVES):
        part /= 2.0
        trial = _hold_with(flush, facet, 1.0, part)
        if trial.share <= 1.0:
            return trial
    return inner
