"""Slips with friction and inertia: of the motions with one normal part, those whose force is on an edge.

The force across the edge is evaluated, with its slope, at places whose distances grow with the part along
the fence. Between two of them there is a slip where it changes its sign, and there are two where it dips
to the other sign, for which both slopes have to point inward. Pivots are known beforehand.
"""

from __future__ import annotations

from math import asinh, ceil, copysign, exp, nan, sinh
from typing import NamedTuple

from planar_pushing.mechanics.compiled import compiled, owning
from planar_pushing.mechanics.numerics.root import EQUATIONS, root
from planar_pushing.mechanics.reduced.pressed.motions import RANGE, write
from planar_pushing.mechanics.reduced.pressed.places import (
    Place,
    Slide,
    first_place,
    moved_at,
    pivot_at,
    pivots_between,
    place_at,
    rough_place,
    sides_of,
)

#: Distance of two places in asinh(x / normal part) at most, and how many distances there are at least.
WIDTH, LEAST = 0.5, 3
#: The least and the largest part along the fence.
SLOWEST, FASTEST = exp(-RANGE), exp(RANGE)
#: A root is not guessed nearer to an end than this, in parts of the way to the other.
INNER = 0.05
#: How often a dip is halved at most.
HALVINGS = 40


class Across(NamedTuple):
    """Force across the edge times a sign, near a place."""

    slide: Slide
    near: Place
    sign: float


@compiled
def _across(of, x):
    place = place_at(of.slide, x, of.near)
    return of.sign * place.across, of.sign * place.slope


EQUATIONS[Across] = _across


@owning
def slips_along(slide, start, found):
    """Write down the slips from the slowest to one that moves by `start` along the fence; their number."""
    edge, normal = slide.edge, slide.normal
    start = copysign(min(abs(start), FASTEST), start)
    end = -edge.y * normal / edge.x if normal != 0.0 else copysign(SLOWEST, start)
    if not edge.x * (start - end) > 0.0:
        return 0
    unit = max(abs(normal), SLOWEST)
    first, last = asinh(end / unit), asinh(start / unit)
    cells = max(ceil(abs(last - first) / WIDTH), LEAST)
    pivots, here, count = pivots_between(slide, end, start), first_place(slide, end), 0
    for i in range(1, cells + 1):
        x = start if i == cells else unit * sinh(first + (last - first) * i / cells)
        here, count = _on_to(slide, here, x, pivots, found, count)
    return count


@compiled
def _on_to(slide, here, x, pivots, found, count):
    """Write down the slips up to the place at x; that place, and how many slips there are then."""
    i = _nearest(pivots, here.x, x)
    while i >= 0:
        before, after = sides_of(slide, pivots[i], i, x > here.x)
        count = _between(slide, here, before, found, count)
        count = _write(pivot_at(slide, pivots[i], i)[1], found, count)
        here, pivots[i] = after, nan
        i = _nearest(pivots, here.x, x)
    place = rough_place(slide, x, here)
    return place, _between(slide, here, place, found, count)


@compiled
def _between(slide, one, other, found, count):
    """Write down the slips between two places, and return how many there are then."""
    if (one.across > 0.0) != (other.across > 0.0):
        return _write_root(slide, one, other, found, count)
    bottom, crosses = _dip(slide, one, other)
    if crosses:
        count = _write_root(slide, one, bottom, found, count)
        count = _write_root(slide, bottom, other, found, count)
    return count


@compiled
def _dip(slide, one, other):
    """A place between two at which the sign is another, and whether there is one.

    Halves of a dip are searched while the tangents at its sides meet beyond zero.
    """
    sign, away = 1.0 if one.across > 0.0 else -1.0, other.x - one.x
    for i in range(HALVINGS):
        fall, rise = sign * away * one.slope, sign * away * other.slope
        if not fall < 0.0 < rise:
            break
        part = (abs(one.across) - abs(other.across) + rise) / (rise - fall)
        if i > 0 and abs(one.across) + part * fall > 0.0:
            break
        away /= 2.0
        middle = place_at(slide, one.x + away, one)
        if sign * middle.across < 0.0:
            return middle, True
        if sign * away * middle.slope < 0.0:
            one = middle
        else:
            other = middle
    return one, False


@compiled
def _write_root(slide, one, other, found, count):
    """Write down the slip between two places of other signs, and return how many there are then."""
    low, high = (one, other) if one.x < other.x else (other, one)
    across = Across(slide, one, 1.0 if high.across > 0.0 else -1.0)
    start = low.x + min(max(_part(low, high), INNER), 1.0 - INNER) * (high.x - low.x)
    x = root(across, low.x, high.x, start)[0]
    return _write(moved_at(slide, x, one), found, count)


@compiled
def _part(low, high):
    """Part of the way between two places of other signs after which the inverse cubic through both is zero.

    The secant where the force across the edge does not go one way.
    """
    rise, way = high.across - low.across, high.x - low.x
    part = -low.across / rise
    if low.slope * rise > 0.0 and high.slope * rise > 0.0:
        start, end, left = rise / (way * low.slope), rise / (way * high.slope), 1.0 - part
        part *= part * (3.0 - 2.0 * part) + left * (left * start - part * end)
    return part


@compiled
def _write(moved, found, count):
    if count == len(found):
        return count
    write(moved, 1.0, 1.0, found[count])
    return count + 1


@compiled
def _nearest(pivots, here, x):
    """Number of the next pivot on the way to x, -1 without one."""
    found, least = -1, abs(x - here)
    for i in range(len(pivots)):
        away = abs(pivots[i] - here)
        if away <= least and (pivots[i] > here) == (x > here):
            found, least = i, away
    return found
