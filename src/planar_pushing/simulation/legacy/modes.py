"""Enumeration of the contact modes of one push from rest (Secs. 2-5)."""

from __future__ import annotations

from math import sqrt

from planar_pushing.simulation.legacy.compiled import compiled
from planar_pushing.simulation.legacy.free import free
from planar_pushing.simulation.legacy.psi import spin_guess
from planar_pushing.simulation.legacy.record import (
    SEPARATE,
    SLIP_LEFT,
    SLIP_RIGHT,
    STICK,
    UNSOLVED,
    copy,
    write,
)
from planar_pushing.simulation.legacy.root import EPSILON
from planar_pushing.simulation.legacy.slipping import (
    COINCIDENCE,
    OUTSIDE,
    force_along,
    scale_of,
    slipping,
)
from planar_pushing.simulation.legacy.slips import SLOWEST
from planar_pushing.simulation.legacy.under import Moved, pushed, sticking, with_force

#: Directions closer than this (radians) are one direction: a few ulp of pi.
RESOLUTION = 8 * EPSILON


@compiled
def _inside(edge, side, f_x, f_y):
    """Signed distance of a force from an edge, positive inside the cone; side 1 is left, -1 right."""
    return side * (-edge.aside * f_x - edge.along * f_y)


@compiled
def _blur(edge, moved):
    """Rounding error of `_inside`."""
    one, other = (
        moved.noise_x + RESOLUTION * abs(moved.f_x),
        moved.noise_y + RESOLUTION * abs(moved.f_y),
    )
    return abs(edge.along) * other + abs(edge.aside) * one


@compiled
def _on_edge(push, pusher, edge):
    """The sticking motion with its force on an edge, after rounding has moved it out of the cone."""
    along = edge.x * pusher.x + edge.y * pusher.y
    return pushed(push.effects, push.at, edge.along, -edge.aside, along)


@compiled
def _part_inside(moved, right_edge, left_edge):
    """Ends of the part of a pivot's interval [-1, 1] that is between the edges; it can be empty."""
    low, high = -1.0, 1.0
    for edge, side in ((right_edge, -1.0), (left_edge, 1.0)):
        depth = _inside(edge, side, moved.f_x, moved.f_y)
        change = _inside(edge, side, moved.free_x, moved.free_y)
        if change > 0.0:
            low = max(low, -depth / change)
        elif change < 0.0:
            high = min(high, -depth / change)
    return low, high


@compiled
def _settled(law, moved, right_edge, left_edge):
    """A pivot with its force at the middle of the forces that the law transmits, if there are any."""
    if moved.free_x == 0.0 and moved.free_y == 0.0:
        return moved
    low, high = (-1.0, 1.0) if law.rough else _part_inside(moved, right_edge, left_edge)
    part = min(max((low + high) / 2.0, -1.0), 1.0)
    half = max((high - low) / 2.0, 0.0)
    return with_force(
        moved, moved.f_x + part * moved.free_x, moved.f_y + part * moved.free_y,
        half * moved.free_x, half * moved.free_y,
    )  # fmt: skip


@compiled
def _resting(push, law, edges, moved, scale):
    """A slider at rest; a force outside the cone is moved to an edge if friction can sustain it there.

    Friction holds the slider under a convex set of forces. The largest of them along an edge is the force
    of the slowest motion under that edge.
    """
    for edge, side in ((edges[0], -1.0), (edges[1], 1.0)):
        if law.rough or _inside(edge, side, moved.f_x, moved.f_y) >= 0.0:
            continue
        slow = pushed(push.effects, push.at, edge.along, -edge.aside, SLOWEST * scale)
        moves = abs(slow.u_x) + abs(slow.u_y)
        if slow.found and moves <= COINCIDENCE * scale and force_along(edge, slow) > 0.0:
            return with_force(moved, slow.f_x, slow.f_y, 0.0, 0.0)
    return moved


@compiled
def _separate(push, found):
    """Write the motion without a contact force."""
    rest = free(push.effects)
    at = push.at
    u_x, u_y = rest.x - rest.spin * at.y, rest.y + rest.spin * at.x
    write(
        push,
        SEPARATE,
        Moved(u_x, u_y, rest.x, rest.y, rest.spin, 0.0, 0.0, 0.0, 0.0, -1, False, 0.0, 0.0, True),
        found,
    )
    return found.motion[0], found.motion[1]


@compiled
def contact_modes(push, law, edges, pusher, moves, scratch, solutions):
    """Write every consistent solution, in units of the pusher's motion.

    Parameters
    ----------
    push : Push
    law : Law
    edges : (Direction, Direction)
        Right and left edges of the friction cone.
    pusher : Direction
        Direction of the pusher's motion, which has unit magnitude.
    moves : bool
        Whether the pusher moves at all.
    scratch : ndarray, shape (SLIPS, ENTRIES)
    solutions : array of SOLUTION, shape (MOST,)
        Receives the solutions, in the order of `ContactMode`.

    Returns
    -------
    count : int
        Number of solutions, -1 if an iteration has not converged.
    continuum : bool
        Whether a continuum of slips touches the stick.

    Notes
    -----
    At an edge of the motion cone, stick and slip are one solution. Rounding separates the force and the
    motion of that edge by the cone's condition number. Near an edge, sticking therefore counts if no slip
    does, and a slip of zero speed counts as sticking.
    """
    right_edge, left_edge = edges
    rest = _separate(push, solutions[0])
    if not moves:
        return 1, False
    place = 1 if pusher.y <= rest[1] else 0  # index of the stick, which precedes the slips
    x, y = pusher.along, -pusher.aside
    moved = sticking(push.effects, push.at, x, y, spin_guess(push.effects, push.at, x, y))
    if not moved.found:
        return UNSOLVED, False
    moved = _settled(law, moved, right_edge, left_edge)
    if x == 0.0 and y == 0.0 and moved.spin == 0.0:
        moved = _resting(push, law, edges, moved, scale_of(pusher, rest))
    right = _inside(right_edge, -1.0, moved.f_x, moved.f_y)
    left = _inside(left_edge, 1.0, moved.f_x, moved.f_y)
    rise = push.t_x * moved.f_y - push.t_y * moved.f_x
    right_noise, left_noise = _blur(right_edge, moved), _blur(left_edge, moved)
    noise = abs(push.t_x) * (moved.noise_y + RESOLUTION * abs(moved.f_y))
    noise += abs(push.t_y) * (moved.noise_x + RESOLUTION * abs(moved.f_x))
    reached = right >= -right_noise and left >= -left_noise and rise >= -noise
    held = law.rough or (right > right_noise and left > left_noise and rise > noise)
    flat, slides, on_left, on_right = False, not law.closed, False, False
    count = place + 1
    if law.slips:
        first, on_left, flat_left = slipping(
            push, left_edge, pusher, rest, moved, SLIP_RIGHT, scratch, solutions, place, place + 1
        )
        count, on_right, flat_right = slipping(
            push, right_edge, pusher, rest, moved, SLIP_LEFT, scratch, solutions, place, first
        )
        if count < 0:
            return UNSOLVED, False
        slides_right, slides_left = first > place + 1, count > first
        # A force on an edge sticks unless the other edge slips; in a cone narrower than rounding it is on
        # both.
        held |= (on_left and not slides_left) or (on_right and not slides_right)
        # The last motion of a continuum also sticks; slips continue from it.
        flat = flat_left or flat_right
        held |= reached and law.closed and flat
        slides = slides_right or slides_left
    if held or (reached and not slides):
        outside = min(right, left) < -OUTSIDE * sqrt(moved.f_x * moved.f_x + moved.f_y * moved.f_y)
        if law.rough or not outside:
            write(push, STICK, moved, solutions[place])
        elif not (on_left or on_right):
            edge = right_edge if right <= left else left_edge
            write(push, STICK, _on_edge(push, pusher, edge), solutions[place])
        solutions[place].continuum |= flat
        return count, flat
    for i in range(place, count - 1):
        copy(solutions[i], solutions[i + 1])
    return count - 1, flat
