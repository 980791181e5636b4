"""The slips of a push under one edge of the friction cone, in addition to the sticking motion."""

from __future__ import annotations

from collections.abc import Callable
from math import copysign, sqrt
from typing import Any

from planar_pushing.simulation.legacy.base import KINDS
from planar_pushing.simulation.legacy.compiled import compiled, generic
from planar_pushing.simulation.legacy.record import SLIP_RIGHT, STICK, UNSOLVED, write
from planar_pushing.simulation.legacy.slips import SLOWEST, slips_along
from planar_pushing.simulation.legacy.under import Moved, moved_at, pushed_ends
from planar_pushing.simulation.legacy.way import Way

#: Motions closer than this, relative to the pusher's and the free motion, are one motion: a slip of zero
#: speed is a stick.
COINCIDENCE = 9e-13
#: Distance to which slips are searched beyond the pusher's motion, relative to the same scale, so that a
#: slip that is the stick is found; for a pusher at rest the search ends before its motion.
BEYOND = 1e-11
#: Smallest normal motion, which keeps its square from underflowing.
LEAST = 1e-140
#: Rotation of a root that counts as zero, relative to that under a force across the rod: the square of a
#: rounding error.
STILL = 1e-31
#: A force farther outside the cone than this, relative to its magnitude, is moved to the edge.
OUTSIDE = 5e-13


@compiled
def scale_of(pusher, rest):
    """Scale of motions: the larger of the pusher's motion, which is 1 or 0, and the free motion."""
    pushed = 1.0 if pusher.x != 0.0 or pusher.y != 0.0 else 0.0
    return max(pushed, abs(rest[0]), abs(rest[1]))


@compiled
def _may_slip(edge, side, part, moved_force, size):
    """Whether slips under an edge are possible, in addition to the sticking motion.

    A slip is opposed by the edge's force along the fence. Its component along the force is therefore
    positive and smaller than that of the pusher's motion, or equal if the force is normal to the fence. The
    potential is convex, so the force along the fence increases with the motion along it: a slip to the
    right takes a larger force than sticking.
    """
    return part > 0.0 and side * moved_force <= OUTSIDE * size


@compiled
def slipping(push, edge, pusher, rest, moved, mode, scratch, solutions, place, count):
    """Write the slips of a mode.

    Returns
    -------
    count : int
        Number of solutions so far, -1 if an iteration has not converged.
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
        return _write_normal(push, edge, normal, side, mode, pusher, rest, solutions, place, count)
    sense = copysign(1.0, edge.x)
    way = Way(push.effects, push.at, e_x, e_y, n_x, n_y, sense * push.t_x, sense * push.t_y)
    first = sense * rest_x - edge.y * (normal - rest_y) / abs(edge.x)
    scale, resting = scale_of(pusher, rest), pusher.x == 0.0 and pusher.y == 0.0
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
        slid = _still(push.at.reach, moved_at(way, s, spin, continuum != 0.0, int(point)))
        count, edge_too, _ = _write_slip(
            push, edge, slid, side, mode, pusher, rest, solutions, place, count
        )
        at_edge |= edge_too
    return count if number >= 0 else UNSOLVED, at_edge, flat


@compiled
def _write_normal(push, edge, normal, side, mode, pusher, rest, solutions, place, count):
    """Write the slips under an edge along the normal; returns as in `slipping`.

    All motions of a continuum have this force: its ends are slips of this mode, or the stick is in it.
    """
    e_x, e_y = edge.along, -edge.aside
    # The path across the force leads from right to left.
    right, left = pushed_ends(push.effects, push.at, e_x, e_y, edge.y * normal)
    if right.u_x == left.u_x and right.u_y == left.u_y:
        return _write_slip(push, edge, right, side, mode, pusher, rest, solutions, place, count)
    least, at_edge = COINCIDENCE * scale_of(pusher, rest), False
    holds = push.t_x * right.u_x + push.t_y * right.u_y >= pusher.x - least
    holds &= push.t_x * left.u_x + push.t_y * left.u_y <= pusher.x + least
    tie = 1.0 + COINCIDENCE  # then from right to left
    slow, fast = (right, left) if _speed(right) <= tie * _speed(left) else (left, right)
    for slid in (slow, fast):
        count, edge_too, _ = _write_slip(
            push, edge, slid, side, mode, pusher, rest, solutions, place, count
        )
        at_edge |= edge_too
    return count, at_edge, holds


@compiled
def _speed(slid):
    return sqrt(slid.u_x * slid.u_x + slid.u_y * slid.u_y)


@compiled
def _still(reach, slid):
    """A slip; a rotation of rounding size is set to zero, since the force is then through the center."""
    size = abs(slid.u_x) + abs(slid.u_y)
    if abs(slid.spin) * (1.0 + reach * reach) > STILL * reach * size:
        return slid
    return Moved(
        slid.u_x, slid.u_y, slid.v_x, slid.v_y, 0.0, slid.f_x, slid.f_y, 0.0, 0.0,
        slid.point, slid.continuum, slid.noise_x, slid.noise_y, slid.found,
    )  # fmt: skip


@compiled
def _write_slip(push, edge, slid, side, mode, pusher, rest, solutions, place, count):
    """Write a slip if its force pushes, or the stick if it does not slip; returns as in `slipping`."""
    least = COINCIDENCE * scale_of(pusher, rest)
    slip = push.t_x * slid.u_x + push.t_y * slid.u_y - pusher.x
    if not slid.found or count < 0:
        return UNSOLVED, False, False
    if force_along(edge, slid) <= slid.noise_x + slid.noise_y:
        return count, False, False
    if abs(slip) <= least:
        write(push, STICK, slid, solutions[place])
        _take_to(edge, slid, solutions[place])
    elif side * slip > least:
        if count == len(solutions):
            return UNSOLVED, False, False
        write(push, mode, slid, solutions[count])
        _take_to(edge, slid, solutions[count])
        if 0.0 < abs(pusher.y) < LEAST:
            part = abs(pusher.y) / LEAST
            _shrink(solutions[count], part, _growth(push.effects, part))
        count += 1
    return count, abs(slip) <= least, False


@compiled
def force_along(edge, slid):
    """The force along an edge, negative against it."""
    return edge.along * slid.f_x - edge.aside * slid.f_y


@compiled
def _take_to(edge, slid, found):
    """Write a force along an edge, without the rounding errors of the body frame."""
    size = force_along(edge, slid)
    found.force[0], found.force[1] = size * edge.x, size * edge.y
    found.force_end[0], found.force_end[1] = found.force[0], found.force[1]


@compiled
def _shrink(found, part, force):
    """Scale the magnitudes of a motion and its force."""
    for k in range(3):
        found.twist[k] *= part
    for k in range(2):
        found.motion[k] *= part
        found.force[k] *= force
        found.force_end[k] *= force


@generic
def _growth(kinds: Any) -> Callable[..., Any]:
    """Factor of the force when a slow motion is scaled by a factor: effects, factor of the motion."""
    return _in_proportion if all(KINDS[kind].DEGREE == 2 for kind in kinds) else _constant


@compiled
def _in_proportion(effects, part):
    return part


@compiled
def _constant(effects, part):
    return 1.0
