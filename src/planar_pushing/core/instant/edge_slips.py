"""The slips of one push whose force is along an edge of the friction cone (Secs. 2-5).

They are the roots of the force across the edge on the path of motions along the fence. Under an edge along
the normal, the force does not depend on the slip, so that the slips can form a continuum; a pivot about a
support point can be missed by the search along the path.
"""

from __future__ import annotations

from math import copysign, fabs, sqrt
from typing import NamedTuple

from planar_pushing.core.instant.directions import Direction
from planar_pushing.core.instant.force import (
    ContactMotion,
    leave_continuum,
    motion_at_root,
    motion_under_force,
    motions_under_force,
    replace_force,
    sticking_motion,
)
from planar_pushing.core.instant.path import Path, Sample, first_sample, hinge_on_edge, sample_of
from planar_pushing.core.instant.slips import SLIP, SLIPS, Slip, find_slips
from planar_pushing.core.instant.solution import (
    MOST_SOLUTIONS,
    SLIP_RIGHT,
    SOLUTION,
    STICK,
    UNSOLVED,
    Push,
    Solution,
    force_along,
    half_along,
    shrink_solution,
    write_on_edge,
)
from planar_pushing.core.numbers import Numbers, zeros
from planar_pushing.core.supports.contact import is_held
from planar_pushing.core.supports.potential import Psi, unknown_psi
from planar_pushing.core.supports.psi import psi, turn_about_contact
from planar_pushing.core.supports.resistance import load_wrench, rough_mass
from planar_pushing.core.supports.rows import NO_POINT, scale_effects
from planar_pushing.core.supports.tolerances import (
    ALIGNED,
    COINCIDENT,
    FAINT,
    NOISE,
    SLOW,
    SLOWEST,
    SMALLEST_NORMAL,
)

#: Power of two by which a normal motion below `SMALLEST_NORMAL` is multiplied, and its slips divided.
STEP_OF_NORMAL = 1152921504606846976.0
#: Unit of the cells of a path without normal motion, relative to the motion without a pusher: friction
#: changes direction where the contact is this slow relative to a rotation.
FINE = 1e-4
#: Farthest slip of a side that rotates, if no mass limits it.
FARTHEST_SLIP = 1e12


class Search(NamedTuple):
    """The inputs that the searches for the slips of one push share.

    Attributes
    ----------
    push : Push
    pusher : Direction
        Motion of the pusher, of magnitude 0 or 1.
    rest_x, rest_y, rest_spin : float
        Motion of the contact without a pusher, in the frame of the contact, and the rotation.
    scale : float
        Magnitude of the larger of the two motions.
    stick : Psi
        The sticking motion.
    f_x, f_y : float
        Its force; for a pivot, one that the law transmits.
    stick_index : int
        Index of the stick in the solutions.
    """

    push: Push
    pusher: Direction
    rest_x: float
    rest_y: float
    rest_spin: float
    scale: float
    stick: Psi
    f_x: float
    f_y: float
    stick_index: int


class Count(NamedTuple):
    """The solutions so far.

    Attributes
    ----------
    number : int
        Number of solutions.
    sticks : bool
        Whether one of the slips is the stick.
    flat : bool
        Whether a continuum of slips touches the stick.
    open : bool
        Whether the motion without a contact force is among them, as an end of an interval of forces.
    """

    number: int
    sticks: bool
    flat: bool
    open: bool


def _farthest_slip(push: Push) -> float:
    """A motion along the fence beyond which the force of a side that rotates has the sign of the slip."""
    effects, contact, load = push.effects, push.contact, load_wrench(push.effects)
    spin, reach = fabs(contact.spin), 1.0 + contact.reach
    weight = rough_mass(scale_effects(effects, 1.0, 0.0), 1.0, contact.x, contact.y).mass
    mass = rough_mass(scale_effects(effects, 0.0, 1.0), 1.0, contact.x, contact.y)
    if mass.mass == 0.0:
        return FARTHEST_SLIP * (1.0 + spin * reach)
    size = fabs(load.x) + fabs(load.y) + weight + spin * (fabs(mass.x) + fabs(mass.y))
    return 2.0 * (size / mass.mass + 1.0 + spin * reach)


def write_slips(
    search: Search, edge: Direction, mode: int, solutions: Numbers, slips: Count
) -> Count:
    """Write the slips of a mode after the solutions so far.

    A slip is opposed by the edge's force along the fence. Its component along the force is therefore
    positive and smaller than that of the pusher's motion, or equal if the force is normal to the fence. The
    potential is convex, so the force along the fence increases with the motion along it: a slip to the
    right takes a larger force than sticking.
    """
    side = 1.0 if mode == SLIP_RIGHT else -1.0
    push, pusher, rest_y = search.push, search.pusher, search.rest_y
    part = edge.x * (pusher.x - search.rest_x) + edge.y * (pusher.y - rest_y)
    force = push.t_x * search.f_x + push.t_y * search.f_y
    size = sqrt(search.f_x * search.f_x + search.f_y * search.f_y)
    rests: bool = pusher.x == 0.0 and pusher.y == 0.0
    turns: bool = is_held(push.contact) and push.contact.spin != 0.0
    pivot = _pivot_on_edge(search, edge, rests)
    pivots: bool = pivot.converged and slips.number >= 0
    if pivots:
        slips = _write_slip_of(search, edge, mode, pivot, 1.0, solutions, slips)
        if edge.x == 0.0:
            return slips
    if slips.number < 0 or (part <= 0.0 and not turns):
        return slips
    # The force of a contact at rest is only one of a set, so it does not rule out slips.
    if side * force > COINCIDENT * size and not rests:
        return slips
    normal, shrink = pusher.y, 1.0
    falls: bool = search.rest_x != 0.0 or rest_y != 0.0
    if falls and fabs(normal) < SMALLEST_NORMAL:
        normal = 0.0  # negligible relative to the motion without a pusher
    while 0.0 < fabs(normal) < SMALLEST_NORMAL:
        normal, shrink = STEP_OF_NORMAL * normal, shrink / STEP_OF_NORMAL
    if edge.x == 0.0:
        return _write_normal_slips(search, edge, mode, normal, shrink, solutions, slips)
    n_x, n_y, sense = -push.t_y * normal, push.t_x * normal, copysign(1.0, edge.x)
    path = Path(
        push.effects,
        push.contact,
        e_x=edge.along,
        e_y=-edge.across,
        p_x=n_x,
        p_y=n_y,
        d_x=sense * push.t_x,
        d_y=sense * push.t_y,
    )
    first = sense * search.rest_x - edge.y * (normal - rest_y) / fabs(edge.x)
    unit = max(fabs(normal), FINE * max(fabs(search.rest_x), fabs(rest_y)))
    slowest = SLOWEST * (unit if unit > 0.0 else 1.0)
    if fabs(first) < slowest:
        first = slowest
    if pivots or (first == sense * search.rest_x and normal == rest_y):
        first += SLOW * search.scale  # the motion without a pusher has no force
    if turns:
        first = sense * pusher.x - _farthest_slip(push)
    if rests and not turns:
        # Nor is it the limit of the forces of slow slips, so the search ends before rest.
        end = first_sample(path, sense * side * SLOW * search.scale)
    else:
        end = sample_of(path, sense * pusher.x, search.stick)
        slips = _write_touching_stick(search, path, edge, mode, end, solutions, slips)
    if not end.s > first:
        return slips
    roots = zeros(SLIPS * SLIP)
    hinge = pivot.point if pivots else NO_POINT
    number, flat = find_slips(path, unit, first, end, roots)
    for i in range(number):
        root = Slip(roots[SLIP * i :])
        motion = motion_at_root(path, root.s, root.spin, root.continuum, root.pivot)
        motion = _snap_to_rest(search, edge, normal, motion)
        if pivots and _coincide(search, pivot, motion):
            continue
        if half_along(edge, motion) > 0.0:
            if motion.point == hinge:
                continue
            hinge = motion.point
        slips = _write_slip_of(search, edge, mode, motion, shrink, solutions, slips)
    count = slips.number if number >= 0 else UNSOLVED
    return Count(count, slips.sticks, slips.flat or flat, slips.open)


def _pivot_on_edge(search: Search, edge: Direction, rests: bool) -> ContactMotion:
    """A pivot on the edge's line that the search along the path can miss; not converged without one.

    It is the rotation about a support point at the contact, if the pusher moves along the fence, or the
    motion without a pusher, if the pusher moves at its normal component.
    """
    push, x, y = search.push, search.rest_x, search.rest_y
    e_x, e_y = edge.along, -edge.across
    none = sticking_motion(0.0, 0.0, unknown_psi())
    if search.pusher.y == 0.0 and not rests:
        root = turn_about_contact(push.effects, push.contact)
        limit, across = root.half_x, e_x * root.f_y - e_y * root.f_x
        if root.converged and fabs(across) < limit:
            along, half = e_x * root.f_x + e_y * root.f_y, sqrt(limit * limit - across * across)
            motion = sticking_motion(0.0, 0.0, root)
            return replace_force(
                motion, f_x=along * e_x, f_y=along * e_y, half_x=half * e_x, half_y=half * e_y
            )
    rounding = ALIGNED * (search.scale + fabs(search.rest_spin) * (1.0 + push.contact.reach))
    if search.rest_spin == 0.0 or fabs(search.pusher.y - y) > rounding:
        return none
    u_x, u_y = push.t_x * x - push.t_y * y, push.t_y * x + push.t_x * y
    path = Path(push.effects, push.contact, e_x, e_y, p_x=u_x, p_y=u_y, d_x=push.t_x, d_y=push.t_y)
    point = hinge_on_edge(path, u_x, u_y, search.rest_spin)
    return (
        motion_at_root(path, s=0.0, spin=search.rest_spin, continuum=False, point=point)
        if point >= 0
        else none
    )


def _write_touching_stick(
    search: Search, path: Path, edge: Direction, mode: int, end: Sample,
    solutions: Numbers, slips: Count,
) -> Count:  # fmt: skip
    """Write the stick if the root of the force across the edge is the same motion, on either side of it."""
    if end.before != end.after or fabs(end.after) > fabs(end.slope) * COINCIDENT * search.scale:
        return slips
    step = -end.after / end.slope if end.slope != 0.0 else 0.0
    spin = end.spin + step * end.swing
    motion = motion_at_root(path, end.s + step, spin, False, NO_POINT)
    if fabs(_slip_of(search, motion)) > COINCIDENT * search.scale:
        return slips
    return _write_slip_of(search, edge, mode, motion, 1.0, solutions, slips)


def _slip_of(search: Search, motion: ContactMotion) -> float:
    """Motion of the slider along the fence relative to the pusher, positive to the right."""
    push = search.push
    return push.t_x * motion.u_x + push.t_y * motion.u_y - search.pusher.x


def _write_normal_slips(
    search: Search, edge: Direction, mode: int, normal: float, shrink: float,
    solutions: Numbers, slips: Count,
) -> Count:  # fmt: skip
    """Write the slips under an edge along the normal.

    All motions of a continuum have this force: its ends are slips of this mode, or the stick is in it.
    """
    push, pusher = search.push, search.pusher
    # The path across the force leads from right to left.
    ends = motions_under_force(
        push.effects, push.contact, e_x=edge.along, e_y=-edge.across, along=edge.y * normal
    )
    right, left = ends.first, ends.last
    if ends.first.converged and not ends.first.continuum:
        right = _snap_to_rest(search, edge, normal, right)
        left = right
    if right.u_x == left.u_x and right.u_y == left.u_y:
        return _write_slip_of(search, edge, mode, right, shrink, solutions, slips)
    closest = COINCIDENT * search.scale
    holds: bool = push.t_x * right.u_x + push.t_y * right.u_y >= pusher.x - closest
    holds = holds and push.t_x * left.u_x + push.t_y * left.u_y <= pusher.x + closest
    # In the order from slow to fast; at equal speeds, from right to left.
    slower: bool = _speed_of(right) <= (1.0 + COINCIDENT) * _speed_of(left)
    if _coincide(search, right, left):
        end = leave_continuum(right if slower else left)
        slips = _write_slip_of(search, edge, mode, end, shrink, solutions, slips)
    elif slower:
        slips = _write_slip_of(search, edge, mode, right, shrink, solutions, slips)
        slips = _write_slip_of(search, edge, mode, left, shrink, solutions, slips)
    else:
        slips = _write_slip_of(search, edge, mode, left, shrink, solutions, slips)
        slips = _write_slip_of(search, edge, mode, right, shrink, solutions, slips)
    return Count(slips.number, slips.sticks, slips.flat or holds, slips.open)


def _coincide(search: Search, one: ContactMotion, other: ContactMotion) -> bool:
    """Whether two ends of a continuum are the same motion."""
    apart = fabs(one.u_x - other.u_x) + fabs(one.u_y - other.u_y) + fabs(one.spin - other.spin)
    return apart <= COINCIDENT * search.scale


def _snap_to_rest(
    search: Search, edge: Direction, normal: float, motion: ContactMotion
) -> ContactMotion:
    """A slip along the fence, or the contact at rest if the root is at rest to rounding.

    At rest the force across the edge jumps across zero. Friction sustains forces along the edge up to that
    of the slowest motion under the edge.
    """
    push = search.push
    if normal != 0.0 or _speed_of(motion) > NOISE * search.scale:
        return motion
    slow = motion_under_force(
        push.effects, push.contact, e_x=edge.along, e_y=-edge.across, along=SLOWEST * search.scale
    )
    root = psi(push.effects, push.contact, x=0.0, y=0.0, guess=0.0, point=NO_POINT, tolerance=0.0)
    return replace_force(
        sticking_motion(0.0, 0.0, root), slow.f_x, slow.f_y, half_x=0.0, half_y=0.0
    )


def _speed_of(motion: ContactMotion) -> float:
    return sqrt(motion.u_x * motion.u_x + motion.u_y * motion.u_y)


def _write_slip_of(
    search: Search, edge: Direction, mode: int, motion: ContactMotion, shrink: float,
    solutions: Numbers, slips: Count,
) -> Count:  # fmt: skip
    """Write a slip if its force pushes, or the stick if it does not slip."""
    push, side = search.push, 1.0 if mode == SLIP_RIGHT else -1.0
    closest = COINCIDENT * search.scale
    slip = _slip_of(search, motion)
    if not motion.converged or slips.number < 0:
        return Count(UNSOLVED, slips.sticks, slips.flat, slips.open)
    force, half, noise = (
        force_along(edge, motion), half_along(edge, motion), motion.noise_x + motion.noise_y
    )  # fmt: skip
    if force + half <= noise:
        return slips
    opens: bool = slips.open or force - half <= noise
    if fabs(slip) <= closest:
        index = search.stick_index
        write_on_edge(push, STICK, motion, edge, Solution(solutions[index * SOLUTION :]))
        return Count(slips.number, True, slips.flat, opens)
    if side * slip <= closest:
        return slips
    if slips.number == MOST_SOLUTIONS:
        return Count(UNSOLVED, slips.sticks, slips.flat, slips.open)
    solution = Solution(solutions[slips.number * SOLUTION :])
    write_on_edge(push, mode, motion, edge, solution)
    if shrink != 1.0 and _speed_of(motion) < FAINT * search.scale:
        shrink_solution(solution, shrink, 1.0 if push.effects.frictional else shrink)
    elif shrink != 1.0:
        solution.motion.y = search.pusher.y
    return Count(slips.number + 1, slips.sticks, slips.flat, opens)
