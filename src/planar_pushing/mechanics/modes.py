"""Enumeration of the contact modes of one push from rest (Secs. 2-5)."""

from __future__ import annotations

from math import sqrt

from planar_pushing.mechanics.angles import RESOLUTION
from planar_pushing.mechanics.compiled import compiled
from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.mechanics.numerics.copying import copy
from planar_pushing.mechanics.plane import QUARTER_TURN, contact_motion, toward
from planar_pushing.mechanics.reduced.base import held_on_edge, slips, stick
from planar_pushing.mechanics.reduced.corners import CONTINUUM
from planar_pushing.mechanics.reduced.sticking import Sustained
from planar_pushing.mechanics.reduced.turning import SLIPS

#: Motions closer than this, relative to the pusher's, are one motion: a slip that vanishes is a stick.
COINCIDENCE = 9e-13
#: How far before the pusher's motion slips begin, relative to it, so that one that is the stick is seen.
BEFORE = 1e-11
#: A force this far outside the cone, relative to its size, is taken to the edge.
OUTSIDE = 5e-13
#: Solutions of one push: separate, stick, and the slips under each edge.
MOST = 2 + 2 * SLIPS
SEPARATE, STICK = int(ContactMode.SEPARATE), int(ContactMode.STICK)
SLIP_RIGHT, SLIP_LEFT = int(ContactMode.SLIP_RIGHT), int(ContactMode.SLIP_LEFT)


@compiled
def _inside(edge, side, along, aside):
    """How far a force is inside an edge of the cone: of the left one on the side 1, of the right one -1."""
    return side * (edge.along * aside - edge.aside * along)


@compiled
def _depth(edge, side, moved):
    """How far a force is inside an edge, and the rounding of it; both times the speed of the centre."""
    noise = RESOLUTION * (abs(edge.aside) + moved.blur * abs(edge.along))
    return _inside(edge, side, moved.along, moved.aside), noise


@compiled
def _rise(own, moved):
    """The force's part along the fence's normal, the middle of every cone, and the rounding of it."""
    normal = toward(own, QUARTER_TURN)
    part = normal.along * moved.along + normal.aside * moved.aside
    return part, RESOLUTION * (abs(normal.along) + moved.blur * abs(normal.aside))


@compiled
def _kept_inside(effects, own, moved, right_edge, left_edge, right, left):
    """The sticking motion, its force taken to the edge of the cone that it has left by rounding.

    Of two edges that it has left, the one on its side of the rod: rounding turns the force of a long rod
    within its side.
    """
    if min(right, left) >= -OUTSIDE * sqrt(moved.along**2 + moved.aside**2):
        return moved
    one, other = right_edge.aside * moved.aside > 0.0, left_edge.aside * moved.aside > 0.0
    if one and (right <= left or not other):
        return held_on_edge(effects, own, right_edge, moved)
    return held_on_edge(effects, own, left_edge, moved) if other else moved


@compiled
def _part_inside(moved, right_edge, left_edge):
    """Ends of the part of a pivot's interval, -1 to 1, that is between the edges; it may be empty."""
    low, high = -1.0, 1.0
    for edge, side in ((right_edge, -1.0), (left_edge, 1.0)):
        depth = _inside(edge, side, moved.along, moved.aside)
        change = _inside(edge, side, moved.free_along, moved.free_aside)
        if change > 0.0:
            low = max(low, -depth / change)
        elif change < 0.0:
            high = min(high, -depth / change)
    return low, high


@compiled
def _settled(own, law, moved, right_edge, left_edge):
    """A pivot whose force is taken to the middle of what the law transmits, if it transmits any."""
    if moved.free_along == 0.0 and moved.free_aside == 0.0:
        return moved
    low, high = (-1.0, 1.0) if law.rough else _part_inside(moved, right_edge, left_edge)
    part = min(max((low + high) / 2.0, -1.0), 1.0)
    half = max((high - low) / 2.0, 0.0)
    along, aside = moved.along + part * moved.free_along, moved.aside + part * moved.free_aside
    f_x, f_y = along * own.x + aside * own.y, along * own.y - aside * own.x
    return Sustained(
        moved.v_x, moved.v_y, moved.spin, f_x, f_y, along, aside, moved.blur,
        half * moved.free_along, half * moved.free_aside, moved.pivot,
    )  # fmt: skip


@compiled
def _stick(own, moved, modes, motions, place):
    """Write down the sticking solution."""
    modes[place] = STICK
    found = motions[place]
    free_x = moved.free_along * own.x + moved.free_aside * own.y
    free_y = moved.free_along * own.y - moved.free_aside * own.x
    found[0], found[1], found[2] = moved.v_x, moved.v_y, moved.spin
    found[3], found[4] = moved.f_x - free_x, moved.f_y - free_y
    found[5], found[6], found[7] = moved.f_x + free_x, moved.f_y + free_y, moved.pivot


@compiled
def _separate(modes, motions):
    modes[0] = SEPARATE
    motions[0], motions[0, 7] = 0.0, -1.0
    return 1


@compiled
def _may_slip(edge, side, pusher, moved):
    """Whether there can be slips under an edge, beside the sticking motion.

    A slip goes against the edge's force along the fence, so it has less of a part along the force than the
    pusher's motion, and that part is positive. The potential is convex, so the force along the fence rises
    with the motion along it: a slip to the right takes more than sticking does.
    """
    part = edge.x * pusher.x + edge.y * pusher.y
    size = sqrt(moved.f_x * moved.f_x + moved.f_y * moved.f_y)
    return part >= -COINCIDENCE and side * moved.f_x <= OUTSIDE * size


@compiled
def _slipping(effects, own, edge, pusher, moved, mode, modes, motions, count):
    """Write down the slips of a mode.

    Returns
    -------
    count : int
        How many solutions there are then.
    at_edge, corner : bool
        Whether one of the slips is the stick, and whether they are the ends of a continuum.
    """
    side, at_edge, corner = 1.0 if mode == SLIP_RIGHT else -1.0, False, False
    if not _may_slip(edge, side, pusher, moved):
        return count, at_edge, corner
    start, first = pusher.x - side * BEFORE, count
    for i in range(first, first + slips(effects, own, edge, pusher.y, start, motions[first:])):
        slip = contact_motion(own, motions[i, 0], motions[i, 1], motions[i, 2])[0] - pusher.x
        if side * slip > COINCIDENCE:
            modes[count] = mode
            copy(motions[count], motions[i])
            count += 1
        at_edge, corner = at_edge or abs(slip) <= COINCIDENCE, motions[i, 7] == CONTINUUM
    return count, at_edge, corner


@compiled
def contact_modes(effects, own, law, pusher, moves, modes, motions):
    """Write down every consistent solution, in units of the pusher's motion.

    Parameters
    ----------
    effects : tuple
    own : Rod
    law : Law
    pusher : Direction
        Of the pusher's motion, which has unit size.
    moves : bool
        Whether the pusher moves at all.
    modes : ndarray of int, shape (MOST,)
    motions : ndarray, shape (MOST, MOTION)
        Take the solutions, in the order of `ContactMode`.

    Returns
    -------
    int
        How many there are.

    Notes
    -----
    At an edge of the motion cone stick and slip are one solution. Rounding moves the force and the motion
    of that edge apart by the cone's condition number, so there a stick counts where no slip does, and a
    slip that vanishes counts as the stick.
    """
    if not moves:
        return _separate(modes, motions)
    place = _separate(modes, motions) if pusher.y <= 0.0 else 0  # of the stick, before the slips
    right_edge, left_edge = toward(own, law.right), toward(own, law.left)
    moved = _settled(own, law, stick(effects, own, pusher), right_edge, left_edge)
    right, right_noise = _depth(right_edge, -1.0, moved)
    left, left_noise = _depth(left_edge, 1.0, moved)
    rise, noise = _rise(own, moved)
    reached = right >= -right_noise and left >= -left_noise and rise >= -noise
    held = law.rough or (right > right_noise and left > left_noise and rise > noise)
    if law.slips:
        first, on_left, left_corner = _slipping(
            effects, own, left_edge, pusher, moved, SLIP_RIGHT, modes, motions, place + 1
        )
        count, on_right, right_corner = _slipping(
            effects, own, right_edge, pusher, moved, SLIP_LEFT, modes, motions, first
        )
        slides_right, slides_left = first > place + 1, count > first
        # Both edges of a cone narrower than rounding: beside one that slips the other does not stick.
        held |= (on_left and not slides_left) or (on_right and not slides_right)
        # A motion of a corner sticks too; slips go on from it.
        held |= reached and law.closed and (left_corner or right_corner)
        slides = slides_right or slides_left
    else:
        count, slides = place + 1, not law.closed
    if held or (reached and not slides):
        if not law.rough:
            moved = _kept_inside(effects, own, moved, right_edge, left_edge, right, left)
        _stick(own, moved, modes, motions, place)
        return count
    for i in range(place, count - 1):
        modes[i] = modes[i + 1]
        copy(motions[i], motions[i + 1])
    return count - 1
