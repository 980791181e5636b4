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

from planar_pushing.core.directions import Rod
from planar_pushing.core.drag import (
    drag,
    load_work,
    write_powers,
)
from planar_pushing.core.fence import fence_path, policy_at, span_at
from planar_pushing.core.log import has_room_for_rows, log_row_at, write_place_of_force, write_state
from planar_pushing.core.numbers import Numbers, zeros
from planar_pushing.core.rows import NO_POINT
from planar_pushing.core.run import (
    IN_GAP,
    IN_MASS_X,
    IN_MASS_Y,
    IN_RESISTING,
    IN_TIMES,
    IN_TWIST,
    LOG_EVENT,
    LOG_FORCE,
    LOG_MODE,
    LOG_PIVOT,
    LOG_PUSHER,
    LOG_SOLUTIONS,
    LOG_STOPPED,
    LOG_TIME,
    RUN_CONTACT_LOST,
    RUN_ENDED,
    RUN_INTERVAL,
    RUN_INTERVAL_START,
    RUN_LOAD_WORK,
    RUN_MODE,
    RUN_NEW_TWIST,
    RUN_OFFSET,
    RUN_PARTED,
    RUN_PATH,
    RUN_PHASE,
    RUN_PIVOT,
    RUN_PUSH,
    RUN_PUSHER,
    RUN_ROWS,
    RUN_SOLUTIONS,
    RUN_STEP,
    RUN_STOPPED,
    RUN_TIME,
    RUN_TWIST,
    RUN_UNTIL,
)
from planar_pushing.core.shapes import (
    Pose,
    center_height,
    center_position,
    confine_finger,
    contact_after_flight,
    contact_motion,
    from_world,
    has_finger,
    is_outlined,
    kinetic_energy_of,
    outline_height,
    pose_of,
    put_initial_state,
    room_on_side,
    to_body,
    to_contact,
    to_world,
    travel_rate,
)
from planar_pushing.core.solution import (
    FORCE,
    PIVOT,
    SEPARATE,
    STICK,
    TWIST,
)
from planar_pushing.core.step_choice import CHOSEN, choose_twist
from planar_pushing.core.system import (
    ALONG,
    ANGLE,
    GAP,
    GOES_ON,
    INCONSISTENT,
    LAID_DOWN,
    LOST,
    MET_OUTLINE,
    NO_MODE,
    RATES,
    SIDE_ENDED,
    SLIPPED,
    STATE,
    WORK,
    System,
    energies_of,
    is_massive,
    prepare_system,
    system_of,
    vector_of,
)
from planar_pushing.core.tolerances import SLACK
from planar_pushing.core.touch import name_contact

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
        run[RUN_ROWS] = 0.0
        if run[RUN_PHASE] == 0.0:
            _begin_steps(system)
        while steps < STEPS_OF_CALL and run[RUN_ENDED] == 0.0:
            if not has_room_for_rows(system, ROWS_OF_STEP, width):
                break
            _step(system)
            steps += 1


def _begin_steps(system: System) -> None:
    """Begin a run, with the state at time 0."""
    run = system.run
    prepare_system(system)
    put_initial_state(system, vector_of(system, STATE))
    name_contact(system, vector_of(system, STATE))
    run[RUN_PHASE], run[RUN_MODE], run[RUN_PIVOT] = 1.0, float(NO_MODE), float(NO_POINT)
    run[RUN_PUSHER + 1] = -system.scene[IN_GAP]
    for k in range(3):
        run[RUN_TWIST + k] = system.scene[IN_TWIST + k]


def _step(system: System) -> None:
    """Take one step, and log the instants at which the mode changes or an interval ends."""
    run = system.run
    if _choose(system):
        _log_step(system)
    if run[RUN_STOPPED] == float(GOES_ON):
        pose = pose_of(system, vector_of(system, STATE))
        _account(system, pose)
        _move(system, pose)
        _end_contact(system)
        _count_step(system)
        if run[RUN_STEP] == 0.0 or run[RUN_STOPPED] != float(GOES_ON):
            _log_step(system)
    if run[RUN_STOPPED] != float(GOES_ON) or run[RUN_INTERVAL] == system.scene[IN_TIMES]:
        run[RUN_ENDED] = 1.0


def _interval_number(system: System, row: int) -> float:
    """Number of the current interval: its end, its number of steps, or its piece of the pusher's motion."""
    return system.times[row * int(system.scene[IN_TIMES]) + int(system.run[RUN_INTERVAL])]


def _choose(system: System) -> bool:
    """Choose the twist at the end of the step by the policy, the first if several have the same mode.

    Returns whether the mode or the number of possible twists has changed.
    """
    run, start = system.run, system.run[RUN_INTERVAL_START]
    part = (run[RUN_STEP] + 1.0) / _interval_number(system, 1)
    run[RUN_UNTIL] = start + (_interval_number(system, 0) - start) * part
    piece = int(_interval_number(system, 2))
    x, y = fence_path(system.fence, span_at(system.fence, piece), run[RUN_TIME], run[RUN_UNTIL])
    run[RUN_PATH], run[RUN_PATH + 1] = x, y
    room = zeros(CHOSEN)
    chosen = room[0:]
    current, before = int(run[RUN_MODE]), int(run[RUN_SOLUTIONS])
    choice = choose_twist(system, current, policy_at(system.fence, piece), chosen)
    run[RUN_SOLUTIONS] = float(max(choice.number, 0))
    if choice.number <= 0:
        run[RUN_MODE], run[RUN_STOPPED] = float(NO_MODE), float(INCONSISTENT)
        run[RUN_PUSH], run[RUN_PUSH + 1] = 0.0, 0.0
        return True
    unit, angle = choice.unit, vector_of(system, STATE)[ANGLE]
    v_x, v_y = to_world(system, angle, unit * chosen[TWIST], unit * chosen[TWIST + 1])
    f_x, f_y = to_world(system, angle, chosen[FORCE], chosen[FORCE + 1])
    run[RUN_NEW_TWIST], run[RUN_NEW_TWIST + 1] = unit * chosen[TWIST], unit * chosen[TWIST + 1]
    run[RUN_NEW_TWIST + 2] = unit * chosen[TWIST + 2]
    run[RUN_MODE], run[RUN_PIVOT] = float(choice.contact), chosen[PIVOT]
    run[RUN_PUSH], run[RUN_PUSH + 1], run[RUN_OFFSET] = f_x, f_y, choice.offset
    if not is_massive(system):
        run[RUN_TWIST], run[RUN_TWIST + 1] = v_x, v_y
        run[RUN_TWIST + 2] = run[RUN_NEW_TWIST + 2]
    return choice.contact != current or choice.number != before


def _account(system: System, pose: Pose) -> None:
    """Add the energies of the step."""
    run, state, rates = system.run, vector_of(system, STATE), vector_of(system, RATES)
    v_x, v_y, spin = run[RUN_NEW_TWIST], run[RUN_NEW_TWIST + 1], run[RUN_NEW_TWIST + 2]
    h = run[RUN_UNTIL] - run[RUN_TIME]
    x, y = from_world(system, state[ANGLE], run[RUN_TWIST], run[RUN_TWIST + 1])
    work = run[RUN_PUSH] * run[RUN_PATH] + run[RUN_PUSH + 1] * run[RUN_PATH + 1]
    rest = work + kinetic_energy_of(system, pose, x, y, run[RUN_TWIST + 2])
    rest -= kinetic_energy_of(system, pose, v_x, v_y, spin)
    x, y = to_body(pose.rod, v_x, v_y)
    total = drag(system, x, y, spin)
    power = total.f_x * x + total.f_y * y + total.torque * spin
    write_powers(system, x, y, spin, power, rates)
    energies = energies_of(system, state)
    for i in range(int(system.scene[IN_RESISTING])):
        energies[i] += h * rates[i]
    state[WORK] += work
    state[LOST] += rest - h * power


def _move(system: System, pose: Pose) -> None:
    """Advance the slider and the pusher to the end of the step."""
    run, state = system.run, vector_of(system, STATE)
    h, contact = run[RUN_UNTIL] - run[RUN_TIME], int(run[RUN_MODE])
    confine_finger(system, state)
    v_x, v_y, spin = run[RUN_NEW_TWIST], run[RUN_NEW_TWIST + 1], run[RUN_NEW_TWIST + 2]
    path_x, path_y = from_world(system, state[ANGLE], run[RUN_PATH], run[RUN_PATH + 1])
    if contact == SEPARATE:
        along, gap = contact_after_flight(
            system, pose, state, h * v_x, h * v_y, path_x, path_y, h * spin
        )
        state[ALONG], state[GAP] = along, gap
    else:
        state[GAP], slip = 0.0, 0.0
        if contact != STICK:
            u_x, _ = contact_motion(pose, v_x, v_y, spin)
            slip = h * u_x - path_x
        state[SLIPPED] += slip
        state[ALONG] += travel_rate(system, slip, h * spin)
    _turn(system, pose, h, v_x, v_y, spin)
    run[RUN_PUSHER] += run[RUN_PATH]
    run[RUN_PUSHER + 1] += run[RUN_PATH + 1]
    run[RUN_TIME] = run[RUN_UNTIL]
    _add_load_work(system)


def _turn(system: System, pose: Pose, h: float, v_x: float, v_y: float, spin: float) -> None:
    """Rotate the slider; with inertia, the motion of the center of mass is preserved."""
    run, state, scene = system.run, vector_of(system, STATE), system.scene
    angle = state[ANGLE]
    turned = angle + h * spin
    before = Rod(1.0, angle, cos(angle), sin(angle))
    after = Rod(1.0, turned, cos(turned), sin(turned))
    x, y = to_contact(before, scene[IN_MASS_X], scene[IN_MASS_Y])
    new_x, new_y = to_contact(after, scene[IN_MASS_X], scene[IN_MASS_Y])
    v_x, v_y = to_world(system, angle, v_x, v_y)
    run[RUN_TWIST], run[RUN_TWIST + 1] = v_x + spin * (new_y - y), v_y - spin * (new_x - x)
    run[RUN_TWIST + 2], state[ANGLE] = spin, turned


def _add_load_work(system: System) -> None:
    """Add the work of the loads in the step; in flight, the rest of the energy goes to the first effect."""
    run, state = system.run, vector_of(system, STATE)
    x, y = center_position(
        system, pose_of(system, state), state, run[RUN_PUSHER], run[RUN_PUSHER + 1]
    )
    work = load_work(system, state[ANGLE], x, y)
    state[LOST] += work - run[RUN_LOAD_WORK]
    run[RUN_LOAD_WORK] = work
    if run[RUN_PUSH] == 0.0 and run[RUN_PUSH + 1] == 0.0 and system.scene[IN_RESISTING] > 0.0:
        energies_of(system, state)[0] += state[LOST] - run[RUN_CONTACT_LOST]
        state[LOST] = run[RUN_CONTACT_LOST]
    run[RUN_CONTACT_LOST] = state[LOST]


def _end_contact(system: System) -> None:
    """End the contact at the end of a finger's side; with an outline, stop there or at a fence."""
    run, state = system.run, vector_of(system, STATE)
    if state[GAP] <= SLACK and room_on_side(system, state[ALONG]) < -SLACK:
        if is_outlined(system):
            run[RUN_STOPPED] = float(SIDE_ENDED)
        else:
            run[RUN_PARTED] = 1.0
    if center_height(system, state) <= 0.0:
        run[RUN_STOPPED] = float(LAID_DOWN)
    elif (
        has_finger(system) and outline_height(system, state, int(run[RUN_MODE]) != SEPARATE) <= 0.0
    ):
        run[RUN_STOPPED] = float(MET_OUTLINE)


def _count_step(system: System) -> None:
    """Count the step, and its interval if it was the last step in it."""
    run = system.run
    run[RUN_STEP] += 1.0
    if run[RUN_STEP] == _interval_number(system, 1):
        run[RUN_INTERVAL_START], run[RUN_STEP] = _interval_number(system, 0), 0.0
        run[RUN_INTERVAL] += 1.0


def _log_step(system: System) -> None:
    """Log the current instant; the last row for an instant replaces previous ones."""
    run, state = system.run, vector_of(system, STATE)
    row = log_row_at(system, run[RUN_TIME])
    for k in range(2):
        row[LOG_PUSHER + k], row[LOG_FORCE + k] = run[RUN_PUSHER + k], run[RUN_PUSH + k]
    row[LOG_TIME], row[LOG_MODE], row[LOG_PIVOT] = run[RUN_TIME], run[RUN_MODE], run[RUN_PIVOT]
    row[LOG_SOLUTIONS], row[LOG_STOPPED], row[LOG_EVENT] = (
        run[RUN_SOLUTIONS],
        run[RUN_STOPPED],
        -1.0,
    )
    v_x, v_y = from_world(system, state[ANGLE], run[RUN_TWIST], run[RUN_TWIST + 1])
    write_state(system, state, v_x, v_y, run[RUN_TWIST + 2], row)
    write_place_of_force(system, state, run[RUN_OFFSET], row)
