"""Every tolerance of the core, each with its reason.

A tolerance is relative to the magnitude of what it compares, unless its comment says otherwise. Limits of
iterations and ranges of formulas are defined next to their functions.
"""

from __future__ import annotations

from planar_pushing.core.numbers import EPSILON

#: Rounding error of a motion or a sum of a few terms.
ROUNDING = 4.0 * EPSILON
#: Rounding error of a value that is computed in a few dozen operations, and of an angle: directions closer
#: than this (radians) are the same.
RESOLUTION = 8.0 * EPSILON
#: A smaller number has lost digits (absolute): the square of a length, or a force in units of the largest.
UNDERFLOW = 1e-290
#: The square of a smaller normal motion underflows (absolute). The motion is then multiplied by a power of
#: two and its slips are divided by it, which is exact.
SMALLEST_NORMAL = 1e-138
#: A load smaller than this, in units of the largest force, is neglected: the squares of the motions that it
#: causes, and of much slower slips, would underflow.
SLIGHTEST_LOAD = 1e-100
#: If the square of the normal motion underflows, a slip slower than this is proportional to that motion. A
#: faster one is along the fence, where friction and inertia balance across the edge.
FAINT = 1e-60
#: A slip along the fence that is slower than this, relative to the motions of pusher and slider, counts as
#: rest.
NOISE = 1e-24
#: Relative error of a root and of the direction of a translation: a rotation slower than this, relative to
#: the speed, is a translation, whose center is at infinity.
RESOLVED = 1e-15
#: Rounding error of a scalar product: vectors are perpendicular, and points on a line, to within this.
ALIGNED = 16.0 * EPSILON
#: Rounding error of a rotation and of a sum over some dozens of points: a force within this of the limit of
#: a point's friction is at the limit, a step this small ends Newton's method, and friction holds a load
#: that exceeds it by less than this.
SHARE = 1e-13
#: Motions closer than this are the same motion: the root of a force along a path is known to about 1e-13,
#: and a slip this slow is a stick.
COINCIDENT = 9e-13
#: A rotation about an end of a side this slow, relative to the motion, can be the rounding error of a force
#: through that end: the side is on the fence if a solution with that force is.
ALMOST_FLUSH = 1e-6
#: The slowest motion that is distinguished from rest, with a margin over `COINCIDENT`: a slip while the
#: pusher is at rest, or the motion of a support point that is not about to become the center of rotation.
SLOW = 1e-11
#: Smallest component of a vector, relative to its length, that is resolved from the squares of the length
#: and of the other component: the square root of a rounding error.
SMALL_PART = 1e-8
#: Relative error of the friction of a support point that barely moves: the error of an iteration that stops
#: at a nonsmooth root.
BALANCED = 1e-9
#: Relative error of the friction that a pivot needs, with a margin over `SHARE`.
LIMITED = 10.0 * SHARE
#: The friction of a support point slower than this is taken from the balance of torques, because the
#: point's direction of motion is lost in the rounding of the twist.
BARELY = 1e-5
#: The slowest motion along the fence that is searched for, exp(-32) in units of the normal motion: below
#: it, either friction or inertia is negligible.
SLOWEST = 1.2664165549094176e-14
#: Fraction of a motion over which the force of a continuum must be constant to rounding.
FLAT = 1e-3
#: Fraction of an interval of rotations, at each end, in which no root is searched for.
INSET = 1e-9
#: Smallest angle between the ends of a continuum, in radians.
TURN = 1e-9
#: Pieces of a support this close to a line through the contact, relative to their largest distance from the
#: contact, count as on the line in the balance of torques.
BESIDE_LINE = 1e-4
#: Resistance to rotation, relative to that of a mass, below which its derivatives are rounding error.
SLIGHT = 1e-10
#: Rounding error of a sum of second derivatives, relative to its terms: a matrix that becomes singular when
#: its entries change by this much counts as singular.
SINGULAR = 1e-14

# Motion over time has three tolerances: of positions, of speeds, and of forces. The others are multiples of
# them, whose order matters.

#: A position in radii, an angle in radians, or a dimensionless margin below this is zero.
SLACK = 1e-11
#: A margin this close to zero is judged by its trend, which counts as zero below the second number.
NEAR_ZERO = 10.0 * SLACK
NO_TREND = 0.1 * SLACK
#: Below this fraction of the typical speed friction holds the slider. A support point that is slower, in
#: units of the slider's speed, can be a pivot.
AT_REST = 1e-9
#: A motion slower than this is completed to rest in closed form, before friction holds the slider.
STOPPED = 2.0 * AT_REST
#: A side whose ends meet the fence in turn so fast that their heights are zero lies on the fence if it
#: rattles more slowly than this, in units of the typical speed.
RATTLES = 1e-4
#: A pusher faster than this pushes a slider at rest.
PUSHES = 0.2 * AT_REST
#: A pusher slower than this, with little acceleration, is at rest: a function can have rounding errors.
PUSHER_AT_REST = 0.1 * AT_REST
#: A support point slower than this, in units of the slider's speed, has arrived at the center of rotation;
#: one faster than the second number has left it.
ARRIVED = 0.1 * AT_REST
HAS_LEFT = 1e-5
#: A support point slower than this, in units of the slider's speed, is at the center of rotation when a
#: stick ends.
PASSES = 1e-6
#: Fraction of the tolerance allowed for one step, and its minimum. Motions about a support point are
#: resolved to some of these errors.
PART_OF_STEP = 0.02
FINEST = 2.3e-14
ERRORS = 30.0
#: A starting slider slower than this has the impending direction of motion: its own is rounding error.
NO_DIRECTION = 1e-13
#: The direction of a force below this fraction of the typical force is undefined.
NO_FORCE = 1e-9
