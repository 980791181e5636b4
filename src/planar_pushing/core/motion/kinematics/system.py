"""The system of one run: a slider, its effects, and a pusher; its state, and the modes of its motion.

The state holds the position of the contact relative to the pusher, the rod's angle, accumulated slip,
energy dissipated at the contact, and work of the pusher. With inertia, the velocity of the contact relative
to the pusher and the angular velocity follow. The energies dissipated by each effect are last.
"""

from __future__ import annotations

from math import cos, fabs, sin, sqrt
from typing import NamedTuple

from planar_pushing.core._record import Record, size_of
from planar_pushing.core.instant.cone import Law
from planar_pushing.core.instant.directions import Rod, direction_at, unit_x, unit_y
from planar_pushing.core.instant.solution import (
    MOST_SOLUTIONS,
    SEPARATE,
    Pair,
    Twist,
)
from planar_pushing.core.motion.kinematics.fence import (
    Fence,
    Span,
    fence_velocity,
    span_at,
    typical_speed,
)
from planar_pushing.core.motion.kinematics.mode import Mode, moving_mode
from planar_pushing.core.motion.kinematics.run import INPUTS, MEMORY, Inputs, Run
from planar_pushing.core.numbers import INFINITY, Numbers
from planar_pushing.core.supports.rows import (
    LOAD,
    NO_POINT,
    RING,
    Vector,
    column_of,
    count_columns,
    kind_of,
    read_effects,
)

#: Number of entries before the energies, without inertia and with it.
STILL = 6
MOVING = 9
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
#: Velocities below this part of the typical speed are as accurate as it is.
SPEED_PART = 0.01
#: Sets of guards of a run: their signs; their values at the start of a step, which those at its nodes and
#: at its end follow; near its middle; and two for trials.
SIGNS, VALUES = 0, 1
END_VALUES, MIDDLE_VALUES, TRIAL_GUARDS, LATER_GUARDS, GUARD_SETS = range(5, 10)
#: Reasons of an early end (`Stop`).
GOES_ON, INCONSISTENT, LAID_DOWN, NO_IMPULSE, SINGULAR_MOTION = range(5)
TOO_MANY_EVENTS, NO_PROGRESS, TWO_CONTACTS, TOO_MUCH_WORK = range(5, 9)


class RunState(Record):
    """The state of a run; the energies dissipated by each effect follow.

    Attributes
    ----------
    along, gap : float
        Position of the contact relative to the pusher.
    angle : float
        Of the rod.
    slipped, lost, work : float
        Accumulated slip, energy dissipated at the contact, and work of the pusher.
    slip_speed, normal_speed, spin : float
        Velocity of the contact relative to the pusher, and angular velocity; only with inertia.
    """

    along: float
    gap: float
    angle: float
    slipped: float
    lost: float
    work: float
    slip_speed: float
    normal_speed: float
    spin: float


class Candidate(Record):
    """A mode that can follow an instant: the fields of a `Mode`, its contact, and how it lasts.

    Attributes
    ----------
    point, other_end : int
        The contact's point, and the other end of a side on the fence, -1 without one.
    piece : int
        The side along which a point leaves an inner corner, -1 if it does not.
    barely_leaves : bool
        Whether the contact is an end of a side that barely moves away from the fence.
    lasts : bool
        Whether the mode lasts.
    """

    contact: int
    foot: int
    hinged: bool
    departure: int
    touches: bool
    rests_in: int
    force: Pair
    offset: float
    start: Twist
    motion: Pair
    point: int
    other_end: int
    piece: int
    barely_leaves: bool
    lasts: bool


CANDIDATE = size_of(Candidate)


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
    scene: Inputs
    times: Numbers
    fence: Fence
    run: Run
    candidates: Numbers
    vectors: Numbers
    guards: Numbers
    entries: int


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
    scene = Inputs(row[count_columns(data) :])
    times = scene[INPUTS:]
    resisting = scene.resisting
    fence = Fence(
        times[rows_of_times * scene.times :],
        scene.pieces, scene.coefficients,
    )  # fmt: skip
    problem = memory[MEMORY:]
    candidates = problem[problem_size(resisting) :]
    guards = candidates[MOST_CANDIDATES * CANDIDATE :]
    return System(
        data, row, problem, scene, times, fence, Run(memory), candidates,
        guards[GUARD_SETS * CAUSES :], guards, state_size(resisting, scene.mass > 0.0),
    )  # fmt: skip


def memory_of(system: System) -> int:
    """Number of numbers of the memory, which the rows of the log follow."""
    massive: bool = system.scene.mass > 0.0
    return memory_size(system.scene.resisting, massive)


def with_candidates(system: System, candidates: Numbers) -> System:
    """The same run with other room for candidates."""
    return System(
        system.data, system.row, system.problem, system.scene, system.times, system.fence,
        system.run, candidates, system.vectors, system.guards, system.entries,
    )  # fmt: skip


def log_of(system: System) -> Numbers:
    """The rows of the log."""
    return system.run[memory_of(system) :]


def vector_of(system: System, number: int) -> RunState:
    """A vector of the run."""
    return RunState(system.vectors[number * system.entries :])


def guards_of(system: System, number: int) -> Numbers:
    """A set of guards of the run."""
    return system.guards[number * CAUSES :]


def copy_numbers(target: Numbers, source: Numbers, count: int) -> None:
    """Copy a row of numbers."""
    for k in range(count):
        target[k] = source[k]


def is_massive(system: System) -> bool:
    """Whether the scene has inertia."""
    return system.run.massive


def is_loaded(system: System) -> bool:
    """Whether the scene has loads."""
    return system.run.loaded


def logs_events(system: System) -> bool:
    """Whether each event is logged."""
    return system.scene.logs_events


def prepare_system(system: System) -> None:
    """Compute the constants of the scene."""
    scene, run, data = system.scene, system.run, system.data
    effects = read_effects(data, system.row)
    for k in range(column_of(data, effects.length)):
        system.problem[k] = system.row[k]
    massive: bool = scene.mass > 0.0
    loaded: bool = effects.length > 0 and kind_of(data, effects.length - 1) == LOAD
    run.massive, run.loaded = (massive), (loaded)
    run.effects, run.feet = effects.length, effects.feet
    run.frictional = effects.frictional
    run.resists_squarely = effects.massive
    run.linear, run.has_ring = (effects.linear), False
    for i in range(scene.frictions):
        if kind_of(data, i) == RING:
            run.has_ring = True
    load = sqrt(scene.load.x * scene.load.x + scene.load.y * scene.load.y)
    v_x, v_y, spin = scene.twist.x, scene.twist.y, scene.twist.spin
    speed = max(max(sqrt(v_x * v_x + v_y * v_y), fabs(spin)), typical_speed(system.fence))
    if speed == 0.0 and load > 0.0 and massive:
        # The speed that the load gives the slider within one length.
        speed = sqrt(load / scene.mass)
    run.speed = speed if speed > 0.0 else 1.0
    run.moment = scene.mass * scene.gyration
    force = scene.mass * run.speed * run.speed + scene.weight + load
    run.force = force if force > 0.0 else 1.0
    run.right.x, run.right.y = unit_x(scene.right), unit_y(scene.right)
    run.left.x, run.left.y = unit_x(scene.left), unit_y(scene.left)
    run.rod.x, run.rod.y = cos(scene.angle), sin(scene.angle)
    run.low, run.high = -INFINITY, INFINITY
    wall = run.wall
    wall.piece, wall.radius = NO_POINT, INFINITY if scene.finger else 0.0
    wall.base, wall.place, wall.angle = 0.0, 0.0, scene.angle
    wall.anchor.x, wall.anchor.y = -scene.length, 0.0
    wall.rod.x, wall.rod.y = run.rod.x, run.rod.y
    wall.start, wall.end = scene.side_start, scene.side_end
    run.contact.x, run.contact.y = -scene.length, 0.0
    run.point, run.other_end = NO_POINT, NO_POINT


def scale_state(system: System) -> None:
    """Store typical magnitudes of the state, for the tolerance near zero."""
    scales, length = vector_of(system, SCALES), max(1.0, system.scene.length)
    for k in range(system.entries):
        scales[k] = system.run.force * length
    scales.along, scales.gap, scales.angle, scales.slipped = length, length, 1.0, length
    if is_massive(system):
        speed = SPEED_PART * system.run.speed
        scales.slip_speed, scales.normal_speed, scales.spin = speed, speed, speed


def energies_of(system: System, state: RunState) -> Numbers:
    """The energies dissipated by each effect, the last entries of a state."""
    return state[system.entries - system.scene.resisting :]


def law_of(system: System, rod: Rod) -> Law:
    """The contact law, for a direction of the rod."""
    scene = system.scene
    return Law(
        right=direction_at(rod, scene.right),
        left=direction_at(rod, scene.left),
        slips=scene.slips,
        closed=scene.closed,
        rough=scene.rough,
    )


def candidate_at(system: System, index: int, piece: int) -> Mode:
    """A candidate mode in the span of a piece, or the mode without a contact force for a negative index."""
    during = span_at(system.fence, min(piece, system.fence.number - 1))
    if index < 0:
        return moving_mode(SEPARATE, NO_POINT, hinged=False, departure=1, during=during)
    candidate = candidate_of(system, index)
    start = Vector(candidate.start.x, candidate.start.y, candidate.start.spin)
    return Mode(
        candidate.contact, candidate.foot, candidate.hinged, candidate.departure, candidate.touches,
        candidate.rests_in, f_x=candidate.force.x, f_y=candidate.force.y, offset=candidate.offset,
        start=start, u_x=candidate.motion.x, u_y=candidate.motion.y, during=during,
    )  # fmt: skip


def candidate_of(system: System, index: int) -> Candidate:
    """The record of a candidate mode."""
    return Candidate(system.candidates[index * CANDIDATE :])


def write_candidate(system: System, index: int, contact: int) -> Candidate:
    """Store a candidate mode at the current contact, of a slider that moves, and return its record."""
    candidate = candidate_of(system, index)
    for k in range(CANDIDATE):
        candidate[k] = 0.0
    candidate.contact, candidate.foot, candidate.departure = contact, NO_POINT, 1
    candidate.point, candidate.other_end = system.run.point, system.run.other_end
    candidate.piece = NO_POINT
    return candidate


def pace_of(system: System, during: Span, time: float) -> float:
    """Time in which the slider moves about one length, or friction stops it."""
    scene, speed = system.scene, system.run.speed
    if not is_massive(system):
        x, y = fence_velocity(system.fence, during, time)
        speed = sqrt(x * x + y * y)
    pace = max(1.0, scene.length) / speed if speed > 0.0 else INFINITY
    if scene.mass * scene.weight > 0.0:
        pace = min(pace, speed * scene.mass / scene.weight)
    return pace
