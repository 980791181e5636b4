"""The reduced potential of the contact's motion: its gradient and Hessian, from one root for the rotation.

With the rotation eliminated, ``Psi(u) = min over omega`` of the sum of the effects' potentials at the twist
whose contact moves by `u` (Secs. 3 and 4). Psi is convex. Its gradient is the force of the pusher, and the
torque about the contact is zero at the minimum. Everything is in the body frame, with lengths in radii.

The torque increases with the rotation. At a center of rotation on a support point it jumps by twice the
maximum torque of that point's friction. A root within the jump is a pivot, with an interval of forces.
"""

from __future__ import annotations

from math import copysign, inf, nan, sqrt

from planar_pushing.simulation.legacy.base import (
    Resistance,
    count_points,
    energy,
    moment,
    place,
    pull,
)
from planar_pushing.simulation.legacy.compiled import compiled
from planar_pushing.simulation.legacy.line import rotation_on_line
from planar_pushing.simulation.legacy.motion import NOWHERE, ROUNDING, about, settled
from planar_pushing.simulation.legacy.pivot import NEAR, about_point, pivot_spin, refined
from planar_pushing.simulation.legacy.root import EPSILON, is_last

#: Rounding error of a pivot's friction, relative to the share of the point, for sums over some dozens of
#: points.
SHARE = 1e-13
#: Tolerance, relative to a motion, within which a point counts as across it if another point is exactly so.
DIRECTION = 16.0 * EPSILON
#: Maximum number of steps to a rotation, enough for bisection over 16 orders of magnitude to the last
#: digit.
STEPS = 120


@compiled
def spin_guess(effects, at, x, y):
    """A first guess of the rotation of a contact that moves by (x, y), exact for a mass."""
    if x == 0.0 and y == 0.0:
        return 0.0
    rough = moment(effects, sqrt(x * x + y * y), at.x, at.y)
    return (rough.y * x - rough.x * y) / rough.whole


@compiled
def _cut(effects, at, x, y, low, high, start):
    """Place at which to cut a bracket: the rotation about the point nearest its middle, or the middle.

    The torque is steepest at rotations about a point. Rotations are relative to `start`.
    """
    middle, least = low + (high - low) / 2.0, (high - low) / 2.0
    found = middle
    for i in range(count_points(effects)):
        p_x, p_y = place(effects, i)
        r_x, r_y = p_x - at.x, p_y - at.y
        square = r_x * r_x + r_y * r_y
        if square > 0.0:
            turn = (x * r_y - y * r_x) / square - start
            if low < turn < high and abs(turn - middle) < least:
                found, least = turn, abs(turn - middle)
    return found


@compiled
def turning(effects, at):
    """The rotation about a contact at rest, and `Resistance` there, or at rest if the slider does not turn.

    About a fixed contact the torque of friction is constant, and that of inertia is proportional to the
    rotation. The slider turns only if friction cannot hold the loads.
    """
    for sense in (1.0, -1.0):
        now = about(effects, at, sense * at.y, -sense * at.x, sense, 0.0)
        whole = 2.0 * energy(effects, at.y, -at.x, 1.0)
        lack = whole - sense * now.torque
        if lack > 0.0:
            spin = sense * lack / whole if whole > 0.0 else nan
            return spin, about(effects, at, spin * at.y, -spin * at.x, spin, 0.0)
    x, y, _ = pull(effects)
    return 0.0, Resistance(-x, -y, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, NOWHERE, 0.0)


@compiled
def _at_rest(effects, at):
    """Psi of a contact at rest, where the gradient is a set: the force that takes the least friction.

    For a slider at rest this force is the opposite of the loads; for one that rotates, it excludes the
    friction of a point at the contact.
    """
    spin, now = turning(effects, at)
    return settled(now, at, spin * at.y, -spin * at.x, spin, 0.0, 0.0, 0.0, 0.0, spin == spin)


@compiled
def psi(effects, at, x, y, guess, point, across):
    """Psi at a motion (x, y) of the contact, from a guess of the rotation.

    For a long rod the unknown is the origin's motion, which is small, and the rotation follows from it; for
    a short rod it is the rotation. If `point` is the number of a support point, that point is taken to lie
    exactly across the motion from the contact, and others do to rounding; otherwise `across` is the
    tolerance, relative to the motion. A rotation that is one of an interval is the one of `reduced.line`.
    """
    if x == 0.0 and y == 0.0:
        return _at_rest(effects, at)
    level = rotation_on_line(effects, at, x, y, guess)
    if level.found:
        return level
    along, speed = x * at.a_x + y * at.a_y, sqrt(x * x + y * y)
    blurred = DIRECTION if point >= 0 else across
    if point >= 0:
        spin = pivot_spin(effects, at, x, y, point)
        there = about_point(effects, at, x, y, point, spin, inf)
        if there.found:
            return there
    rough = moment(effects, speed, at.x, at.y)
    far = 2.0 * rough.mass * at.reach * at.reach > rough.whole
    start, rest = (-along / at.reach, 0.0) if far else (0.0, along)
    p_x, p_y = x - along * at.a_x, y - along * at.a_y
    q, low, high, last = guess - start, -inf, inf, inf
    for _ in range(STEPS):
        spin, carried = start + q, rest + at.reach * q
        v_x, v_y = p_x + carried * at.a_x, p_y + carried * at.a_y
        blur = ROUNDING * (speed + at.reach * abs(spin))
        now = about(effects, at, v_x, v_y, spin, blur)
        value = now.torque
        if now.most > 0.0:
            hold = now.most * speed / abs(spin)
            if abs(value) <= hold * (1.0 + SHARE):
                spin = pivot_spin(effects, at, x, y, now.point)
                return about_point(effects, at, x, y, now.point, spin, blurred)
            value -= copysign(hold, value)
        step = -value / now.ss if now.ss > 0.0 else copysign(inf, -value)
        scale = (abs(v_x) + abs(v_y) + abs(spin)) / (1.0 + at.reach)
        size = abs(step) / scale if value != 0.0 else 0.0
        if is_last(size, last):
            step = step if value != 0.0 else 0.0
            found = settled(now, at, v_x, v_y, spin, step, x, y, abs(q), True)
            found = refined(effects, at, x, y, found, blurred)
            if found.found:
                return found
            step, size, last = copysign(8.0 * NEAR * scale, -value), 0.0, inf
        if value > 0.0:
            high = q
        else:
            low = q
        new = q + step
        if not (low < new < high) or size > last / 2.0:
            if high - low <= ROUNDING * scale:
                found = settled(now, at, v_x, v_y, spin, 0.0, x, y, abs(q), True)
                return refined(effects, at, x, y, found, blurred)
            last, new = inf, _next(effects, at, x, y, low, high, start, q, scale)
        elif not abs(step) < 8.0 * (abs(q) + scale):
            last, new = inf, q + copysign(8.0 * (abs(q) + scale), step)
        else:
            last = size
        q = new
    return settled(now, at, v_x, v_y, spin, 0.0, x, y, abs(q), False)


@compiled
def _next(effects, at, x, y, low, high, start, q, scale):
    """The next trial if Newton's method fails: beyond an open end of the bracket, or within it."""
    if low == -inf:
        return q - 8.0 * (abs(q) + scale)
    if high == inf:
        return q + 8.0 * (abs(q) + scale)
    return _cut(effects, at, x, y, low, high, start)
