"""Enumeration of the contact modes of one push from rest (Secs. 2-5)."""

from __future__ import annotations

from collections.abc import Callable
from math import copysign, sqrt
from typing import Any, NamedTuple

import numpy as np

from planar_pushing.mechanics.angles import RESOLUTION
from planar_pushing.mechanics.compiled import compiled, generic
from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.mechanics.effects.base import KINDS
from planar_pushing.mechanics.reduced.free import free
from planar_pushing.mechanics.reduced.psi import spin_guess
from planar_pushing.mechanics.reduced.slips import SLIPS, SLOWEST, slips_along
from planar_pushing.mechanics.reduced.under import Moved, moved_at, pushed, sticking, with_force
from planar_pushing.mechanics.reduced.way import Way

#: Motions closer than this, relative to the pusher's and the free one, are one motion: a slip that vanishes
#: is a stick.
COINCIDENCE = 9e-13
#: How far beyond the pusher's motion slips are sought, relative to the same, so that one that is the stick is
#: found; beside a pusher at rest they end before it.
BEYOND = 1e-11
#: A normal motion is not smaller than this, so that squares of it are doubles.
LEAST = 1e-140
#: A force this far outside the cone, relative to its magnitude, is taken to the edge.
OUTSIDE = 5e-13
#: Solutions of one push: separate, stick, and the slips under each edge.
MOST = 2 + 2 * SLIPS
SEPARATE, STICK = int(ContactMode.SEPARATE), int(ContactMode.STICK)
SLIP_RIGHT, SLIP_LEFT = int(ContactMode.SLIP_RIGHT), int(ContactMode.SLIP_LEFT)
#: In place of a number of solutions: an iteration has not settled, or there are more slips than fit.
UNSOLVED = -1
#: A solution, in the frame of the contact: twist of the slider's origin, motion of the contact, force and the
#: other end of its interval, number of the support point that is a pivot, whether it is an end of a continuum.
SOLUTION = np.dtype(
    (
        np.record,
        [
            ("mode", "i8"), ("twist", "f8", (3,)), ("motion", "f8", (2,)), ("force", "f8", (2,)),
            ("force_end", "f8", (2,)), ("pivot", "i8"), ("continuum", "i8"),
        ],
    ),
)  # fmt: skip


class Push(NamedTuple):
    """A push in the body frame: effects, contact, and the tangent of the pusher there.

    The normal is the tangent turned by 90 degrees to the left.
    """

    effects: tuple[Any, ...]
    at: Any
    t_x: float
    t_y: float


@compiled
def _inside(edge, side, f_x, f_y):
    """How far a force is inside an edge of the cone: of the left one on the side 1, of the right one -1."""
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
    """The sticking motion whose force rounding has taken out of the cone, with its force on an edge."""
    along = edge.x * pusher.x + edge.y * pusher.y
    return pushed(push.effects, push.at, edge.along, -edge.aside, along)


@compiled
def _part_inside(moved, right_edge, left_edge):
    """Ends of the part of a pivot's interval, -1 to 1, that is between the edges; it may be empty."""
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
    """A pivot whose force is taken to the middle of what the law transmits, if it transmits any."""
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
    """A slider at rest whose force friction takes to an edge of the cone, if it is outside and friction can.

    Friction holds the slider under all forces of a convex set. The last of them along an edge is that of the
    slowest motion under it.
    """
    for edge, side in ((edges[0], -1.0), (edges[1], 1.0)):
        if law.rough or _inside(edge, side, moved.f_x, moved.f_y) >= 0.0:
            continue
        slow = pushed(push.effects, push.at, edge.along, -edge.aside, SLOWEST * scale)
        moves = abs(slow.u_x) + abs(slow.u_y)
        if slow.found and moves <= COINCIDENCE * scale and _along(edge, slow) > 0.0:
            return with_force(moved, slow.f_x, slow.f_y, 0.0, 0.0)
    return moved


@compiled
def _write(push, mode, moved, found):
    """Write down a solution in the frame of the contact."""
    t_x, t_y = push.t_x, push.t_y
    found.mode, found.pivot, found.continuum = mode, moved.point, moved.continuum
    found.twist[0], found.twist[1] = (
        t_x * moved.v_x + t_y * moved.v_y,
        t_x * moved.v_y - t_y * moved.v_x,
    )
    found.twist[2] = moved.spin
    found.motion[0], found.motion[1] = (
        t_x * moved.u_x + t_y * moved.u_y,
        t_x * moved.u_y - t_y * moved.u_x,
    )
    f_x, f_y = moved.f_x - moved.free_x, moved.f_y - moved.free_y
    found.force[0], found.force[1] = t_x * f_x + t_y * f_y, t_x * f_y - t_y * f_x
    f_x, f_y = moved.f_x + moved.free_x, moved.f_y + moved.free_y
    found.force_end[0], found.force_end[1] = t_x * f_x + t_y * f_y, t_x * f_y - t_y * f_x


@compiled
def _separate(push, found):
    """Write down the motion without a force."""
    rest = free(push.effects)
    at = push.at
    u_x, u_y = rest.x - rest.spin * at.y, rest.y + rest.spin * at.x
    _write(
        push,
        SEPARATE,
        Moved(u_x, u_y, rest.x, rest.y, rest.spin, 0.0, 0.0, 0.0, 0.0, -1, False, 0.0, 0.0, True),
        found,
    )
    return found.motion[0], found.motion[1]


@compiled
def _scale(pusher, rest):
    """What motions are compared with: the pusher's, which has unit size or is at rest, and the free one."""
    pushed = 1.0 if pusher.x != 0.0 or pusher.y != 0.0 else 0.0
    return max(pushed, abs(rest[0]), abs(rest[1]))


@compiled
def _may_slip(edge, side, part, moved_force, size):
    """Whether there can be slips under an edge, beside the sticking motion.

    A slip goes against the edge's force along the fence, so it has less of a part along the force than the
    pusher's motion, and that part is positive; a force across the fence gives both the same part. The
    potential is convex, so the force along the fence rises with the motion along it: a slip to the right
    takes more than sticking does.
    """
    return part > 0.0 and side * moved_force <= OUTSIDE * size


@compiled
def _slipping(push, edge, pusher, rest, moved, mode, scratch, solutions, place, count):
    """Write down the slips of a mode.

    Returns
    -------
    count : int
        How many solutions there are then, -1 where they are not solved.
    at_edge, flat : bool
        Whether one of the slips is the stick, and whether the stick is an end of a continuum.
    """
    side = 1.0 if mode == SLIP_RIGHT else -1.0
    rest_x, rest_y = rest
    part = edge.x * (pusher.x - rest_x) + edge.y * (pusher.y - rest_y)
    force = push.t_x * moved.f_x + push.t_y * moved.f_y
    size = sqrt(moved.f_x * moved.f_x + moved.f_y * moved.f_y)
    if count < 0 or not _may_slip(edge, side, part, force, size):
        return count, False, False
    e_x, e_y = edge.along, -edge.aside
    normal = copysign(max(abs(pusher.y), LEAST), pusher.y) if pusher.y != 0.0 else 0.0
    n_x, n_y = -push.t_y * normal, push.t_x * normal
    if edge.x == 0.0:
        slid = pushed(push.effects, push.at, e_x, e_y, edge.y * normal)
        return _write_slip(push, edge, slid, side, mode, pusher, rest, solutions, place, count)
    sense = copysign(1.0, edge.x)
    way = Way(push.effects, push.at, e_x, e_y, n_x, n_y, sense * push.t_x, sense * push.t_y)
    first = sense * rest_x - edge.y * (normal - rest_y) / abs(edge.x)
    scale, resting = _scale(pusher, rest), pusher.x == 0.0 and pusher.y == 0.0
    last = sense * (pusher.x - side * (-BEYOND if resting else BEYOND) * scale)
    unit = max(abs(normal), abs(rest_x), abs(rest_y))
    if first == 0.0:
        first = SLOWEST * (unit if unit > 0.0 else 1.0)
    if not last > first:
        return count, False, False
    number, flat = slips_along(way, unit, first, last, scratch)
    at_edge = False
    for i in range(number):
        s, spin, continuum, point = scratch[i, 0], scratch[i, 1], scratch[i, 2], scratch[i, 3]
        slid = moved_at(way, s, spin, continuum != 0.0, int(point))
        count, edge_too, _ = _write_slip(
            push, edge, slid, side, mode, pusher, rest, solutions, place, count
        )
        at_edge |= edge_too
    return count if number >= 0 else UNSOLVED, at_edge, flat


@compiled
def _write_slip(push, edge, slid, side, mode, pusher, rest, solutions, place, count):
    """Write down a slip if its force pushes, as the stick if it does not slip; as `_slipping`."""
    least = COINCIDENCE * _scale(pusher, rest)
    slip = push.t_x * slid.u_x + push.t_y * slid.u_y - pusher.x
    if not slid.found or count < 0:
        return UNSOLVED, False, False
    if _along(edge, slid) <= slid.noise_x + slid.noise_y:
        return count, False, False
    if abs(slip) <= least:
        _write(push, STICK, slid, solutions[place])
        _take_to(edge, slid, solutions[place])
    elif side * slip > least:
        if count == len(solutions):
            return UNSOLVED, False, False
        _write(push, mode, slid, solutions[count])
        _take_to(edge, slid, solutions[count])
        if 0.0 < abs(pusher.y) < LEAST:
            part = abs(pusher.y) / LEAST
            _shrink(solutions[count], part, _growth(push.effects, part))
        count += 1
    return count, abs(slip) <= least, False


@compiled
def _along(edge, slid):
    """The force along an edge, negative against it."""
    return edge.along * slid.f_x - edge.aside * slid.f_y


@compiled
def _take_to(edge, slid, found):
    """Write down a force along an edge, free of the rounding of the body frame."""
    size = _along(edge, slid)
    found.force[0], found.force[1] = size * edge.x, size * edge.y
    found.force_end[0], found.force_end[1] = found.force[0], found.force[1]


@compiled
def _shrink(found, part, force):
    """Take a motion and its force to parts of their magnitudes."""
    for k in range(3):
        found.twist[k] *= part
    for k in range(2):
        found.motion[k] *= part
        found.force[k] *= force
        found.force_end[k] *= force


@generic
def _growth(kinds: Any) -> Callable[..., Any]:
    """Part of the force that a slow motion takes of a part of it: effects, part."""
    return _in_proportion if all(KINDS[kind].DEGREE == 2 for kind in kinds) else _constant


@compiled
def _in_proportion(effects, part):
    return part


@compiled
def _constant(effects, part):
    return 1.0


@compiled
def contact_modes(push, law, edges, pusher, moves, scratch, solutions):
    """Write down every consistent solution, in units of the pusher's motion.

    Parameters
    ----------
    push : Push
    law : Law
    edges : (Direction, Direction)
        Right and left edges of the friction cone.
    pusher : Direction
        Of the pusher's motion, which has unit size.
    moves : bool
        Whether the pusher moves at all.
    scratch : ndarray, shape (SLIPS, ENTRIES)
    solutions : array of SOLUTION, shape (MOST,)
        Takes the solutions, in the order of `ContactMode`.

    Returns
    -------
    count : int
        How many there are, -1 where an iteration has not settled.
    continuum : bool
        Whether a continuum of slips touches the stick.

    Notes
    -----
    At an edge of the motion cone stick and slip are one solution. Rounding moves the force and the motion
    of that edge apart by the cone's condition number, so there a stick counts where no slip does, and a
    slip that vanishes counts as the stick.
    """
    right_edge, left_edge = edges
    rest = _separate(push, solutions[0])
    if not moves:
        return 1, False
    place = 1 if pusher.y <= rest[1] else 0  # of the stick, before the slips
    x, y = pusher.along, -pusher.aside
    moved = sticking(push.effects, push.at, x, y, spin_guess(push.effects, push.at, x, y))
    if not moved.found:
        return UNSOLVED, False
    moved = _settled(law, moved, right_edge, left_edge)
    if x == 0.0 and y == 0.0 and moved.spin == 0.0:
        moved = _resting(push, law, edges, moved, _scale(pusher, rest))
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
        first, on_left, flat_left = _slipping(
            push, left_edge, pusher, rest, moved, SLIP_RIGHT, scratch, solutions, place, place + 1
        )
        count, on_right, flat_right = _slipping(
            push, right_edge, pusher, rest, moved, SLIP_LEFT, scratch, solutions, place, first
        )
        if count < 0:
            return UNSOLVED, False
        slides_right, slides_left = first > place + 1, count > first
        # Both edges of a cone narrower than rounding: beside one that slips the other does not stick.
        held |= (on_left and not slides_left) or (on_right and not slides_right)
        # The last motion of a continuum sticks too; slips go on from it.
        flat = flat_left or flat_right
        held |= reached and law.closed and flat
        slides = slides_right or slides_left
    if held or (reached and not slides):
        outside = min(right, left) < -OUTSIDE * sqrt(moved.f_x * moved.f_x + moved.f_y * moved.f_y)
        if law.rough or not outside:
            _write(push, STICK, moved, solutions[place])
        elif not (on_left or on_right):
            edge = right_edge if right <= left else left_edge
            _write(push, STICK, _on_edge(push, pusher, edge), solutions[place])
        solutions[place].continuum = flat
        return count, flat
    for i in range(place, count - 1):
        _copy(solutions[i], solutions[i + 1])
    return count - 1, flat


@compiled
def _copy(target, source):
    target.mode, target.pivot, target.continuum = source.mode, source.pivot, source.continuum
    for k in range(3):
        target.twist[k] = source.twist[k]
    for k in range(2):
        target.motion[k], target.force[k] = source.motion[k], source.force[k]
        target.force_end[k] = source.force_end[k]
