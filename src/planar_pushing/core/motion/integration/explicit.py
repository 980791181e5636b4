"""Steps of DOP853, an explicit method of order 8, with dense output and their sizes.

The formulas are those of Hairer, Norsett and Wanner (Solving Ordinary Differential Equations I, 2nd
edition, 1993), Secs. II.4 and II.10.
"""

from __future__ import annotations

from math import fabs, sqrt

from planar_pushing.core.motion.integration.tableau import (
    DENSE_WEIGHTS,
    FIFTH_ERROR,
    STAGE_TIMES,
    STAGE_WEIGHTS,
    STEP_STAGES,
    THIRD_ERROR,
)
from planar_pushing.core.motion.kinematics.mode import Mode
from planar_pushing.core.motion.kinematics.run import Run
from planar_pushing.core.motion.kinematics.shapes import pusher_velocity, size_of_twist
from planar_pushing.core.motion.kinematics.system import (
    DENSE,
    END_VALUES,
    FIRST_RATES,
    LAST_RATES,
    MIDDLE_VALUES,
    MOVING,
    REACHED,
    SCALES,
    SPEED_PART,
    STAGE_RATES,
    STAGES,
    STATE,
    STILL,
    TRIAL,
    RunState,
    System,
    guards_of,
    vector_of,
)
from planar_pushing.core.motion.modes.equations import write_rates
from planar_pushing.core.motion.modes.guards import write_rates_and_guards
from planar_pushing.core.numbers import Coefficients, Numbers
from planar_pushing.core.supports.tolerances import (
    FINEST,
    PART_OF_STEP,
    PUSHES,
)

#: Stage near the middle of a step, with a state close to the motion, and its fraction of the step.
MIDDLE_STAGE = 9
MIDDLE_PART = 0.6
#: Largest error of a velocity in a step, relative to the motion.
COARSEST = 1e-6
#: Error of a velocity, relative to the motion, that a stiff motion may always have, since it forgets it.
RESOLVED_SPEED = 1e-12
#: Largest difference among the rates of the additional stages, relative to those within the step.
FARTHEST_STAGE = 100.0


def _add_stages(
    weights: Coefficients, first: int, count: int, rates: Numbers, entries: int, total: Numbers
) -> None:
    """Store the weighted sum of the rates of stages, for weights from `first` on."""
    for k in range(entries):
        value = 0.0
        for j in range(count):
            value += weights[first + j] * rates[j * entries + k]
        total[k] = value


def _time_in_step(run: Run, part: float) -> tuple[float, float]:
    """Time at a fraction of a step, and its rate.

    Near a kink, the square root of the distance to it advances uniformly, which smooths the motion.
    """
    time, until, kink, side = run.time, run.until, run.kink, run.kink_side
    if side == 0.0:
        return time + part * (until - time), until - time
    start, end = sqrt(fabs(time - kink)), sqrt(fabs(until - kink))
    root = start + part * (end - start)
    return kink + side * root * root, 2.0 * side * root * (end - start)


def _part_of_time(run: Run, time: float) -> float:
    """Fraction of a step completed at a time."""
    kink = run.kink
    if run.kink_side == 0:
        return (time - run.time) / (run.until - run.time)
    start, end = sqrt(fabs(run.time - kink)), sqrt(fabs(run.until - kink))
    return (sqrt(fabs(time - kink)) - start) / (end - start)


def _compute_stage(system: System, mode: Mode, i: int) -> None:
    """Compute the rates of a stage, and the guards at the middle stage."""
    entries, trial, state = system.entries, vector_of(system, TRIAL), vector_of(system, STATE)
    all_rates = vector_of(system, STAGE_RATES)
    rates = RunState(all_rates[i * entries :])
    _add_stages(
        STAGE_WEIGHTS,
        first=i * (i - 1) // 2,
        count=i,
        rates=all_rates,
        entries=entries,
        total=trial,
    )
    time, rate = _time_in_step(system.run, STAGE_TIMES[i])
    for k in range(entries):
        trial[k] += state[k]
    if i == MIDDLE_STAGE:
        write_rates_and_guards(
            system, mode, time, trial, rates, guards_of(system, MIDDLE_VALUES)
        )  # fmt: skip
    else:
        write_rates(system, mode, time, trial, rates)
    for k in range(entries):
        rates[k] *= rate


def attempt_explicit_step(system: System, mode: Mode) -> float:
    """Try a step; return the estimate of its error in units of the tolerance (Sec. II.10).

    The guards near its middle and at its end are stored.
    """
    run, entries, rates = system.run, system.entries, vector_of(system, STAGE_RATES)
    state, reached = vector_of(system, STATE), vector_of(system, REACHED)
    first, last = vector_of(system, FIRST_RATES), vector_of(system, LAST_RATES)
    trial = vector_of(system, TRIAL)
    _, rate = _time_in_step(run, 0.0)
    for k in range(entries):
        rates[k] = rate * first[k]
    for i in range(1, STEP_STAGES):
        _compute_stage(system, mode, i)
    row = STEP_STAGES * (STEP_STAGES - 1) // 2
    _add_stages(
        STAGE_WEIGHTS, first=row, count=STEP_STAGES, rates=rates, entries=entries, total=reached
    )
    for k in range(entries):
        reached[k] += state[k]
    write_rates_and_guards(
        system, mode, run.until, state=reached, rates=last, guards=guards_of(system, END_VALUES)
    )
    _, rate = _time_in_step(run, 1.0)
    for k in range(entries):
        rates[STEP_STAGES * entries + k] = rate * last[k]
    _add_stages(
        FIFTH_ERROR, first=0, count=STEP_STAGES + 1, rates=rates, entries=entries, total=trial
    )
    fifth = error_norm(system, trial, state, reached)
    _add_stages(
        THIRD_ERROR, first=0, count=STEP_STAGES + 1, rates=rates, entries=entries, total=trial
    )
    third = error_norm(system, trial, state, reached)
    fifth, third = fifth * fifth, third * third
    return fifth / sqrt(fifth + 0.01 * third) if fifth != 0.0 else 0.0


def _prepare_dense_output(system: System, mode: Mode) -> None:
    """Compute the coefficients of the dense output, and the additional stages that it needs.

    Where friction makes a slow motion stiff, a step can be stable and these stages are not. The dense
    output is then the cubic through both ends.
    """
    entries, rates = system.entries, vector_of(system, STAGE_RATES)
    for i in range(STEP_STAGES + 1, STAGES):
        _compute_stage(system, mode, i)
    dense, reached, state = (
        vector_of(system, DENSE), vector_of(system, REACHED), vector_of(system, STATE)
    )  # fmt: skip
    for k in range(entries):
        step = reached[k] - state[k]
        bend = rates[k] - step
        dense[k], dense[entries + k] = step, bend
        dense[2 * entries + k] = step - rates[STEP_STAGES * entries + k] - bend
    stable: bool = _are_extra_stages_stable(system)
    for i in range(4):
        _add_stages(
            DENSE_WEIGHTS,
            first=i * STAGES,
            count=STAGES if stable else 0,
            rates=rates,
            entries=entries,
            total=dense[(3 + i) * entries :],
        )
    system.run.prepared = True


def _are_extra_stages_stable(system: System) -> bool:
    """Whether the rates of the additional stages are about as different as those within the step."""
    entries, rates = system.entries, vector_of(system, STAGE_RATES)
    trial, reached = vector_of(system, TRIAL), vector_of(system, REACHED)
    largest, extra = 0.0, 0.0
    for i in range(1, STAGES):
        for k in range(entries):
            trial[k] = rates[i * entries + k] - rates[k]
        spread = error_norm(system, trial, reached, reached)
        if i <= STEP_STAGES:
            largest = max(largest, spread)
        else:
            extra = max(extra, spread)
    return extra <= FARTHEST_STAGE * (largest + 1.0)


def interpolate_explicit_step(system: System, mode: Mode, time: float, result: Numbers) -> None:
    """Store the state at a time within the last step."""
    if not system.run.prepared:
        _prepare_dense_output(system, mode)
    entries, dense, state = system.entries, vector_of(system, DENSE), vector_of(system, STATE)
    x = _part_of_time(system.run, time)
    y = 1.0 - x
    for k in range(entries):
        value = dense[5 * entries + k] + x * dense[6 * entries + k]
        value = dense[4 * entries + k] + y * value
        value = dense[2 * entries + k] + y * (dense[3 * entries + k] + x * value)
        result[k] = state[k] + x * (dense[k] + y * (dense[entries + k] + x * value))


def tolerance_of_step(system: System) -> float:
    """Relative error allowed for one step, less than that of the run, since the errors of steps add up."""
    return max(PART_OF_STEP * system.scene.tolerance, FINEST)


def error_norm(system: System, vector: Numbers, start: Numbers, end: Numbers) -> float:
    """Root mean square of a vector, in units of the tolerance of one step."""
    tolerance = tolerance_of_step(system)
    total, scales = 0.0, vector_of(system, SCALES)
    for i in range(system.entries):
        part = vector[i] / (tolerance * (scales[i] + max(fabs(start[i]), fabs(end[i]))))
        total += part * part
    return sqrt(total / float(system.entries))


def relaxations_in_step(system: System) -> float:
    """The last step in units of the time in which friction lets a change of the velocities decay.

    Two states at the end of the step, and their rates, give this time (Hairer and Wanner, Solving Ordinary
    Differential Equations II, 2nd edition, 1996, Sec. IV.2).
    """
    entries, rates = system.entries, vector_of(system, STAGE_RATES)
    state, reached = vector_of(system, STATE), vector_of(system, REACHED)
    trial, last = vector_of(system, TRIAL), STEP_STAGES - 1
    _add_stages(
        STAGE_WEIGHTS,
        first=last * (last - 1) // 2,
        count=last,
        rates=rates,
        entries=entries,
        total=trial,
    )
    change, apart = 0.0, 0.0
    for k in range(STILL, MOVING):
        rate = rates[STEP_STAGES * entries + k] - rates[last * entries + k]
        distance = reached[k] - state[k] - trial[k]
        change, apart = change + rate * rate, apart + distance * distance
    return sqrt(change / apart) if apart > 0.0 else 0.0


def current_speed(system: System, mode: Mode) -> float:
    """Size of the motion at the start of the step; a typical one for a slider at rest."""
    state = vector_of(system, STATE)
    x, y = pusher_velocity(system, mode.during, system.run.time, state)
    x, y = x + state.slip_speed, y + state.normal_speed
    speed = size_of_twist(x, y, state.spin)
    return speed if speed >= PUSHES * system.run.speed else system.run.speed


def scale_velocities(system: System, mode: Mode) -> None:
    """Let the errors of velocities be small beside a slow motion, whose direction friction opposes."""
    scales, speed = vector_of(system, SCALES), current_speed(system, mode)
    tolerance = tolerance_of_step(system)
    size = min(COARSEST * speed / tolerance, SPEED_PART * system.run.speed)
    if system.run.implicit:
        size = max(size, RESOLVED_SPEED * speed / tolerance)
    scales.slip_speed, scales.normal_speed, scales.spin = size, size, size
