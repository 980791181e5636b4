"""Several contacts that hold a slider at rest, which loads would move without them.

Friction holds any wrench of a convex set. The contacts hold the slider if their forces leave it a wrench of
this set. Those that need the smallest share of friction are found: the share is convex in the forces, and
the wrench that needs the smallest one is zero, or on the boundary of the cone, where two unit forces
suffice. The power of a unit force in the motion that friction resists is the slope of the share.
"""

from __future__ import annotations

from math import fabs
from typing import NamedTuple

from planar_pushing.core.contacts.force_sets import (
    HeldLoad,
    balance_load,
)
from planar_pushing.core.contacts.several_frames import Several, frame_of
from planar_pushing.core.contacts.several_solutions import Sharing, add_solution
from planar_pushing.core.contacts.unit_forces import (
    UNIT_FORCE,
    UnitForce,
)
from planar_pushing.core.instant.solution import SEPARATE, SLIP_LEFT, STICK
from planar_pushing.core.numbers import INFINITY, Numbers
from planar_pushing.core.supports.descent import (
    continue_descent,
    is_found,
    lowest_number,
    open_descent,
)
from planar_pushing.core.supports.free import friction_share
from planar_pushing.core.supports.resistance import has_friction, load_wrench
from planar_pushing.core.supports.roots import ITERATIONS
from planar_pushing.core.supports.rows import NO_POINT, Vector
from planar_pushing.core.supports.tolerances import BALANCED, COINCIDENT, SHARE


class Share(NamedTuple):
    """Coefficients of two unit forces, the share of friction that they need, and the motion it resists."""

    one: float
    other: float
    share: float
    twist: Vector


def rests_with(several: Several, modes: Numbers) -> bool:
    """Whether contacts have given modes with the slider at rest; slips are at moving pushers."""
    for i in range(several.number):
        frame, mode = frame_of(several, i), int(modes[i])
        across, along = frame.pusher_across, frame.pusher_along
        if mode == SEPARATE:
            if across > COINCIDENT:
                return False
        elif fabs(across) > COINCIDENT:
            return False
        elif mode == STICK:
            if fabs(along) > COINCIDENT:
                return False
        elif (along if mode == SLIP_LEFT else -along) <= COINCIDENT:
            return False
    return True


def add_at_rest(several: Several, sharing: Sharing, solutions: Numbers, count: int) -> int:
    """Add the slider at rest if the contacts hold it, and return the number of solutions."""
    effects, low, high = several.effects, sharing.low, sharing.high
    load = load_wrench(effects)
    held: bool = balance_load(
        sharing.units,
        sharing.number,
        HeldLoad(
            x=-load.x,
            y=-load.y,
            torque=-load.spin,
            limit=0.0,
            foot_x=0.0,
            foot_y=0.0,
            size=fabs(load.x) + fabs(load.y) + fabs(load.spin),
        ),
        BALANCED,
        low=low,
        high=high,
    )
    if not held and has_friction(effects):
        held = _write_least_share(several, sharing)
    if not held:
        return count
    return add_solution(
        several, sharing, Vector(0.0, 0.0, 0.0), NO_POINT, continuum=False, solutions=solutions,
        count=count,
    )  # fmt: skip


def _write_least_share(several: Several, sharing: Sharing) -> bool:
    """Write the forces that need the smallest share of friction; whether friction bears it.

    They are known in sum, so the inner force has a range.
    """
    best, first, second = INFINITY, 0, 0
    one, other = 0.0, 0.0
    for i in range(sharing.number):
        for j in range(i if sharing.number == 1 else i + 1, sharing.number):
            share = _least_of_pair(several, sharing, i, j)
            if share.share < best:
                best, first, second = share.share, i, j
                one, other = share.one, share.other
    if best > 1.0 + SHARE:
        return False
    unit, partner = (
        UnitForce(sharing.units[UNIT_FORCE * first :]),
        UnitForce(sharing.units[UNIT_FORCE * second :]),
    )
    x, y = one * unit.x + other * partner.x, one * unit.y + other * partner.y
    torque = one * unit.torque + other * partner.torque
    size = fabs(x) + fabs(y) + fabs(torque)
    load = HeldLoad(x, y, torque, limit=0.0, foot_x=0.0, foot_y=0.0, size=size)
    return balance_load(
        sharing.units, sharing.number, load, COINCIDENT, low=sharing.low, high=sharing.high
    )


def _share_of(
    several: Several, sharing: Sharing, i: int, j: int, one: float, other: float
) -> Share:
    """The share of friction that multiples of two unit forces need."""
    first = UnitForce(sharing.units[UNIT_FORCE * i :])
    second = UnitForce(sharing.units[UNIT_FORCE * j :])
    wrench = Vector(
        one * first.x + other * second.x,
        one * first.y + other * second.y,
        one * first.torque + other * second.torque,
    )
    level = friction_share(several.effects, wrench)
    return Share(one, other, level.value, level.twist)


def _power_of_unit(sharing: Sharing, i: int, twist: Vector) -> float:
    """Power of a unit force in a motion."""
    force = UnitForce(sharing.units[UNIT_FORCE * i :])
    return force.x * twist.x + force.y * twist.y + force.torque * twist.spin


def _least_of_pair(several: Several, sharing: Sharing, i: int, j: int) -> Share:
    """The smallest share over all multiples of two forces, or of one."""
    return _least_share(several, sharing, i, j, 0 if i == j else 1, 0.0)


def _share_with(
    several: Several, sharing: Sharing, i: int, j: int, number: int, multiple: float, other: float
) -> Share:
    """The share with a multiple of one of two forces: of the first, or of the second, then the smallest."""
    if number == 0:
        return _share_of(several, sharing, i, j, one=multiple, other=other)
    return _least_share(several, sharing, i, j, 0, multiple)


def _least_share(
    several: Several, sharing: Sharing, i: int, j: int, number: int, other: float
) -> Share:
    """The smallest share over all multiples of the first of two forces, or of both.

    Parameters
    ----------
    several, sharing : Several, Sharing
    i, j : int
        The unit forces.
    number : int
        0 to search among multiples of the first, 1 among those of the second, each with the best multiple
        of the first.
    other : float
        Multiple of the second force for a search among those of the first.
    """
    load, unit = load_wrench(several.effects), i if number == 0 else j
    step = fabs(load.x) + fabs(load.y) + fabs(load.spin)
    there = _share_with(several, sharing, i, j, number, multiple=0.0, other=other)
    descent = open_descent(_power_of_unit(sharing, unit, there.twist), step, INFINITY)
    for _ in range(ITERATIONS):
        if is_found(descent):
            break
        there = _share_with(several, sharing, i, j, number, multiple=descent.trial, other=other)
        descent = continue_descent(descent, _power_of_unit(sharing, unit, there.twist))
    return _share_with(several, sharing, i, j, number, lowest_number(descent), other)
