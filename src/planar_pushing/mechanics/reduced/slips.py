"""The slips under an edge of the friction cone: the roots of the force across it along the fence.

The motions of the contact have the pusher's normal part; s is their part along the fence, in the sense of
the edge's force, from the slowest that this force can drive to the pusher's own.
"""

from __future__ import annotations

from collections.abc import Callable
from math import asinh, ceil, exp, sinh
from typing import Any

from planar_pushing.mechanics.compiled import compiled, generic
from planar_pushing.mechanics.effects.base import is_steady
from planar_pushing.mechanics.reduced.way import (
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

#: Width of a cell in asinh(s / normal part), and least number of cells.
WIDTH, LEAST = 0.5, 3
#: The slowest motion along the fence, of one unit: friction or inertia alone counts below it.
SLOWEST = exp(-32.0)
#: Angle by which motions of a continuum differ at least.
TURN = 1e-9
#: Where a way is: at its start, outside of a continuum, inside of one.
REST, OUTSIDE, INSIDE = 0, 1, 2
#: Slips closer than this, relative to their motion, are one.
COINCIDENCE = 9e-13
#: How often a dip is halved at most.
HALVINGS = 60
#: Slips under one edge that are written down.
SLIPS = 8
#: Entries of `found`: place, rotation, whether the slip is an end of a continuum, and about which point it
#: is.
ENTRIES = 4


@generic
def _cells(kinds: Any) -> Callable[..., Any]:
    """Number of cells between two places of a way: effects, unit, first, last."""
    return _one_cell if is_steady(kinds) else _many_cells


@compiled
def _one_cell(effects, unit, first, last):
    return 1


@compiled
def _many_cells(effects, unit, first, last):
    return max(ceil((asinh(last / unit) - asinh(first / unit)) / WIDTH), LEAST)


@compiled
def slips_along(way, unit, first, last, found):
    """Write down the roots from `first` to `last`, in this order.

    Parameters
    ----------
    way : Way
        Along the fence; `unit` is the size of its normal part.
    unit, first, last : float
    found : ndarray, shape (SLIPS, ENTRIES)

    Returns
    -------
    count : int
        Number of slips, -1 where an iteration has not settled or there are too many.
    flat : bool
        Whether the last motions are a part of a continuum.
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
            # The sign of a rounding error says nothing: the next place decides.
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
    """Whether the force steps across the edge at a kink, or up to it; a flat part counts for itself."""
    from_zero, to_zero = _is_zero(kink, kink.before), _is_zero(kink, kink.after)
    if flat:
        return kink.before * kink.after < 0.0 and not (from_zero or to_zero)
    before = here.after if from_zero else kink.before
    return not from_zero if to_zero else before * kink.after < 0.0


@compiled
def _write(unit, at, continuum, found, count):
    """Write down a slip; the number of slips then, -1 where it is none or one too many.

    Two cells that meet at a kink may both find it.
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
    """Write down the slips between two motions; their number then, and whether they end in a continuum."""
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
    """Whether a part of a way may be a continuum: effects, whether it is along the fence, and where it is.

    Of effects of one degree any part may be. Of others a part along the fence that begins at rest: beyond,
    inertia adds to the force across the edge in proportion to the motion.
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
    """The end of a flat part that begins at a motion; that motion where it is nothing but a root.

    Motions along the fence differ in size, all others in direction.
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
    """As `_between`, where the force is along the edge at an end: a root there, or a continuum."""
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
    """A motion between two at which the sign is another; the lower one where there is none.

    Halves of a dip are searched while both slopes point into it and the tangents at its sides meet beyond
    zero.
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
    """Write down the slip between two motions of other signs; of a continuum both ends."""
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
    """Part of the way between two motions after which the inverse cubic through both is zero.

    The secant where the force across the edge does not go one way.
    """
    rise, width = high.before - low.after, high.s - low.s
    part = -low.after / rise
    if low.slope * rise > 0.0 and high.slope * rise > 0.0:
        start, end, left = rise / (width * low.slope), rise / (width * high.slope), 1.0 - part
        part *= part * (3.0 - 2.0 * part) + left * (left * start - part * end)
    return part
