"""The force across an edge along a straight path of contact motions, and its roots.

A path is ``u = p + s d``. If p is the pusher's normal motion and d is along the fence, its roots are the
slips under an edge of the friction cone. If p is along a line of force and d across it, the only root is
the motion under that force. Psi is convex. The force across the edge is therefore monotone in the second
case, if p and d are parallel, or if the effects have one degree. Otherwise it can have a dip.

If the slider pivots about a support point, the force is in an interval, and the force across the edge
jumps: a root within the jump is the pivot. By symmetry, or with a support on one line, the force across the
edge can vanish to rounding on a whole stretch of the path, unlike at a root: this stretch is a continuum.
"""

from __future__ import annotations

from math import copysign, inf, nan, sqrt
from typing import Any, NamedTuple

from planar_pushing.simulation.legacy.base import count_points, place
from planar_pushing.simulation.legacy.compiled import compiled
from planar_pushing.simulation.legacy.motion import NOWHERE, Contact
from planar_pushing.simulation.legacy.psi import psi, spin_guess
from planar_pushing.simulation.legacy.root import EPSILON, is_last

#: Vectors are perpendicular if their scalar product is below this, relative to their magnitudes.
DIRECTION = 16.0 * EPSILON
#: Maximum number of steps to a root.
STEPS = 200
#: Maximum length of a step, relative to the motion.
FARTHEST = 8.0
#: Forces are in units of the largest one: one this small has underflowed.
UNDERFLOW = 1e-200
#: Fraction of a motion over which a force must be constant, to rounding, for a continuum.
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
    """A motion of a path.

    Attributes
    ----------
    s : float
    before, after : float
        Force across the edge, ``e x f``, just before and after s; they differ only at a pivot.
    slope : float
        Derivative of this force with respect to s.
    noise : float
        Rounding error of this force.
    spin, swing : float
        Rotation, and its derivative with respect to s.
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
    """A motion of the contact across the line to a support point, the rotation about it, and its number."""

    s: float
    spin: float
    point: int


@compiled
def motion(way, s):
    """The contact's motion."""
    return way.p_x + s * way.d_x, way.p_y + s * way.d_y


@compiled
def node(way, s, spin, point):
    """The motion at s, from a guess of its rotation and, at a kink, the number of its point."""
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
            # Psi is convex, so the force along d jumps up as s increases.
            before, after = (
                across - copysign(half, half * ahead),
                across + copysign(half, half * ahead),
            )
        else:
            # The whole path is across the line to the point; its friction can bring the force to the edge.
            before = copysign(max(abs(across) - abs(half), 0.0), across)
            after, slope = before, 0.0
    noise = abs(e_x) * now.noise_y + abs(e_y) * now.noise_x + UNDERFLOW
    return Node(s, before, after, slope, noise, now.spin, swing, now.point, now.found)


@compiled
def beside(way, near, s):
    """The motion at s, from a nearby motion."""
    return node(way, s, near.spin + near.swing * (s - near.s), NOWHERE)


@compiled
def first_node(way, s):
    """The motion at s, without a nearby motion."""
    x, y = motion(way, s)
    return node(way, s, spin_guess(way.effects, way.at, x, y), NOWHERE)


@compiled
def kink_near(way, low, high, s):
    """The kink nearest to s between two places; NaN if there is none."""
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
    """Whether the force stays along the edge near a motion, to rounding."""
    small = max(abs(at.before), abs(at.after)) <= at.noise
    return small and abs(at.slope) * FLAT * scale <= at.noise


@compiled
def crossing(way, low, high, here):
    """The root between two motions of opposite signs, from a motion between them.

    Parameters
    ----------
    way : Way
    low, high, here : Node
        `low` and `high` can be at infinity.

    Returns
    -------
    Node
        Its `found` is whether the iteration has converged.
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
    """The same motion, marked as not converged."""
    return Node(at.s, at.before, at.after, at.slope, at.noise, at.spin, at.swing, at.point, False)


@compiled
def at_infinity(s, value):
    """An end of an unbounded path."""
    return Node(s, value, value, 0.0, 0.0, 0.0, 0.0, NOWHERE, True)


@compiled
def _middle(low, high, scale, least):
    """Midpoint of a bracket; the geometric mean if it spans several orders of magnitude."""
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
    """The end of a flat stretch, to the last digits, between a motion inside it and one outside."""
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
