"""The rotation of a slider whose support is on one line through the contact.

Let the contact move by a across that line and by b along it. A point of the support at x on the line then
moves by ``w = a + omega x`` across it, and the torque about the contact is ``sum p x w / h`` with
``h = sqrt(w^2 + b^2)``. With ``s = sgn(w)`` it is ``sum p x s - b^2 sum p x s / (h (h + |w|))``. The first
sum is constant between the rotations about two neighboring points. If it vanishes there, the second sum
determines the rotation, while the torque itself is rounding error for a small b.

For b = 0 every rotation of this interval, between those about the two neighboring points, is a solution.
The root of the second sum is the limit for small b, which a slider passes through over time.

Points at a distance y from the line, such as those of a line with rounded coordinates, move along it by
``b - omega y`` instead of b. They add ``p y (b - omega y) / h`` to the second sum, and the first one need
not vanish. A segment is described in the frame of its own tangent, in which its y is constant. Its x
differs from that along the line, and the second sum includes the difference.
"""

from __future__ import annotations

from math import copysign, fabs, log, sqrt
from typing import NamedTuple

from planar_pushing.core.numbers import GAUSS_NODES, GAUSS_WEIGHTS, INFINITY, UNKNOWN
from planar_pushing.core.supports.contact import Contact, resistance_about
from planar_pushing.core.supports.piece_rows import COLUMNS, AtomRow, LineRow
from planar_pushing.core.supports.pieces import head_of
from planar_pushing.core.supports.potential import Psi, potential_at, unknown_psi
from planar_pushing.core.supports.resistance import Resistance, load_wrench, rough_mass
from planar_pushing.core.supports.roots import (
    ITERATIONS,
    best_number,
    is_narrow,
    narrow_bracket,
    next_number,
    open_bracket,
)
from planar_pushing.core.supports.rows import (
    NO_POINT,
    SUPPORT,
    Effects,
    SupportRow,
    column_of,
    kind_of,
    pressure_of,
)
from planar_pushing.core.supports.tolerances import ALIGNED, BESIDE_LINE, INSET, RESOLVED, SLIGHT

#: Motion of a segment's end relative to its midpoint, as a fraction of that of the midpoint, below which a
#: Gauss rule is more accurate than differences of integrals.
SHORT_MOTION = 0.2


class Ends(NamedTuple):
    """A point or a segment of the support: its ends in the body frame, and its friction."""

    x: float
    y: float
    end_x: float
    end_y: float
    friction: float


class Line(NamedTuple):
    """A line of support through the contact, and the contact's motion.

    Attributes
    ----------
    effects : Effects
    contact : Contact
    pieces : int
        Number of pieces; 0 unless they are on a line through the contact, or nearly so.
    x, y : float
        Unit vector along the line.
    exact : bool
        Whether the support is on the line, rather than near it.
    across, along : float
        The contact's motion.
    """

    effects: Effects
    contact: Contact
    pieces: int
    x: float
    y: float
    exact: bool
    across: float
    along: float


class Seat(NamedTuple):
    """A piece as seen from the contact, in the frame of its own tangent; for a point, in that of the line.

    Attributes
    ----------
    across, along : float
        The contact's motion.
    x, half, y : float
        Position of the midpoint along the tangent, half the length, and position of the piece across the
        tangent.
    middle, shift : float
        Position of the midpoint along the line, and x minus this position.
    friction : float
    """

    across: float
    along: float
    x: float
    half: float
    y: float
    middle: float
    shift: float
    friction: float


class Interval(NamedTuple):
    """An interval of rotations."""

    low: float
    high: float


class FirstSum(NamedTuple):
    """The first sum minus the torque of loads, its rounding error, and whether it is constant nearby."""

    torque: float
    rounding: float
    constant: bool


class Means(NamedTuple):
    """Means over the motions of a segment of ``g = 1 / (h (h + w))``, g times x in [-1, 1], and 1 / h."""

    mean: float
    slope: float
    inverse: float


def _count_pieces(effects: Effects) -> int:
    """Number of points and segments."""
    count = 0
    for effect in range(effects.length):
        if kind_of(effects.data, effect) == SUPPORT:
            head = head_of(pressure_of(effects, effect))
            count += (head.rings - head.atoms) // COLUMNS
    return count


def _ends_of(effects: Effects, number: int) -> Ends:
    """The ends of a piece."""
    for effect in range(effects.length):
        if kind_of(effects.data, effect) == SUPPORT:
            pressure = pressure_of(effects, effect)
            head = head_of(pressure)
            first = head.atoms + COLUMNS * number
            if first < head.rings:
                support = SupportRow(effects.row[column_of(effects.data, effect) :])
                weight, extent = effects.one * support.weight, support.extent
                if first < head.segments:
                    atom = AtomRow(pressure.data[first:])
                    x, y = extent * atom.x, extent * atom.y
                    return Ends(x, y, end_x=x, end_y=y, friction=weight * atom.share)
                line = LineRow(pressure.data[first:])
                x, y, half = extent * line.x, extent * line.y, extent * line.half
                t_x, t_y, friction = half * line.t_x, half * line.t_y, weight * line.share
                return Ends(x - t_x, y - t_y, end_x=x + t_x, end_y=y + t_y, friction=friction)
            number -= (head.rings - head.atoms) // COLUMNS
    return Ends(x=0.0, y=0.0, end_x=0.0, end_y=0.0, friction=0.0)


def _line_of(effects: Effects, contact: Contact, x: float, y: float) -> Line:
    """The line of a support through a contact that moves by (x, y)."""
    count, square, far_x, far_y = _count_pieces(effects), 0.0, 0.0, 0.0
    for i in range(count):
        ends = _ends_of(effects, i)
        for k in range(2):
            r_x = (ends.x if k == 0 else ends.end_x) - contact.x
            r_y = (ends.y if k == 0 else ends.end_y) - contact.y
            if r_x * r_x + r_y * r_y > square:
                far_x, far_y, square = r_x, r_y, r_x * r_x + r_y * r_y
    size = sqrt(square)
    exact: bool = square > 0.0
    if exact:
        far_x, far_y = far_x / size, far_y / size
    for i in range(count):
        ends = _ends_of(effects, i)
        for k in range(2):
            r_x = (ends.x if k == 0 else ends.end_x) - contact.x
            r_y = (ends.y if k == 0 else ends.end_y) - contact.y
            beside = fabs(far_x * r_y - far_y * r_x)
            if beside > BESIDE_LINE * size:
                return Line(
                    effects, contact, 0, x=far_x, y=far_y, exact=False, across=0.0, along=0.0
                )
            exact = exact and beside <= ALIGNED * (size + contact.reach)
    across, along = far_x * y - far_y * x, far_x * x + far_y * y
    return Line(effects, contact, count, x=far_x, y=far_y, exact=exact, across=across, along=along)


def _seat_of(line: Line, number: int) -> Seat:
    """A piece as seen from the contact, along its own tangent."""
    ends = _ends_of(line.effects, number)
    x, y = ends.x - line.contact.x, ends.y - line.contact.y
    end_x, end_y = ends.end_x - line.contact.x, ends.end_y - line.contact.y
    first, last = line.x * x + line.y * y, line.x * end_x + line.y * end_y
    middle, half = (first + last) / 2.0, (last - first) / 2.0
    if line.exact:
        return Seat(
            line.across,
            line.along,
            x=middle,
            half=half,
            y=0.0,
            middle=middle,
            shift=0.0,
            friction=ends.friction,
        )
    first, last = line.x * y - line.y * x, line.x * end_y - line.y * end_x
    middle_across, half_across = (first + last) / 2.0, (last - first) / 2.0
    length = copysign(sqrt(half * half + half_across * half_across), half)
    c, s = 1.0, 0.0
    if length != 0.0:
        c, s = half / length, half_across / length
    return Seat(
        across=c * line.across - s * line.along,
        along=c * line.along + s * line.across,
        x=c * middle + s * middle_across,
        half=length,
        y=c * middle_across - s * middle,
        middle=middle,
        shift=s * (middle_across - s * middle / (1.0 + c)),
        friction=ends.friction,
    )


def _interval_at(line: Line, spin: float, below: bool) -> Interval:
    """The interval around a rotation, bounded by rotations about ends of pieces, or infinite.

    If the rotation is itself about an end, the interval is the one below or above it.
    """
    low, high = -INFINITY, INFINITY
    for i in range(line.pieces):
        seat = _seat_of(line, i)
        for k in range(2):
            x = seat.x - seat.half if k == 0 else seat.x + seat.half
            if fabs(x) > ALIGNED * line.contact.reach:
                turn = -seat.across / x
                if turn < spin or (turn == spin and not below):
                    low = max(low, turn)
                else:
                    high = min(high, turn)
    return Interval(low, high)


def _first_sum(line: Line, spin: float) -> FirstSum:
    """`FirstSum` at a rotation."""
    wrench = load_wrench(line.effects)
    load = wrench.spin - (line.contact.x * wrench.y - line.contact.y * wrench.x)
    constant: bool = True
    total, terms = -load, fabs(load)
    for i in range(line.pieces):
        seat = _seat_of(line, i)
        first = seat.across + spin * (seat.x - seat.half)
        last = seat.across + spin * (seat.x + seat.half)
        part = seat.friction * seat.middle
        if (first > 0.0) != (last > 0.0):
            # The center of rotation is in the segment and divides it into two parts that move in opposite
            # senses.
            constant = False
            center, half = -seat.across / spin - seat.x, seat.half
            part = -seat.friction * (
                seat.middle * center / half + (center * center / half - half) / 2.0
            )
        total += part if last > 0.0 else -part
        terms += seat.friction * (line.contact.reach + fabs(seat.middle) + fabs(seat.half))
    return FirstSum(total, ALIGNED * terms, constant)


def _second_sum(line: Line, first_sum: float, spin: float) -> float:
    """The second sum minus the first one, relative to its terms; NaN if the center is in a segment."""
    total, terms = -first_sum, fabs(first_sum)
    for i in range(line.pieces):
        seat = _seat_of(line, i)
        first = seat.across + spin * (seat.x - seat.half)
        last = seat.across + spin * (seat.x + seat.half)
        slide = seat.along - spin * seat.y
        if (first > 0.0) != (last > 0.0):
            return UNKNOWN
        means = _means_of(fabs(first), fabs(last), slide)
        sense = 1.0 if first > 0.0 else -1.0
        part = sense * seat.friction * (means.mean * seat.x + means.slope * seat.half)
        if not line.exact:
            part = (
                slide * (slide * part + seat.friction * seat.y * means.inverse)
                - sense * seat.friction * seat.shift
            )
        total, terms = total + part, terms + fabs(part)
    return total / terms if terms > 0.0 else 0.0


def _means_of(first: float, last: float, slide: float) -> Means:
    """`Means` from the motions of the ends across, and the motion along.

    The integrals are ``-1 / (w + h)`` for g, ``(log(w + h) - w / (w + h)) / 2`` for w g, and
    ``log(w + h)`` for 1 / h.
    """
    middle, half = (first + last) / 2.0, (last - first) / 2.0
    if fabs(half) < SHORT_MOTION * max(middle, fabs(slide)):
        mean, slope, inverse = 0.0, 0.0, 0.0
        for i in range(len(GAUSS_NODES)):
            w = middle + half * GAUSS_NODES[i]
            h = sqrt(w * w + slide * slide)
            part = GAUSS_WEIGHTS[i] / (2.0 * h * (h + w))
            mean, slope = mean + part, slope + GAUSS_NODES[i] * part
            inverse += GAUSS_WEIGHTS[i] / (2.0 * h)
        return Means(mean, slope, inverse)
    h, k = sqrt(first * first + slide * slide), sqrt(last * last + slide * slide)
    start, end = first + h, last + k
    if start == 0.0 or end == 0.0 or half == 0.0:
        return Means(INFINITY, UNKNOWN, INFINITY)
    mean = (1.0 + 2.0 * middle / (h + k)) / (start * end)
    inverse = log(end / start) / (2.0 * half)
    moment = inverse / 2.0 - (last / end - first / start) / (4.0 * half)
    return Means(mean, (moment - middle * mean) / half, inverse)


def _root_in(line: Line, first_sum: float, low: float, high: float) -> float:
    """The rotation in an interval at which the torque is zero; NaN if there is none."""
    inset = INSET * (high - low)
    low, high = low + inset, high - inset
    first, last = _second_sum(line, first_sum, low), _second_sum(line, first_sum, high)
    if not first > 0.0 > last:
        return UNKNOWN
    bracket = open_bracket(low, high, at_low=first, at_high=last, resolution=RESOLVED)
    for _ in range(ITERATIONS):
        spin = next_number(bracket)
        bracket = narrow_bracket(bracket, spin, _second_sum(line, first_sum, spin))
        if is_narrow(bracket):
            break
    return best_number(bracket)


def _level_rotation(line: Line, guess: float) -> float:
    """The rotation of zero torque, from the second sum; NaN if the torque itself determines it."""
    interval, last = _interval_at(line, guess, False), 0.0
    for _ in range(2 * line.pieces + 1):
        low, high = interval.low, interval.high
        if low == -INFINITY or high == INFINITY:  # the torque has the sign of the rotation
            sense = 1.0 if low == -INFINITY else -1.0
        else:
            total = _first_sum(line, low + (high - low) / 2.0)
            vanishes: bool = fabs(total.torque) <= total.rounding
            if total.constant and (vanishes or not line.exact):
                spin = _root_in(line, 0.0 if vanishes else total.torque, low, high)
                if vanishes or spin == spin:
                    return spin
            sense = -1.0 if total.torque > 0.0 else 1.0
        if sense == -last:
            break
        interval = _interval_at(line, high, False) if sense > 0.0 else _interval_at(line, low, True)
        last = sense
    return UNKNOWN


def rotation_on_line(effects: Effects, contact: Contact, x: float, y: float, guess: float) -> Psi:
    """Psi at a motion of the contact if the first sum vanishes there; otherwise it has not converged."""
    if not effects.linear:
        return unknown_psi()
    line = _line_of(effects, contact, x, y)
    # If the contact moves mainly along the line, the torque itself determines the rotation well.
    if line.pieces == 0 or fabs(line.along) > fabs(line.across):
        return unknown_psi()
    spin = _level_rotation(line, guess)
    if spin != spin:
        return unknown_psi()
    v_x, v_y, speed = x + spin * contact.y, y - spin * contact.x, sqrt(x * x + y * y)
    total = resistance_about(effects, contact, x=v_x, y=v_y, spin=spin, blur=0.0)
    rough = rough_mass(effects, speed, contact.x, contact.y)
    free: bool = line.exact and fabs(line.along) <= ALIGNED * speed
    stiff = rough.inertia + rough.mass * contact.reach * contact.reach
    if not free and total.ss > SLIGHT * stiff:
        return potential_at(
            total, contact, v_x, v_y, spin, step=0.0, x=x, y=y, size=fabs(spin), converged=True
        )
    # The rotation is proportional to the motion across the line, and the force does not depend on it.
    total = Resistance(
        total.f_x,
        total.f_y,
        torque=0.0,
        xx=total.xx,
        xy=total.xy,
        yy=total.yy,
        xs=0.0,
        ys=0.0,
        ss=0.0,
        limit=0.0,
        point=NO_POINT,
        terms=total.terms,
    )
    root = potential_at(
        total, contact, v_x, v_y, spin, step=0.0, x=x, y=y, size=fabs(spin), converged=True
    )
    turn = spin / line.across
    return Psi(
        v_x,
        v_y,
        spin,
        root.f_x,
        root.f_y,
        root.xx,
        root.xy,
        root.yy,
        turn_x=-turn * line.y,
        turn_y=turn * line.x,
        half_x=0.0,
        half_y=0.0,
        point=NO_POINT,
        noise_x=root.noise_x,
        noise_y=root.noise_y,
        continuum=free,
        converged=True,
    )
