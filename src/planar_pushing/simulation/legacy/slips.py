"""The slips under an edge of the friction cone, as roots of the force across the edge.

The motions of the contact share the pusher's normal component. The variable s is their component along the
fence, in the sense of the edge's force, from the slowest motion that this force can drive to the pusher's.
"""

from __future__ import annotations

from collections.abc import Callable
from math import asinh, ceil, exp, sinh
from typing import Any

from planar_pushing.simulation.legacy.base import is_steady
from planar_pushing.simulation.legacy.compiled import compiled, generic
from planar_pushing.simulation.legacy.way import (
    FLAT,
    beside,
    crossing,
    first_node,
    flat_end,
    is_flat,
    kink_near,
    motion,
    node,
)

#: Width of a cell in asinh(s / normal component), and minimum number of cells.
WIDTH, LEAST = 0.5, 3
#: The slowest motion along the fence, in units of the normal one; below it only friction or inertia counts.
SLOWEST = exp(-32.0)
#: Minimum angle between the ends of a continuum.
TURN = 1e-9
#: Position on a path: at its start, outside a continuum, inside one.
REST, OUTSIDE, INSIDE = 0, 1, 2
#: Slips closer than this, relative to their motion, are one.
COINCIDENCE = 9e-13
#: Maximum number of times that a dip is halved.
HALVINGS = 60
#: Maximum number of slips under one edge.
SLIPS = 8
#: Number of entries of a slip: place, rotation, whether it is an end of a continuum, number of its pivot.
ENTRIES = 4


@generic
def _cells(kinds: Any) -> Callable[..., Any]:
    """Number of cells between two places of a path: effects, unit, first, last."""
    return _one_cell if is_steady(kinds) else _many_cells


@compiled
def _one_cell(effects, unit, first, last):
    return 1


@compiled
def _many_cells(effects, unit, first, last):
    return max(ceil((asinh(last / unit) - asinh(first / unit)) / WIDTH), LEAST)


@compiled
def slips_along(way, unit, first, last, found):
    """Write the roots from `first` to `last`, in this order.

    Parameters
    ----------
    way : Way
        Along the fence; `unit` is the magnitude of its normal component.
    unit, first, last : float
    found : ndarray, shape (SLIPS, ENTRIES)

    Returns
    -------
    count : int
        Number of slips, -1 if an iteration has not converged or there are too many.
    flat : bool
        Whether the last motions belong to a continuum.
    """
    straight, unit = unit == 0.0, unit if unit > 0.0 else SLOWEST
    cells = _cells(way.effects, unit, first, last)
    start, end = asinh(first / unit), asinh(last / unit)
    here, count, run, place = first_node(way, first), 0, REST, first
    for i in range(1, cells + 1):
        s = last if i == cells else unit * sinh(start + (end - start) * i / cells)
        while place < s:
            flat = _may_be_flat(way.effects, straight, run)
            kink = kink_near(way, place, s, place)
            if kink.s == kink.s:
                place, there = kink.s, node(way, kink.s, kink.spin, kink.point)
            else:
                place, there = s, beside(way, here, s)
            # The sign of a rounding error is meaningless, so the next place decides.
            if flat or not there.found or not _vanishes(there):
                count, run = _between(way, unit, straight, flat, here, there, found, count, run)
                if _steps_across(flat, here, there):
                    count = _write(unit, there, False, found, count)
                here = there
    return count, run == INSIDE


@compiled
def _is_zero(at, value):
    return abs(value) <= at.noise


@compiled
def _vanishes(at):
    return _is_zero(at, at.before) and _is_zero(at, at.after)


@compiled
def _steps_across(flat, here, kink):
    """Whether the force jumps across the edge at a kink, or up to it; flat stretches count separately."""
    from_zero, to_zero = _is_zero(kink, kink.before), _is_zero(kink, kink.after)
    if flat:
        return kink.before * kink.after < 0.0 and not (from_zero or to_zero)
    before = here.after if from_zero else kink.before
    return not from_zero if to_zero else before * kink.after < 0.0


@compiled
def _write(unit, at, continuum, found, count):
    """Write a slip and return the number of slips, -1 if it was not found or does not fit.

    Two cells that meet at a kink can both find the same slip.
    """
    if count > 0 and abs(at.s - found[count - 1, 0]) <= COINCIDENCE * (abs(at.s) + unit):
        return count
    if count < 0 or count == len(found) or not at.found:
        return -1
    found[count, 0], found[count, 1] = at.s, at.spin
    found[count, 2], found[count, 3] = 1.0 if continuum else 0.0, at.point
    return count + 1


@compiled
def _between(way, unit, straight, flat, low, high, found, count, run):
    """Write the slips between two motions; return the number of slips, and the position on the path."""
    if count < 0 or not (low.found and high.found):
        return -1, run
    if _is_zero(low, low.after) or _is_zero(high, high.before):
        if flat:
            return _touching(way, unit, straight, low, high, found, count, run)
        return count, OUTSIDE
    if (low.after > 0.0) != (high.before > 0.0):
        return _write_root(way, unit, low, high, found, count), OUTSIDE
    bottom = _dip(way, low, high)
    if (bottom.after > 0.0) != (low.after > 0.0):
        count = _write_root(way, unit, low, bottom, found, count)
        count = _write_root(way, unit, bottom, high, found, count)
    return count, OUTSIDE


@generic
def _may_be_flat(kinds: Any) -> Callable[..., Any]:
    """Whether a stretch of a path can be a continuum: effects, whether it is along the fence, its position.

    With effects of one degree any stretch can be. Otherwise only a stretch along the fence that begins at
    rest can be: elsewhere inertia adds a force across the edge that is proportional to the motion.
    """
    return _always if is_steady(kinds) else _along_the_fence


@compiled
def _always(effects, straight, run):
    return True


@compiled
def _along_the_fence(effects, straight, run):
    return straight and run != OUTSIDE


@compiled
def _flat_end(way, straight, at, other):
    """The end of a flat stretch that begins at a motion, or the motion itself if it is an isolated root.

    Motions along the fence differ in magnitude, all others in direction.
    """
    if not _is_zero(at, at.after if other.s > at.s else at.before):
        return at
    near = beside(way, at, at.s + FLAT * (other.s - at.s))
    if max(abs(near.before), abs(near.after)) > near.noise:
        return at
    end = flat_end(way, near, other)
    (x, y), (u_x, u_y) = motion(way, at.s), motion(way, end.s)
    turn = abs(x * u_y - y * u_x) / ((abs(x) + abs(y)) * (abs(u_x) + abs(u_y)))
    return end if straight or turn > TURN else at


@compiled
def _touching(way, unit, straight, low, high, found, count, run):
    """As `_between`, if the force is along the edge at an end: a root, or a continuum."""
    first, last = _flat_end(way, straight, low, high), _flat_end(way, straight, high, low)
    starts, ends = first.s > low.s, last.s < high.s
    if _is_zero(low, low.after) and run != INSIDE and not (starts and run == REST):
        count = _write(unit, low, starts, found, count)
    if starts and ends:
        return count, INSIDE
    if starts:
        count = _write(unit, first, True, found, count)
    elif run == INSIDE:
        count = _write(unit, low, True, found, count)
    if ends:
        return _write(unit, last, True, found, count), INSIDE
    if _is_zero(high, high.before) and not _is_zero(high, high.after):
        count = _write(unit, high, False, found, count)
    return count, OUTSIDE


@compiled
def _dip(way, low, high):
    """A motion between two at which the sign differs, or the lower motion if there is none.

    The dip is halved while both slopes point into it and the tangents at its sides meet beyond zero.
    """
    first, sign = low, 1.0 if low.after > 0.0 else -1.0
    at_low, at_high = abs(low.after), abs(high.before)
    for i in range(HALVINGS):
        width, fall, rise = high.s - low.s, sign * low.slope, sign * high.slope
        if not fall < 0.0 < rise:
            break
        part = (at_low - at_high + rise * width) / (rise - fall)
        if i > 0 and at_low + part * fall > 0.0:
            break
        middle = beside(way, low, low.s + width / 2.0)
        if sign * middle.after < 0.0:
            return middle
        if sign * middle.slope < 0.0:
            low, at_low = middle, abs(middle.after)
        else:
            high, at_high = middle, abs(middle.before)
    return first


@compiled
def _write_root(way, unit, low, high, found, count):
    """Write the slip between two motions of opposite signs, or both ends of a continuum."""
    start = low.s + min(max(_part(low, high), 0.05), 0.95) * (high.s - low.s)
    root = crossing(way, low, high, beside(way, low, start))
    if not (_may_be_flat(way.effects, False, OUTSIDE) and is_flat(way, root, abs(root.s) + unit)):
        return _write(unit, root, False, found, count)
    first, last = _flat_end(way, False, root, low), _flat_end(way, False, root, high)
    if first.s == root.s and last.s == root.s:
        return _write(unit, root, False, found, count)
    return _write(unit, last, True, found, _write(unit, first, True, found, count))


@compiled
def _part(low, high):
    """Fraction of the path between two motions at which the inverse cubic through both is zero.

    The secant is used if the force across the edge is not monotone.
    """
    rise, width = high.before - low.after, high.s - low.s
    part = -low.after / rise
    if low.slope * rise > 0.0 and high.slope * rise > 0.0:
        start, end, left = rise / (width * low.slope), rise / (width * high.slope), 1.0 - part
        part *= part * (3.0 - 2.0 * part) + left * (left * start - part * end)
    return part
