"""Rows of the log: position, twist, force and energies at an instant, along the axes of the world."""

from __future__ import annotations

from planar_pushing.core.directions import spin_ratio
from planar_pushing.core.drag import load_work
from planar_pushing.core.instant import Instant
from planar_pushing.core.numbers import Numbers
from planar_pushing.core.rows import NO_POINT
from planar_pushing.core.run import (
    IN_RESISTING,
    IN_TIMES,
    LOG_ANGLE,
    LOG_CONTACT_DISSIPATED,
    LOG_CONTACT_POSITION,
    LOG_DISSIPATED,
    LOG_EVALUATIONS,
    LOG_FLUSH,
    LOG_FORCE,
    LOG_GAP,
    LOG_IMPULSE,
    LOG_KINETIC,
    LOG_LOAD_WORK,
    LOG_MODE,
    LOG_PARTED,
    LOG_PIVOT,
    LOG_POSITION,
    LOG_PUSHER,
    LOG_RATIO,
    LOG_SLIP,
    LOG_SOLUTIONS,
    LOG_STOPPED,
    LOG_TIME,
    LOG_TWIST,
    LOG_WORK,
    RUN_EVALUATIONS,
    RUN_IMPULSE,
    RUN_PARTED,
    RUN_ROWS,
    RUN_SLOT,
    RUN_STOPPED,
)
from planar_pushing.core.shapes import (
    center_position,
    has_finger,
    kinetic_energy_of,
    pose_of,
    to_world,
)
from planar_pushing.core.solution import SEPARATE
from planar_pushing.core.system import (
    ALONG,
    ANGLE,
    GAP,
    LOST,
    SLIPPED,
    WORK,
    System,
    copy_numbers,
    energies_of,
    log_of,
    logs_events,
    memory_of,
)
from planar_pushing.core.tolerances import SLACK
from planar_pushing.core.touch import height_above_pusher, is_flush, side_on_fence


def row_width(resisting: int) -> int:
    """Number of numbers of a row of the log, for a number of effects that resist motion."""
    return LOG_DISSIPATED + resisting


def has_room_for_rows(system: System, count: int, width: int) -> bool:
    """Whether more rows fit into a row of results of this width."""
    if not logs_events(system):
        return True
    rows = int(system.run[RUN_ROWS]) + count
    return memory_of(system) + rows * row_width(int(system.scene[IN_RESISTING])) <= width


def next_log_row(system: System, time: float) -> Numbers:
    """The row of the log in which an instant is stored.

    If only the times are logged, each instant up to a time is stored in the row of that time, so that the
    last one remains.
    """
    run, width = system.run, row_width(int(system.scene[IN_RESISTING]))
    if logs_events(system):
        number = int(run[RUN_ROWS])
        run[RUN_ROWS] += 1.0
        return log_of(system)[number * width :]
    slot, last = int(run[RUN_SLOT]), int(system.scene[IN_TIMES]) - 1
    while slot < last and time > system.times[slot]:
        slot += 1
    run[RUN_SLOT] = float(slot)
    return log_of(system)[slot * width :]


def log_row_at(system: System, time: float) -> Numbers:
    """The last row of the log if it is for this instant, otherwise the next one."""
    width, rows = row_width(int(system.scene[IN_RESISTING])), int(system.run[RUN_ROWS])
    if rows > 0:
        row = log_of(system)[(rows - 1) * width :]
        if row[LOG_TIME] == time:
            return row
    return next_log_row(system, time)


def end_log(system: System) -> None:
    """If only the times are logged, repeat the last row for the times after it."""
    width, slot = row_width(int(system.scene[IN_RESISTING])), int(system.run[RUN_SLOT])
    if not logs_events(system):
        row = log_of(system)[slot * width :]
        first = slot if row[LOG_TIME] < system.times[slot] else slot + 1
        for i in range(max(first, slot + 1), int(system.scene[IN_TIMES])):
            later = log_of(system)[i * width :]
            copy_numbers(later, row, width)
            later[LOG_IMPULSE], later[LOG_IMPULSE + 1] = 0.0, 0.0


def write_state(
    system: System, state: Numbers, v_x: float, v_y: float, spin: float, row: Numbers
) -> None:
    """Store state, position, twist and energies in a row that already contains the pusher."""
    pose, angle, run = pose_of(system, state), state[ANGLE], system.run
    row[LOG_ANGLE], row[LOG_SLIP], row[LOG_GAP] = angle, state[SLIPPED], state[GAP]
    if state[GAP] > SLACK:
        row[LOG_GAP] = height_above_pusher(system, state)
    row[LOG_WORK], row[LOG_CONTACT_DISSIPATED] = state[WORK], state[LOST]
    row[LOG_EVALUATIONS] = run[RUN_EVALUATIONS]
    copy_numbers(row[LOG_DISSIPATED:], energies_of(system, state), int(system.scene[IN_RESISTING]))
    x, y = center_position(system, pose, state, row[LOG_PUSHER], row[LOG_PUSHER + 1])
    row[LOG_POSITION], row[LOG_POSITION + 1] = x, y
    row[LOG_LOAD_WORK] = load_work(system, angle, x, y)
    w_x, w_y = to_world(system, angle, v_x, v_y)
    row[LOG_TWIST], row[LOG_TWIST + 1], row[LOG_TWIST + 2] = w_x, w_y, spin
    row[LOG_RATIO] = spin_ratio(v_x, v_y, spin)
    row[LOG_KINETIC] = kinetic_energy_of(system, pose, v_x, v_y, spin)
    row[LOG_CONTACT_POSITION], row[LOG_PARTED] = 0.0 - state[ALONG], run[RUN_PARTED]


def write_place_of_force(system: System, state: Numbers, offset: float, row: Numbers) -> None:
    """Store where the force acts along a fence, or the contact is, and whether a side lies on the fence."""
    if not has_finger(system):
        row[LOG_CONTACT_POSITION] = state[ALONG] + offset
        left = NO_POINT
        if row[LOG_MODE] == float(SEPARATE) and state[GAP] <= SLACK:
            left, _ = side_on_fence(system, state)
        lies: bool = left >= 0 or (is_flush(system) and state[GAP] <= SLACK)
        row[LOG_FLUSH] = 1.0 if lies else 0.0


def write_impulse(system: System, row: Numbers) -> None:
    """Store the impulses since the row before.

    If only the times are logged, a row is stored several times, and the impulses add up in it.
    """
    for k in range(2):
        before = 0.0 if logs_events(system) else row[LOG_IMPULSE + k]
        row[LOG_IMPULSE + k] = before + system.run[RUN_IMPULSE + k]
        system.run[RUN_IMPULSE + k] = 0.0


def write_instant(
    system: System, instant: Instant, contact: int, time: float, state: Numbers,
    x: float, y: float, solutions: int, row: Numbers,
) -> None:  # fmt: skip
    """Store an instant, without its event; (x, y) is the displacement of the pusher."""
    row[LOG_TIME], row[LOG_PUSHER], row[LOG_PUSHER + 1] = time, x, y
    row[LOG_MODE], row[LOG_SOLUTIONS] = float(contact), float(solutions)
    row[LOG_STOPPED] = system.run[RUN_STOPPED]
    write_state(system, state, instant.v_x, instant.v_y, instant.spin, row)
    row[LOG_PIVOT] = float(instant.pivot)
    f_x, f_y = to_world(system, state[ANGLE], instant.f_x, instant.f_y)
    row[LOG_FORCE], row[LOG_FORCE + 1] = f_x, f_y
    write_impulse(system, row)
    write_place_of_force(system, state, instant.offset, row)
