"""The time-stepping integrator: steps of order 1, without events.

A step of length h minimizes ``|v+ - v|_M^2 / 2 + h D(v+)`` over the twist v+ at its end, subject to the
contact. This is the problem of a push from rest, with a velocity as the motion and inertia ``M / h`` about
the previous twist. A step uses the rod angle and the contact frame at its start. The contact's normal
motion is at least ``w_n - gap / h``, so that the gap never becomes negative; with a contact force it is
equal.

During contact, the contact point is advanced by its own motion and the slider's center follows from the
rod. A sticking contact therefore does not drift, and the gap is zero to rounding error for any step. A
finger of finite radius also rolls along the side. In flight, the slider's center is advanced. Over a fence,
the contact's path is then above its tangent, so the step's condition on the gap also keeps the true gap
nonnegative. Over a finger, the gap can become negative in flight by the order of the squared step; the next
step corrects it.

Effects dissipate the power at the end of a step. The rest of the work is attributed to the contact. In
flight it is the numerical dissipation, which is attributed to the first effect.
"""

from __future__ import annotations

from math import cos, sin

from planar_pushing.core.instant.directions import Rod
from planar_pushing.core.instant.solution import (
    SEPARATE,
    STICK,
    Solution,
)
from planar_pushing.core.motion.integration.log import (
    has_room_for_rows,
    log_row_at,
    write_place_of_force,
    write_state,
)
from planar_pushing.core.motion.integration.step_choice import CHOSEN, choose_twist
from planar_pushing.core.motion.kinematics.corner import leave_corner, leave_pocket, side_of_pocket
from planar_pushing.core.motion.kinematics.drag import (
    drag,
    load_work,
    write_powers,
)
from planar_pushing.core.motion.kinematics.fence import fence_path, policy_at, span_at
from planar_pushing.core.motion.kinematics.mode import NO_MODE, slip_side
from planar_pushing.core.motion.kinematics.rolling import enters_pockets, is_in_pocket, travel_rate
from planar_pushing.core.motion.kinematics.shapes import (
    Pose,
    center_height,
    center_position,
    contact_after_flight,
    contact_motion,
    from_world,
    kinetic_energy_of,
    pose_of,
    put_initial_state,
    to_body,
    to_contact,
    to_world,
)
from planar_pushing.core.motion.kinematics.system import (
    GOES_ON,
    INCONSISTENT,
    LAID_DOWN,
    RATES,
    STATE,
    TWO_CONTACTS,
    System,
    energies_of,
    is_massive,
    prepare_system,
    system_of,
    vector_of,
)
from planar_pushing.core.motion.kinematics.touch import name_contact
from planar_pushing.core.motion.kinematics.wall import (
    begin_at_wall,
    confine_finger,
    is_in_outline,
    meets_in_step,
    open_wall,
    pass_ends,
    room_on_piece,
    seat_finger,
)
from planar_pushing.core.numbers import Numbers, zeros
from planar_pushing.core.supports.rows import NO_POINT
from planar_pushing.core.supports.tolerances import SLACK

#: Maximum number of steps of a call, so that Python can handle an interrupt, and of rows per step.
STEPS_OF_CALL = 20000
ROWS_OF_STEP = 2
#: Number of rows of numbers that describe the intervals: ends, numbers of steps, and pieces.
INTERVAL_ROWS = 3


def run_steps(
    data: Numbers, rows: Numbers, count: int, columns: int, results: Numbers, width: int
) -> None:
    """Continue each run step by step, until it ends, its log is full, or many steps are done.

    Rows of inputs and of results are described in the module `run`.
    """
    steps = 0
    for i in range(count):
        system = system_of(data, rows[i * columns :], results[i * width :], INTERVAL_ROWS)
        run = system.run
        run.rows = 0
        if run.phase == 0:
            _begin_steps(system)
        while steps < STEPS_OF_CALL and not run.ended:
            if not has_room_for_rows(system, ROWS_OF_STEP, width):
                break
            _step(system)
            steps += 1


def _begin_steps(system: System) -> None:
    """Begin a run, with the state at time 0."""
    run = system.run
    prepare_system(system)
    begin_at_wall(system)
    put_initial_state(system, vector_of(system, STATE))
    name_contact(system, vector_of(system, STATE))
    run.phase, run.mode, run.pivot = 1, NO_MODE, NO_POINT
    run.pusher.y = -system.scene.gap
    for k in range(3):
        run.twist[k] = system.scene.twist[k]


def _step(system: System) -> None:
    """Take one step, and log the instants at which the mode changes or an interval ends."""
    run = system.run
    seat_finger(system, vector_of(system, STATE))
    if _choose(system):
        _log_step(system)
    if run.stopped == GOES_ON:
        pose = pose_of(system, vector_of(system, STATE))
        _account(system, pose)
        _move(system, pose)
        _end_contact(system)
        _count_step(system)
        if run.step == 0 or run.stopped != GOES_ON:
            _log_step(system)
    if run.stopped != GOES_ON or run.interval == system.scene.times:
        run.ended = True


def _interval_number(system: System, row: int) -> float:
    """Number of the current interval: its end, its number of steps, or its piece of the pusher's motion."""
    return system.times[row * system.scene.times + system.run.interval]


def _choose(system: System) -> bool:
    """Choose the twist at the end of the step by the policy, the first if several have the same mode.

    Returns whether the mode or the number of possible twists has changed.
    """
    run, start = system.run, system.run.interval_start
    part = (run.step + 1.0) / _interval_number(system, 1)
    run.until = start + (_interval_number(system, 0) - start) * part
    piece = int(_interval_number(system, 2))
    x, y = fence_path(system.fence, span_at(system.fence, piece), run.time, run.until)
    run.path.x, run.path.y = x, y
    room = zeros(CHOSEN)
    chosen = Solution(room[0:])
    current, before = run.mode, run.solutions
    policy, state = policy_at(system.fence, piece), vector_of(system, STATE)
    if is_in_pocket(system) and not enters_pockets(system):
        run.mode, run.stopped = NO_MODE, TWO_CONTACTS
        run.push.x, run.push.y = 0.0, 0.0
        return True
    choice = choose_twist(system, current, policy, chosen)
    if leave_corner(system, span_at(system.fence, piece), run.time, state, choice.contact):
        choice = choose_twist(system, current, policy, chosen)
    run.solutions = max(choice.number, 0)
    if choice.number <= 0:
        run.mode, run.stopped = NO_MODE, INCONSISTENT
        run.push.x, run.push.y = 0.0, 0.0
        return True
    unit = choice.unit
    v_x, v_y = to_world(system, state, unit * chosen.twist.x, unit * chosen.twist.y)
    f_x, f_y = to_world(system, state, chosen.force.x, chosen.force.y)
    run.new_twist.x, run.new_twist.y = unit * chosen.twist.x, unit * chosen.twist.y
    run.new_twist.spin = unit * chosen.twist.spin
    if is_in_pocket(system) and slip_side(choice.contact) != 0.0:
        leave_pocket(system, state, side_of_pocket(system, choice.contact))
        run.new_twist.x, run.new_twist.y = from_world(system, state, v_x, v_y)
    run.mode, run.pivot = choice.contact, chosen.pivot
    run.push.x, run.push.y, run.offset = f_x, f_y, choice.offset
    if not is_massive(system):
        run.twist.x, run.twist.y = v_x, v_y
        run.twist.spin = run.new_twist.spin
    return choice.contact != current or choice.number != before


def _account(system: System, pose: Pose) -> None:
    """Add the energies of the step."""
    run, state, rates = system.run, vector_of(system, STATE), vector_of(system, RATES)
    v_x, v_y, spin = run.new_twist.x, run.new_twist.y, run.new_twist.spin
    h = run.until - run.time
    x, y = from_world(system, state, run.twist.x, run.twist.y)
    work = run.push.x * run.path.x + run.push.y * run.path.y
    rest = work + kinetic_energy_of(system, pose, v_x=x, v_y=y, spin=run.twist.spin)
    rest -= kinetic_energy_of(system, pose, v_x, v_y, spin)
    x, y = to_body(pose.rod, v_x, v_y)
    total = drag(system, x, y, spin)
    power = total.f_x * x + total.f_y * y + total.torque * spin
    write_powers(system, x, y, spin, power, rates)
    energies = energies_of(system, state)
    for i in range(system.scene.resisting):
        energies[i] += h * rates[i]
    state.work += work
    state.lost += rest - h * power


def _move(system: System, pose: Pose) -> None:
    """Advance the slider and the pusher to the end of the step."""
    run, state = system.run, vector_of(system, STATE)
    h, contact = run.until - run.time, run.mode
    confine_finger(system, state)
    v_x, v_y, spin = run.new_twist.x, run.new_twist.y, run.new_twist.spin
    w_x, w_y = to_world(system, state, v_x, v_y)
    path_x, path_y = from_world(system, state, run.path.x, run.path.y)
    if contact == SEPARATE:
        open_wall(system, state)
        along, gap = contact_after_flight(
            system, pose, state, x=h * v_x, y=h * v_y, path_x=path_x, path_y=path_y, turn=h * spin
        )
        state.along, state.gap = along, gap
    else:
        state.gap, slip = 0.0, 0.0
        if contact != STICK:
            u_x, _ = contact_motion(pose, v_x, v_y, spin)
            slip = h * u_x - path_x
        state.slipped += slip
        state.along += travel_rate(system, 0.0, slip, h * spin)
    _turn(system, h, w_x, w_y, spin)
    run.pusher.x += run.path.x
    run.pusher.y += run.path.y
    run.time = run.until
    _add_load_work(system)


def _turn(system: System, h: float, v_x: float, v_y: float, spin: float) -> None:
    """Rotate the slider, whose center has a velocity in the world.

    With inertia, the motion of the center of mass is preserved.
    """
    run, state, scene = system.run, vector_of(system, STATE), system.scene
    angle = state.angle
    turned = angle + h * spin
    before = Rod(1.0, angle, cos(angle), sin(angle))
    after = Rod(1.0, turned, cos(turned), sin(turned))
    x, y = to_contact(before, scene.center.x, scene.center.y)
    new_x, new_y = to_contact(after, scene.center.x, scene.center.y)
    run.twist.x, run.twist.y = v_x + spin * (new_y - y), v_y - spin * (new_x - x)
    run.twist.spin, state.angle = spin, turned


def _add_load_work(system: System) -> None:
    """Add the work of the loads in the step; in flight, the rest of the energy goes to the first effect."""
    run, state = system.run, vector_of(system, STATE)
    x, y = center_position(system, pose_of(system, state), state, run.pusher.x, run.pusher.y)
    work = load_work(system, state.angle, x, y)
    state.lost += work - run.load_work
    run.load_work = work
    if run.push.x == 0.0 and run.push.y == 0.0 and system.scene.resisting > 0:
        energies_of(system, state)[0] += state.lost - run.contact_lost
        state.lost = run.contact_lost
    run.contact_lost = state.lost


def _end_contact(system: System) -> None:
    """Go past the ends of pieces, end the contact at that of a side without an outline, or stop."""
    run, state = system.run, vector_of(system, STATE)
    closed: bool = state.gap <= SLACK
    if closed and system.scene.chain > 0:
        seat_finger(system, state)
        passes: bool = room_on_piece(system, state) < -SLACK
        goes_on: bool = not meets_in_step(system, state) and pass_ends(system, state)
        if not goes_on or (passes and is_in_outline(system, state)):
            run.stopped = TWO_CONTACTS
    elif closed and room_on_piece(system, state) < -SLACK:
        run.parted = True
    if center_height(system, state) <= 0.0:
        run.stopped = LAID_DOWN


def _count_step(system: System) -> None:
    """Count the step, and its interval if it was the last step in it."""
    run = system.run
    run.step += 1
    if run.step == _interval_number(system, 1):
        run.interval_start, run.step = _interval_number(system, 0), 0
        run.interval += 1


def _log_step(system: System) -> None:
    """Log the current instant; the last row for an instant replaces previous ones."""
    run, state = system.run, vector_of(system, STATE)
    row = log_row_at(system, run.time)
    for k in range(2):
        row.pusher[k], row.force[k] = run.pusher[k], run.push[k]
    row.time, row.mode, row.pivot = run.time, run.mode, run.pivot
    row.solutions, row.stopped, row.event = (
        run.solutions,
        run.stopped,
        -1,
    )
    v_x, v_y = from_world(system, state, run.twist.x, run.twist.y)
    write_state(system, state, v_x, v_y, run.twist.spin, row)
    write_place_of_force(system, state, run.offset, row)
