"""Every consistent solution of a slider between two fingers, one of which presses with a given force.

The fingers are on one line, with opposite normals. One moves as given. The other is driven by force: it
follows the slider along the normal, presses with that force, and moves as given along its tangent only. Its
normal force is a load, and so is its friction if it slips, while its friction if it sticks is a force along
the tangent that the law bounds. Friction alone resists, and there is no other support than friction.

Two motions are left along a line of twists, on which the line problem finds all. Where both fingers slip,
or one alone touches, friction bears a wrench on a line of wrenches. It is then on the limit surface, which
a line meets twice at most, and its normal there is the direction of the motion.
"""

from __future__ import annotations

from math import fabs

from planar_pushing.core.contacts.gripped_at_rest import add_grip_at_rest
from planar_pushing.core.contacts.gripped_frames import (
    GRIP_ROW,
    Grip,
    GripRow,
    add_gripped,
    balance_grip,
    can_slip,
    force_of_press,
    grip_at,
    pull_of,
    write_grip_force,
)
from planar_pushing.core.contacts.limit_line import add_multiple, surface_at, write_crossings
from planar_pushing.core.contacts.line_problem import (
    LINE_ROOT,
    MOST_ON_LINE,
    LineRoot,
    find_on_line,
)
from planar_pushing.core.contacts.several import write_solutions
from planar_pushing.core.contacts.several_frames import (
    CONTACT_FRAME,
    CONTACT_ROW,
    MOST_CONTACTS,
    MOST_OF_SEVERAL,
    ContactFrame,
    SeveralRow,
    as_vector,
    cross_vectors,
    frame_of,
    keeps_modes,
    slip_rate,
    write_frame,
)
from planar_pushing.core.contacts.several_lines import ANY_LOAD
from planar_pushing.core.contacts.several_solutions import (
    SEVERAL_SOLUTION,
    load_of,
    sort_solutions,
)
from planar_pushing.core.contacts.twist_line import (
    dot_vectors,
    give_force,
    length_of_twist,
    line_through,
    scale_vector,
    twist_on_line,
)
from planar_pushing.core.instant.directions import QUARTER_TURN
from planar_pushing.core.instant.force import ContactMotion
from planar_pushing.core.instant.solution import (
    SEPARATE,
    SLIP_LEFT,
    SLIP_RIGHT,
    STICK,
    UNSOLVED,
)
from planar_pushing.core.numbers import INFINITY, Numbers, zeros
from planar_pushing.core.supports.resistance import resistance
from planar_pushing.core.supports.rows import (
    NO_POINT,
    Vector,
    count_columns,
    read_effects,
)
from planar_pushing.core.supports.tolerances import BALANCED, COINCIDENT, SLOW


def _edge_of(frame: ContactFrame, mode: int) -> Vector:
    """Unit force of a slip."""
    return as_vector(frame.left) if mode == SLIP_RIGHT else as_vector(frame.right)


def _twist_of(motion: ContactMotion) -> Vector:
    return Vector(motion.v_x, motion.v_y, motion.spin)


def _add_balanced(
    grip: Grip, modes: Numbers, twist: Vector, slack: float, continuum: bool, solutions: Numbers,
    count: int,
) -> int:  # fmt: skip
    """Add a motion if it keeps the modes and the fingers can balance its load within their laws."""
    several = grip.several
    if count < 0 or not keeps_modes(several, modes, twist) or length_of_twist(twist) <= COINCIDENT:
        return count
    load = load_of(several, twist)
    forces = zeros(8)
    if not balance_grip(grip, modes, load, slack, forces):
        return count
    pivot, blur = NO_POINT, SLOW * length_of_twist(twist)
    if load.limit > 0.0:
        pivot = resistance(several.effects, twist.x, twist.y, twist.spin, blur).point
    return add_gripped(
        grip, modes, twist, pivot, forces, continuum=continuum, solutions=solutions, count=count
    )


def _add_on_line(
    grip: Grip, modes: Numbers, start: Vector, step: Vector, probe: Vector, solutions: Numbers,
    count: int,
) -> int:  # fmt: skip
    """Add the motions on a line of twists at which the load has no power along a probe."""
    if count < 0 or length_of_twist(start) <= COINCIDENT:
        return count
    given = force_of_press(grip, int(modes[grip.pressed]))
    line = give_force(
        line_through(grip.several.effects, start, step, probe), add_multiple(given, 1.0, grip.load)
    )
    roots = zeros(MOST_ON_LINE * LINE_ROOT)
    number = find_on_line(line, -INFINITY, INFINITY, roots)
    if number < 0:
        return UNSOLVED
    for k in range(number):
        root = LineRoot(roots[LINE_ROOT * k :])
        if fabs(root.angle) < QUARTER_TURN - COINCIDENT:
            count = _add_balanced(
                grip, modes, twist_on_line(line, root.angle), ANY_LOAD, continuum=root.continuum,
                solutions=solutions, count=count,
            )  # fmt: skip
    return count


def _rotation_about(frame: ContactFrame) -> Vector:
    """The unit rotation about a finger."""
    return Vector(frame.inputs.point.y, -frame.inputs.point.x, 1.0)


def _translation_with(across: Vector, normal: float, along: Vector, tangent: float) -> Vector:
    """The translation with given components along a normal and a tangent."""
    return Vector(normal * across.x + tangent * along.x, normal * across.y + tangent * along.y, 0.0)


def _add_with_stick(grip: Grip, solutions: Numbers, count: int) -> int:
    """Add the motions at which both fingers touch and one sticks, or both."""
    several = grip.several
    held, press = frame_of(several, grip.held), frame_of(several, grip.pressed)
    across, along = as_vector(held.across), as_vector(held.along)
    modes = zeros(MOST_CONTACTS)
    modes[grip.held], modes[grip.pressed] = float(STICK), float(STICK)
    start = _translation_with(across, held.pusher_across, along, held.pusher_along)
    step = _rotation_about(held)
    turn = dot_vectors(as_vector(press.along), step)
    both = add_multiple(start, -slip_rate(press, start) / turn, step)
    count = _add_balanced(
        grip, modes, both, BALANCED, continuum=False, solutions=solutions, count=count
    )
    for mode in range(SLIP_RIGHT, SLIP_LEFT + 1):
        if can_slip(grip, grip.pressed):
            modes[grip.held], modes[grip.pressed] = float(STICK), float(mode)
            count = _add_on_line(grip, modes, start, step, step, solutions=solutions, count=count)
    start = _translation_with(
        across, held.pusher_across, as_vector(press.along), press.pusher_along
    )
    step = _rotation_about(press)
    for mode in range(SLIP_RIGHT, SLIP_LEFT + 1):
        if can_slip(grip, grip.held):
            modes[grip.held], modes[grip.pressed] = float(mode), float(STICK)
            probe = cross_vectors(_edge_of(held, mode), as_vector(press.along))
            count = _add_on_line(grip, modes, start, step, probe, solutions=solutions, count=count)
    return count


def _add_crossings(
    grip: Grip, modes: Numbers, unit: Vector, row: Vector, value: float, i: int, most: float,
    solutions: Numbers, count: int,
) -> int:  # fmt: skip
    """Add the motions under the given forces and a multiple of a unit force of one finger.

    The motion's power with the row of the finger has a value.
    """
    given = force_of_press(grip, int(modes[grip.pressed]))
    start = add_multiple(given, 1.0, grip.load)
    parts = zeros(2)
    number = write_crossings(grip.several.effects, start, unit, parts)
    for k in range(number):
        part, wrench = parts[k], add_multiple(start, parts[k], unit)
        surface = surface_at(grip.several.effects, wrench)
        twist = _twist_of(surface.motion)
        rate = dot_vectors(row, twist)
        if count < 0 or not surface.motion.converged:
            return UNSOLVED
        if part > most or not rate * value > 0.0:
            continue
        twist = scale_vector(twist, value / rate)
        if not keeps_modes(grip.several, modes, twist):
            continue
        forces = zeros(8)
        write_grip_force(given, grip.pressed, forces)
        write_grip_force(scale_vector(unit, part), i, forces)
        count = add_gripped(
            grip, modes, twist, surface.motion.point, forces, continuum=surface.motion.continuum,
            solutions=solutions, count=count,
        )  # fmt: skip
    return count


def _add_without_stick(grip: Grip, solutions: Numbers, count: int) -> int:
    """Add the motions at which both fingers slip, or the one that presses alone moves the slider."""
    several = grip.several
    held, press = frame_of(several, grip.held), frame_of(several, grip.pressed)
    modes = zeros(MOST_CONTACTS)
    for mode in range(SLIP_RIGHT, SLIP_LEFT + 1):
        for other in range(SLIP_RIGHT, SLIP_LEFT + 1):
            if can_slip(grip, grip.held) and can_slip(grip, grip.pressed):
                modes[grip.held], modes[grip.pressed] = float(mode), float(other)
                count = _add_crossings(
                    grip, modes, _edge_of(held, mode), as_vector(held.across), held.pusher_across,
                    grip.held, INFINITY, solutions=solutions, count=count,
                )  # fmt: skip
        modes[grip.held], modes[grip.pressed] = float(SEPARATE), float(STICK)
        sign = 1.0 if mode == SLIP_LEFT else -1.0
        along = scale_vector(as_vector(press.along), sign)
        count = _add_crossings(
            grip, modes, along, along, sign * press.pusher_along, grip.pressed,
            grip.force * fabs(pull_of(press, mode)), solutions=solutions, count=count,
        )  # fmt: skip
    return count


def _all_gripped(grip: Grip, solutions: Numbers) -> int:
    """Write every consistent solution, in units of the faster finger, and return their number."""
    count = add_grip_at_rest(grip, solutions, 0)
    count = _add_with_stick(grip, solutions, count)
    count = _add_without_stick(grip, solutions, count)
    return sort_solutions(grip.several, solutions, count)


def solve_gripped(
    data: Numbers, rows: Numbers, count: int, columns: int, results: Numbers, width: int
) -> None:
    """Every consistent solution of each slider between a finger and one that is driven by force.

    After the effects, which are friction alone, a row holds a `GripRow` and a `SeveralRow` for each finger.
    A row of results is as in `solve_contacts`.
    """
    first = count_columns(data)
    frames = zeros(MOST_CONTACTS * CONTACT_FRAME)
    solutions = zeros(MOST_OF_SEVERAL * SEVERAL_SOLUTION)
    for i in range(count):
        row, result = rows[i * columns :], results[i * width :]
        for k in range(2):
            contact = SeveralRow(row[first + GRIP_ROW + CONTACT_ROW * k :])
            write_frame(contact, ContactFrame(frames[CONTACT_FRAME * k :]))
        grip = grip_at(frames, read_effects(data, row), GripRow(row[first:]))
        _ = write_solutions(solutions, _all_gripped(grip, solutions), result, width)
