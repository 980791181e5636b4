"""Every tolerance of the core, each with its reason.

A tolerance is relative to the magnitude of what it compares, unless its comment says otherwise. Limits of
iterations and bounds of formulas stand beside their functions.
"""

from __future__ import annotations

from planar_pushing.core.numbers import EPSILON

#: Rounding error of a motion or a sum of a few terms.
ROUNDING = 4.0 * EPSILON
#: Rounding error of a value that is computed in a few dozen operations, and of an angle: directions closer
#: than this (radians) are one.
RESOLUTION = 8.0 * EPSILON
#: A smaller number has lost digits (absolute): the square of a length, or a force in units of the largest.
UNDERFLOW = 1e-290
#: The square of a smaller normal motion underflows; the slips of a power of two of it are scaled, which is
#: exact (absolute).
SMALLEST_NORMAL = 1e-138
#: A smaller load, in units of the largest force, counts as none: squares of the motions that it causes, and
#: of slips much slower than these, would underflow.
SLIGHTEST_LOAD = 1e-100
#: A slip faster than this is not in proportion to a normal motion whose square underflows, but one along
#: the fence at which friction and inertia balance across the edge.
FAINT = 1e-60
#: A slip along the fence that is slower than this, relative to the motions of pusher and slider, is rest.
NOISE = 1e-24
#: The last digits of a root, and of the direction of a translation: a rotation slower than this, relative
#: to the speed, is a translation, whose center is at infinity.
RESOLVED = 1e-15
#: Rounding error of a scalar product: vectors are perpendicular, and points on a line, to within this.
ALIGNED = 16.0 * EPSILON
#: Rounding error of a rotation and of a sum over some dozens of points: a force within this of the limit of
#: a point's friction is at the limit, a step this small ends Newton's method, and a load that exceeds
#: friction by less is held.
SHARE = 1e-13
#: Motions closer than this are one motion: the root of a force along a path is known to about 1e-13, and a
#: slip this slow is a stick.
COINCIDENT = 9e-13
#: The slowest motion that is told from rest, more than what counts as one motion: a slip of a contact whose
#: pusher is at rest, or a support point that is not about to become the center of rotation.
SLOW = 1e-11
#: Smallest part of a number that is resolved beside the rest of it after a square: the root of a rounding
#: error.
SMALL_PART = 1e-8
#: Balance of the friction of a support point that barely moves, to within the error of an iteration that
#: stops at a root that is not smooth.
BALANCED = 1e-9
#: A support point slower than this is taken from the balance of torques, as its direction of motion is lost
#: in the rounding of the twist.
BARELY = 1e-5
#: The slowest motion along the fence that is looked for, in units of the normal motion, exp(-32): below it
#: only one of friction and inertia counts.
SLOWEST = 1.2664165549094176e-14
#: Part of a motion over which a force has to be constant, to rounding, for a continuum.
FLAT = 1e-3
#: Part of an interval of rotations next to its ends in which no root is looked for.
INSET = 1e-9
#: Smallest angle between the ends of a continuum, in radians.
TURN = 1e-9
#: Pieces of a support this near a line through the contact, relative to their largest distance from it,
#: are on a line as far as torques are concerned.
BESIDE_LINE = 1e-4
#: Resistance to rotation, relative to that of a mass, below which its derivatives are rounding error.
SLIGHT = 1e-10
#: Rounding error of a sum of second derivatives, relative to its terms: a matrix that a change of its
#: numbers by this much makes singular is so.
SINGULAR = 1e-14
