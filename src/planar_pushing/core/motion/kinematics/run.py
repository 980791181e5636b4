"""A run as rows of numbers: its inputs, its memory, and its log.

A row of inputs begins with the numbers of the effects: friction, viscous friction, inertia and loads, in
this order. The scene follows, then the times at which the run is logged, and last the pieces of the
pusher's motion. A row of results holds the memory of the run, with which it can be continued at any time,
and then the rows of its log. Lengths are in radii of the slider.
"""

from __future__ import annotations

from planar_pushing.core._record import Record, size_of
from planar_pushing.core.instant.solution import Pair, Twist


class Inputs(Record):
    """Inputs of a run, after the numbers of its effects.

    The times follow. For steps they are three rows: the ends of the intervals that are divided into equal
    steps, the numbers of steps, and the pieces in which the intervals begin.

    Attributes
    ----------
    weight : float
        Weight of the friction, zero without friction.
    mass, gyration, center : float, float, Pair
        Mass, square of the radius of gyration, and center of mass; zero without inertia.
    load, cross, dot : Pair, float, float
        Force of the loads in the initial body frame, and its cross and dot products with their points.
    length, angle : float
        Of the rod.
    right, left, slips, closed, rough : float, float, bool, bool, bool
        Edges of the friction cone, and properties of the contact law.
    twist, gap : Twist, float
        At time 0.
    finger, radius, side_start, side_end : bool, float, float, float
        Whether the pusher is a finger; its radius; ends of its side, relative to the contact.
    fine, chain, chain_place : float, int, int
        Slider's radius in tolerances of its outline, zero without an outline; number of the pieces of the
        outline, and their place in the data, in the frame of the outline and in units of its tolerance.
    frame, axis, turn : Pair, Pair, float
        Origin of the body frame in that of the outline, in the same unit, and direction of body x there,
        as a unit vector and as an angle.
    wall, place : int, float
        The piece at the contact at time 0, -1 if it is not known, and its place: distance from the start of
        a side, or direction of the tangent.
    frictions, resisting : int
        Numbers of the effects that are friction, and of those that resist: friction and viscous friction.
    tolerance : float
        Relative.
    pieces, coefficients : int
        Numbers of pieces of the pusher's motion, and of coefficients in each of their series.
    times, logs_events : int, bool
        Number of times to log; whether each event is logged as well, or only the times.
    flush : bool
        Whether the side between its ends lies on the fence.
    """

    weight: float
    mass: float
    gyration: float
    center: Pair
    load: Pair
    cross: float
    dot: float
    length: float
    angle: float
    right: float
    left: float
    slips: bool
    closed: bool
    rough: bool
    twist: Twist
    gap: float
    finger: bool
    radius: float
    side_start: float
    side_end: float
    fine: float
    chain: int
    chain_place: int
    frame: Pair
    axis: Pair
    turn: float
    wall: int
    place: float
    frictions: int
    resisting: int
    tolerance: float
    pieces: int
    coefficients: int
    times: int
    logs_events: bool
    flush: bool


class PusherPiece(Record):
    """A piece of the pusher's motion.

    Six series of Chebyshev coefficients follow, for the components of velocity, acceleration, and mean
    velocity since the start of the piece.

    Attributes
    ----------
    start, end : float
    degree : int
        Of its polynomials.
    first, last : int
        The pieces of its span of smooth velocity, from the first to before the last.
    policy : int
    noise : Pair
        Rounding error of each velocity component.
    origin : Pair
        Displacement at its start.
    """

    start: float
    end: float
    degree: int
    first: int
    last: int
    policy: int
    noise: Pair
    origin: Pair


class LogRow(Record):
    """A row of the log; the energies dissipated by each effect follow.

    Attributes
    ----------
    position, angle, twist : Pair, float, Twist
        Of the slider's center in the world; the angle is that of the rod in radians.
    pusher : Pair
        Displacement of the pusher.
    contact_position, contact_normal, contact_piece : float, float, int
        Where the force acts along a fence, or the contact is along the outline; rotation of the contact
        frame since time 0; and the piece of the outline at the contact, -1 if it is not known.
    impulse : Pair
        Sum of the impulses since the row before.
    """

    time: float
    position: Pair
    angle: float
    twist: Twist
    pusher: Pair
    slip: float
    gap: float
    force: Pair
    mode: int
    solutions: int
    pivot: int
    event: int
    ratio: float
    contact_dissipated: float
    work: float
    load_work: float
    kinetic: float
    evaluations: int
    stopped: int
    contact_position: float
    contact_normal: float
    contact_piece: int
    parted: bool
    flush: bool
    impulse: Pair


class Wall(Record):
    """The piece of the slider's outline that is at the contact: a side, an arc, or a corner.

    Attributes
    ----------
    piece : int
        Its number, -1 if it is not known or the contact is open.
    anchor : Pair
        In the body frame: the center of an arc, the corner, or the point of a side at the position `base`.
    radius : float
        Of curvature: infinite for a side, 0 for a corner, and negative for a hollow arc.
    base, place : float, float
        A position of the contact, and its place on the piece: distance from the start of a side, or
        direction of the tangent.
    angle, rod : float, Pair
        Angle and direction of body x in the contact frame there.
    start, end : float
        Its ends, along the pusher's path on the outline, from the contact at time 0 toward +x.
    position : float
        Arc length of the outline at the position `base`, from the contact at time 0.
    pocket : float
        At an inner corner, half of the angle between the normals of its sides; otherwise 0. A point there
        only sticks, and its frame, about the bisector, rotates with the slider.
    """

    piece: int
    anchor: Pair
    radius: float
    base: float
    place: float
    angle: float
    rod: Pair
    start: float
    end: float
    position: float
    pocket: float


class Misjudged(Record):
    """Whether each contact mode, by its number, was misjudged at an instant."""

    separate: bool
    stick: bool
    slip_right: bool
    slip_left: bool


class Run(Record):
    """The memory of a run, at the beginning of a row of results.

    Work arrays follow: the effects' numbers for the problem at hand, candidate modes, vectors of the state,
    and guards.

    Attributes
    ----------
    ended, rows, changes, events, at_once : bool, int, int, int, int
        Whether the run has ended; how many rows of its log are new; changes of the mode; events, and how
        many of them at one instant.
    mode, misjudged : int, Misjudged
        Current contact mode; modes that were chosen at this instant and did not last.
    time, until, event_time, mode_began, kink, checked : float
        Times of the state, the end of the current step, an event in it, the choice of the mode, a kink of
        the motion, and the last check for progress.
    kink_side : int
        Whether the motion is smooth (0), or has its kink ahead (-1) or behind (1).
    planned, last_size, last_error : float
        Sizes of the next step and of the last, with its error.
    phase, piece, chosen, solutions : int
        What is to be done next; current piece of the pusher's motion; chosen candidate; number of
        consistent modes.
    next_time, cause, stopped, steps : int
        Next time to log; cause of the next event; reason of an early end; steps.
    fresh, prepared : bool
        Whether a mode has just begun; whether the dense output of the step is known.
    implicit, extends : bool
        Whether steps are implicit; whether the last step was, so that its polynomial extends into the next.
    relaxations : float
        Number of relaxation times that the mode has lasted.
    evaluations : int
        Of the motion.
    parted, low, high : bool, float, float
        Whether a finger has left its side for good; positions of its contact between which it meets no
        other point of the outline.
    speed, force : float
        Typical ones, to which tolerances are relative.
    moment : float
        Of inertia.
    right, left, rod : Pair
        Edges of the friction cone, and direction of the rod at time 0, as unit vectors.
    massive, loaded, effects, feet : bool, bool, int, int
        Whether the scene has inertia and loads; numbers of its effects and of its support points.
    frictional, resists_squarely, linear : bool
        Properties of the effects (`Effects`).
    has_ring : bool
        Whether its own ring is among them.
    interval, step, interval_start : int, int, float
        Of a run in steps.
    pusher, path : Pair
        Displacement of the pusher until now, and in the step.
    twist, new_twist : Twist
        In the world at the start of a step; in the contact frame at its end.
    push, pivot : Pair, int
        Force and pivot of a step.
    load_work, contact_lost : float
        Work of the loads, and energy dissipated at the contact.
    slot : int
        If only the times are logged: the row of the log for the next one.
    contact, point, other_end : Pair, int, int
        The contact: its position in the body frame, its number among the points that can touch a fence, and
        that of the other end of a side on the fence, -1 without one.
    floor : float
        Height of the lowest other point at the start of the mode, if it is below the fence within the
        tolerance.
    offset : float
        Place of the force of a step from the contact.
    impulse : Pair
        Sum of the impulses at the contact since the last row of the log, along the axes of the world.
    wall : Wall
        At the contact.
    """

    ended: bool
    rows: int
    changes: int
    events: int
    at_once: int
    mode: int
    misjudged: Misjudged
    time: float
    until: float
    event_time: float
    mode_began: float
    kink: float
    checked: float
    kink_side: int
    planned: float
    last_size: float
    last_error: float
    phase: int
    piece: int
    chosen: int
    solutions: int
    next_time: int
    cause: int
    stopped: int
    steps: int
    fresh: bool
    prepared: bool
    implicit: bool
    extends: bool
    relaxations: float
    evaluations: int
    parted: bool
    low: float
    high: float
    speed: float
    force: float
    moment: float
    right: Pair
    left: Pair
    rod: Pair
    massive: bool
    loaded: bool
    effects: int
    feet: int
    frictional: bool
    resists_squarely: bool
    linear: bool
    has_ring: bool
    interval: int
    step: int
    interval_start: float
    pusher: Pair
    path: Pair
    twist: Twist
    push: Pair
    pivot: int
    load_work: float
    contact_lost: float
    new_twist: Twist
    slot: int
    contact: Pair
    point: int
    other_end: int
    floor: float
    offset: float
    impulse: Pair
    wall: Wall


#: Number of series of a piece.
SERIES_OF_PIECE = 6
#: Numbers of a scene's inputs, of a piece before its series, of a row of the log before the energies, and
#: of the memory before the work arrays.
INPUTS, PIECE, LOG_ROW, MEMORY = (
    size_of(Inputs),
    size_of(PusherPiece),
    size_of(LogRow),
    size_of(Run),
)
