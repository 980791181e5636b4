"""Motions of the contact with one normal part, over the part along the fence: forces, slopes and pivots.

The rotation is the one that leaves no torque. The force across the edge is smooth over the part along the
fence, but for a step at each pivot about a support point.
"""

from __future__ import annotations

from math import copysign, nan
from typing import Any, NamedTuple

import numpy as np

from planar_pushing.mechanics.compiled import compiled, owning
from planar_pushing.mechanics.effects.any_support import count_points, point
from planar_pushing.mechanics.plane import Direction, Rod
from planar_pushing.mechanics.reduced.pivots import SHARE, held
from planar_pushing.mechanics.reduced.pressed.motions import line_of, of_line, sustained
from planar_pushing.mechanics.reduced.rotation import SETTLED, Motion, rough_spin, turned

#: Part of the slider's motion to which a place between slips is found, and part of the force that is
#: beyond its errors.
ROUGH, CLEAR = 1e-3, 1e-2
#: A force that has a sign and no size.
TINY = 1e-300


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


@compiled
def _contact(slide, x):
    """Motion of the contact in the body frame."""
    own, normal = slide.own, slide.normal
    return x * own.x + normal * own.y, normal * own.x - x * own.y


@compiled
def place_at(slide, x, near):
    """The place at x, from a near one."""
    return _found(slide, x, near, SETTLED)[0]


@compiled
def rough_place(slide, x, near):
    """The place at x to about `ROUGH`, but with the right sign of the force across the edge."""
    place, now = _found(slide, x, near, ROUGH)
    if abs(place.across) > CLEAR * (abs(now.f_x) + abs(now.f_y)):
        return place
    return place_at(slide, x, place)


@compiled
def _found(slide, x, near, enough):
    """The place at x, and what is felt there."""
    own, edge, (u_x, u_y) = slide.own, slide.edge, _contact(slide, x)
    guess = near.spin + near.swing * (x - near.x)
    spin, now = turned(slide.effects, own.length, u_x, u_y, guess, enough)
    swing = (now.ys * own.y - now.xs * own.x) / now.ss
    change_x = now.xx * own.x - now.xy * own.y + now.xs * swing
    change_y = now.xy * own.x - now.yy * own.y + now.ys * swing
    across, slope = _across_edge(edge, now.f_x, now.f_y), _across_edge(edge, change_x, change_y)
    return Place(x, across, slope, spin, swing), now


@compiled
def _across_edge(edge, f_x, f_y):
    return edge.along * f_y + edge.aside * f_x


@compiled
def first_place(slide, x):
    """The place at x, without another one."""
    u_x, u_y = _contact(slide, x)
    spin = rough_spin(slide.effects, slide.own.length, u_x, u_y)
    return rough_place(slide, x, Place(x, 0.0, 0.0, spin, 0.0))


@compiled
def _line(slide, x):
    """The line of the edge, of motions with the part along it that the motion at x has."""
    along = slide.edge.x * x + slide.edge.y * slide.normal
    return line_of(slide.effects, slide.own, slide.edge, along)


@compiled
def moved_at(slide, x, near):
    """The motion of the place at x, from a near one, with its force taken to be along the edge."""
    place, now = _found(slide, x, near, SETTLED)
    (u_x, u_y), line = _contact(slide, x), _line(slide, x)
    force = now.f_x * line.x + now.f_y * line.y
    return of_line(slide.own, line, Motion(u_x, u_y, place.spin), force)


@owning
def pivots_between(slide, end, start):
    """Of each support point, the place of the slip about it; NaN where there is none."""
    places, own = np.full(count_points(slide.effects[0]), nan), slide.own
    for i in range(len(places)):
        x, y, _ = point(slide.effects[0], i)
        x += own.length
        lever = y * own.y - x * own.x
        place = slide.normal * (y * own.x + x * own.y) / lever if lever != 0.0 else nan
        if min(end, start) < place < max(end, start) and pivot_at(slide, place, i)[0]:
            places[i] = place
    return places


@compiled
def pivot_at(slide, x, i):
    """Whether a force on the edge sustains the motion about a point, and that motion."""
    excess, motion, f_x, f_y = held(slide.effects, _line(slide, x), i)
    return excess <= SHARE, sustained(slide.own, motion, f_x, f_y, 0.0, 0.0, i)


@compiled
def sides_of(slide, x, i, upward):
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
