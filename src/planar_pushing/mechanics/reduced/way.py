"""The force across an edge along a straight way of contact motions, and its roots.

A way is ``u = p + s d``. With p along the pusher's normal motion and d along the fence its roots are the
slips under an edge of the friction cone; with p along a line of force and d across it the one root is the
motion under that force. Psi is convex: where p and d have no part across one another, or the effects have
one degree, the force across the edge goes one way. Elsewhere it may dip.

Where the slider pivots about a support point, the force is an interval and the force across the edge jumps:
a root within the jump is the pivot. By symmetry, or with a support on one line, the force across the edge
may be zero over a whole part of a way, which rounding tells from a root: such a part is a continuum.
"""

from __future__ import annotations

from math import copysign, inf, nan, sqrt
from typing import Any, NamedTuple

from planar_pushing.mechanics.compiled import compiled
from planar_pushing.mechanics.effects.base import count_points, place
from planar_pushing.mechanics.numerics.root import EPSILON, is_last
from planar_pushing.mechanics.reduced.psi import NOWHERE, Contact, psi, spin_guess

#: A vector is across another within this part of their sizes.
DIRECTION = 16.0 * EPSILON
#: Steps to a root at most.
STEPS = 200
#: A step goes no further than this many sizes of a motion.
FARTHEST = 8.0
#: Forces are in units of the largest one: one this small has underflowed.
UNDERFLOW = 1e-200
#: Part of a motion over which a force that is constant to rounding is a continuum.
FLAT = 1e-3


class Way(NamedTuple):
    """Contact motions ``p + s d`` in the body frame, and the unit vector e of an edge."""

    effects: tuple[Any, ...]
    at: Contact
    e_x: float
    e_y: float
    p_x: float
    p_y: float
    d_x: float
    d_y: float


class Node(NamedTuple):
    """A motion of a way.

    Attributes
    ----------
    s : float
    before, after : float
        Force across the edge, ``e x f``, just before and after s; different at a pivot alone.
    slope : float
        Its derivative by s.
    noise : float
        Its rounding error.
    spin, swing : float
        Rotation, and its derivative by s.
    point : int
        Number of the support point about which the slider pivots, -1 without one.
    found : bool
    """

    s: float
    before: float
    after: float
    slope: float
    noise: float
    spin: float
    swing: float
    point: int
    found: bool


class Kink(NamedTuple):
    """Where the contact moves across the line to a support point, the rotation about it, and its number."""

    s: float
    spin: float
    point: int


@compiled
def motion(way, s):
    """The contact's motion."""
    return way.p_x + s * way.d_x, way.p_y + s * way.d_y


@compiled
def node(way, s, spin, point):
    """The motion at s, from a guess of its rotation; at a kink, of its point."""
    x, y = motion(way, s)
    return _node(way, s, psi(way.effects, way.at, x, y, spin, point, 0.0))


@compiled
def _node(way, s, now):
    e_x, e_y, d_x, d_y = way.e_x, way.e_y, way.d_x, way.d_y
    across = e_x * now.f_y - e_y * now.f_x
    bend_x, bend_y = now.xx * d_x + now.xy * d_y, now.xy * d_x + now.yy * d_y
    slope, swing = e_x * bend_y - e_y * bend_x, now.turn_x * d_x + now.turn_y * d_y
    half, before, after = e_x * now.free_y - e_y * now.free_x, across, across
    if now.point >= 0:
        ahead = now.free_x * d_x + now.free_y * d_y
        size = (abs(now.free_x) + abs(now.free_y)) * (abs(d_x) + abs(d_y))
        if abs(ahead) > DIRECTION * size:
            # As Psi is convex, the force along d steps up where s increases.
            before, after = (
                across - copysign(half, half * ahead),
                across + copysign(half, half * ahead),
            )
        else:
            # The whole way is across the line to the point, whose friction may take the force to the edge.
            before = copysign(max(abs(across) - abs(half), 0.0), across)
            after, slope = before, 0.0
    noise = abs(e_x) * now.noise_y + abs(e_y) * now.noise_x + UNDERFLOW
    return Node(s, before, after, slope, noise, now.spin, swing, now.point, now.found)


@compiled
def beside(way, near, s):
    """The motion at s, from a near one."""
    return node(way, s, near.spin + near.swing * (s - near.s), NOWHERE)


@compiled
def first_node(way, s):
    """The motion at s, without another one."""
    x, y = motion(way, s)
    return node(way, s, spin_guess(way.effects, way.at, x, y), NOWHERE)


@compiled
def kink_near(way, low, high, s):
    """Of the kinks between two places the nearest to s; NaN where there is none."""
    found, least, at = Kink(nan, nan, NOWHERE), inf, way.at
    for i in range(count_points(way.effects)):
        x, y = place(way.effects, i)
        r_x, r_y = x - at.x, y - at.y
        ahead, square = way.d_x * r_x + way.d_y * r_y, r_x * r_x + r_y * r_y
        if abs(ahead) <= DIRECTION * (abs(r_x) + abs(r_y)) * (abs(way.d_x) + abs(way.d_y)):
            continue
        place_s = -(way.p_x * r_x + way.p_y * r_y) / ahead
        if low < place_s < high and abs(place_s - s) < least:
            u_x, u_y = motion(way, place_s)
            spin = (u_x * r_y - u_y * r_x) / square
            found, least = Kink(place_s, spin, i), abs(place_s - s)
    return found


@compiled
def is_flat(way, at, scale):
    """Whether the force is along the edge about a motion, but for rounding."""
    small = max(abs(at.before), abs(at.after)) <= at.noise
    return small and abs(at.slope) * FLAT * scale <= at.noise


@compiled
def crossing(way, low, high, here):
    """The root between two motions, of opposite signs, from a motion between them.

    Parameters
    ----------
    way : Way
    low, high, here : Node
        `low` and `high` may be at infinity. A kink between them is a kink of the way.

    Returns
    -------
    Node
        Its `found` says whether the iteration has settled.
    """
    sense, last = 1.0 if high.before > low.after else -1.0, inf
    part, least = abs(way.d_x) + abs(way.d_y), abs(way.p_x) + abs(way.p_y)
    least = least / part if least > 0.0 else EPSILON
    for _ in range(STEPS):
        before, after = sense * here.before, sense * here.after
        if before <= 0.0 <= after:
            return here
        if after < 0.0:
            low, value = here, after
        else:
            high, value = here, before
        scale = abs(here.s) + least
        slope = sense * here.slope
        step = -value / slope if slope > 0.0 else copysign(inf, -value)
        size, new = abs(step) / scale, here.s + step
        done = is_last(size, last) and low.s <= new <= high.s
        if done:
            pass
        elif not low.s < new < high.s or size > last / 2.0:
            if high.s - low.s <= 4.0 * EPSILON * scale:
                return here
            last, new = inf, _middle(low.s, high.s, scale, EPSILON * least)
        elif size > FARTHEST:
            last, new = inf, here.s + copysign(FARTHEST * scale, step)
        else:
            last = size
        kink = kink_near(way, low.s, high.s, new)
        ahead = here.s < kink.s < new or new < kink.s < here.s
        if ahead or abs(kink.s - new) <= DIRECTION * scale:
            last, here = inf, node(way, kink.s, kink.spin, kink.point)
            continue
        here = beside(way, here, new)
        if done:
            return here
    return unsettled(here)


@compiled
def unsettled(at):
    """A motion that is no root."""
    return Node(at.s, at.before, at.after, at.slope, at.noise, at.spin, at.swing, at.point, False)


@compiled
def at_infinity(s, value):
    """An end of an unbounded way."""
    return Node(s, value, value, 0.0, 0.0, 0.0, 0.0, NOWHERE, True)


@compiled
def _middle(low, high, scale, least):
    """Middle of a bracket; of one that spans sizes above the least, the middle of the sizes."""
    if low == -inf:
        return high - FARTHEST * scale
    if high == inf:
        return low + FARTHEST * scale
    near, far = max(abs(low), least), max(abs(high), least)
    if high > 4.0 * near and near > 0.0:
        return sqrt(near) * sqrt(high)
    if -low > 4.0 * far and far > 0.0:
        return -sqrt(far) * sqrt(-low)
    return low + (high - low) / 2.0


@compiled
def flat_end(way, inside, outside):
    """The end of a flat part, between a motion in it and one that is not: to the last digits."""
    for _ in range(STEPS):
        scale = abs(inside.s) + abs(outside.s)
        if abs(inside.s - outside.s) <= EPSILON * scale:
            break
        middle = beside(
            way, inside, _middle(min(inside.s, outside.s), max(inside.s, outside.s), scale, 0.0)
        )
        if max(abs(middle.before), abs(middle.after)) <= middle.noise:
            inside = middle
        else:
            outside = middle
    return inside
