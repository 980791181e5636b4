"""Rows of the log: position, twist, force and energies at an instant, along the axes of the world."""

from __future__ import annotations

from planar_pushing.core.instant.directions import spin_ratio
from planar_pushing.core.instant.solution import SEPARATE
from planar_pushing.core.motion.kinematics.drag import load_work
from planar_pushing.core.motion.kinematics.instant import Instant
from planar_pushing.core.motion.kinematics.rolling import has_finger
from planar_pushing.core.motion.kinematics.run import (
    LOG_ROW,
    LogRow,
)
from planar_pushing.core.motion.kinematics.shapes import (
    center_position,
    frame_turn,
    kinetic_energy_of,
    pose_of,
    to_world,
)
from planar_pushing.core.motion.kinematics.system import (
    RunState,
    System,
    copy_numbers,
    energies_of,
    log_of,
    logs_events,
    memory_of,
)
from planar_pushing.core.motion.kinematics.touch import is_flush, side_on_fence
from planar_pushing.core.motion.kinematics.wall import (
    gap_above_pusher,
    is_closed,
    piece_at_contact,
    position_on_outline,
)
from planar_pushing.core.supports.rows import NO_POINT
from planar_pushing.core.supports.tolerances import SLACK


def row_width(resisting: int) -> int:
    """Number of numbers of a row of the log, for a number of effects that resist motion."""
    return LOG_ROW + resisting


def has_room_for_rows(system: System, count: int, width: int) -> bool:
    """Whether more rows fit into a row of results of this width."""
    if not logs_events(system):
        return True
    rows = system.run.rows + count
    return memory_of(system) + rows * row_width(system.scene.resisting) <= width


def next_log_row(system: System, time: float) -> LogRow:
    """The row of the log in which an instant is stored.

    If only the times are logged, each instant up to a time is stored in the row of that time, so that the
    last one remains.
    """
    run, width = system.run, row_width(system.scene.resisting)
    if logs_events(system):
        number = run.rows
        run.rows += 1
        return LogRow(log_of(system)[number * width :])
    slot, last = run.slot, system.scene.times - 1
    while slot < last and time > system.times[slot]:
        slot += 1
    run.slot = slot
    return LogRow(log_of(system)[slot * width :])


def log_row_at(system: System, time: float) -> LogRow:
    """The last row of the log if it is for this instant, otherwise the next one."""
    width, rows = row_width(system.scene.resisting), system.run.rows
    if rows > 0:
        row = LogRow(log_of(system)[(rows - 1) * width :])
        if row.time == time:
            return row
    return next_log_row(system, time)


def end_log(system: System) -> None:
    """If only the times are logged, repeat the last row for the times after it."""
    width, slot = row_width(system.scene.resisting), system.run.slot
    if not logs_events(system):
        row = LogRow(log_of(system)[slot * width :])
        for i in range(slot + 1, system.scene.times):
            later = LogRow(log_of(system)[i * width :])
            copy_numbers(later, row, width)
            later.impulse.x, later.impulse.y = 0.0, 0.0


def write_state(
    system: System, state: RunState, v_x: float, v_y: float, spin: float, row: LogRow
) -> None:
    """Store state, position, twist and energies in a row that already contains the pusher."""
    pose, angle, run = pose_of(system, state), state.angle, system.run
    row.angle, row.slip, row.gap = angle, state.slipped, state.gap
    if not is_closed(system, state):
        row.gap = gap_above_pusher(system, state)
    row.work, row.contact_dissipated = state.work, state.lost
    row.evaluations = run.evaluations
    copy_numbers(row[LOG_ROW:], energies_of(system, state), system.scene.resisting)
    x, y = center_position(system, pose, state, row.pusher.x, row.pusher.y)
    row.position.x, row.position.y = x, y
    row.load_work = load_work(system, angle, x, y)
    w_x, w_y = to_world(system, state, v_x, v_y)
    row.twist.x, row.twist.y, row.twist.spin = w_x, w_y, spin
    row.ratio = spin_ratio(v_x, v_y, spin)
    row.kinetic = kinetic_energy_of(system, pose, v_x, v_y, spin)
    row.contact_position, row.parted = position_on_outline(system, state.along), run.parted
    row.contact_normal, row.contact_piece = (
        frame_turn(system, state),
        piece_at_contact(system, state),
    )


def write_place_of_force(system: System, state: RunState, offset: float, row: LogRow) -> None:
    """Store where the force acts along a fence, or the contact is, and whether a side lies on the fence."""
    if not has_finger(system):
        row.contact_position = state.along + offset
        left = NO_POINT
        if row.mode == SEPARATE and state.gap <= SLACK:
            left, _ = side_on_fence(system, state)
        lies: bool = left >= 0 or (is_flush(system) and state.gap <= SLACK)
        row.flush = lies


def write_impulse(system: System, row: LogRow) -> None:
    """Store the impulses since the row before.

    If only the times are logged, a row is stored several times, and the impulses add up in it.
    """
    for k in range(2):
        before = 0.0 if logs_events(system) else row.impulse[k]
        row.impulse[k] = before + system.run.impulse[k]
        system.run.impulse[k] = 0.0


def write_instant(
    system: System, instant: Instant, contact: int, time: float, state: RunState,
    x: float, y: float, solutions: int, row: LogRow,
) -> None:  # fmt: skip
    """Store an instant, without its event; (x, y) is the displacement of the pusher."""
    row.time, row.pusher.x, row.pusher.y = time, x, y
    row.mode, row.solutions = contact, solutions
    row.stopped = system.run.stopped
    write_state(system, state, instant.v_x, instant.v_y, instant.spin, row)
    row.pivot = instant.pivot
    f_x, f_y = to_world(system, state, instant.f_x, instant.f_y)
    row.force.x, row.force.y = f_x, f_y
    write_impulse(system, row)
    write_place_of_force(system, state, instant.offset, row)
