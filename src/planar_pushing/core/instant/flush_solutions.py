"""All solutions of a push of a flat side: flush contact, and contacts at an end that lift off the other.

Solutions with one twist count once, as flush. The two ends are also two contacts for `several`, with the
same answers on random sides; a side has a solver of its own because `several` measures twists and forces in
units of the fastest motion, which loses pushes that are almost along the fence or through an end, and
because it counts a contact without a force as closed.
"""

from __future__ import annotations

from math import copysign, fabs, sqrt
from typing import NamedTuple

from planar_pushing.core._record import Record, size_of
from planar_pushing.core.instant.cone import Law
from planar_pushing.core.instant.directions import Direction
from planar_pushing.core.instant.flush import flush_modes
from planar_pushing.core.instant.flush_force import (
    MOST_FLUSH,
    FlatSide,
    FlushPush,
    noise_at_ends,
    resist_translation,
    translation_force,
)
from planar_pushing.core.instant.kernels import (
    HEAD_OF_RESULTS,
    PushResult,
    PushRow,
    pushing_problem,
    write_results,
)
from planar_pushing.core.instant.modes import contact_modes
from planar_pushing.core.instant.solution import (
    MOST_SOLUTIONS,
    SEPARATE,
    SLIP_LEFT,
    SOLUTION,
    STICK,
    UNSOLVED,
    Pair,
    Push,
    Solution,
    copy_solution,
)
from planar_pushing.core.numbers import INFINITY, UNKNOWN, Numbers, zeros
from planar_pushing.core.supports.contact import contact_at
from planar_pushing.core.supports.free import foot_at_center, free_twist
from planar_pushing.core.supports.rows import Vector, count_columns, read_effects
from planar_pushing.core.supports.tolerances import ALMOST_FLUSH, COINCIDENT

#: Where a solution touches the fence: nowhere or along the whole side, at its start, at its end.
WHOLE_SIDE, SIDE_START, SIDE_END = range(3)
#: Maximum number of solutions.
MOST_ON_SIDE = 1 + MOST_FLUSH + 2 * MOST_SOLUTIONS


class End(NamedTuple):
    """An end of the side.

    Attributes
    ----------
    touches : int
        `SIDE_START` or `SIDE_END`.
    x : float
        Position along the fence.
    lifts : float
        Sign of a rotation that lifts the other end off the fence.
    rest_x, rest_y : float
        Motion without a contact, in the fence frame.
    """

    touches: int
    x: float
    lifts: float
    rest_x: float
    rest_y: float


class SideRow(PushRow):
    """A push from rest of a side, whose ends are measured along the fence from the contact."""

    start: float
    end: float


class SideSolution(Solution):
    """A solution of a push of a side, and where it touches the fence."""

    touches_at: int


class EndForces(Record):
    """Lower and upper bounds of the components of the forces at both ends of a side."""

    start_low: Pair
    start_high: Pair
    end_low: Pair
    end_high: Pair


class SideResult(PushResult):
    """A solution in the results of `solve_flush`.

    Attributes
    ----------
    flush : bool
    position : float
        Where the force crosses the fence.
    end_forces : EndForces
    """

    flush: bool
    position: float
    end_forces: EndForces


SIDE_SOLUTION, SIDE_RESULT = size_of(SideSolution), size_of(SideResult)
END_FORCES = size_of(EndForces)


def solve_flush(
    data: Numbers, rows: Numbers, count: int, columns: int, results: Numbers, width: int
) -> None:
    """Every consistent solution of each push of a side that lies on the fence.

    After the effects, a row holds a `SideRow`. A row of results holds what that of `solve` does, with each
    solution as `SideResult`. The motion of the contact is that of the end that touches the fence, if only
    one does.
    """
    first = count_columns(data)
    solutions = zeros(MOST_ON_SIDE * SIDE_SOLUTION)
    for i in range(count):
        row, result = rows[i * columns :], results[i * width :]
        inputs = SideRow(row[first:])
        problem = pushing_problem(read_effects(data, row), inputs)
        side = FlatSide(inputs.start, inputs.end)
        number = side_modes(problem.push, side, problem.law, problem.pusher, solutions)
        number = write_results(
            problem.rod, solutions, SIDE_SOLUTION, number, False, result, width, SIDE_RESULT
        )
        for j in range(number):
            solution = SideSolution(solutions[j * SIDE_SOLUTION :])
            written = SideResult(result[HEAD_OF_RESULTS + j * SIDE_RESULT :])
            flush: bool = solution.mode != SEPARATE and solution.touches_at == WHOLE_SIDE
            written.flush, written.position = flush, _position_of_force(side, solution)
            _write_end_forces(problem.law, solution, written.end_forces)


def _push_at(push: Push, x: float) -> Push:
    """The push of a point of the side at an abscissa of the fence."""
    contact = push.contact
    there = contact_at(contact.x + x * push.t_x, contact.y + x * push.t_y)
    return Push(push.effects, there, push.t_x, push.t_y)


def side_modes(push: Push, side: FlatSide, law: Law, pusher: Direction, solutions: Numbers) -> int:
    """Write every consistent solution in the order of the modes, flush ones first; return their number.

    These include contacts at one end; `flush_or_free_modes` has only those that a run looks for on a side.
    """
    flush, all_contacts = zeros(MOST_FLUSH * SOLUTION), zeros(MOST_ON_SIDE * SIDE_SOLUTION)
    count, scale, rest = _write_separate(push, side, pusher, SideSolution(solutions))
    if scale == 0.0:
        return count  # as for one point, a slider and a fence at rest count as separate
    held = FlushPush(
        push, side, law, w_x=pusher.x, w_y=pusher.y, spin=0.0, translation=resist_translation(push)
    )
    number = flush_modes(held, flush)
    for i in range(number):
        _write_contact(all_contacts, i, Solution(flush[i * SOLUTION :]), WHOLE_SIDE)
    for touches in range(SIDE_START, SIDE_END + 1):
        x, lifts = side.start, 1.0
        if touches == SIDE_END:
            x, lifts = side.end, -1.0
        end = End(touches, x, lifts, rest.x, rest.y + x * rest.spin)
        if number >= 0 and _can_lift(held, end):
            number = _add_at_end(held, end, pusher, all_contacts, number)
    if number < 0:
        return UNSOLVED
    for mode in range(STICK, SLIP_LEFT + 1):
        for touches in range(WHOLE_SIDE, SIDE_END + 1):
            for i in range(number):
                solution = SideSolution(all_contacts[i * SIDE_SOLUTION :])
                if solution.mode == mode and solution.touches_at == touches:
                    _write_contact(solutions, count, solution, touches)
                    count += 1
    return count


def _write_contact(solutions: Numbers, index: int, solution: Solution, touches: int) -> None:
    """Write a solution with the place where it touches the fence."""
    target = SideSolution(solutions[index * SIDE_SOLUTION :])
    copy_solution(target, solution)
    target.touches_at = touches


def _add_at_end(
    flush: FlushPush, end: End, pusher: Direction, all_contacts: Numbers, count: int
) -> int:
    """Add the contacts at one end that lift off the other, and return the number of contacts.

    Solutions with one twist count once, as flush. One without a rotation, to rounding, is flush even if no
    other solution is the same.
    """
    push, side = flush.push, flush.side
    points = zeros(MOST_SOLUTIONS * SOLUTION)
    lever = side.end - side.start + push.contact.reach
    number, _ = contact_modes(_push_at(push, end.x), flush.law, pusher, points)
    if number < 0:
        return UNSOLVED
    for i in range(number):
        point = Solution(points[i * SOLUTION :])
        turn = end.lifts * point.twist.spin
        speed = fabs(point.motion.x) + fabs(point.motion.y)
        is_flush: bool = fabs(turn) * lever <= COINCIDENT * speed
        if point.mode == SEPARATE or _is_added(end, point, all_contacts, count, lever, speed):
            continue
        if is_flush:
            at_start: bool = end.touches == SIDE_START
            point.start_force = point.force.y if at_start else 0.0
            point.end_force = 0.0 if at_start else point.force.y
        elif turn < 0.0:
            continue
        _write_contact(all_contacts, count, point, WHOLE_SIDE if is_flush else end.touches)
        count += 1
    return count


def _is_added(
    end: End, point: Solution, all_contacts: Numbers, count: int, lever: float, speed: float
) -> bool:
    """Whether a contact at an end is a flush solution, to rounding; together they are a continuum or not.

    If no force acts at the other end, the rotation can be a rounding error of the force's position, which
    a small support magnifies.
    """
    for i in range(count):
        solution = SideSolution(all_contacts[i * SIDE_SOLUTION :])
        other = solution.end_force if end.touches == SIDE_START else solution.start_force
        nearest = ALMOST_FLUSH if other == 0.0 else COINCIDENT
        apart = fabs(point.motion.x - solution.motion.x) + fabs(point.motion.y - solution.motion.y)
        apart += fabs(point.twist.spin) * lever
        is_flush: bool = solution.touches_at == WHOLE_SIDE
        if is_flush and solution.mode == point.mode and apart <= nearest * speed:
            solution.continuum = solution.continuum or point.continuum
            return True
    return False


def _can_lift(flush: FlushPush, end: End) -> bool:
    """Whether a contact at one end of the side can lift the other end off the fence.

    Psi is convex, so its gradient is monotone. A contact at the end, which has no torque about the end,
    therefore turns against the torque of the translation in which the end moves alike: a stick cannot lift
    against that of the translation with the fence. Without loads, a contact with a fence that retreats
    cannot lift against that of the translation along the fence either, since the law has no adhesion.
    """
    law, w_x, w_y = flush.law, flush.w_x, flush.w_y
    if w_x == 0.0 and w_y == 0.0:
        return True
    pulls: bool = w_y < 0.0 and not (law.rough or _is_loaded(flush))
    if pulls and _resists_lifting(flush, end, copysign(1.0, w_x), 0.0):
        return False
    if not _presses_other_end(flush, end, w_x, w_y):
        return True
    if not law.slips:
        return False
    return _can_slip(flush, end, law.left) or _can_slip(flush, end, law.right)


def _can_slip(flush: FlushPush, end: End, edge: Direction) -> bool:
    """Whether a contact at one end that slips under an edge can lift the other end, if a stick cannot.

    A slip is between the pusher's motion and the slowest slip, in which the end is as fast along the edge
    as without a contact. If friction and inertia both resist lifting in the translations with these two
    motions, the torque of all translations between them is least at one of the two. Without loads, a
    translation along the edge has a force along it, so no slip lifts against its torque either.
    """
    w_x, w_y = flush.w_x, flush.w_y
    if edge.x * (w_x - end.rest_x) + edge.y * (w_y - end.rest_y) <= 0.0:
        return False
    if not _is_loaded(flush) and _resists_lifting(flush, end, edge.x, edge.y):
        return False
    if edge.x == 0.0 or not _resists_lifting(flush, end, w_x, w_y):
        return True
    x = end.rest_x + edge.y * (end.rest_y - w_y) / edge.x
    speed = sqrt(x * x + w_y * w_y)
    if speed == 0.0 or not _resists_lifting(flush, end, x / speed, w_y / speed):
        return True
    return not _presses_other_end(flush, end, x, w_y)


def _is_loaded(flush: FlushPush) -> bool:
    load = flush.translation.load
    return load.x != 0.0 or load.y != 0.0 or load.spin != 0.0


def _presses_other_end(flush: FlushPush, end: End, x: float, y: float) -> bool:
    """Whether the other end of the side would have to push in a translation."""
    force, side = translation_force(flush.translation, x, y), flush.side
    torque = end.lifts * (force.torque - end.x * force.f_y)
    return torque / (side.end - side.start) > noise_at_ends(flush, force)


def _resists_lifting(flush: FlushPush, end: End, x: float, y: float) -> bool:
    """Whether both friction and inertia of a translation along a unit vector press the other end down."""
    still, lever = flush.translation, fabs(end.x) + flush.translation.lever
    one = end.lifts * ((still.weight_x - end.x * still.weight) * y - still.weight_y * x)
    two = end.lifts * ((still.mass_x - end.x * still.mass) * y - still.mass_y * x)
    holds_one: bool = still.weight == 0.0 or one > COINCIDENT * still.weight * lever
    holds_two: bool = still.mass == 0.0 or two > COINCIDENT * still.mass * lever
    return holds_one and holds_two


def _write_separate(
    push: Push, side: FlatSide, pusher: Direction, solution: SideSolution
) -> tuple[int, float, Vector]:
    """Write the motion without a contact force, if both ends move away from the fence.

    Returns
    -------
    count : int
        Number of solutions.
    scale : float
        Magnitude of the motions of fence and slider.
    rest : Vector
        The motion, of the origin of the side, in the fence frame.
    """
    rest, contact, t_x, t_y = (
        free_twist(push.effects, Vector(0.0, 0.0, 0.0)), push.contact, push.t_x, push.t_y,
    )  # fmt: skip
    u_x, u_y = rest.x - rest.spin * contact.y, rest.y + rest.spin * contact.x
    x, y = t_x * u_x + t_y * u_y, t_x * u_y - t_y * u_x
    at_start, at_end = y + side.start * rest.spin, y + side.end * rest.spin
    speed = 1.0 if pusher.x != 0.0 or pusher.y != 0.0 else 0.0
    scale = max(max(speed, fabs(x)), max(fabs(at_start), fabs(at_end)))
    if pusher.y > at_start or pusher.y > at_end:
        return 0, scale, Vector(x, y, rest.spin)
    for k in range(SIDE_SOLUTION):
        solution[k] = 0.0
    solution.mode = SEPARATE
    solution.pivot = foot_at_center(push.effects, rest)
    solution.twist.x = t_x * rest.x + t_y * rest.y
    solution.twist.y = t_x * rest.y - t_y * rest.x
    solution.twist.spin = rest.spin
    solution.motion.x, solution.motion.y = x, y
    return 1, scale, Vector(x, y, rest.spin)


def _position_of_force(side: FlatSide, solution: SideSolution) -> float:
    """Where the line of action of a force crosses the fence; NaN without one, or along the fence."""
    touches = solution.touches_at
    if touches != WHOLE_SIDE:
        return side.start if touches == SIDE_START else side.end
    at_start, at_end = solution.start_force, solution.end_force
    if solution.mode == SEPARATE or at_start + at_end == 0.0:
        return UNKNOWN
    return (side.start * at_start + side.end * at_end) / (at_start + at_end) + 0.0


def _write_end_forces(law: Law, solution: SideSolution, bounds: EndForces) -> None:
    """Write the lower and the upper bounds of the forces at both ends of the side."""
    for k in range(END_FORCES):
        bounds[k] = 0.0
    touches = solution.touches_at
    if solution.mode == SEPARATE:
        return
    if touches != WHOLE_SIDE:
        low, high = bounds.start_low, bounds.start_high
        if touches == SIDE_END:
            low, high = bounds.end_low, bounds.end_high
        for k in range(2):
            one, other = solution.force[k], solution.force_end[k]
            low[k], high[k] = min(one, other), max(one, other)
        return
    least, most = _tangential_at_start(law, solution)
    # Adding zero turns a negative zero into a positive one.
    bounds.start_low.x, bounds.start_high.x = least + 0.0, most + 0.0
    bounds.end_low.x, bounds.end_high.x = solution.force.x - most, solution.force.x - least
    bounds.start_low.y, bounds.start_high.y = solution.start_force, solution.start_force
    bounds.end_low.y, bounds.end_high.y = solution.end_force, solution.end_force


def _tangential_at_start(law: Law, solution: Solution) -> tuple[float, float]:
    """The range of the tangential force at the start of a side on the fence."""
    at_start, at_end, f_x = solution.start_force, solution.end_force, solution.force.x
    if solution.mode != STICK:
        total = at_start + at_end
        if total != 0.0:
            return f_x * (at_start / total), f_x * (at_start / total)
        return min(f_x, 0.0), max(f_x, 0.0)
    if law.rough or law.right.y == 0.0:
        if not law.closed and at_start == 0.0:
            return 0.0, 0.0
        if not law.closed and at_end == 0.0:
            return f_x, f_x
        return -INFINITY, INFINITY
    right, left = law.right.x / law.right.y, law.left.x / law.left.y
    low = max(left * at_start, f_x - right * at_end)
    high = min(right * at_start, f_x - left * at_end)
    # On an edge of the cone the range is a number, to rounding.
    middle = (low + high) / 2.0
    return min(low, middle), max(high, middle)
