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
from planar_pushing.core.instant.pocket import modes_in_pocket
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
#: Distance, in radii, at which a force replaces a pure couple.
FAR = 1e6


class RodRow(Record):
    """Length and angle of the rod, with which the columns after the effects begin."""

    length: float
    angle: float


class PushRow(RodRow):
    """A push from rest.

    Attributes
    ----------
    right, left : float
        Angles of the edges of the law.
    slips, closed, rough : bool
        As in `Law`.
    pusher : float
        Angle of the pusher's motion.
    moves : bool
        Whether the pusher moves.
    pocket : float
        At an inner corner, half of the angle between the normals of its sides; otherwise 0.
    """

    right: float
    left: float
    slips: bool
    closed: bool
    rough: bool
    pusher: float
    moves: bool
    pocket: float


class ForceRow(RodRow):
    """A force through the contact.

    Attributes
    ----------
    force : float
        Its angle.
    norm : int
        What fixes the magnitude of the motion, `UNIT_MOTION` to `FORCE_SIZE`.
    magnitude : float
        Magnitude of the force for `FORCE_SIZE`.
    """

    force: float
    norm: int
    magnitude: float


class ConeRow(RodRow):
    """Angles of the right and of the left edge of a friction cone."""

    right: float
    left: float


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


class PushResults(Record):
    """Head of a row of results of `solve`: how many solutions follow it, and their status."""

    count: int
    status: int


class MotionResult(Record):
    """A motion in the results of `force_motions`, in the frame of the contact.

    Attributes
    ----------
    status : int
    twist, motion : Twist, Pair
        Of the slider's center, and of the contact.
    force : Pair
    angle : float
        Of the contact's motion.
    pivot : int
    spin_ratio : float
    center : Pair
        Motion center relative to the slider's center.
    """

    status: int
    twist: Twist
    motion: Pair
    force: Pair
    angle: float
    pivot: int
    spin_ratio: float
    center: Pair


class ConeResult(Record):
    """Edges of a motion cone, whether they are reached, and status."""

    right: float
    left: float
    reached: bool
    status: int


class WrenchRow(Record):
    """A force and a torque in the body frame."""

    x: float
    y: float
    torque: float


HEAD_OF_RESULTS, RESULT, MOTION = size_of(PushResults), size_of(PushResult), size_of(MotionResult)


class PushingProblem(NamedTuple):
    """A push, the contact law, the motion of the pusher, the rod, and `PushRow.pocket`."""

    push: Push
    law: Law
    pusher: Direction
    rod: Rod
    pocket: float


def solve(
    data: Numbers, rows: Numbers, count: int, columns: int, results: Numbers, width: int
) -> None:
    """Every consistent solution of each push.

    After the effects, a row holds a `PushRow`. A row of results holds `PushResults` and as many solutions
    as fit, as `PushResult`, or NaN.
    """
    first = count_columns(data)
    solutions = zeros(MOST_SOLUTIONS * SOLUTION)
    for i in range(count):
        row, result = rows[i * columns :], results[i * width :]
        problem = pushing_problem(read_effects(data, row), PushRow(row[first:]))
        if problem.pocket > 0.0:
            number, flat = modes_in_pocket(
                problem.push, problem.rod, problem.law, problem.pusher, problem.pocket, solutions
            )
        else:
            number, flat = contact_modes(problem.push, problem.law, problem.pusher, solutions)
        write_results(
            problem.rod,
            solutions,
            size=SOLUTION,
            number=number,
            flat=flat,
            result=result,
            width=width,
            columns_of_result=RESULT,
        )


def pushing_problem(effects: Effects, inputs: PushRow) -> PushingProblem:
    """The problem of a row of `solve`."""
    rod = rod_at(inputs.length, inputs.angle)
    law = Law(
        right=direction_at(rod, inputs.right),
        left=direction_at(rod, inputs.left),
        slips=inputs.slips,
        closed=inputs.closed,
        rough=inputs.rough,
    )
    pusher = direction_at(rod, inputs.pusher)
    if not inputs.moves:
        pusher = Direction(angle=inputs.pusher, x=0.0, y=0.0, along=0.0, across=0.0)
    push = Push(effects, contact_at(-rod.length, 0.0), rod.x, -rod.y)
    return PushingProblem(push, law, pusher, rod, inputs.pocket)


def write_results(
    rod: Rod, solutions: Numbers, size: int, number: int, flat: bool,
    result: Numbers, width: int, columns_of_result: int,
) -> int:  # fmt: skip
    """Write number, status and solutions in a row of results; return how many solutions are written.

    Each solution has `size` numbers in the core, and `columns_of_result` of the `width` columns of results.
    """
    status = CONTINUA if flat else NONE if number == 0 else CONSISTENT
    if number < 0 or HEAD_OF_RESULTS + number * columns_of_result > width:
        number, status = 0, NOT_SOLVED
    for k in range(HEAD_OF_RESULTS, width):
        result[k] = UNKNOWN
    for j in range(number):
        solution = Solution(solutions[j * size :])
        if solution.continuum:
            status = CONTINUA
        elif solution.pivot >= 0 and status == CONSISTENT:
            status = PIVOTS
        _write_result(rod, solution, PushResult(result[HEAD_OF_RESULTS + j * columns_of_result :]))
    head = PushResults(result)
    head.count, head.status = number, status
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

    After the effects, a row holds a `ForceRow`, and a row of results a `MotionResult`. If friction holds
    the slider, the status is `NONE`; without a motion, all of the result but the status is NaN.
    """
    first = count_columns(data)
    for i in range(count):
        row, numbers = rows[i * columns :], results[i * width :]
        inputs, result = ForceRow(row[first:]), MotionResult(numbers)
        effects, rod = read_effects(data, row), rod_at(inputs.length, inputs.angle)
        contact, force = contact_at(-rod.length, 0.0), direction_at(rod, inputs.force)
        norm, e_x, e_y = inputs.norm, force.along, -force.across
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
                motion = motion_with_norm(effects, contact, force, norm, inputs.magnitude)
            angle = force.angle + angle_from_force(motion, e_x, e_y)
        if status != CONTINUA and motion.point >= 0:
            status = PIVOTS
        _write_motion(rod, motion, result)
        result.angle, result.status = angle, status
        if not motion.converged:
            for k in range(width):
                numbers[k] = UNKNOWN
            result.status = NONE if inputs.magnitude > 0.0 else NOT_SOLVED


def _signed_spin_ratio(motion: ContactMotion) -> float:
    """R omega / v of a motion, infinite for a rotation about the origin."""
    speed = sqrt(motion.v_x * motion.v_x + motion.v_y * motion.v_y)
    if speed > 0.0:
        return motion.spin / speed
    return INFINITY if motion.spin > 0.0 else -INFINITY


def _write_motion(rod: Rod, motion: ContactMotion, result: MotionResult) -> None:
    """Write twist, motion of the contact, force, pivot, spin ratio and motion center."""
    _write_vector(rod, motion.v_x, motion.v_y, result.twist)
    result.twist.spin = motion.spin
    _write_vector(rod, motion.u_x, motion.u_y, result.motion)
    _write_vector(rod, motion.f_x, motion.f_y, result.force)
    center = motion_center(result.twist.x, result.twist.y, result.twist.spin)
    result.pivot, result.spin_ratio = motion.point, _signed_spin_ratio(motion)
    result.center.x, result.center.y = center.x, center.y


def _write_vector(rod: Rod, x: float, y: float, result: Pair) -> None:
    """Write a vector of the body frame in the frame of the contact."""
    result.x, result.y = rod.x * x - rod.y * y, rod.x * y + rod.y * x


def motion_cones(
    data: Numbers, rows: Numbers, count: int, columns: int, results: Numbers, width: int
) -> None:
    """The motion cone between two angles of forces.

    After the effects, a row holds a `ConeRow`, and a row of results a `ConeResult`.
    """
    first = count_columns(data)
    for i in range(count):
        row, result = rows[i * columns :], ConeResult(results[i * width :])
        inputs = ConeRow(row[first:])
        effects, rod = read_effects(data, row), rod_at(inputs.length, inputs.angle)
        contact = contact_at(-rod.length, 0.0)
        low = motion_angles(effects, rod, contact, direction_at(rod, inputs.right))
        high = motion_angles(effects, rod, contact, direction_at(rod, inputs.left))
        continuum: bool = low.continuum or high.continuum
        spread = max(low.largest - low.smallest, high.largest - high.smallest)
        status = CONTINUA if continuum else PIVOTS if low.pivots or high.pivots else CONSISTENT
        # Rounding can swap the edges of a long rod's cone, which can be narrower than an ulp.
        result.right, result.left = min(low.smallest, high.largest), high.largest
        result.reached, result.status = continuum or spread <= RESOLUTION, status
        if not (low.converged and high.converged):
            result.right, result.left = UNKNOWN, UNKNOWN
            result.reached, result.status = False, NOT_SOLVED


def wrenches(
    data: Numbers, rows: Numbers, count: int, columns: int, results: Numbers, width: int
) -> None:
    """The wrench in the body frame that sustains each twist; at rest, that of the loads alone.

    After the effects, a row holds the `Twist` of the origin, and a row of results a `WrenchRow`.
    """
    first = count_columns(data)
    for i in range(count):
        row, result = rows[i * columns :], WrenchRow(results[i * width :])
        effects, twist = read_effects(data, row), Twist(row[first:])
        if twist.x != 0.0 or twist.y != 0.0 or twist.spin != 0.0:
            total = resistance(effects, x=twist.x, y=twist.y, spin=twist.spin, blur=0.0)
            result.x, result.y, result.torque = total.f_x, total.f_y, total.torque
        else:
            load = load_wrench(effects)
            result.x, result.y, result.torque = -load.x, -load.y, -load.spin


def load_ratios(
    data: Numbers, rows: Numbers, count: int, columns: int, results: Numbers, width: int
) -> None:
    """The ratio of each load to the largest one that friction holds.

    After the effects of friction, a row holds the load as a `WrenchRow`. A row of results holds the ratio.
    """
    first = count_columns(data)
    for i in range(count):
        row = rows[i * columns :]
        effects, load = read_effects(data, row), WrenchRow(row[first:])
        x, y, torque = load.x, load.y, load.torque
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
        angle, result = rows[i * columns], Pair(results[i * width :])
        result.x, result.y = unit_x(angle), unit_y(angle)
