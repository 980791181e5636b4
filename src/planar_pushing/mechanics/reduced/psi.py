"""The reduced potential of the contact's motion: its gradient and Hessian, by one root for the rotation.

With the rotation eliminated, ``Psi(u) = min over omega`` of the sum of the effects' potentials at the twist
whose contact moves by `u` (Secs. 3 and 4). Psi is convex; its gradient is the force of the pusher, and the
torque about the contact is zero by the minimum. All is in the body frame, lengths in radii.

The torque increases with the rotation. Where the center of rotation is a support point it jumps by twice what
that point's friction can take: a root within the jump is a pivot, and leaves an interval of forces.
"""

from __future__ import annotations

from math import copysign, inf, nan, sqrt
from typing import NamedTuple

from planar_pushing.mechanics.compiled import compiled
from planar_pushing.mechanics.effects.base import (
    Resistance,
    count_points,
    energy,
    moment,
    place,
    pull,
    resistance,
)
from planar_pushing.mechanics.numerics.root import EPSILON, is_last

#: Rounding error of a motion, relative to its parts.
ROUNDING = 4.0 * EPSILON
#: Rounding error of a pivot's friction, relative to the share of the point: sums over some dozens of points.
SHARE = 1e-13
#: A support point slower than this, relative to the slider, barely moves.
NEAR = 1e-5
#: Least part of a share that is told from none beside the rest of it: the root of a rounding error.
SHORT = 1e-8
#: A point that barely moves carries at most its share, but for this part of it.
BALANCED = 1e-9
#: Steps to a rotation at most: bisection takes a bracket through 1e16 sizes to its last digit.
STEPS = 120
NOWHERE = -1


class Contact(NamedTuple):
    """Position of the contact in the body frame.

    `reach` is its distance from the origin, and (a_x, a_y) the direction in which the origin moves by a
    rotation about the contact.
    """

    x: float
    y: float
    reach: float
    a_x: float
    a_y: float


class Psi(NamedTuple):
    """Motion of the slider under one motion of the contact, and gradient and Hessian of Psi there.

    Attributes
    ----------
    v_x, v_y, spin : float
        Twist of the origin.
    f_x, f_y : float
        Force at the contact; of a pivot the middle of its interval.
    xx, xy, yy : float
        Hessian of Psi; of a pivot that of the motion about the point.
    turn_x, turn_y : float
        Derivatives of the rotation by the contact's motion.
    free_x, free_y : float
        Half of a pivot's interval of forces, zero elsewhere.
    point : int
        Number of the support point about which the slider pivots, -1 without one.
    noise_x, noise_y : float
        Rounding errors of the force.
    found : bool
        Whether the iteration has settled.
    """

    v_x: float
    v_y: float
    spin: float
    f_x: float
    f_y: float
    xx: float
    xy: float
    yy: float
    turn_x: float
    turn_y: float
    free_x: float
    free_y: float
    point: int
    noise_x: float
    noise_y: float
    found: bool


@compiled
def contact_at(x, y):
    """The contact at a position of the body frame."""
    reach = sqrt(x * x + y * y)
    return (
        Contact(x, y, reach, y / reach, -x / reach) if reach > 0.0 else Contact(x, y, 0.0, 1.0, 0.0)
    )


@compiled
def about(effects, at, x, y, spin, blur):
    """`Resistance` about the contact at a twist (x, y, spin) of the origin."""
    now = resistance(effects, x, y, spin, blur)
    a, b = at.y, -at.x
    across, turn = now.xs + a * now.xx + b * now.xy, now.ys + a * now.xy + b * now.yy
    return Resistance(
        now.f_x, now.f_y, now.torque + (a * now.f_x + b * now.f_y), now.xx, now.xy, now.yy, across, turn,
        now.ss + a * (now.xs + across) + b * (now.ys + turn), now.most, now.point, now.gross,
    )  # fmt: skip


@compiled
def spin_guess(effects, at, x, y):
    """A first guess of the rotation of a contact that moves by (x, y), exact for a mass."""
    if x == 0.0 and y == 0.0:
        return 0.0
    rough = moment(effects, sqrt(x * x + y * y), at.x, at.y)
    return (rough.y * x - rough.x * y) / rough.whole


@compiled
def _cut(effects, at, x, y, low, high, start):
    """Where a bracket is cut: at the rotation about the point nearest to its middle, else in the middle.

    The torque of a point is steepest there. Rotations count from `start`.
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
    """The rotation about a contact at rest, and `Resistance` there; without any that at rest.

    About a place that rests friction's torque is constant and that of inertia in proportion to the rotation.
    Friction holds what loads it can.
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
    """Psi of a contact at rest, where its gradient is a set: the force that takes friction least.

    At rest that is the opposite of the loads, in a rotation the force without that of a point at the contact.
    """
    spin, now = turning(effects, at)
    return _settled(now, at, spin * at.y, -spin * at.x, spin, 0.0, 0.0, 0.0, spin == spin)


@compiled
def psi(effects, at, x, y, guess, point=NOWHERE):
    """Psi at a motion (x, y) of the contact, from a guess of the rotation.

    Of a long rod the unknown is the origin's motion, which is small, and the rotation follows from it; of a
    short one the rotation. A support point with a number is taken to be across the motion from the contact.
    """
    if x == 0.0 and y == 0.0:
        return _at_rest(effects, at)
    along, speed = x * at.a_x + y * at.a_y, sqrt(x * x + y * y)
    if point >= 0:
        spin = pivot_spin(effects, at, x, y, point)
        there = _about_point(effects, at, x, y, point, spin, True)
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
                return _about_point(effects, at, x, y, now.point, spin, False)
            value -= copysign(hold, value)
        step = -value / now.ss if now.ss > 0.0 else copysign(inf, -value)
        scale = (abs(v_x) + abs(v_y) + abs(spin)) / (1.0 + at.reach)
        size = abs(step) / scale if value != 0.0 else 0.0
        if is_last(size, last):
            found = _settled(now, at, v_x, v_y, spin, step if value != 0.0 else 0.0, x, y, True)
            found = _refined(effects, at, x, y, found)
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
                found = _settled(now, at, v_x, v_y, spin, 0.0, x, y, True)
                return _refined(effects, at, x, y, found)
            last, new = inf, _next(effects, at, x, y, low, high, start, q, scale)
        elif not abs(step) < 8.0 * (abs(q) + scale):
            last, new = inf, q + copysign(8.0 * (abs(q) + scale), step)
        else:
            last = size
        q = new
    return _settled(now, at, v_x, v_y, spin, 0.0, x, y, False)


@compiled
def _next(effects, at, x, y, low, high, start, q, scale):
    """The next trial where Newton's method fails: beyond an open end of the bracket, or within it."""
    if low == -inf:
        return q - 8.0 * (abs(q) + scale)
    if high == inf:
        return q + 8.0 * (abs(q) + scale)
    return _cut(effects, at, x, y, low, high, start)


@compiled
def _settled(now, at, v_x, v_y, spin, step, x, y, found):
    """Psi from what is felt one last Newton step before the root."""
    turn_x, turn_y = (-now.xs / now.ss, -now.ys / now.ss) if now.ss > 0.0 else (0.0, 0.0)
    xx, xy, yy = now.xx + turn_x * now.xs, now.xy + turn_x * now.ys, now.yy + turn_y * now.ys
    f_x, f_y = now.f_x + step * now.xs, now.f_y + step * now.ys
    # The torque is known up to its parts' rounding, and so is the rotation.
    lever = (1.0 + at.reach) * (abs(at.a_x * f_x) + abs(at.a_y * f_y))
    noise_x = now.gross + abs(f_x) + abs(xx * x) + abs(xy * y) + lever * abs(turn_x)
    noise_y = now.gross + abs(f_y) + abs(xy * x) + abs(yy * y) + lever * abs(turn_y)
    carried = step * at.reach
    return Psi(
        v_x + carried * at.a_x, v_y + carried * at.a_y, spin + step, f_x, f_y, xx, xy, yy,
        turn_x, turn_y, 0.0, 0.0, NOWHERE, ROUNDING * noise_x, ROUNDING * noise_y, found,
    )  # fmt: skip


@compiled
def _nearest(effects, at, v_x, v_y, spin):
    """The slowest support point that is not at the contact, and a quarter of the speed of the next one."""
    found, least, next_least = NOWHERE, inf, inf
    for i in range(count_points(effects)):
        x, y = place(effects, i)
        w_x, w_y = v_x - spin * y, v_y + spin * x
        square = w_x * w_x + w_y * w_y
        if square < least and (x != at.x or y != at.y):
            found, least, next_least = i, square, least
        else:
            next_least = min(next_least, square)
    return found, sqrt(least), sqrt(next_least) / 4.0


@compiled
def _refined(effects, at, x, y, now):
    """Psi with the friction of a support point that barely moves from the balance of torques.

    It is not found where that point does not balance the torque, whose slope it makes so steep that any step
    is small.
    """
    if count_points(effects) > 0:
        i, least, apart = _nearest(effects, at, now.v_x, now.v_y, now.spin)
        if least <= NEAR * (sqrt(x * x + y * y) + at.reach * abs(now.spin)) and least < apart:
            return _about_point(effects, at, x, y, i, now.spin, False)
    return now


@compiled
def pivot_spin(effects, at, x, y, i):
    """The rotation about a support point that moves along its line to the contact at most."""
    p_x, p_y = place(effects, i)
    r_x, r_y = p_x - at.x, p_y - at.y
    return (x * r_y - y * r_x) / (r_x * r_x + r_y * r_y)


@compiled
def _about_point(effects, at, x, y, i, spin, across):
    """Psi of a rotation about a support point, or nearly: the point carries the torque that the rest leaves.

    Which way a point that barely moves does so is lost in the rounding of the twist. With the point at r from
    the contact, the part of its friction across r follows from the torques, and the part along r from its
    share, in the sense of its motion along r, ``u . r``. Where that is zero, or the point is said to be
    `across` the motion, the slider pivots about it and the part along r is an interval.
    """
    p_x, p_y = place(effects, i)
    r_x, r_y = p_x - at.x, p_y - at.y
    reach = sqrt(r_x * r_x + r_y * r_y)
    r_x, r_y = r_x / reach, r_y / reach
    ahead, aside = x * r_x + y * r_y, reach * spin - (x * r_y - y * r_x)
    if across or abs(ahead) <= ROUNDING * (abs(x * r_x) + abs(y * r_y)):
        ahead = 0.0
    w_x, w_y = ahead * r_x - aside * r_y, ahead * r_y + aside * r_x
    v_x, v_y = w_x + spin * p_y, w_y - spin * p_x
    rounding = ROUNDING * abs(spin) * (reach + at.reach)
    now = about(effects, at, v_x, v_y, spin, 2.0 * (abs(ahead) + abs(aside)) + rounding)
    found = now.point == i and abs(now.torque) <= now.most * reach * (1.0 + BALANCED)
    part = min(max(-now.torque / reach, -now.most), now.most)
    free, moves = sqrt(now.most * now.most - part * part), abs(ahead)
    f_x, f_y = now.f_x - part * r_y, now.f_y + part * r_x
    # Its friction turns with its motion: across itself, along n, the less it moves the more.
    slack, n_x, n_y, turns = 0.0, -r_y, r_x, reach
    slides = abs(aside) > rounding and free <= SHORT * now.most
    if ahead != 0.0 or slides:
        sense = copysign(1.0, ahead) if ahead != 0.0 else 0.0
        f_x, f_y = f_x + sense * free * r_x, f_y + sense * free * r_y
        n_x = (-free * r_y - sense * part * r_x) / now.most
        n_y = (free * r_x - sense * part * r_y) / now.most
        slack = abs(ahead) / free if free > SHORT * now.most else abs(aside) / now.most
        turns = reach * free / now.most
    whole = slack * now.ss + turns * turns
    turn_x, turn_y = -(slack * now.xs + turns * n_x) / whole, -(slack * now.ys + turns * n_y) / whole
    # What rounding moves the part across r by, it moves the part along r by more where that is short.
    noise = 4.0 * ROUNDING * (abs(now.f_x) + abs(now.f_y) + now.most + abs(part))
    along = noise * abs(part) / max(free, SHORT * now.most)
    pivots = 0.0 if ahead != 0.0 or slides else 1.0
    return Psi(
        v_x, v_y, spin, f_x, f_y,
        now.xx + (n_x * n_x * now.ss - turns * n_x * now.xs) / whole + turn_x * now.xs,
        now.xy + (n_x * n_y * now.ss - turns * n_y * now.xs) / whole + turn_x * now.ys,
        now.yy + (n_y * n_y * now.ss - turns * n_y * now.ys) / whole + turn_y * now.ys,
        turn_x, turn_y, pivots * free * r_x, pivots * free * r_y, i if pivots > 0.0 else NOWHERE,
        noise + along * abs(r_x), noise + along * abs(r_y), found,
    )  # fmt: skip
