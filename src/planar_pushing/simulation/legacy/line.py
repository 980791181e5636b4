"""The rotation of a slider whose support is on one line through the contact.

Let the contact move by a across that line and by b along it. A point of the support at x on the line then
moves by ``w = a + omega x`` across it, and the torque about the contact is ``sum p x w / h`` with
``h = sqrt(w^2 + b^2)``. With ``s = sgn(w)`` it is ``sum p x s - b^2 sum p x s / (h (h + |w|))``. The first
sum is constant between the rotations about two neighboring points. If it vanishes there, the second sum
determines the rotation, while the torque itself is rounding error for a small b.

For b = 0 every rotation of this interval is right, from one about a neighboring point to one about the
other. The root of the second sum is the limit for small b, which a slider passes through over time.

Points at y beside the line, such as those of a line with rounded coordinates, move by ``b - omega y``
along it in the place of b, and add ``p y (b - omega y) / h`` to the second sum; the first one need not
vanish. In the frame of its own tangent, a segment is at one y. Its x differs there, and the second sum
takes the difference.
"""

from __future__ import annotations

from collections.abc import Callable
from math import copysign, inf, log, nan, sqrt
from typing import Any, NamedTuple

import numpy as np

from planar_pushing.simulation.legacy.any_support import Support
from planar_pushing.simulation.legacy.base import Resistance, moment, pull
from planar_pushing.simulation.legacy.compiled import compiled, generic
from planar_pushing.simulation.legacy.load import Wrench
from planar_pushing.simulation.legacy.motion import NOWHERE, Contact, Psi, about, settled
from planar_pushing.simulation.legacy.pressure import ATOMS, EDGES, RINGS, SEGMENTS
from planar_pushing.simulation.legacy.root import EPSILON, root

#: Tolerance of positions on the line and of a torque that vanishes, relative to distances, and of a motion
#: across the line: a few units in the last place.
EXACT = 16.0 * EPSILON
#: Part of an interval of rotations next to its ends in which no root is looked for.
INSET = 1e-9
#: Pieces this near a line, relative to their largest distance, are treated as the text says.
NEARBY = 1e-4
#: Resistance to rotation, relative to that of a mass, below which its derivatives are rounding error.
SLIGHT = 1e-10
#: Motion of a segment's end relative to its midpoint, as a fraction of that of the midpoint, below which a
#: Gauss rule is more accurate than differences of integrals; and the nodes and shares of this rule.
SHORT = 0.2
GAUSS = tuple(zip(*(each.tolist() for each in np.polynomial.legendre.leggauss(8)), strict=True))
NOT_FOUND = Psi(
    nan, nan, nan, nan, nan, nan, nan, nan, nan, nan, 0.0, 0.0, NOWHERE, nan, nan, False, False
)


class Piece(NamedTuple):
    """A point or a segment of the support: its ends, and its friction; NaN for an area."""

    x: float
    y: float
    end_x: float
    end_y: float
    most: float


class Place(NamedTuple):
    """A piece as seen from the contact, in the frame of its own tangent; a point has that of the line.

    Attributes
    ----------
    across, along : float
        The contact's motion.
    x, half, aside : float
        Place of the midpoint along the tangent, half the length, and place of the piece beside the contact.
    middle, shift : float
        Place of the midpoint along the line, and x less this.
    most : float
        Friction.
    """

    across: float
    along: float
    x: float
    half: float
    aside: float
    middle: float
    shift: float
    most: float


class Line(NamedTuple):
    """A line of support through the contact, and the contact's motion.

    Attributes
    ----------
    effects : tuple
    at : Contact
    x, y : float
        Unit vector along the line.
    exact : bool
        Whether the support is on the line, rather than points near it.
    across, along : float
        The contact's motion.
    """

    effects: tuple[Any, ...]
    at: Contact
    x: float
    y: float
    exact: bool
    across: float
    along: float


class Sums(NamedTuple):
    """A line, and the first sum in an interval of rotations."""

    line: Line
    first: float


@compiled
def _count_first(effects):
    return _count(effects[0])


@compiled
def _count_all(effects):
    return _count(effects[0]) + _count(effects[1:])


@compiled
def _count_of_support(effect):
    return effect.pressure.starts[EDGES] - effect.pressure.starts[ATOMS]


@compiled
def _count_of_load(effect):
    return 0


@generic
def _count(kinds: Any) -> Callable[..., Any]:
    """Number of pieces: effect or effects."""
    if isinstance(kinds, tuple):
        return _count_first if len(kinds) == 1 else _count_all
    return _count_of_support if kinds is Support else _count_of_load


@compiled
def _first_piece(effects, i):
    return _piece(effects[0], i)


@compiled
def _any_piece(effects, i):
    count = _count(effects[0])
    return _piece(effects[0], i) if i < count else _piece(effects[1:], i - count)


@compiled
def _piece_of_support(effect, i):
    weight, extent, pressure = effect
    i += pressure.starts[ATOMS]
    row = pressure.rows[i]
    if i < pressure.starts[SEGMENTS]:
        x, y = extent * row[0], extent * row[1]
        return Piece(x, y, x, y, weight * row[2])
    if i < pressure.starts[RINGS]:
        half = extent * row[4]
        x, y, end_x, end_y = extent * row[0], extent * row[1], half * row[2], half * row[3]
        return Piece(x - end_x, y - end_y, x + end_x, y + end_y, weight * row[5])
    return _no_piece(effect, i)


@compiled
def _no_piece(effect, i):
    return Piece(nan, nan, nan, nan, nan)


@generic
def _piece(kinds: Any) -> Callable[..., Any]:
    """A piece: effect or effects, number of the piece."""
    if isinstance(kinds, tuple):
        return _first_piece if len(kinds) == 1 else _any_piece
    return _piece_of_support if kinds is Support else _no_piece


@compiled
def _place(line, i):
    """A piece as seen from the contact, along its own tangent."""
    x, y, end_x, end_y, most = _piece(line.effects, i)
    x, y, end_x, end_y = x - line.at.x, y - line.at.y, end_x - line.at.x, end_y - line.at.y
    one, other = line.x * x + line.y * y, line.x * end_x + line.y * end_y
    middle, half = (one + other) / 2.0, (other - one) / 2.0
    if line.exact:
        return Place(line.across, line.along, middle, half, 0.0, middle, 0.0, most)
    one, other = line.x * y - line.y * x, line.x * end_y - line.y * end_x
    aside, rise = (one + other) / 2.0, (other - one) / 2.0
    length = copysign(sqrt(half * half + rise * rise), half)
    c, s = (half / length, rise / length) if length != 0.0 else (1.0, 0.0)
    return Place(
        c * line.across - s * line.along, c * line.along + s * line.across,
        c * middle + s * aside, length, c * aside - s * middle,
        middle, s * (aside - s * middle / (1.0 + c)), most,
    )  # fmt: skip


@compiled
def _direction(effects, at):
    """Unit vector of a line through the contact, and whether all pieces are on it, and near it."""
    far_x, far_y, square = 0.0, 0.0, 0.0
    for i in range(_count(effects)):
        x, y, end_x, end_y, most = _piece(effects, i)
        if most != most:
            return 0.0, 0.0, False, False
        for r_x, r_y in ((x - at.x, y - at.y), (end_x - at.x, end_y - at.y)):
            if r_x * r_x + r_y * r_y > square:
                far_x, far_y, square = r_x, r_y, r_x * r_x + r_y * r_y
    size, exact = sqrt(square), square > 0.0
    if exact:
        far_x, far_y = far_x / size, far_y / size
    for i in range(_count(effects)):
        x, y, end_x, end_y, _ = _piece(effects, i)
        for r_x, r_y in ((x - at.x, y - at.y), (end_x - at.x, end_y - at.y)):
            aside = abs(far_x * r_y - far_y * r_x)
            if not aside <= NEARBY * size:
                return far_x, far_y, False, False
            exact &= aside <= EXACT * (size + at.reach)
    return far_x, far_y, exact, True


@compiled
def _interval(line, spin, below):
    """The rotations about neighboring ends of pieces between which a rotation is; infinite without one.

    If it is one of them itself, the interval is the one below or above it.
    """
    low, high = -inf, inf
    for i in range(_count(line.effects)):
        at = _place(line, i)
        for x in (at.x - at.half, at.x + at.half):
            if abs(x) > EXACT * line.at.reach:
                turn = -at.across / x
                if turn < spin or (turn == spin and not below):
                    low = max(low, turn)
                else:
                    high = min(high, turn)
    return low, high


@compiled
def _motions(at, spin):
    """The motions of a piece's ends across its tangent."""
    return at.across + spin * (at.x - at.half), at.across + spin * (at.x + at.half)


@compiled
def _torque(line, spin):
    """The first sum less the torque of loads, its rounding error, and whether it is constant."""
    x, y, torque = pull(line.effects)
    load, constant = torque - (line.at.x * y - line.at.y * x), True
    total, gross = -load, abs(load)
    for i in range(_count(line.effects)):
        at = _place(line, i)
        w, end = _motions(at, spin)
        part = at.most * at.middle
        if (w > 0.0) != (end > 0.0):
            # The center of rotation is in the segment and divides it into two parts with opposite senses.
            center, constant = -at.across / spin - at.x, False
            part = -at.most * (
                at.middle * center / at.half + (center * center / at.half - at.half) / 2.0
            )
        total += part if end > 0.0 else -part
        gross += at.most * (line.at.reach + abs(at.middle) + abs(at.half))
    return total, EXACT * gross, constant


@compiled
def _second(of, spin):
    """The second sum less the first one, relative to the terms; NaN if the center is in a segment."""
    line, total, gross = of.line, -of.first, abs(of.first)
    for i in range(_count(line.effects)):
        at = _place(line, i)
        (w, end), slide = _motions(at, spin), at.along - spin * at.aside
        if (w > 0.0) != (end > 0.0):
            return nan
        mean, slope, inverse = _means(abs(w), abs(end), slide)
        sense = 1.0 if w > 0.0 else -1.0
        part = sense * at.most * (mean * at.x + slope * at.half)
        if not line.exact:
            part = (
                slide * (slide * part + at.most * at.aside * inverse) - sense * at.most * at.shift
            )
        total, gross = total + part, gross + abs(part)
    return total / gross if gross > 0.0 else 0.0


@compiled
def _means(w, end, v):
    """Means from w to `end` of ``g = 1 / (h (h + w))``, g times the place in [-1, 1], and 1 / h.

    The integrals are ``-1 / (w + h)`` for g, ``(log(w + h) - w / (w + h)) / 2`` for w g, and
    ``log(w + h)`` for 1 / h.
    """
    middle, half = (w + end) / 2.0, (end - w) / 2.0
    if abs(half) < SHORT * max(middle, abs(v)):
        mean, moment, inverse = 0.0, 0.0, 0.0
        for place, share in GAUSS:
            now = middle + half * place
            h = sqrt(now * now + v * v)
            part = share / (2.0 * h * (h + now))
            mean, moment, inverse = mean + part, moment + place * part, inverse + share / (2.0 * h)
        return mean, moment, inverse
    h, k = sqrt(w * w + v * v), sqrt(end * end + v * v)
    one, other = w + h, end + k
    mean, inverse = (1.0 + 2.0 * middle / (h + k)) / (one * other), log(other / one) / (2.0 * half)
    first = inverse / 2.0 - (end / other - w / one) / (4.0 * half)
    return mean, (first - middle * mean) / half, inverse


@compiled
def _root(of, low, high):
    """The rotation without torque in an interval; NaN if there is none."""
    inset = INSET * (high - low)
    low, high = low + inset, high - inset
    first, last = _second(of, low), _second(of, high)
    return root(_second, of, low, high, first, last) if first > 0.0 > last else nan


@compiled
def _level(line, guess):
    """The rotation without torque, from the second sum; NaN if the torque itself determines it."""
    low, high = _interval(line, guess, False)
    last = 0.0
    for _ in range(2 * _count(line.effects) + 1):
        if low == -inf or high == inf:  # the torque has the sign of the rotation
            sense = 1.0 if low == -inf else -1.0
        else:
            torque, rounding, constant = _torque(line, low + (high - low) / 2.0)
            vanishes = abs(torque) <= rounding
            if constant and (vanishes or not line.exact):
                spin = _root(Sums(line, 0.0 if vanishes else torque), low, high)
                if vanishes or spin == spin:
                    return spin
            sense = -1.0 if torque > 0.0 else 1.0
        if sense == -last:
            break
        low, high = _interval(line, high, False) if sense > 0.0 else _interval(line, low, True)
        last = sense
    return nan


@generic
def rotation_on_line(kinds: Any) -> Callable[..., Any]:
    """`Psi` at a motion of the contact for which the first sum vanishes, otherwise not found.

    Arguments: effects, contact, its motion, and a guess of the rotation.
    """
    return _rotation if set(kinds) <= {Support, Wrench} else _no_rotation


@compiled
def _no_rotation(effects, at, x, y, guess):
    return NOT_FOUND


@compiled
def _rotation(effects, at, x, y, guess):
    along_x, along_y, exact, near = _direction(effects, at)
    across, along = along_x * y - along_y * x, along_x * x + along_y * y
    # If the contact rather moves along the line, the torque itself determines the rotation well.
    if not near or abs(along) > abs(across):
        return NOT_FOUND
    spin = _level(Line(effects, at, along_x, along_y, exact, across, along), guess)
    if spin != spin:
        return NOT_FOUND
    v_x, v_y, speed = x + spin * at.y, y - spin * at.x, sqrt(x * x + y * y)
    now, rough = about(effects, at, v_x, v_y, spin, 0.0), moment(effects, speed, at.x, at.y)
    free = exact and abs(along) <= EXACT * speed
    if not free and now.ss > SLIGHT * (rough.whole + rough.mass * at.reach * at.reach):
        return settled(now, at, v_x, v_y, spin, 0.0, x, y, abs(spin), True)
    # The rotation is proportional to the motion across the line, and the force does not depend on it.
    now = settled(
        Resistance(
            now.f_x, now.f_y, 0.0, now.xx, now.xy, now.yy, 0.0, 0.0, 0.0, 0.0, NOWHERE, now.gross
        ),
        at, v_x, v_y, spin, 0.0, x, y, abs(spin), True,
    )  # fmt: skip
    return Psi(
        v_x, v_y, spin, now.f_x, now.f_y, now.xx, now.xy, now.yy,
        -spin / across * along_y, spin / across * along_x, 0.0, 0.0, NOWHERE,
        now.noise_x, now.noise_y, free, True,
    )  # fmt: skip
