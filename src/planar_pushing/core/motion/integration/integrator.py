"""Steps of a motion, their sizes, and the choice between the explicit method and the implicit one.

A mode begins with explicit steps. If it lasts long beside the time in which friction lets a change of the
velocities decay, implicit steps follow until it ends.
"""

from __future__ import annotations

from math import exp, fabs, log

from planar_pushing.core.motion.integration.collocation import (
    attempt_implicit_step,
    interpolate_implicit_step,
)
from planar_pushing.core.motion.integration.explicit import (
    attempt_explicit_step,
    error_norm,
    interpolate_explicit_step,
    relaxations_in_step,
    scale_velocities,
)
from planar_pushing.core.motion.kinematics.drag import load_work
from planar_pushing.core.motion.kinematics.fence import end_of_fence, fence_displacement
from planar_pushing.core.motion.kinematics.mode import REST, Mode
from planar_pushing.core.motion.kinematics.run import Run
from planar_pushing.core.motion.kinematics.shapes import (
    center_motion,
    center_position,
    kinetic_energy_of,
    pose_of,
    pusher_velocity,
)
from planar_pushing.core.motion.kinematics.system import (
    FIRST_RATES,
    MOVING,
    PASSING,
    REACHED,
    SCALES,
    STATE,
    TRIAL,
    RunState,
    System,
    is_loaded,
    is_massive,
    vector_of,
)
from planar_pushing.core.motion.modes.equations import write_rates
from planar_pushing.core.numbers import EPSILON, INFINITY, Numbers
from planar_pushing.core.supports.tolerances import FINEST

#: Largest error of the balance of energy in one step, in units of the tolerance.
UNBALANCED = 1.0
#: Safety factor, and limits for the change of the step size.
SAFETY = 0.9
SHRINK_LIMIT = 0.1
GROWTH_LIMIT = 10.0
#: Maximum factor by which a trend of the step size is extrapolated, and by which the first step of a mode
#: exceeds the last step before it, since the motion after a singularity is as hard as before it.
TREND_LIMIT = 2.0
#: The usual first size, multiplied by this factor, gives a step with an error near the tolerance.
CAUTIOUS = 4.0
#: The smallest step at time 0, where rounding of the time does not limit it.
SMALLEST_STEP = 1e-300
#: Order of the error of a step.
STEP_ORDER = 8.0
#: Number of steps in which a run must advance by at least this fraction of the duration.
PATIENCE = 5000
SMALLEST_PROGRESS = 1e-12
#: Number of relaxation times after which a mode that still needs explicit steps is stiff.
RELAXED = 30.0


def attempt_step(system: System, mode: Mode) -> float:
    """Try a step; return the estimate of its error in units of the tolerance."""
    if system.run.implicit:
        return attempt_implicit_step(system, mode)
    return attempt_explicit_step(system, mode)


def interpolate_state(system: System, mode: Mode, time: float, result: Numbers) -> None:
    """Store the state at a time within the last step."""
    if system.run.implicit:
        interpolate_implicit_step(system, time, result)
    else:
        interpolate_explicit_step(system, mode, time, result)


def begin_steps(system: System, mode: Mode, end: float) -> None:
    """Plan the first step of a mode with known rates at its start; it is explicit."""
    run = system.run
    run.implicit = False
    if is_massive(system):
        scale_velocities(system, mode)
    run.planned = _first_size(system, mode, end)
    run.last_size, run.fresh = 0.0, False
    run.extends, run.relaxations = False, 0.0


def choose_method(run: Run) -> None:
    """Take implicit steps from now on if the motion is stiff."""
    run.extends = run.implicit
    run.implicit = run.implicit or run.relaxations > RELAXED


def count_relaxations(system: System) -> None:
    """Add the last step to the number of relaxation times that the mode has lasted."""
    if is_massive(system) and not system.run.implicit:
        relaxations = system.run.relaxations
        system.run.relaxations = relaxations + relaxations_in_step(system)


def _energy_given(system: System, mode: Mode, time: float, state: RunState) -> float:
    """Energy that pusher and loads have given to the slider, less what it has stored and dissipated."""
    pose = pose_of(system, state)
    fence_x, fence_y = pusher_velocity(system, mode.during, time, state)
    v_x, v_y = center_motion(
        pose, fence_x + state.slip_speed, fence_y + state.normal_speed, state.spin
    )
    total = state.work - state.lost - kinetic_energy_of(system, pose, v_x, v_y, state.spin)
    for i in range(MOVING, system.entries):
        total -= state[i]
    if is_loaded(system):
        x, y = fence_displacement(system.fence, mode.during, time)
        x, y = center_position(system, pose, state, x, y)
        total += load_work(system, state.angle, x, y)
    return total


def keeps_energy(system: System, mode: Mode) -> bool:
    """Whether the energies at the ends of the last step balance within the tolerance.

    The integrator's estimate can miss that the friction of a support point turns within a step, where the
    center of rotation passes the point closely, and is by chance small in a long step of a stiff motion.
    """
    run, state, reached = system.run, vector_of(system, STATE), vector_of(system, REACHED)
    if not is_massive(system) or mode.contact == REST or mode.hinged:
        return True
    lost = _energy_given(system, mode, run.until, reached)
    lost -= _energy_given(system, mode, run.time, state)
    scale = vector_of(system, SCALES).work + fabs(reached.work)
    return fabs(lost) <= UNBALANCED * max(system.scene.tolerance, FINEST) * scale


def smallest_size(time: float) -> float:
    """Step size below which rounding of the time matters."""
    return 10.0 * EPSILON * time + SMALLEST_STEP


def _first_size(system: System, mode: Mode, end: float) -> float:
    """Size of the first step of a mode with known rates at its start (Sec. II.4)."""
    run, state, trial = system.run, vector_of(system, STATE), vector_of(system, TRIAL)
    rates, other = vector_of(system, FIRST_RATES), vector_of(system, PASSING)
    time = run.time
    state_size = error_norm(system, state, state, state)
    rate_size = error_norm(system, rates, state, state)
    small: bool = state_size < 1e-5 or rate_size < 1e-5
    size = min(1e-6 if small else 0.01 * state_size / rate_size, end - time)
    for k in range(system.entries):
        trial[k] = state[k] + size * rates[k]
    write_rates(system, mode, time + size, state=trial, rates=other)
    for k in range(system.entries):
        trial[k] = other[k] - rates[k]
    bend = max(rate_size, error_norm(system, trial, state, state) / size)
    better = max(1e-6, 1e-3 * size)
    if not bend < INFINITY:
        better = 0.0
    elif bend > 1e-15:
        better = exp(log(0.01 / bend) / STEP_ORDER)
    longest = TREND_LIMIT * run.last_size if run.last_size > 0.0 else INFINITY
    return min(min(min(100.0 * size, CAUTIOUS * better), longest), end - time)


def next_size(run: Run, size: float, error: float) -> float:
    """Size of the step after one with an error below 1; a steady change of the size continues.

    Gustafsson's prediction (Hairer and Wanner, Solving Ordinary Differential Equations II, 1996, Sec.
    IV.8): near a singularity, step sizes decrease before it and increase after it by a constant factor per
    step.
    """
    if error == 0.0:
        return GROWTH_LIMIT * size
    factor = SAFETY * exp(-log(error) / STEP_ORDER)
    if run.last_size > 0.0:
        trend = 0.0
        if run.last_error > 0.0:
            trend = exp(log(run.last_error / error) / STEP_ORDER)
        trend *= size / run.last_size
        factor *= min(max(trend, 1.0 / TREND_LIMIT), TREND_LIMIT)
    return size * min(max(factor, SHRINK_LIMIT), GROWTH_LIMIT)


def smaller_size(size: float, error: float, last_size: float, last_error: float) -> float:
    """Size of the next trial after an error above 1, given also the error of a larger size, if any.

    The two errors give the order of the error, which is low where the motion is not smooth.
    """
    order = STEP_ORDER
    if last_size > size and last_error > error:
        order = min(max(log(last_error / error) / log(last_size / size), 1.0), order)
    factor = SAFETY * exp(-log(error) / order)
    return size * (factor if factor > SHRINK_LIMIT else SHRINK_LIMIT)


def makes_progress(system: System) -> bool:
    """Whether the run has advanced since the last check."""
    run = system.run
    run.steps += 1
    if run.steps < PATIENCE:
        return True
    elapsed = run.time - run.checked
    run.steps, run.checked = 0, run.time
    return elapsed > SMALLEST_PROGRESS * end_of_fence(system.fence)
