"""A run as rows of numbers: its inputs, its memory, and its log.

A row of inputs begins with the numbers of the effects: friction, viscous friction, inertia and loads, in
this order. The scene follows, then the times at which the run is logged, and last the pieces of the
pusher's motion. A row of results holds the memory of the run, with which it can be continued at any time,
and then the rows of its log. Lengths are in radii of the slider.
"""

from __future__ import annotations

#: Inputs of a run, after the numbers of its effects. Weight of the friction, zero without friction; mass,
#: square of the radius of gyration, and center of mass, zero without inertia; force of the loads in the
#: initial body frame, and its cross and dot products with their points.
IN_WEIGHT, IN_MASS, IN_GYRATION, IN_MASS_X, IN_MASS_Y = range(5)
IN_LOAD_X, IN_LOAD_Y, IN_CROSS, IN_DOT = range(5, 9)
#: Length and angle of the rod; edges of the friction cone, and whether the law slips, is closed and rough;
#: initial twist; initial gap.
IN_LENGTH, IN_ANGLE, IN_RIGHT, IN_LEFT, IN_SLIPS, IN_CLOSED, IN_ROUGH = range(9, 16)
IN_TWIST, IN_GAP = 16, 19
#: Whether the pusher is a finger; its radius; ends of its side, relative to the contact.
IN_FINGER, IN_RADIUS, IN_SIDE_START, IN_SIDE_END = range(20, 24)
#: Slider's radius in tolerances of its outline, zero without an outline; number of the outline's corners,
#: zero if they are not given, and their place in the data, in units of its tolerance.
IN_FINE, IN_CORNERS, IN_CORNERS_PLACE = range(24, 27)
#: Numbers of the effects that are friction, and of those that resist: friction and viscous friction.
IN_FRICTIONS, IN_RESISTING = range(27, 29)
#: Relative tolerance; number of pieces of the pusher's motion, and of coefficients in each of their series;
#: number of times to log; whether each event is logged as well, or only the times.
IN_TOLERANCE, IN_PIECES, IN_COEFFICIENTS, IN_TIMES, IN_EVENTS = range(29, 34)
#: Whether the side between its ends lies on the fence.
IN_FLUSH = 34
#: Number of inputs of a scene. The times follow. For steps they are three rows: the ends of the intervals
#: that are divided into equal steps, the numbers of steps, and the pieces in which the intervals begin.
INPUTS = 35

#: A piece of the pusher's motion: its time interval and the degree of its polynomials; the pieces of its
#: span of smooth velocity, from the first to before the last; its policy; the rounding error of each
#: velocity component; the displacement at its start; then six series of Chebyshev coefficients, for the
#: components of velocity, acceleration, and mean velocity since the start of the piece.
PIECE_START, PIECE_END, PIECE_DEGREE, PIECE_FIRST, PIECE_LAST, PIECE_POLICY = range(6)
PIECE_NOISE, PIECE_ORIGIN, PIECE_SERIES = 6, 8, 10
SERIES_OF_PIECE = 6

#: The first numbers of a row of results: whether the run has ended, how many rows of its log are new,
#: changes of the mode, events, how many of them at one instant, and the current contact mode.
RUN_ENDED, RUN_ROWS, RUN_CHANGES, RUN_EVENTS, RUN_AT_ONCE, RUN_MODE = range(6)

#: A row of the log. Position is that of the slider's center, the angle is that of the rod in radians, and
#: the displacement is that of the pusher. The position of the contact is where its force acts along the
#: pusher. The impulse is the sum of those since the row before. The last entries are the energies
#: dissipated by each effect.
LOG_TIME, LOG_POSITION, LOG_ANGLE, LOG_TWIST, LOG_PUSHER = 0, 1, 3, 4, 7
LOG_SLIP, LOG_GAP, LOG_FORCE, LOG_MODE, LOG_SOLUTIONS = 9, 10, 11, 13, 14
LOG_PIVOT, LOG_EVENT, LOG_RATIO, LOG_CONTACT_DISSIPATED, LOG_WORK = range(15, 20)
LOG_LOAD_WORK, LOG_KINETIC, LOG_EVALUATIONS, LOG_STOPPED = range(20, 24)
LOG_CONTACT_POSITION, LOG_PARTED, LOG_FLUSH = range(24, 27)
LOG_IMPULSE, LOG_DISSIPATED = 27, 29

#: The rest of the memory. Times: that of the state, the end of the current step, an event in it, the choice
#: of the mode, a kink of the motion, and the last check for progress.
RUN_TIME, RUN_UNTIL, RUN_EVENT, RUN_BEFORE, RUN_KINK, RUN_CHECKED = range(6, 12)
#: Whether the motion is smooth (0), or has its kink ahead (-1) or behind (1); sizes of the next step and of
#: the last, with its error.
RUN_SIDE, RUN_PLANNED, RUN_LAST_SIZE, RUN_LAST_ERROR = range(12, 16)
#: What is to be done next; current piece of the pusher's motion; chosen candidate and number of candidates;
#: number of consistent modes; next time to log; cause of the next event; reason of an early end; steps.
RUN_PHASE, RUN_PIECE, RUN_CHOSEN, RUN_SOLUTIONS = range(16, 20)
RUN_NEXT, RUN_CAUSE, RUN_STOPPED, RUN_STEPS = range(21, 25)
#: Whether a mode has just begun; whether the dense output of the step is known; evaluations of the motion;
#: whether a finger has left its side for good; positions of its contact between which it meets no other
#: point of the outline.
RUN_FRESH, RUN_PREPARED, RUN_EVALUATIONS, RUN_PARTED, RUN_LOW, RUN_HIGH = range(25, 31)
#: Constants of the scene: typical speed and force, to which tolerances are relative; moment of inertia;
#: edges of the friction cone and direction of the rod at time 0 as unit vectors; whether it has inertia and
#: loads; number of its effects; number of support points; properties of the effects (`Effects`); whether
#: its own ring is among them.
RUN_SPEED, RUN_FORCE, RUN_MOMENT, RUN_RIGHT, RUN_LEFT, RUN_ROD = 31, 32, 33, 34, 36, 38
RUN_MASSIVE, RUN_LOADED, RUN_EFFECTS, RUN_FEET = range(40, 44)
RUN_FRICTIONAL, RUN_SQUARE, RUN_LINEAR, RUN_RING = range(44, 48)
#: For steps: interval, and step in it; start of the interval; displacement of the pusher until now, and in
#: the step; twist in the world at its start; force; pivot; work of the loads; energy dissipated at the
#: contact; twist in the contact frame at its end.
RUN_INTERVAL, RUN_STEP, RUN_INTERVAL_START = range(48, 51)
RUN_PUSHER, RUN_PATH, RUN_TWIST, RUN_PUSH = 51, 53, 55, 58
RUN_PIVOT, RUN_LOAD_WORK, RUN_CONTACT_LOST, RUN_NEW_TWIST = range(60, 64)
#: If only the times are logged: the row of the log for the next one.
RUN_SLOT = 66
#: The contact: its position in the body frame, its number among the points that can touch a fence, and that
#: of the other end of a side on the fence, -1 without one; the height of the lowest other point at the
#: start of the mode, if it is below the fence within the tolerance. For steps: place of the force from the
#: contact.
RUN_CONTACT, RUN_POINT, RUN_OTHER_END, RUN_FLOOR, RUN_OFFSET = 67, 69, 70, 71, 72
#: Sum of the impulses at the contact since the last row of the log, along the axes of the world.
RUN_IMPULSE = 73
#: Number of these numbers. Work arrays follow: the effects' numbers for the problem at hand, candidate
#: modes, vectors of the state, and guards.
MEMORY = 75
