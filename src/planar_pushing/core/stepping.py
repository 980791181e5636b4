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

from math import cos, fabs, sin, sqrt

from planar_pushing.core.candidates import modes_of_push
from planar_pushing.core.directions import Rod
from planar_pushing.core.drag import (
    drag,
    load_at,
    load_work,
    put_load,
    put_loads_at,
    put_mass,
    scale_films,
    write_powers,
)
from planar_pushing.core.fence import fence_path, policy_at, span_at
from planar_pushing.core.log import has_room_for_rows, log_row_at, write_state
from planar_pushing.core.numbers import INFINITY, Numbers, zeros
from planar_pushing.core.rows import NO_POINT, Vector
from planar_pushing.core.run import (
    IN_GAP,
    IN_MASS,
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
    RUN_EVALUATIONS,
    RUN_INTERVAL,
    RUN_INTERVAL_START,
    RUN_LOAD_WORK,
    RUN_MODE,
    RUN_MOMENT,
    RUN_NEW_TWIST,
    RUN_PARTED,
    RUN_PATH,
    RUN_PHASE,
    RUN_PIVOT,
    RUN_PUSH,
    RUN_PUSHER,
    RUN_ROWS,
    RUN_SOLUTIONS,
    RUN_SPEED,
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
    clearance_of,
    confine_finger,
    contact_after_flight,
    contact_motion,
    from_world,
    has_outline,
    kinetic_energy_of,
    outline_height,
    pose_of,
    put_initial_state,
    room_on_side,
    size_of_twist,
    to_body,
    to_contact,
    to_world,
    travel_rate,
)
from planar_pushing.core.solution import (
    FORCE,
    MODE,
    MOST_SOLUTIONS,
    PIVOT,
    SEPARATE,
    SOLUTION,
    STICK,
    TWIST,
)
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
    is_preferred,
    prepare_system,
    system_of,
    vector_of,
)
from planar_pushing.core.tolerances import SLACK

#: After a finger has left the side permanently, the pusher recedes at this multiple of the typical speed.
RECEDES = 1e3
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
    run[RUN_PHASE], run[RUN_MODE], run[RUN_PIVOT] = 1.0, float(NO_MODE), float(NO_POINT)
    run[RUN_PUSHER + 1] = -system.scene[IN_GAP]
    for k in range(3):
        run[RUN_TWIST + k] = system.scene[IN_TWIST + k]


def _step(system: System) -> None:
    """Take one step, and log the instants at which the mode changes or an interval ends."""
    run, pose = system.run, pose_of(system, vector_of(system, STATE))
    if _choose_twist(system, pose):
        _log_step(system)
    if run[RUN_STOPPED] == float(GOES_ON):
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


def _choose_twist(system: System, pose: Pose) -> bool:
    """Choose the twist at the end of the step by the policy, the first if several have the same mode.

    Returns whether the mode or the number of possible twists has changed.
    """
    run, start = system.run, system.run[RUN_INTERVAL_START]
    part = (run[RUN_STEP] + 1.0) / _interval_number(system, 1)
    run[RUN_UNTIL] = start + (_interval_number(system, 0) - start) * part
    piece = int(_interval_number(system, 2))
    x, y = fence_path(system.fence, span_at(system.fence, piece), run[RUN_TIME], run[RUN_UNTIL])
    run[RUN_PATH], run[RUN_PATH + 1] = x, y
    solutions = zeros(MOST_SOLUTIONS * SOLUTION)
    count, unit = _solve_step(system, pose, solutions)
    current, before = int(run[RUN_MODE]), int(run[RUN_SOLUTIONS])
    run[RUN_SOLUTIONS] = float(max(count, 0))
    if count <= 0:
        run[RUN_MODE], run[RUN_STOPPED] = float(NO_MODE), float(INCONSISTENT)
        run[RUN_PUSH], run[RUN_PUSH + 1] = 0.0, 0.0
        return True
    policy, best, contact = policy_at(system.fence, piece), 0, NO_MODE
    for i in range(count):
        other = int(solutions[i * SOLUTION + MODE])
        if is_preferred(policy, current, other, contact):
            best, contact = i, other
    solution, angle = solutions[best * SOLUTION :], vector_of(system, STATE)[ANGLE]
    v_x, v_y = to_world(system, angle, unit * solution[TWIST], unit * solution[TWIST + 1])
    f_x, f_y = to_world(system, angle, solution[FORCE], solution[FORCE + 1])
    run[RUN_NEW_TWIST], run[RUN_NEW_TWIST + 1] = unit * solution[TWIST], unit * solution[TWIST + 1]
    run[RUN_NEW_TWIST + 2] = unit * solution[TWIST + 2]
    run[RUN_MODE], run[RUN_PIVOT] = float(contact), solution[PIVOT]
    run[RUN_PUSH], run[RUN_PUSH + 1] = f_x, f_y
    if not is_massive(system):
        run[RUN_TWIST], run[RUN_TWIST + 1] = v_x, v_y
        run[RUN_TWIST + 2] = run[RUN_NEW_TWIST + 2]
    return contact != current or count != before


def _solve_step(system: System, pose: Pose, solutions: Numbers) -> tuple[int, float]:
    """Store the possible twists; return their number and unit. For an open contact, only the flight."""
    run, state = system.run, vector_of(system, STATE)
    h, gap, angle = run[RUN_UNTIL] - run[RUN_TIME], clearance_of(system, state), state[ANGLE]
    v_x, v_y = from_world(system, angle, run[RUN_TWIST], run[RUN_TWIST + 1])
    x, y = from_world(system, angle, run[RUN_PATH], run[RUN_PATH + 1])
    spin = run[RUN_TWIST + 2]
    is_open: bool = gap > SLACK
    x, y = x / h, (y - gap) / h
    if gap == INFINITY:
        y = -RECEDES * (run[RUN_SPEED] + size_of_twist(v_x, v_y, spin))
    u_x, u_y = contact_motion(pose, v_x, v_y, spin)
    size, before = sqrt(x * x + y * y), max(sqrt(u_x * u_x + u_y * u_y), fabs(spin))
    unit = _prepare_step(system, pose, h, size, before)
    run[RUN_EVALUATIONS] += 1.0
    part = size / unit if unit > 0.0 else 0.0
    count, _ = modes_of_push(system, pose, x, y, part, solutions)
    if is_open:
        for i in range(count):
            if int(solutions[i * SOLUTION + MODE]) == SEPARATE:
                return i + 1, unit
    return count, unit


def _prepare_step(system: System, pose: Pose, h: float, size: float, before: float) -> float:
    """Store the effects of a step of length h; return the unit of motion.

    `size` is the speed of the pusher and `before` that of the contact. Inertia acts toward the previous
    twist: the momentum is a load.
    """
    scene, run, angle = system.scene, system.run, vector_of(system, STATE)[ANGLE]
    if not is_massive(system):
        scale_films(system, size)
        put_loads_at(system, angle)
        return size
    load = load_at(system, angle)
    v_x, v_y = from_world(system, angle, run[RUN_TWIST], run[RUN_TWIST + 1])
    x, y = to_body(pose.rod, v_x, v_y)
    spin, mass, c_x, c_y = run[RUN_TWIST + 2], scene[IN_MASS], scene[IN_MASS_X], scene[IN_MASS_Y]
    # Momentum of the center of mass, and about the slider's center, divided by the length of the step.
    p_x, p_y = mass * (x - spin * c_y) / h, mass * (y + spin * c_x) / h
    turn = run[RUN_MOMENT] * spin / h + (c_x * p_y - c_y * p_x)
    push = h * sqrt(load.x * load.x + load.y * load.y) / mass
    unit = max(max(size, before), push)
    scale_films(system, unit)
    put_mass(system, unit * mass / h)
    put_load(system, Vector(load.x + p_x, load.y + p_y, load.spin + turn))
    return unit


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
    if state[GAP] <= SLACK and room_on_side(system, state[ALONG]) < 0.0:
        if has_outline(system):
            run[RUN_STOPPED] = float(SIDE_ENDED)
        else:
            run[RUN_PARTED] = 1.0
    if center_height(system, state) <= 0.0:
        run[RUN_STOPPED] = float(LAID_DOWN)
    elif outline_height(system, state, int(run[RUN_MODE]) != SEPARATE) <= 0.0:
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
