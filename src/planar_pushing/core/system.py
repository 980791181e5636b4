"""The system of one run: a slider, its effects, and a pusher; its state, and the modes of its motion.

The state holds the position of the contact relative to the pusher, the rod's angle, accumulated slip,
energy dissipated at the contact, and work of the pusher. With inertia, the velocity of the contact relative
to the pusher and the angular velocity follow. The energies dissipated by each effect are last.
"""

from __future__ import annotations

from math import cos, fabs, sin, sqrt
from typing import NamedTuple

from planar_pushing.core.cone import Law
from planar_pushing.core.directions import Rod, direction_at, unit_x, unit_y
from planar_pushing.core.fence import Fence, Span, fence_velocity, span_at, typical_speed
from planar_pushing.core.numbers import INFINITY, Numbers
from planar_pushing.core.rows import (
    LOAD,
    NO_POINT,
    RING,
    column_of,
    count_columns,
    kind_of,
    read_effects,
)
from planar_pushing.core.run import (
    IN_ANGLE,
    IN_CLOSED,
    IN_COEFFICIENTS,
    IN_EVENTS,
    IN_FRICTIONS,
    IN_GYRATION,
    IN_LEFT,
    IN_LENGTH,
    IN_LOAD_X,
    IN_LOAD_Y,
    IN_MASS,
    IN_PIECES,
    IN_RESISTING,
    IN_RIGHT,
    IN_ROUGH,
    IN_SLIPS,
    IN_TIMES,
    IN_TWIST,
    IN_WEIGHT,
    INPUTS,
    MEMORY,
    RUN_CONTACT,
    RUN_EFFECTS,
    RUN_FEET,
    RUN_FORCE,
    RUN_FRICTIONAL,
    RUN_HIGH,
    RUN_LEFT,
    RUN_LINEAR,
    RUN_LOADED,
    RUN_LOW,
    RUN_MASSIVE,
    RUN_MOMENT,
    RUN_OTHER_END,
    RUN_POINT,
    RUN_RIGHT,
    RUN_RING,
    RUN_ROD,
    RUN_SPEED,
    RUN_SQUARE,
)
from planar_pushing.core.solution import MOST_SOLUTIONS, SEPARATE, SLIP_LEFT, SLIP_RIGHT, STICK

#: Entries of the state.
ALONG, GAP, ANGLE, SLIPPED, LOST, WORK, SLIP_SPEED, NORMAL_SPEED, SPIN = range(9)
#: Number of entries before the energies, without inertia and with it.
STILL = 6
MOVING = 9
#: A slider at rest, in addition to the contact modes; no mode.
REST = 4
NO_MODE = -1
#: Numbers of a candidate mode: contact mode or rest, pivot, whether it is held, whether the slider touches
#: the pusher, three numbers of the start, the contact's point, the other end of a side on the fence, the
#: place of the force on this side, whether the contact is an end of a side that barely moves away from the
#: fence, whether the mode lasts, and the way in which the pivot leaves.
CANDIDATE = 13
BARELY_LEAVES, LASTS, DEPARTURE = 10, 11, 12
#: Maximum number of candidates: the modes of a side on the fence, and those of its two ends.
MOST_CANDIDATES = 3 * MOST_SOLUTIONS
#: Vectors of a run with the entries of the state: state, end of the step, two for trials, typical
#: magnitudes, rates at the start and at the end of a step, a last one for rates, and a state at another
#: contact; then the stages of a step, and the coefficients of its dense output.
STATE, REACHED, TRIAL, PASSING, SCALES, FIRST_RATES, LAST_RATES, RATES = range(8)
ELSEWHERE, STAGE_RATES = 8, 9
STAGES = 16
DENSE = STAGE_RATES + STAGES
VECTORS = DENSE + 7
#: Causes of the end of a mode (`Event`). Of simultaneous ones, the first counts.
LEAVES_CONE, SLIP_ENDS, FORCE_ENDS, TOUCHES, PUSH_STARTS, SEPARATION_CHANGES = range(6)
PIVOT_YIELDS, CENTER_DOWN, SLIDER_STOPS, CENTER_AT_POINT, KINK = range(6, 11)
NORMAL_REVERSES, TANGENTIAL_REVERSES, END_OF_SIDE, PENETRATES = range(11, 15)
CAUSES = 15
#: Whether any change of the sign of a guard is an event. Those with 2 are watched once they are positive;
#: the others are positive while a mode lasts.
WATCHES = (0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 2.0, 1.0, 1.0, 1.0, 1.0, 1.0, 0.0)
#: Sets of guards of a run: their signs; their values at the start of a step, which those at its nodes and
#: at its end follow; near its middle; and two for trials.
SIGNS, VALUES = 0, 1
END_VALUES, MIDDLE_VALUES, TRIAL_GUARDS, LATER_GUARDS, GUARD_SETS = range(5, 10)
#: Reasons of an early end (`Stop`).
GOES_ON, INCONSISTENT, LAID_DOWN, NO_IMPULSE, SINGULAR_MOTION = range(5)
TOO_MANY_EVENTS, NO_PROGRESS, MET_OUTLINE, SIDE_ENDED, TOO_MUCH_WORK = range(5, 10)
#: Policies (`Policy`).
KEEP_CONTACT, PREFER_SEPARATE, STAY_IN_MODE, PREFER_STICK, PREFER_RIGHT, PREFER_LEFT = range(6)


class System(NamedTuple):
    """The rows of one run.

    Attributes
    ----------
    data, row : Numbers
        Data and numbers of the effects, those of inertia and loads zero.
    problem : Numbers
        Numbers of the effects for the problem at hand.
    scene : Numbers
        Inputs.
    times : Numbers
    fence : Fence
    run, candidates, vectors, guards : Numbers
        Memory.
    entries : int
        Number of entries of the state.
    """

    data: Numbers
    row: Numbers
    problem: Numbers
    scene: Numbers
    times: Numbers
    fence: Fence
    run: Numbers
    candidates: Numbers
    vectors: Numbers
    guards: Numbers
    entries: int


class Mode(NamedTuple):
    """A possible continuation of the motion during a span of the pusher's motion.

    Attributes
    ----------
    contact : int
        Contact mode, or `REST`.
    foot : int
        Number of the support point at the center of rotation, -1 without one.
    hinged : bool
        Whether friction holds this point like a hinge.
    departure : int
        Which of the ways in which it can leave the center otherwise, from 1 (`leaving_friction`).
    touches : bool
        Whether a slider at rest touches the pusher.
    x, y, spin : float
        Acceleration of a slider that starts from rest; of a slider at rest, the force and the contact mode;
        in a slip without inertia, the contact's motion; otherwise zero.
    offset : float
        Place of the force of a slider at rest along the fence, from the contact.
    during : Span
    """

    contact: int
    foot: int
    hinged: bool
    departure: int
    touches: bool
    x: float
    y: float
    spin: float
    offset: float
    during: Span


def state_size(resisting: int, massive: bool) -> int:
    """Number of entries of the state, for a number of effects that resist motion."""
    return (MOVING if massive else STILL) + resisting


def problem_size(resisting: int) -> int:
    """Room for the numbers of the effects, at most four each, with inertia and loads."""
    return 4 * (resisting + 2)


def memory_size(resisting: int, massive: bool) -> int:
    """Number of numbers of a run's memory."""
    arrays = problem_size(resisting) + MOST_CANDIDATES * CANDIDATE + GUARD_SETS * CAUSES
    return MEMORY + arrays + VECTORS * state_size(resisting, massive)


def system_of(data: Numbers, row: Numbers, memory: Numbers, rows_of_times: int) -> System:
    """The system of a row of inputs, its times in one or several rows, and its memory."""
    scene = row[count_columns(data) :]
    times = scene[INPUTS:]
    resisting = int(scene[IN_RESISTING])
    fence = Fence(
        times[rows_of_times * int(scene[IN_TIMES]) :],
        int(scene[IN_PIECES]), int(scene[IN_COEFFICIENTS]),
    )  # fmt: skip
    problem = memory[MEMORY:]
    candidates = problem[problem_size(resisting) :]
    guards = candidates[MOST_CANDIDATES * CANDIDATE :]
    return System(
        data, row, problem, scene, times, fence, memory, candidates,
        guards[GUARD_SETS * CAUSES :], guards, state_size(resisting, scene[IN_MASS] > 0.0),
    )  # fmt: skip


def memory_of(system: System) -> int:
    """Number of numbers of the memory, which the rows of the log follow."""
    massive: bool = system.scene[IN_MASS] > 0.0
    return memory_size(int(system.scene[IN_RESISTING]), massive)


def with_candidates(system: System, candidates: Numbers) -> System:
    """The same run with other room for candidates."""
    return System(
        system.data, system.row, system.problem, system.scene, system.times, system.fence,
        system.run, candidates, system.vectors, system.guards, system.entries,
    )  # fmt: skip


def log_of(system: System) -> Numbers:
    """The rows of the log."""
    return system.run[memory_of(system) :]


def vector_of(system: System, number: int) -> Numbers:
    """A vector of the run."""
    return system.vectors[number * system.entries :]


def guards_of(system: System, number: int) -> Numbers:
    """A set of guards of the run."""
    return system.guards[number * CAUSES :]


def copy_numbers(target: Numbers, source: Numbers, count: int) -> None:
    """Copy a row of numbers."""
    for k in range(count):
        target[k] = source[k]


def is_massive(system: System) -> bool:
    """Whether the scene has inertia."""
    return system.run[RUN_MASSIVE] != 0.0


def is_loaded(system: System) -> bool:
    """Whether the scene has loads."""
    return system.run[RUN_LOADED] != 0.0


def logs_events(system: System) -> bool:
    """Whether each event is logged."""
    return system.scene[IN_EVENTS] != 0.0


def prepare_system(system: System) -> None:
    """Compute the constants of the scene."""
    scene, run, data = system.scene, system.run, system.data
    effects = read_effects(data, system.row)
    for k in range(column_of(data, effects.length)):
        system.problem[k] = system.row[k]
    massive: bool = scene[IN_MASS] > 0.0
    loaded: bool = effects.length > 0 and kind_of(data, effects.length - 1) == LOAD
    run[RUN_MASSIVE], run[RUN_LOADED] = (1.0 if massive else 0.0), (1.0 if loaded else 0.0)
    run[RUN_EFFECTS], run[RUN_FEET] = float(effects.length), float(effects.feet)
    run[RUN_FRICTIONAL] = 1.0 if effects.frictional else 0.0
    run[RUN_SQUARE] = 1.0 if effects.massive else 0.0
    run[RUN_LINEAR], run[RUN_RING] = (1.0 if effects.linear else 0.0), 0.0
    for i in range(int(scene[IN_FRICTIONS])):
        if kind_of(data, i) == RING:
            run[RUN_RING] = 1.0
    load = sqrt(scene[IN_LOAD_X] * scene[IN_LOAD_X] + scene[IN_LOAD_Y] * scene[IN_LOAD_Y])
    v_x, v_y, spin = scene[IN_TWIST], scene[IN_TWIST + 1], scene[IN_TWIST + 2]
    speed = max(max(sqrt(v_x * v_x + v_y * v_y), fabs(spin)), typical_speed(system.fence))
    if speed == 0.0 and load > 0.0 and massive:
        # The speed that the load gives the slider within one length.
        speed = sqrt(load / scene[IN_MASS])
    run[RUN_SPEED] = speed if speed > 0.0 else 1.0
    run[RUN_MOMENT] = scene[IN_MASS] * scene[IN_GYRATION]
    force = scene[IN_MASS] * run[RUN_SPEED] * run[RUN_SPEED] + scene[IN_WEIGHT] + load
    run[RUN_FORCE] = force if force > 0.0 else 1.0
    run[RUN_RIGHT], run[RUN_RIGHT + 1] = unit_x(scene[IN_RIGHT]), unit_y(scene[IN_RIGHT])
    run[RUN_LEFT], run[RUN_LEFT + 1] = unit_x(scene[IN_LEFT]), unit_y(scene[IN_LEFT])
    run[RUN_ROD], run[RUN_ROD + 1] = cos(scene[IN_ANGLE]), sin(scene[IN_ANGLE])
    run[RUN_LOW], run[RUN_HIGH] = -INFINITY, INFINITY
    run[RUN_CONTACT], run[RUN_CONTACT + 1] = -scene[IN_LENGTH], 0.0
    run[RUN_POINT], run[RUN_OTHER_END] = float(NO_POINT), float(NO_POINT)


def scale_state(system: System) -> None:
    """Store typical magnitudes of the state, for the tolerance near zero."""
    scales, length = vector_of(system, SCALES), max(1.0, system.scene[IN_LENGTH])
    for k in range(system.entries):
        scales[k] = system.run[RUN_FORCE] * length
    scales[ALONG], scales[GAP], scales[ANGLE], scales[SLIPPED] = length, length, 1.0, length
    if is_massive(system):
        speed = 0.01 * system.run[RUN_SPEED]
        scales[SLIP_SPEED], scales[NORMAL_SPEED], scales[SPIN] = speed, speed, speed


def energies_of(system: System, state: Numbers) -> Numbers:
    """The energies dissipated by each effect, the last entries of a state."""
    return state[system.entries - int(system.scene[IN_RESISTING]) :]


def law_of(system: System, rod: Rod) -> Law:
    """The contact law, for a direction of the rod."""
    scene = system.scene
    return Law(
        direction_at(rod, scene[IN_RIGHT]), direction_at(rod, scene[IN_LEFT]),
        scene[IN_SLIPS] != 0.0, scene[IN_CLOSED] != 0.0, scene[IN_ROUGH] != 0.0,
    )  # fmt: skip


def candidate_at(system: System, index: int, piece: int) -> Mode:
    """A candidate mode in the span of a piece, or the mode without a contact force for a negative index."""
    during = span_at(system.fence, min(piece, system.fence.number - 1))
    if index < 0:
        return Mode(SEPARATE, NO_POINT, False, 1, False, 0.0, 0.0, 0.0, 0.0, during)
    numbers = system.candidates[index * CANDIDATE :]
    return Mode(
        int(numbers[0]), int(numbers[1]), numbers[2] != 0.0, int(numbers[12]), numbers[3] != 0.0,
        numbers[4], numbers[5], numbers[6], numbers[9], during,
    )  # fmt: skip


def write_candidate(
    system: System, index: int, contact: int, foot: int, hinged: bool, touches: bool,
    x: float, y: float, spin: float,
) -> None:  # fmt: skip
    """Store a candidate mode at the current contact."""
    numbers = system.candidates[index * CANDIDATE :]
    numbers[7], numbers[8] = system.run[RUN_POINT], system.run[RUN_OTHER_END]
    numbers[0], numbers[1] = float(contact), float(foot)
    numbers[2], numbers[3] = (1.0 if hinged else 0.0), (1.0 if touches else 0.0)
    numbers[4], numbers[5], numbers[6], numbers[9] = x, y, spin, 0.0
    numbers[BARELY_LEAVES], numbers[LASTS], numbers[DEPARTURE] = 0.0, 0.0, 1.0


def contact_mode_of(mode: Mode) -> int:
    """The contact mode, also of a slider at rest."""
    return int(mode.spin) if mode.contact == REST else mode.contact


def is_preferred(policy: int, current: int, contact: int, other: int) -> bool:
    """Whether a policy prefers a contact mode to another one, or to none, in a current mode."""
    return other == NO_MODE or _rank_of(policy, current, contact) < _rank_of(policy, current, other)


def _rank_of(policy: int, current: int, contact: int) -> int:
    """Rank of a contact mode in the order of preference of a policy."""
    preferred = NO_MODE
    if policy == PREFER_SEPARATE:
        preferred = SEPARATE
    elif policy == STAY_IN_MODE:
        preferred = current
    elif policy >= PREFER_STICK:
        preferred = STICK + (policy - PREFER_STICK)
    if contact == preferred:
        return SEPARATE
    return SLIP_LEFT + 1 if contact == SEPARATE else contact


def slip_side(contact: int) -> float:
    """Direction of slip as 1 or -1, 0 in a mode without slip."""
    return 1.0 if contact == SLIP_RIGHT else -1.0 if contact == SLIP_LEFT else 0.0


def pace_of(system: System, during: Span, time: float) -> float:
    """Time in which the slider moves about one length, or friction stops it."""
    scene, speed = system.scene, system.run[RUN_SPEED]
    if not is_massive(system):
        x, y = fence_velocity(system.fence, during, time)
        speed = sqrt(x * x + y * y)
    pace = max(1.0, scene[IN_LENGTH]) / speed if speed > 0.0 else INFINITY
    if scene[IN_MASS] * scene[IN_WEIGHT] > 0.0:
        pace = min(pace, speed * scene[IN_MASS] / scene[IN_WEIGHT])
    return pace
