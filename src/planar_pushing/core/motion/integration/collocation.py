"""Steps of a collocation method of order 13, with dense output, for motions that friction makes stiff.

Friction lets a slow slider forget its velocity within a time that is proportional to it. Steps of an
explicit method are not longer than some of these times, however smooth the motion is. In a step of this
method, the derivative of the state is a polynomial of degree 6, which the equations of motion determine at
seven nodes. These are those of Radau's quadrature on the right (Hairer and Wanner, Solving Ordinary
Differential Equations II, 2nd edition, 1996, Sec. IV.5), so that the method is L-stable. Newton's method
finds it, with the derivative of the accelerations with respect to the velocities alone (Sec. IV.8).
"""

from __future__ import annotations

from math import fabs, sqrt

from planar_pushing.core.instant.elimination import solve_factored
from planar_pushing.core.motion.integration.explicit import MIDDLE_PART, current_speed, error_norm
from planar_pushing.core.motion.kinematics.drag import slowest_foot
from planar_pushing.core.motion.kinematics.mode import Mode
from planar_pushing.core.motion.kinematics.shapes import (
    center_motion,
    pose_of,
    pusher_velocity,
    to_body,
)
from planar_pushing.core.motion.kinematics.system import (
    DENSE,
    END_VALUES,
    FIRST_RATES,
    LAST_RATES,
    MIDDLE_VALUES,
    MOVING,
    RATES,
    REACHED,
    STAGE_RATES,
    STATE,
    STILL,
    TRIAL,
    RunState,
    System,
    guards_of,
    vector_of,
)
from planar_pushing.core.motion.modes.equations import write_rates
from planar_pushing.core.motion.modes.guards import write_guards, write_rates_and_guards
from planar_pushing.core.numbers import EPSILON, INFINITY, Coefficients, Numbers, zeros

#: Number of nodes of a step, of velocities, and of unknowns of Newton's method.
NODES = 7
VELOCITIES = MOVING - STILL
UNKNOWNS = NODES * VELOCITIES
#: Number of the node near the middle of a step.
MIDDLE_NODE = 3
#: The nodes as fractions of the step, zeros of P7 - P6, where Pk is a Legendre polynomial.
NODE_TIMES = (
    0.029316427159784893, 0.1480785996684843, 0.3369846902811543, 0.5586715187715501,
    0.7692338620300545, 0.9269456713197411, 1.0,
)  # fmt: skip
#: Integral up to node i of the polynomial that is 1 at node j and 0 at the others, row i after row i - 1.
NODE_WEIGHTS = (
    0.03754626499392133, -0.0140393345564604, 0.0103527896007423, -0.008158322540275011,
    0.006388413879534685, -0.004602326779148656, 0.0018289425614706437, 0.08014759651561897,
    0.08106206398589154, -0.021237992120711036, 0.014000291238817119, -0.010234185730090163,
    0.0071534651513645905, -0.0028126393724067235, 0.0720638469418819, 0.17106835498388662,
    0.10961456404007211, -0.024619871728984055, 0.014760377043950817, -0.009575259396791401,
    0.0036726783971383057, 0.07570512581982441, 0.15409015514217114, 0.2271077366732024,
    0.11747818703702478, -0.023810827153044174, 0.012709985533661206, -0.004608844281289633,
    0.07391234216319184, 0.16135560761594242, 0.2068672415521042, 0.23700711534269422,
    0.10308679353381345, -0.018854139152580447, 0.0058589009748887914, 0.07470556205979623,
    0.1583072238724687, 0.21415342326720002, 0.21987784703186003, 0.19875212168063527,
    0.06926550160550914, -0.00811600819772829, 0.07449423555601031, 0.15910211573365074,
    0.21235188950297781, 0.22355491450728324, 0.19047493682211558, 0.1196137446126562,
    0.02040816326530612,
)  # fmt: skip
#: Coefficient of Pk in the polynomial that is 1 at node j and 0 at the others, row k after row k - 1.
NODE_LEGENDRE = (
    0.07449423555601031, 0.15910211573365074, 0.21235188950297781, 0.22355491450728324,
    0.19047493682211558, 0.1196137446126562, 0.02040816326530612, -0.21037927768502115,
    -0.33594863618815946, -0.20769965422026015, 0.07869783817791812, 0.30769381716329286,
    0.3064114229563114, 0.061224489795918366, 0.3088747614716217, 0.19338228309987313,
    -0.3615886064513802, -0.5358006778185274, -0.06197936846707489, 0.35507079183895707,
    0.10204081632653061, -0.35119396850825024, 0.20499506935400982, 0.5981625848095221,
    -0.2691213105112547, -0.5565072354784693, 0.23080771747729936, 0.14285714285714285,
    0.32687461537159823, -0.5857057655913657, 0.04935115309709022, 0.6522770129583284,
    -0.5905655177193665, -0.035904967504039785, 0.1836734693877551, -0.23545886308724948,
    0.6492304429323879, -0.7873737923346583, 0.5067122984583037, 8.06151367569484e-06,
    -0.3576079434008268, 0.22448979591836735, 0.08678849688129067, -0.2850555093403964,
    0.4967964255967085, -0.6563200757720513, 0.7108753061658264, -0.6183907659803575,
    0.2653061224489796,
)  # fmt: skip
#: Largest number of iterations, and the change of the state, in units of the tolerance, at which they end.
MOST_ITERATIONS = 7
SOLVED = 0.01
#: The iterations are not trusted to contract an error by more than this factor.
FASTEST_CONTRACTION = 0.01
#: A change below this one is accepted where rounding prevents that it decreases further.
NEARLY_SOLVED = 0.3
#: Error of a step whose equations are not solved; the next one has about half its size.
UNSOLVED_STEP = 200.0
#: Change of a velocity for a difference quotient, relative to the size of the velocities, and to the speed
#: of the slowest support point, whose friction depends on its direction.
NUDGE = 1e-6
NUDGE_OF_FOOT = 0.1
#: A step longer than the one before by more than this factor does not begin with its polynomial.
FARTHEST_GUESS = 3.0


def attempt_implicit_step(system: System, mode: Mode) -> float:
    """Try a step; return the estimate of the error of its dense output in units of the tolerance.

    The guards near its middle and at its end are stored.
    """
    run, entries = system.run, system.entries
    state, reached = vector_of(system, STATE), vector_of(system, REACHED)
    rates = vector_of(system, STAGE_RATES)
    matrix = zeros(UNKNOWNS * UNKNOWNS)
    order = zeros(UNKNOWNS)
    size = run.until - run.time
    _guess_rates(system, size)
    speed = current_speed(system, mode)
    _write_newton_matrix(system, mode, size, speed, matrix)
    if not _factor(matrix, order) or not _solve_nodes(system, mode, size, matrix, order):
        return UNSOLVED_STEP
    _add_nodes(system, NODE_WEIGHTS, NODES - 1, rates, total=reached)
    for k in range(entries):
        reached[k] += state[k]
    last, trial = vector_of(system, LAST_RATES), vector_of(system, TRIAL)
    write_rates_and_guards(
        system, mode, run.until, state=reached, rates=last, guards=guards_of(system, END_VALUES)
    )
    _add_nodes(system, NODE_LEGENDRE, NODES - 1, rates, total=trial)
    highest = error_norm(system, trial, state, reached)
    _add_nodes(system, NODE_LEGENDRE, NODES - 3, rates, total=trial)
    lower = error_norm(system, trial, state, reached)
    # The coefficients decrease by a constant factor, and an integral divides them by 2 (2 k + 1).
    decrease = min(sqrt(highest / lower), 1.0) if lower > 0.0 else 0.0
    error = highest * decrease / float(2 * NODES)
    if error < 1.0:
        for k in range(NODES):
            _add_nodes(system, NODE_LEGENDRE, k, rates, total=vector_of(system, DENSE + k))
        run.prepared = True
        middle = run.time + MIDDLE_PART * size
        interpolate_implicit_step(system, middle, trial)
        write_guards(system, mode, middle, trial, guards_of(system, MIDDLE_VALUES))
    return error


def interpolate_implicit_step(system: System, time: float, result: Numbers) -> None:
    """Store the state at a time within the last step."""
    run, state = system.run, vector_of(system, STATE)
    x = 2.0 * (time - run.time) / (run.until - run.time) - 1.0
    lower, same = 1.0, x
    for k in range(system.entries):
        result[k] = state[k] + 0.5 * (x + 1.0) * vector_of(system, DENSE)[k]
    for j in range(1, NODES):
        higher = (float(2 * j + 1) * x * same - float(j) * lower) / float(j + 1)
        factor, dense = (higher - lower) / float(4 * j + 2), vector_of(system, DENSE + j)
        for k in range(system.entries):
            result[k] += factor * dense[k]
        lower, same = same, higher


def _add_nodes(
    system: System, weights: Coefficients, row: int, rates: Numbers, total: Numbers
) -> None:
    """Store the sum of vectors at the nodes, with a row of weights."""
    entries = system.entries
    for k in range(entries):
        value = 0.0
        for j in range(NODES):
            value += weights[NODES * row + j] * rates[j * entries + k]
        total[k] = value


def _guess_rates(system: System, size: float) -> None:
    """Store rates at the nodes to begin with, from the last step's polynomial, or without acceleration."""
    run, entries = system.run, system.entries
    rates, first, part = vector_of(system, STAGE_RATES), vector_of(system, FIRST_RATES), 0.0
    if run.extends and size < FARTHEST_GUESS * run.last_size:
        part = size / run.last_size
    for i in range(NODES):
        x = 2.0 * NODE_TIMES[i] * part + 1.0
        lower, same = 1.0, x
        for k in range(entries):
            rates[i * entries + k] = (
                part * vector_of(system, DENSE)[k] if part > 0.0 else size * first[k]
            )
        if part == 0.0:
            for k in range(STILL, MOVING):
                rates[i * entries + k] = 0.0
        if part > 0.0:
            for j in range(1, NODES):
                dense = vector_of(system, DENSE + j)
                for k in range(entries):
                    rates[i * entries + k] += part * same * dense[k]
                higher = (float(2 * j + 1) * x * same - float(j) * lower) / float(j + 1)
                lower, same = same, higher


def _write_newton_matrix(
    system: System, mode: Mode, size: float, speed: float, matrix: Numbers
) -> None:
    """Store the derivative of the equations at the nodes with respect to the rates of the velocities.

    That of the accelerations is taken at the node in the middle, where the state is guessed.
    """
    state, middle, trial = (
        vector_of(system, STATE), vector_of(system, REACHED), vector_of(system, TRIAL)
    )  # fmt: skip
    rates, other = vector_of(system, RATES), vector_of(system, LAST_RATES)
    time = system.run.time + NODE_TIMES[MIDDLE_NODE] * size
    _add_nodes(system, NODE_WEIGHTS, MIDDLE_NODE, vector_of(system, STAGE_RATES), total=middle)
    for n in range(system.entries):
        middle[n] += state[n]
    write_rates(system, mode, time, state=middle, rates=rates)
    nudge = min(NUDGE * speed, NUDGE_OF_FOOT * _speed_of_slowest_foot(system, mode, time, middle))
    nudge = max(nudge, 4.0 * EPSILON * speed)
    for k in range(VELOCITIES):
        for n in range(system.entries):
            trial[n] = middle[n]
        trial[STILL + k] += nudge
        write_rates(system, mode, time, state=trial, rates=other)
        for n in range(VELOCITIES):
            slope = (other[STILL + n] - rates[STILL + n]) / (trial[STILL + k] - middle[STILL + k])
            for i in range(NODES):
                for j in range(NODES):
                    same: bool = i == j and k == n
                    matrix[(VELOCITIES * i + n) * UNKNOWNS + VELOCITIES * j + k] = (
                        1.0 if same else 0.0
                    ) - size * NODE_WEIGHTS[NODES * i + j] * slope


def _speed_of_slowest_foot(system: System, mode: Mode, time: float, state: RunState) -> float:
    """Speed of the slowest support point, infinite without one."""
    pose = pose_of(system, state)
    x, y = pusher_velocity(system, mode.during, time, state)
    x, y = center_motion(pose, x + state.slip_speed, y + state.normal_speed, state.spin)
    x, y = to_body(pose.rod, x, y)
    return slowest_foot(system, x, y, state.spin).speed


def _solve_nodes(system: System, mode: Mode, size: float, matrix: Numbers, order: Numbers) -> bool:
    """Improve the rates at the nodes until the equations of motion hold; return whether they do."""
    run, entries = system.run, system.entries
    state, trial = vector_of(system, STATE), vector_of(system, TRIAL)
    rates, computed = vector_of(system, STAGE_RATES), vector_of(system, STAGE_RATES + NODES)
    right = zeros(UNKNOWNS)
    change = zeros(UNKNOWNS)
    last = 0.0
    for iteration in range(MOST_ITERATIONS):
        for i in range(NODES):
            _add_nodes(system, NODE_WEIGHTS, i, rates, total=trial)
            for k in range(entries):
                trial[k] += state[k]
            there = vector_of(system, STAGE_RATES + NODES + i)
            write_rates(system, mode, run.time + NODE_TIMES[i] * size, state=trial, rates=there)
            for k in range(entries):
                # The difference, which is added below.
                there[k] = size * there[k] - rates[i * entries + k]
            for k in range(VELOCITIES):
                right[VELOCITIES * i + k] = there[STILL + k]
        solve_factored(matrix, order, right, solution=change, count=UNKNOWNS)
        largest = 0.0
        for i in range(NODES):
            for k in range(VELOCITIES):
                computed[i * entries + STILL + k] = change[VELOCITIES * i + k]
        for i in range(NODES):
            # The change of the position by the velocities, which would otherwise come an iteration later.
            _add_nodes(system, NODE_WEIGHTS, i, computed, total=trial)
            there = vector_of(system, STAGE_RATES + NODES + i)
            there.along += size * trial.slip_speed
            there.gap += size * trial.normal_speed
            there.angle += size * trial.spin
        for i in range(NODES):
            _add_nodes(system, NODE_WEIGHTS, i, computed, total=trial)
            largest = max(largest, error_norm(system, trial, state, state))
        for k in range(NODES * entries):
            rates[k] += computed[k]
        if not largest < INFINITY:
            return False
        contraction = max(largest / last, FASTEST_CONTRACTION) if last > 0.0 else INFINITY
        if largest < SOLVED:
            return True
        if contraction < 1.0 and largest * contraction < SOLVED * (1.0 - contraction):
            return True
        last = largest
        if iteration > 1 and contraction >= 1.0:
            break
    return last < NEARLY_SOLVED


def _factor(matrix: Numbers, order: Numbers) -> bool:
    """Factor Newton's matrix in place, with the order of its rows; return whether it is regular."""
    for i in range(UNKNOWNS):
        order[i] = float(i)
    for k in range(UNKNOWNS):
        chosen, best = k, 0.0
        for i in range(k, UNKNOWNS):
            size = fabs(matrix[i * UNKNOWNS + k])
            if size > best:
                chosen, best = i, size
        if not 0.0 < best < INFINITY:
            return False
        if chosen != k:
            order[k], order[chosen] = order[chosen], order[k]
            for j in range(UNKNOWNS):
                one, other = matrix[k * UNKNOWNS + j], matrix[chosen * UNKNOWNS + j]
                matrix[k * UNKNOWNS + j], matrix[chosen * UNKNOWNS + j] = other, one
        for i in range(k + 1, UNKNOWNS):
            factor = matrix[i * UNKNOWNS + k] / matrix[k * UNKNOWNS + k]
            matrix[i * UNKNOWNS + k] = factor
            if factor != 0.0:
                for j in range(k + 1, UNKNOWNS):
                    matrix[i * UNKNOWNS + j] -= factor * matrix[k * UNKNOWNS + j]
    return True
