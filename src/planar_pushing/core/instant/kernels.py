"""The functions that Python calls: loops over the rows of an array, one row for each problem.

A row begins with the numbers of the effects, as `read_effects` reads them. Each kernel describes the
columns that follow. Here are those of a push; `solve_flush` is in `flush_solutions`, `responses` in
`sensitivity`, those of runs in `motion`, and those of pressures and outlines beside what they compute.
Angles are radians in the fence frame, lengths are in radii, and results are in the frame of the contact: x
along the fence and y along its normal into the slider.
"""

from __future__ import annotations

from math import fabs, sqrt
from typing import NamedTuple

from planar_pushing.core._record import Record, size_of
from planar_pushing.core.instant.cone import Law
from planar_pushing.core.instant.directions import (
    Direction,
    Rod,
    direction_at,
    motion_center,
    rod_at,
    spin_ratio,
    unit_x,
    unit_y,
)
from planar_pushing.core.instant.force import ContactMotion, motion_under_force, motions_under_force
from planar_pushing.core.instant.magnitude import (
    UNIT_MOTION,
    UNIT_SPEED,
    angle_from_force,
    is_ring_alone,
    motion_angles,
    motion_on_ring,
    motion_with_norm,
    ring_motion_angle,
)
from planar_pushing.core.instant.modes import contact_modes
from planar_pushing.core.instant.solution import (
    MOST_SOLUTIONS,
    SOLUTION,
    Pair,
    Push,
    Solution,
    Twist,
)
from planar_pushing.core.numbers import INFINITY, UNKNOWN, Numbers, zeros
from planar_pushing.core.supports.contact import contact_at
from planar_pushing.core.supports.resistance import load_wrench, resistance
from planar_pushing.core.supports.ring import ring_spin_ratio
from planar_pushing.core.supports.rows import Effects, count_columns, read_effects
from planar_pushing.core.supports.tolerances import RESOLUTION

#: Status of the solutions of a row.
NONE, CONSISTENT, PIVOTS, CONTINUA, NOT_SOLVED = range(5)
#: Number of columns of a motion in the results of `force_motions`.
MOTION_WIDTH = 13
#: Distance, in radii, at which a force replaces a pure couple.
FAR = 1e6


class PushResult(Record):
    """A solution in the results of `solve`, in the frame of the contact.

    Attributes
    ----------
    mode : int
    force, force_end : Pair
        The force, and the other end of its interval.
    twist, motion : Twist, Pair
        Of the slider, and of the contact.
    spin_ratio : float
    center : Pair
        Motion center relative to the contact, NaN at rest.
    pivot, continuum : int, bool
        As in `Solution`.
    """

    mode: int
    force: Pair
    force_end: Pair
    twist: Twist
    motion: Pair
    spin_ratio: float
    center: Pair
    pivot: int
    continuum: bool


RESULT = size_of(PushResult)


class PushingProblem(NamedTuple):
    """A push, the contact law, the motion of the pusher, and the rod."""

    push: Push
    law: Law
    pusher: Direction
    rod: Rod


def solve(
    data: Numbers, rows: Numbers, count: int, columns: int, results: Numbers, width: int
) -> None:
    """Every consistent solution of each push.

    After the effects, a row holds: length and angle of the rod; the edges of the law, right and left, and
    whether it slips, is closed, and is rough; angle of the pusher's motion; whether the pusher moves. A row
    of results holds: number of solutions; status; and as many solutions as fit, as `PushResult`, or NaN.
    """
    first = count_columns(data)
    solutions = zeros(MOST_SOLUTIONS * SOLUTION)
    for i in range(count):
        row, result = rows[i * columns :], results[i * width :]
        problem = pushing_problem(read_effects(data, row), row[first:])
        number, flat = contact_modes(problem.push, problem.law, problem.pusher, solutions)
        write_results(
            problem.rod,
            solutions,
            size=SOLUTION,
            number=number,
            flat=flat,
            result=result,
            width=width,
            columns_of_each=RESULT,
        )


def pushing_problem(effects: Effects, inputs: Numbers) -> PushingProblem:
    """The problem of a row of `solve`, from the numbers after its effects."""
    rod = rod_at(inputs[0], inputs[1])
    law = Law(
        right=direction_at(rod, inputs[2]),
        left=direction_at(rod, inputs[3]),
        slips=inputs[4] != 0.0,
        closed=inputs[5] != 0.0,
        rough=inputs[6] != 0.0,
    )
    pusher = direction_at(rod, inputs[7])
    if inputs[8] == 0.0:
        pusher = Direction(angle=inputs[7], x=0.0, y=0.0, along=0.0, across=0.0)
    push = Push(effects, contact_at(-rod.length, 0.0), rod.x, -rod.y)
    return PushingProblem(push, law, pusher, rod)


def write_results(
    rod: Rod, solutions: Numbers, size: int, number: int, flat: bool,
    result: Numbers, width: int, columns_of_each: int,
) -> int:  # fmt: skip
    """Write number, status and solutions in a row of results; return how many solutions are written.

    Each solution has `size` numbers in the core, and `columns_of_each` of the `width` columns of results.
    """
    status = CONTINUA if flat else NONE if number == 0 else CONSISTENT
    if number < 0 or 2 + number * columns_of_each > width:
        number, status = 0, NOT_SOLVED
    for k in range(2, width):
        result[k] = UNKNOWN
    for j in range(number):
        solution = Solution(solutions[j * size :])
        if solution.continuum:
            status = CONTINUA
        elif solution.pivot >= 0 and status == CONSISTENT:
            status = PIVOTS
        _write_result(rod, solution, PushResult(result[2 + j * columns_of_each :]))
    result[0], result[1] = float(number), float(status)
    return number


def _write_result(rod: Rod, solution: Solution, result: PushResult) -> None:
    """Write a solution, its spin ratio, and its motion center."""
    v_x, v_y, spin = solution.twist.x, solution.twist.y, solution.twist.spin
    center = motion_center(v_x, v_y, spin)
    moves: bool = v_x != 0.0 or v_y != 0.0 or spin != 0.0
    result.mode = solution.mode
    for k in range(2):
        result.force[k], result.force_end[k] = solution.force[k], solution.force_end[k]
        result.motion[k] = solution.motion[k]
    result.twist.x, result.twist.y, result.twist.spin = v_x, v_y, spin
    result.spin_ratio = spin_ratio(v_x, v_y, spin)
    result.center.x = rod.length * rod.x + center.x if moves else UNKNOWN
    result.center.y = rod.length * rod.y + center.y if moves else UNKNOWN
    result.pivot, result.continuum = solution.pivot, solution.continuum


def force_motions(
    data: Numbers, rows: Numbers, count: int, columns: int, results: Numbers, width: int
) -> None:
    """The motion under each force.

    After the effects, a row holds: length and angle of the rod; angle of the force; the norm that fixes the
    magnitude of the motion, `UNIT_MOTION` to `UNIT_ENERGY`, and the magnitude of the force for
    `FORCE_SIZE`. A row of results holds: status, `NONE` if friction holds the slider; twist of the origin;
    motion of the contact; force; angle of the contact's motion; number of the pivot; spin ratio; motion
    center relative to the slider's center. Without a motion, all of them but the status are NaN.
    """
    first = count_columns(data)
    for i in range(count):
        row, result = rows[i * columns :], results[i * width :]
        inputs = row[first:]
        effects, rod = read_effects(data, row), rod_at(inputs[0], inputs[1])
        contact, force, norm = (
            contact_at(-rod.length, 0.0),
            direction_at(rod, inputs[2]),
            int(inputs[3]),
        )
        e_x, e_y = force.along, -force.across
        status = CONSISTENT
        if norm == UNIT_SPEED and is_ring_alone(effects):
            motion = motion_on_ring(rod, contact, force)
            angle = ring_motion_angle(rod, force, ring_spin_ratio(rod.length * force.across))
        else:
            if norm == UNIT_MOTION:
                ends = motions_under_force(effects, contact, e_x, e_y, 1.0)
                motion = ends.first
                if ends.first.continuum:
                    status, motion = CONTINUA, motion_under_force(effects, contact, e_x, e_y, 1.0)
            else:
                motion = motion_with_norm(effects, contact, force, norm, inputs[4])
            angle = force.angle + angle_from_force(motion, e_x, e_y)
        if status != CONTINUA and motion.point >= 0:
            status = PIVOTS
        result[0], result[8], result[9] = float(status), angle, float(motion.point)
        _write_motion(rod, motion, result[1:])
        center = motion_center(result[1], result[2], result[3])
        result[10] = _signed_spin_ratio(motion)
        result[11], result[12] = center.x, center.y
        if not motion.converged:
            result[0] = float(NONE if inputs[4] > 0.0 else NOT_SOLVED)
            for k in range(1, width):
                result[k] = UNKNOWN


def _signed_spin_ratio(motion: ContactMotion) -> float:
    """R omega / v of a motion, infinite for a rotation about the origin."""
    speed = sqrt(motion.v_x * motion.v_x + motion.v_y * motion.v_y)
    if speed > 0.0:
        return motion.spin / speed
    return INFINITY if motion.spin > 0.0 else -INFINITY


def _write_motion(rod: Rod, motion: ContactMotion, result: Numbers) -> None:
    """Write twist, motion of the contact, and force."""
    _write_vector(rod, motion.v_x, motion.v_y, result)
    result[2] = motion.spin
    _write_vector(rod, motion.u_x, motion.u_y, result[3:])
    _write_vector(rod, motion.f_x, motion.f_y, result[5:])


def _write_vector(rod: Rod, x: float, y: float, result: Numbers) -> None:
    """Write a vector of the body frame in the frame of the contact."""
    result[0], result[1] = rod.x * x - rod.y * y, rod.x * y + rod.y * x


def motion_cones(
    data: Numbers, rows: Numbers, count: int, columns: int, results: Numbers, width: int
) -> None:
    """The motion cone between two angles of forces.

    After the effects, a row holds: length and angle of the rod; angles of the right and the left edge of
    the friction cone. A row of results holds: right and left edge, whether they are reached, status.
    """
    first = count_columns(data)
    for i in range(count):
        row, result = rows[i * columns :], results[i * width :]
        inputs = row[first:]
        effects, rod = read_effects(data, row), rod_at(inputs[0], inputs[1])
        contact = contact_at(-rod.length, 0.0)
        low = motion_angles(effects, rod, contact, direction_at(rod, inputs[2]))
        high = motion_angles(effects, rod, contact, direction_at(rod, inputs[3]))
        continuum: bool = low.continuum or high.continuum
        spread = max(low.largest - low.smallest, high.largest - high.smallest)
        status = CONTINUA if continuum else PIVOTS if low.pivots or high.pivots else CONSISTENT
        # Rounding can swap the edges of a long rod's cone, which can be narrower than an ulp.
        result[0], result[1] = min(low.smallest, high.largest), high.largest
        result[2] = 1.0 if continuum or spread <= RESOLUTION else 0.0
        result[3] = float(status)
        if not (low.converged and high.converged):
            result[0], result[1], result[2], result[3] = UNKNOWN, UNKNOWN, 0.0, float(NOT_SOLVED)


def wrenches(
    data: Numbers, rows: Numbers, count: int, columns: int, results: Numbers, width: int
) -> None:
    """The wrench in the body frame that sustains each twist; at rest, that of the loads alone.

    After the effects, a row holds the twist of the origin. A row of results holds force and torque.
    """
    first = count_columns(data)
    for i in range(count):
        row, result = rows[i * columns :], results[i * width :]
        effects, twist = read_effects(data, row), row[first:]
        if twist[0] != 0.0 or twist[1] != 0.0 or twist[2] != 0.0:
            total = resistance(effects, x=twist[0], y=twist[1], spin=twist[2], blur=0.0)
            result[0], result[1], result[2] = total.f_x, total.f_y, total.torque
        else:
            load = load_wrench(effects)
            result[0], result[1], result[2] = -load.x, -load.y, -load.spin


def load_ratios(
    data: Numbers, rows: Numbers, count: int, columns: int, results: Numbers, width: int
) -> None:
    """The ratio of each load to the largest one that friction holds.

    After the effects of friction, a row holds the wrench of the load. A row of results holds the ratio.
    """
    first = count_columns(data)
    for i in range(count):
        row = rows[i * columns :]
        effects, load = read_effects(data, row), row[first:]
        x, y, torque = load[0], load[1], load[2]
        if fabs(x) + fabs(y) <= fabs(torque) / FAR:
            x, y = fabs(torque) / FAR, 0.0
        size = sqrt(x * x + y * y)
        results[i * width] = 0.0
        if size > 0.0:
            # The load is equivalent to a pusher's force at the point of its line of action nearest the
            # origin.
            contact = contact_at(y * torque / (size * size), -x * torque / (size * size))
            limit = motion_under_force(effects, contact, e_x=x / size, e_y=y / size, along=1.0)
            force = sqrt(limit.f_x * limit.f_x + limit.f_y * limit.f_y)
            results[i * width] = size / force if force > 0.0 else INFINITY


def unit_vectors(
    data: Numbers, rows: Numbers, count: int, columns: int, results: Numbers, width: int
) -> None:
    """The unit vector at each angle, exact at multiples of 90 degrees."""
    for i in range(count):
        angle, result = rows[i * columns], results[i * width :]
        result[0], result[1] = unit_x(angle), unit_y(angle)
