"""Every consistent solution of a slider with up to four contacts at once, from rest.

Each contact is open, sticks, or slips to either side. With one closed contact, the solutions are those of
`contact_modes` at which no other contact closes. With several, they leave one twist, or a line of twists,
which is the line problem, and share the load as in `force_sets`.
"""

from __future__ import annotations

from math import sqrt

from planar_pushing.core.contacts.several_at_rest import add_at_rest, rests_with
from planar_pushing.core.contacts.several_frames import (
    CONTACT_FRAME,
    CONTACT_ROW,
    MOST_CONTACTS,
    MOST_OF_SEVERAL,
    ContactFrame,
    Several,
    SeveralRow,
    frame_of,
    keeps_modes,
    motions_of_modes,
    several_at,
    write_frame,
)
from planar_pushing.core.contacts.several_lines import (
    add_from_rest,
    add_on_line,
)
from planar_pushing.core.contacts.several_solutions import (
    HEAD_OF_SEVERAL,
    SEVERAL_SOLUTION,
    SeveralResults,
    SeveralSolution,
    add_balanced,
    add_solution,
    settle_solution,
    sharing_of,
    sort_solutions,
    unit_forces,
    write_unit_force,
)
from planar_pushing.core.contacts.twist_line import (
    length_of_twist,
)
from planar_pushing.core.contacts.unit_forces import (
    END_OF_FORCES,
    MOST_UNITS,
    UNIT_FORCE,
    ForceEnd,
    UnitForce,
    find_cancelling,
)
from planar_pushing.core.instant.cone import (
    Law,
)
from planar_pushing.core.instant.directions import (
    Direction,
    unit_x,
    unit_y,
)
from planar_pushing.core.instant.kernels import (
    CONSISTENT,
    CONTINUA,
    NONE,
    NOT_SOLVED,
    PIVOTS,
)
from planar_pushing.core.instant.modes import (
    contact_modes,
)
from planar_pushing.core.instant.solution import (
    MOST_SOLUTIONS,
    SEPARATE,
    SOLUTION,
    STICK,
    UNSOLVED,
    Push,
    Solution,
)
from planar_pushing.core.numbers import (
    UNKNOWN,
    Numbers,
    zeros,
)
from planar_pushing.core.supports.contact import (
    contact_at,
)
from planar_pushing.core.supports.free import (
    foot_at_center,
    free_twist,
)
from planar_pushing.core.supports.rows import (
    Vector,
    count_columns,
    read_effects,
    scale_effects,
)
from planar_pushing.core.supports.tolerances import (
    BALANCED,
    COINCIDENT,
)

#: Why no solution exists: unknown, the pushers close every motion in, or forces can cancel one another.
NO_REASON, JAMMED, WEDGED = range(3)


def all_solutions(several: Several, solutions: Numbers) -> int:
    """Write every consistent solution, in units of the fastest pusher, and return their number.

    Parameters
    ----------
    several : Several
    solutions : Numbers
        Room for `MOST_OF_SEVERAL`, as `SeveralSolution`.

    Returns
    -------
    int
        `UNSOLVED` if an iteration has not converged or there are more solutions than fit.

    Notes
    -----
    Solutions with one twist count once. Of them a contact is closed rather than open, even without a force,
    and sticks rather than slips. A contact that is neither pushed nor pulled at rest counts as open.
    """
    modes = zeros(MOST_CONTACTS)
    combinations, free = 1, free_twist(several.effects, Vector(0.0, 0.0, 0.0))
    falls: bool = free.x != 0.0 or free.y != 0.0 or free.spin != 0.0
    count = _add_free(several, free, solutions, 0)
    for i in range(several.number):
        count = _add_single(several, i, solutions, count)
        combinations *= 4
    for code in range(1, combinations):
        rest, closed, allowed = code, 0, True
        for i in range(several.number):
            mode = rest - 4 * (rest // 4)
            rest = rest // 4
            modes[i] = float(mode)
            if mode != SEPARATE:
                closed += 1
            if mode > STICK and not frame_of(several, i).inputs.slips:
                allowed = False
        if closed >= 2 and allowed and count >= 0:
            count = _add_closed(several, modes, falls, solutions, count)
    return sort_solutions(several, solutions, count)


def _add_free(several: Several, twist: Vector, solutions: Numbers, count: int) -> int:
    """Add the motion without any contact: rest, or that which loads cause."""
    modes, units = zeros(MOST_CONTACTS), zeros(MOST_UNITS * UNIT_FORCE)
    low, high = zeros(END_OF_FORCES), zeros(END_OF_FORCES)
    if not keeps_modes(several, modes, twist):
        return count
    sharing = sharing_of(several, modes, units, low=low, high=high)
    pivot = foot_at_center(several.effects, twist)
    return add_solution(
        several, sharing, twist, pivot, continuum=False, solutions=solutions, count=count
    )


def _add_single(several: Several, i: int, solutions: Numbers, count: int) -> int:
    """Add the solutions with one closed contact."""
    frame = frame_of(several, i)
    inputs = frame.inputs
    t_x, t_y = inputs.normal.y, -inputs.normal.x
    speed = sqrt(
        frame.pusher_along * frame.pusher_along + frame.pusher_across * frame.pusher_across
    )
    unit, x, y = 1.0, 0.0, 0.0
    if speed > 0.0:
        unit, x, y = speed, frame.pusher_along / speed, frame.pusher_across / speed
    push = Push(
        scale_effects(several.effects, 1.0, unit),
        contact_at(inputs.point.x, inputs.point.y),
        t_x,
        t_y,
    )
    law = Law(
        right=_direction_of(push, unit_x(inputs.right), unit_y(inputs.right)),
        left=_direction_of(push, unit_x(inputs.left), unit_y(inputs.left)),
        slips=inputs.slips,
        closed=inputs.closed,
        rough=inputs.rough,
    )
    alone, modes = zeros(MOST_SOLUTIONS * SOLUTION), zeros(MOST_CONTACTS)
    number, _ = contact_modes(push, law, _direction_of(push, x, y), alone)
    if number < 0:
        return UNSOLVED
    for k in range(number):
        one = Solution(alone[SOLUTION * k :])
        if one.mode == SEPARATE or count < 0:
            continue
        twist = Vector(
            unit * (t_x * one.twist.x - t_y * one.twist.y),
            unit * (t_y * one.twist.x + t_x * one.twist.y),
            unit * one.twist.spin,
        )
        for j in range(several.number):
            modes[j] = float(SEPARATE)
        # The slip of a contact alone is signed already.
        modes[i] = float(STICK)
        if not keeps_modes(several, modes, twist):
            continue
        if count == MOST_OF_SEVERAL:
            return UNSOLVED
        solution = SeveralSolution(solutions[SEVERAL_SOLUTION * count :])
        for m in range(SEVERAL_SOLUTION):
            solution[m] = 0.0
        solution.modes[i] = float(one.mode)
        solution.twist.x, solution.twist.y, solution.twist.spin = twist.x, twist.y, twist.spin
        solution.pivot, solution.continuum = one.pivot, one.continuum
        solution.low_forces[2 * i] = t_x * one.force.x - t_y * one.force.y
        solution.low_forces[2 * i + 1] = t_y * one.force.x + t_x * one.force.y
        solution.high_forces[2 * i] = t_x * one.force_end.x - t_y * one.force_end.y
        solution.high_forces[2 * i + 1] = t_y * one.force_end.x + t_x * one.force_end.y
        count = settle_solution(several, solutions, count)
    return count


def _direction_of(push: Push, x: float, y: float) -> Direction:
    """A direction in the frame of the contact; its angle is not needed."""
    return Direction(
        angle=0.0,
        x=x,
        y=y,
        along=push.t_x * x - push.t_y * y,
        across=-(push.t_y * x + push.t_x * y),
    )


def _add_closed(
    several: Several, modes: Numbers, falls: bool, solutions: Numbers, count: int
) -> int:
    """Add the solutions with several closed contacts in given modes.

    At rest the contacts are closed only if the slider falls without them.
    """
    motions = motions_of_modes(several, modes)
    at_rest: bool = falls and rests_with(several, modes)
    if motions.dimension != 0 and motions.dimension != 1 and not at_rest:
        return count
    units, low, high = (
        zeros(MOST_UNITS * UNIT_FORCE), zeros(END_OF_FORCES), zeros(END_OF_FORCES)
    )  # fmt: skip
    sharing = sharing_of(several, modes, units, low=low, high=high)
    if at_rest:
        count = add_at_rest(several, sharing, solutions, count)
    if motions.dimension < 0 or motions.dimension > 1:
        return count
    rests: bool = length_of_twist(motions.twist) <= COINCIDENT
    if motions.dimension == 0:
        if rests or not keeps_modes(several, modes, motions.twist):
            return count
        return add_balanced(
            several, sharing, motions.twist, BALANCED, continuum=False, solutions=solutions,
            count=count,
        )  # fmt: skip
    if rests:
        return add_from_rest(several, sharing, motions, solutions, count)
    return add_on_line(several, sharing, motions, solutions, count)


def reason_without_solution(several: Several) -> int:
    """Why there is no solution.

    The slider is jammed if no twist opens or keeps all gaps. By Farkas' lemma the normals are then
    dependent with coefficients, none negative, of which the pushers' motions make a positive sum. Otherwise
    it can be wedged: forces of the friction cones cancel one another, so that they have no bound.
    """
    units, low, high = (
        zeros(MOST_UNITS * UNIT_FORCE), zeros(END_OF_FORCES), zeros(END_OF_FORCES)
    )  # fmt: skip
    modes = zeros(MOST_CONTACTS)
    count = 0
    for i in range(several.number):
        frame = frame_of(several, i)
        count = write_unit_force(units, count, i, 1.0, frame.across, 0.0, 0.0)
        UnitForce(units[UNIT_FORCE * i :]).inner = frame.pusher_across
        modes[i] = float(STICK)
    find_cancelling(units, count, low, high)
    if ForceEnd(high).is_infinite:
        return JAMMED
    count = unit_forces(several, modes, units)
    return WEDGED if find_cancelling(units, count, low, high) else NO_REASON


def solve_contacts(
    data: Numbers, rows: Numbers, count: int, columns: int, results: Numbers, width: int
) -> None:
    """Every consistent solution of each slider with several contacts.

    After the effects, a row holds a `SeveralRow` for each contact. A row of results holds `SeveralResults`
    and as many solutions as fit, as `SeveralSolution`, or NaN.
    """
    first = count_columns(data)
    frames = zeros(MOST_CONTACTS * CONTACT_FRAME)
    solutions = zeros(MOST_OF_SEVERAL * SEVERAL_SOLUTION)
    contacts = (columns - first) // CONTACT_ROW
    for i in range(count):
        row, result = rows[i * columns :], results[i * width :]
        for k in range(contacts):
            contact = SeveralRow(row[first + CONTACT_ROW * k :])
            write_frame(contact, ContactFrame(frames[CONTACT_FRAME * k :]))
        several = several_at(read_effects(data, row), contacts, frames)
        number = write_solutions(solutions, all_solutions(several, solutions), result, width)
        if number == 0:
            SeveralResults(result).reason = reason_without_solution(several)


def write_solutions(solutions: Numbers, number: int, result: Numbers, width: int) -> int:
    """Write a row of results, with all solutions if they fit; return their number or `UNSOLVED`."""
    head = SeveralResults(result)
    for k in range(HEAD_OF_SEVERAL, width):
        result[k] = UNKNOWN
    head.count, head.status, head.reason = number, CONSISTENT, NO_REASON
    if number < 0 or HEAD_OF_SEVERAL + SEVERAL_SOLUTION * number > width:
        head.count, head.status = 0, NOT_SOLVED
        return UNSOLVED
    if number == 0:
        head.status = NONE
    for j in range(number):
        solution = SeveralSolution(solutions[SEVERAL_SOLUTION * j :])
        if solution.continuum:
            head.status = CONTINUA
        elif solution.pivot >= 0 and head.status == CONSISTENT:
            head.status = PIVOTS
        for m in range(SEVERAL_SOLUTION):
            result[HEAD_OF_SEVERAL + SEVERAL_SOLUTION * j + m] = solution[m]
    return number
