"""The modes of a flat side on the fence: flush contact, between the two ends of the side.

The side stays on the fence, so the motion has one unknown, the component along the fence of the point at
the origin of the side.
"""

from __future__ import annotations

from math import asinh, fabs, sinh, sqrt

from planar_pushing.core.cone import Law
from planar_pushing.core.directions import Direction
from planar_pushing.core.flush_at_rest import write_side_at_rest
from planar_pushing.core.flush_force import (
    FLUSH_SLIPS,
    FlatSide,
    FlushPush,
    SideForce,
    force_on_side,
    is_between_ends,
    resist_translation,
    write_flush,
)
from planar_pushing.core.free import free_twist
from planar_pushing.core.numbers import INFINITY, Numbers, zeros
from planar_pushing.core.roots import (
    ITERATIONS,
    best_number,
    is_narrow,
    narrow_bracket,
    next_number,
    open_bracket,
)
from planar_pushing.core.rows import Vector
from planar_pushing.core.solution import (
    SLIP_LEFT,
    SLIP_RIGHT,
    STICK,
    UNSOLVED,
    Push,
)
from planar_pushing.core.tolerances import COINCIDENT, RESOLUTION, RESOLVED

#: Width of a cell in asinh(s / unit) if the slider rotates, and the farthest motion, in units, if no mass
#: limits it.
ROTATING_CELL = 0.25
FARTHEST_SLIP = 1e12


def flush_modes(
    push: Push, side: FlatSide, law: Law, w_x: float, w_y: float, spin: float, scale: float,
    solutions: Numbers,
) -> int:  # fmt: skip
    """Write every solution with the side on the fence, in the order of the modes, and return their number.

    Parameters
    ----------
    push : Push
        Its contact is the origin of the side.
    side : FlatSide
    law : Law
    w_x : float
        Motion of the fence along itself.
    w_y : float
        Motion of the origin of the side across the fence; without a rotation, that of the fence.
    spin : float
        Rotation of the slider, zero for a side that stays on a fence that does not rotate. In a rotation a
        support point exactly at the center of rotation has no friction.
    scale : float
        Magnitude of the motions of fence and slider.
    solutions : Numbers
        Room for `MOST_FLUSH` solutions of `FLUSH_SOLUTION` columns.

    Returns
    -------
    int
        `UNSOLVED` if there are more slips than fit.

    Notes
    -----
    Slips of one mode are in the order of their speed. If fence and slider are at rest although friction
    alone holds the loads, there is no solution: they count as separate.
    """
    flush = FlushPush(push, side, law, w_x, w_y, spin, scale, resist_translation(push))
    roots = zeros(2 * FLUSH_SLIPS)
    left = _find_flush_slips(flush, law.left, 1.0, roots)
    right = _find_flush_slips(flush, law.right, -1.0, roots[FLUSH_SLIPS:])
    if left < 0 or right < 0:
        return UNSOLVED
    falls: bool = w_y == 0.0 and spin == 0.0 and _falls(flush)
    count = 0
    if w_x != 0.0 or w_y != 0.0 or spin != 0.0:
        count = _write_flush_stick(flush, roots, left, right, solutions)
    elif falls:
        count = write_side_at_rest(flush, STICK, law.left, solutions, 0)
    for i in range(left):
        if roots[i] - w_x > COINCIDENT * scale:
            count = _write_flush_slip(flush, SLIP_RIGHT, law.left, roots[i], solutions, count)
    if falls and law.slips and w_x < 0.0:
        count = write_side_at_rest(flush, SLIP_RIGHT, law.left, solutions, count)
    for i in range(right):
        s = roots[FLUSH_SLIPS + i]
        if w_x - s > COINCIDENT * scale:
            count = _write_flush_slip(flush, SLIP_LEFT, law.right, s, solutions, count)
    if falls and law.slips and w_x > 0.0:
        count = write_side_at_rest(flush, SLIP_LEFT, law.right, solutions, count)
    return count


def _falls(flush: FlushPush) -> bool:
    """Whether loads move the slider without a contact, because friction does not hold them."""
    load = flush.still.load
    if load.x == 0.0 and load.y == 0.0 and load.spin == 0.0:
        return False
    twist = free_twist(flush.push.effects, Vector(0.0, 0.0, 0.0))
    return twist.x != 0.0 or twist.y != 0.0 or twist.spin != 0.0


def _write_flush_stick(
    flush: FlushPush, roots: Numbers, left: int, right: int, solutions: Numbers
) -> int:
    """Write the stick of a moving slider if the law transmits its force; return the number of solutions.

    The roots are the motions under the left edge, and then those under the right edge. A force within
    rounding of an edge sticks unless the side slips under this edge, and so does one whose slip is as slow
    as rounding.
    """
    law, w_x, closest = flush.law, flush.w_x, COINCIDENT * flush.scale
    sticks: bool = True
    force = force_on_side(flush, law.left, w_x)
    for i in range(0 if law.rough else 2):
        edge, count, first, side = law.left, left, 0, -1.0
        if i == 1:
            edge, count, first, side = law.right, right, FLUSH_SLIPS, 1.0
        inside = side * (edge.x * force.f_y - edge.y * force.f_x)
        noise = RESOLUTION * force.size
        within: bool = inside > noise or (law.closed and inside >= -noise)
        for k in range(first, first + count):
            slip = -side * (roots[k] - w_x)
            if fabs(slip) <= closest:
                within = True
            elif slip > 0.0 and inside < 0.0 and fabs(inside) <= noise:
                within = False
        sticks = sticks and within
    if not (law.rough or (sticks and is_between_ends(flush, force))):
        return 0
    # Under a force along the fence every slower slip along it has a force along the fence, too.
    along: bool = law.slips and law.left.y == 0.0 and flush.w_y == 0.0 and flush.spin == 0.0
    along = along and fabs(force.f_y) <= RESOLUTION * force.size
    return write_flush(flush, STICK, force, along, solutions, 0)


def _write_flush_slip(
    flush: FlushPush, mode: int, edge: Direction, s: float, solutions: Numbers, count: int
) -> int:
    """Write a slip if its force pushes along the edge, between the ends of the side."""
    force = force_on_side(flush, edge, s)
    along = edge.x * force.f_x + edge.y * force.f_y
    exact = SideForce(s, along * edge.x, along * edge.y, force.torque, 0.0, 0.0, force.size)
    if along <= RESOLUTION * force.size or not is_between_ends(flush, exact):
        return count
    return write_flush(flush, mode, exact, False, solutions, count)


def _find_flush_slips(flush: FlushPush, edge: Direction, sense: float, roots: Numbers) -> int:
    """Write the motions along the fence whose force is along an edge; return how many, -1 for too many.

    Motions beyond the stick, in the sense of a slip under the edge, in the order of speed; a motion that
    coincides with the stick is among them. Motions along the fence that are all under a force along it
    belong to the continuum of the stick, and are not.
    """
    still, w_y = flush.still, flush.w_y
    if not flush.law.slips:
        return 0
    if flush.spin != 0.0:
        return _scan_slips(flush, edge, sense, roots)
    load: bool = still.load.x != 0.0 or still.load.y != 0.0
    if w_y == 0.0:
        return _find_slips_along(flush, edge, roots) if load and edge.y > 0.0 else 0
    if not load:
        # The motion is along the force.
        roots[0] = w_y / edge.y * edge.x if edge.y > 0.0 else 0.0
        return 1 if edge.y > 0.0 and w_y > 0.0 else 0
    if still.mass == 0.0:
        g_x, g_y = still.load.x, still.load.y
        ahead, beside = g_x * edge.x + g_y * edge.y, g_x * edge.y - g_y * edge.x
        force = sqrt(max(still.weight * still.weight - beside * beside, 0.0)) - ahead
        q_x, q_y = g_x + force * edge.x, g_y + force * edge.y
        roots[0] = q_x * (w_y / q_y) if q_y * w_y > 0.0 else 0.0
        return 1 if q_y * w_y > 0.0 else 0
    return _scan_slips(flush, edge, sense, roots)


def _find_slips_along(flush: FlushPush, edge: Direction, roots: Numbers) -> int:
    """As `_find_flush_slips`, for a slider under a load that slides along the fence."""
    still, count = flush.still, 0
    if still.mass == 0.0:
        return 0
    ahead = still.load.x - still.load.y * (edge.x / edge.y)
    for i in range(2):
        sense = 1.0 if i == 0 else -1.0
        s = (ahead - sense * still.weight) / still.mass
        if sense * s > COINCIDENT * flush.scale:
            roots[count] = s
            count += 1
    return count


def _scan_slips(flush: FlushPush, edge: Direction, sense: float, roots: Numbers) -> int:
    """As `_find_flush_slips`, by the signs of the force across the edge, and its slopes.

    In a translation the slope is monotone between the two places where its derivative vanishes, whose ratio
    to the normal motion has a closed form. A cell between them has at most two roots, with an extremum in
    between.
    """
    w_y, still, spin = flush.w_y, flush.still, flush.spin
    sweep, bend_low, bend_high = 0.0, -INFINITY, -INFINITY
    first = sense * flush.w_x - 2.0 * COINCIDENT * flush.scale
    unit = fabs(w_y) + fabs(spin) * (1.0 + still.lever)
    last = FARTHEST_SLIP * unit
    if still.mass > 0.0:
        # Farther away the force along the fence has the sign of the slip.
        last = (fabs(still.load.x) + still.weight + fabs(spin * still.mass_y)) / still.mass
        last += COINCIDENT * (last + flush.scale)
    if not last > first:
        return 0
    low, count = force_on_side(flush, edge, sense * first), 0
    if spin != 0.0:
        sweep = asinh(first / unit)
    else:
        ratio = 3.0 * edge.y + sqrt(9.0 * edge.y * edge.y + 8.0 * edge.x * edge.x)
        one = -ratio / (4.0 * edge.x) if edge.x != 0.0 else 0.0
        bend_low, bend_high = sense * w_y * one, sense * w_y * (2.0 * edge.x / ratio)
        bend_low, bend_high = min(bend_low, bend_high), max(bend_low, bend_high)
    s = first
    while s < last:
        target = last
        if spin != 0.0:
            sweep += ROTATING_CELL
            target = min(last, unit * sinh(sweep))
        elif s < bend_low:
            target = min(last, bend_low)
        elif s < bend_high:
            target = min(last, bend_high)
        high = force_on_side(flush, edge, sense * target)
        count = _write_cell(flush, edge, sense, low, high, roots, count)
        s, low = target, high
    return count


def _write_cell(
    flush: FlushPush, edge: Direction, sense: float, low: SideForce, high: SideForce,
    roots: Numbers, count: int,
) -> int:  # fmt: skip
    """Write the roots in a cell, at most two."""
    positive: bool = low.across > 0.0
    if positive != (high.across > 0.0):
        return _insert_root(_root_of_cell(flush, edge, low, high, False), flush.scale, roots, count)
    side = sense if positive else -sense
    if not (side * low.slope < 0.0 < side * high.slope):
        return count
    turn = force_on_side(flush, edge, _root_of_cell(flush, edge, low, high, True))
    if positive == (turn.across > 0.0):
        return count
    one = _root_of_cell(flush, edge, low, turn, False)
    other = _root_of_cell(flush, edge, turn, high, False)
    return _insert_root(other, flush.scale, roots, _insert_root(one, flush.scale, roots, count))


def _root_of_cell(
    flush: FlushPush, edge: Direction, low: SideForce, high: SideForce, extremum: bool
) -> float:
    """Where the force across the edge, or its slope for an extremum, vanishes between two motions."""
    at_low, at_high = low.across, high.across
    if extremum:
        at_low, at_high = low.slope, high.slope
    bracket = open_bracket(low.s, high.s, at_low, at_high, RESOLVED)
    for _ in range(ITERATIONS):
        if is_narrow(bracket):
            break
        s = next_number(bracket)
        force = force_on_side(flush, edge, s)
        bracket = narrow_bracket(bracket, s, force.slope if extremum else force.across)
    return best_number(bracket)


def _insert_root(s: float, scale: float, roots: Numbers, count: int) -> int:
    """Insert a root in the order of speed unless it is there already; return their number."""
    if count < 0 or count == FLUSH_SLIPS:
        return -1
    for i in range(count):
        if fabs(s - roots[i]) <= COINCIDENT * scale:
            return count
    index = count
    while index > 0 and fabs(roots[index - 1]) > fabs(s):
        roots[index] = roots[index - 1]
        index -= 1
    roots[index] = s
    return count + 1
