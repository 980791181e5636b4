"""Motions of the contact with one normal part, followed along the fence to where the force is on an edge.

Such a motion has the part x along the fence, and the rotation that leaves no torque. The force across the edge is
smooth over x, but for steps at the pivots, which are known beforehand. It is evaluated, with its slope, at
places whose distances grow with x; between two of them are a root where it changes its sign, and two
where it dips below zero, for which the slopes at both places have to point inward.
"""

from __future__ import annotations

from math import asinh, ceil, copysign, exp, inf, nan, sinh
from typing import Any, NamedTuple

import numpy as np

from planar_pushing.mechanics.compiled import compiled
from planar_pushing.mechanics.effects.base import count_points, point
from planar_pushing.mechanics.numerics.root import EQUATIONS, root
from planar_pushing.mechanics.plane import Direction, Rod
from planar_pushing.mechanics.reduced.general import Motion, felt, rough_spin, spin_of
from planar_pushing.mechanics.reduced.pivots import SHARE, held
from planar_pushing.mechanics.reduced.pressed.motions import RANGE, line_of, of_line, sustained, write

#: Distance of two places in asinh(x / normal part) at most, and how many distances there are at least.
WIDTH, LEAST = 0.5, 3
#: Newton steps to a rotation at most, what one may leave of the last, and the relative size of one whose
#: square is rounding.
STEPS, SHRINK, SETTLED = 8, 0.3, 1e-8
#: How often a dip is halved at most.
HALVINGS = 40
#: The least and the largest part along the fence, and a force that has a sign and no size.
SLOWEST, FASTEST, TINY = exp(-RANGE), exp(RANGE), 1e-300


class Slide(NamedTuple):
    """Motions of the contact with one normal part, and the edge."""

    effects: tuple[Any, ...]
    own: Rod
    edge: Direction
    normal: float


class Place(NamedTuple):
    """A motion of a slide: its part along the fence, force across the edge, rotation, and their slopes."""

    x: float
    across: float
    slope: float
    spin: float
    swing: float


class Across(NamedTuple):
    """Force across the edge times a sign, near a place."""

    slide: Slide
    near: Place
    sign: float


@compiled
def _contact(slide, x):
    """Motion of the contact in the body frame."""
    own, normal = slide.own, slide.normal
    return x * own.x + normal * own.y, normal * own.x - x * own.y


@compiled
def _place(slide, x, near):
    """The place at x: by Newton's method from a near one, or where that is not near by a bracketed root."""
    length, (u_x, u_y) = slide.own.length, _contact(slide, x)
    spin, last = near.spin + near.swing * (x - near.x), inf
    for _ in range(STEPS):
        now = felt(slide.effects, length, Motion(u_x, u_y, spin))
        step = -now.torque / now.ss
        if abs(step) <= SETTLED * (abs(spin) + (abs(u_x) + abs(u_y)) / (1.0 + length)):
            return _felt_at(slide, x, spin, step, now)
        if not abs(step) <= SHRINK * last:
            break
        spin, last = spin + step, abs(step)
    spin = spin_of(slide.effects, length, u_x, u_y)
    return _felt_at(slide, x, spin, 0.0, felt(slide.effects, length, Motion(u_x, u_y, spin)))


@compiled
def _felt_at(slide, x, spin, step, now):
    """The place at x, from what is felt at a rotation and the step that is left of it."""
    own, edge = slide.own, slide.edge
    swing = (now.ys * own.y - now.xs * own.x) / now.ss
    change_x = now.xx * own.x - now.xy * own.y + now.xs * swing
    change_y = now.xy * own.x - now.yy * own.y + now.ys * swing
    f_x, f_y = now.f_x + step * now.xs, now.f_y + step * now.ys
    across, slope = _across_edge(edge, f_x, f_y), _across_edge(edge, change_x, change_y)
    return Place(x, across, slope, spin + step, swing)


@compiled
def _across_edge(edge, f_x, f_y):
    return edge.along * f_y + edge.aside * f_x


@compiled
def _across(of, x):
    place = _place(of.slide, x, of.near)
    return of.sign * place.across, of.sign * place.slope


EQUATIONS[Across] = _across


@compiled
def slips_along(slide, start, found):
    """Write down the slips from the slowest to one that moves by `start` along the fence; their number."""
    edge, normal = slide.edge, slide.normal
    start = copysign(min(abs(start), FASTEST), start)
    end = -edge.y * normal / edge.x if normal != 0.0 else copysign(SLOWEST, start)
    if not edge.x * (start - end) > 0.0:
        return 0
    unit = max(abs(normal), SLOWEST)
    first, last = asinh(end / unit), asinh(start / unit)
    cells = max(int(ceil(abs(last - first) / WIDTH)), LEAST)
    pivots, here, count = _pivots(slide, end, start), _first(slide, end), 0
    for i in range(1, cells + 1):
        x = start if i == cells else unit * sinh(first + (last - first) * i / cells)
        here, count = _on_to(slide, here, x, pivots, found, count)
    return count


@compiled
def _first(slide, x):
    u_x, u_y = _contact(slide, x)
    spin = rough_spin(slide.effects, slide.own.length, u_x, u_y)
    return _place(slide, x, Place(x, 0.0, 0.0, spin, 0.0))


@compiled
def _on_to(slide, here, x, pivots, found, count):
    """Write down the slips up to the place at x; that place, and how many slips there are then."""
    i = _nearest(pivots, here.x, x)
    while i >= 0:
        before, after = _sides(slide, pivots[i], i, x > here.x)
        count = _between(slide, here, before, found, count)
        count = _write(_pivot(slide, pivots[i], i)[1], found, count)
        here, pivots[i] = after, nan
        i = _nearest(pivots, here.x, x)
    place = _place(slide, x, here)
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

    Halves of a dip are looked at while the tangents at its sides meet beyond zero.
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
        middle = _place(slide, one.x + away, one)
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
    x = root(across, low.x, high.x, low.x + (high.x - low.x) / 2.0)[0]
    place, (u_x, u_y) = _place(slide, x, one), _contact(slide, x)
    moved = of_line(slide.effects, slide.own, _line(slide, x), Motion(u_x, u_y, place.spin))
    return _write(moved, found, count)


@compiled
def _write(moved, found, count):
    if count == len(found):
        return count
    write(moved, 1.0, 1.0, found[count])
    return count + 1


@compiled
def _line(slide, x):
    """The line of the edge, of motions with the part along it that the motion at x has."""
    along = slide.edge.x * x + slide.edge.y * slide.normal
    return line_of(slide.effects, slide.own, slide.edge, along)


@compiled
def _pivots(slide, end, start):
    """Of each support point, the place of the slip about it; NaN where there is none."""
    places, own = np.full(count_points(slide.effects[0]), nan), slide.own
    for i in range(len(places)):
        x, y, _ = point(slide.effects[0], i)
        x += own.length
        lever = y * own.y - x * own.x
        place = slide.normal * (y * own.x + x * own.y) / lever if lever != 0.0 else nan
        if min(end, start) < place < max(end, start) and _pivot(slide, place, i)[0]:
            places[i] = place
    return places


@compiled
def _pivot(slide, x, i):
    """Whether a force on the edge sustains the motion about a point, and that motion."""
    excess, motion, f_x, f_y = held(slide.effects, _line(slide, x), i)
    return excess <= SHARE, sustained(slide.own, motion, f_x, f_y, 0.0, 0.0, i)


@compiled
def _sides(slide, x, i, upward):
    """Places before and after a pivot, on either side of the step that its force makes over the edge.

    As the potential is convex, the force along the fence steps up where x increases.
    """
    own, edge, (p_x, p_y, _) = slide.own, slide.edge, point(slide.effects[0], i)
    p_x += own.length
    step = (edge.along * p_y + edge.aside * p_x) * (p_x * own.x - p_y * own.y)
    step = copysign(TINY, step if upward else -step)
    u_x, u_y = _contact(slide, x)
    spin = (u_x * p_y - u_y * p_x) / (p_x * p_x + p_y * p_y)
    return Place(x, -step, 0.0, spin, 0.0), Place(x, step, 0.0, spin, 0.0)


@compiled
def _nearest(pivots, here, x):
    """Number of the next pivot on the way to x, -1 without one."""
    found, least = -1, abs(x - here)
    for i in range(len(pivots)):
        away = abs(pivots[i] - here)
        if away <= least and (pivots[i] > here) == (x > here):
            found, least = i, away
    return found
