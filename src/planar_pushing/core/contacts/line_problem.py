"""The twists on a line at which the load has no component along a given twist: ``q . W(xi_0 + s d) = 0``.

W is the wrench that sustains a twist, the gradient of the potential. Two contacts that slip leave the
slider a line of motions, and q is the rotation about the meeting point of their lines of force. The
magnitude s is the tangent of an angle, so that the line is finite. Friction depends on the angle alone:
``F(xi_0 + tan(a) d) = F(cos(a) xi_0 + sin(a) d)``.

Between two angles the friction of a foot has one extremum at most, and so has the numerator of its slope.
Roots on feet are therefore isolated with certainty: an interval is halved until zero is outside the range
of the values or outside that of the slopes. For other supports the ranges are those of the cubic through
values and slopes at the ends of an interval, with its error in the middle as a margin.
"""

from __future__ import annotations

from math import atan2, fabs

from planar_pushing.core._record import (
    Record,
    size_of,
)
from planar_pushing.core.contacts.twist_line import (
    Power,
    Ranges,
    TwistLine,
    angle_of_rest,
    feet_ranges,
    power_on_line,
    term_of_foot,
)
from planar_pushing.core.instant.directions import (
    QUARTER_TURN,
)
from planar_pushing.core.numbers import (
    INFINITY,
    Numbers,
    zeros,
)
from planar_pushing.core.supports.roots import (
    best_number,
    is_narrow,
    narrow_bracket,
    next_number,
    open_bracket,
)
from planar_pushing.core.supports.rows import (
    NO_POINT,
)
from planar_pushing.core.supports.tolerances import (
    COINCIDENT,
    INSET,
    ROUNDING,
)

#: Maximum number of roots, with pivots and ends of continua.
MOST_ON_LINE = 24
#: Widest interval whose values are taken from a cubic, in radians.
WIDEST_CUBIC = 0.4
#: Narrowest interval that is halved, and the width below which a flat stretch is a double root, in radians.
NARROWEST, FLAT_WIDTH = 1e-11, 1e-5
#: Number of parts of an interval at whose ends a power that vanishes there is evaluated.
PLACES_OF_FLAT = 8
#: Maximum number of intervals, and of those that wait, which halving keeps below its depth.
INTERVALS, WAITING = 20000, 64


class LineRoot(Record):
    """A root of the line problem.

    Attributes
    ----------
    angle : float
    continuum : bool
        Whether it is an end of a stretch without any power.
    pivot : int
        Number of the foot that rests there, whose friction is a set; `NO_POINT` for a root.
    """

    angle: float
    continuum: bool
    pivot: int


LINE_ROOT = size_of(LineRoot)


class Cell(Record):
    """An interval of angles, with the values and slopes at both ends."""

    low: float
    high: float
    first: float
    first_slope: float
    last: float
    last_slope: float


CELL = size_of(Cell)


def find_on_line(line: TwistLine, low: float, high: float, roots: Numbers) -> int:
    """Write the roots between two multiples of the step, in order, and return their number.

    Feet that rest on the line are written as pivots: friction is a set there, and the caller decides. The
    power jumps there, so they part the line.

    Parameters
    ----------
    line : TwistLine
    low, high : float
        Values of ``tan(angle)``, possibly infinite.
    roots : Numbers
        Room for `MOST_ON_LINE` of `LineRoot`.

    Returns
    -------
    int
        -1 if there are more roots than fit or the intervals are too many.
    """
    first, last = atan2(low, 1.0), atan2(high, 1.0)
    count, reached, rests = 0, first, False
    pivot = _pivot_at(line, first)
    if pivot >= 0:
        count, rests = _write_line_root(roots, count, first, False, pivot), True
    while count >= 0:
        pivot = _next_pivot(line, reached, last)
        end = last
        if pivot >= 0:
            end = angle_of_rest(line, term_of_foot(line, pivot))
        start, stop = reached, end
        if not line.on_feet and rests:
            start += INSET
        if not line.on_feet and pivot >= 0:
            stop -= INSET
        if stop > start:
            count = _find_between(line, start, stop, roots, count)
        elif stop == start and pivot < 0 and not rests:
            power = power_on_line(line, start, start)
            if fabs(power.value) <= line.noise:
                count = _write_line_root(roots, count, start, False, NO_POINT)
        if pivot < 0:
            break
        count = _write_line_root(roots, count, end, False, pivot)
        reached, rests = end, True
    return count


def _write_line_root(roots: Numbers, count: int, angle: float, continuum: bool, pivot: int) -> int:
    """Write a root and return their number, -1 without room."""
    if count < 0 or count == MOST_ON_LINE:
        return -1
    root = LineRoot(roots[LINE_ROOT * count :])
    root.angle, root.continuum, root.pivot = angle, continuum, pivot
    return count + 1


def _find_between(line: TwistLine, low: float, high: float, roots: Numbers, count: int) -> int:
    """Write the roots between two angles without a pivot between them."""
    inside = (low + high) / 2.0
    cells = zeros(WAITING * CELL)
    waiting, flat_from, flat_to = 1, INFINITY, INFINITY
    _write_cell(
        cells, low, high, power_on_line(line, low, inside), power_on_line(line, high, inside)
    )
    for _ in range(INTERVALS):
        if waiting == 0 or count < 0:
            break
        waiting -= 1
        cell = Cell(cells[CELL * waiting :])
        a, b, middle = cell.low, cell.high, (cell.low + cell.high) / 2.0
        one, other = Power(cell.first, cell.first_slope), Power(cell.last, cell.last_slope)
        center = Power(0.0, 0.0)
        ranges = Ranges(-INFINITY, INFINITY, least_slope=-INFINITY, most_slope=INFINITY)
        if line.on_feet:
            # The square of a foot's speed has one extremum in a quarter turn.
            if b - a <= QUARTER_TURN:
                ranges = feet_ranges(line, a, b, inside)
        else:
            center = power_on_line(line, middle, inside)
            if b - a <= WIDEST_CUBIC:
                ranges = _cubic_ranges(b - a, one, other, center)
        if ranges.low > line.noise or ranges.high < -line.noise:
            continue
        flat: bool = ranges.low >= -line.noise and ranges.high <= line.noise
        if not flat and fabs(one.value) <= line.noise and fabs(other.value) <= line.noise:
            flat = _vanishes_between(line, a, b, inside)
        narrow: bool = b - a <= NARROWEST
        crosses: bool = (one.value < 0.0 < other.value) or (other.value < 0.0 < one.value)
        if flat or (narrow and not crosses):
            if fabs(a - flat_to) > NARROWEST:
                count = _write_flat(roots, count, flat_from, flat_to)
                flat_from = a
            flat_to = b
        elif ranges.least_slope > 0.0 or ranges.most_slope < 0.0 or narrow:
            if crosses:
                angle = _root_between(line, a, b, one.value, other.value, inside=inside)
                count = _write_line_root(roots, count, angle, False, NO_POINT)
            elif fabs(one.value) <= line.noise or fabs(other.value) <= line.noise:
                # A root at the joint of two intervals is that of both.
                angle = a if fabs(one.value) < fabs(other.value) else b
                count = _write_once(roots, count, angle)
        elif waiting + 2 > WAITING:
            return -1
        else:
            if line.on_feet:
                center = power_on_line(line, middle, inside)
            _write_cell(cells[CELL * waiting :], middle, b, center, other)
            _write_cell(cells[CELL * (waiting + 1) :], a, middle, one, center)
            waiting += 2
    if waiting > 0:
        return -1
    return _write_flat(roots, count, flat_from, flat_to)


def _vanishes_between(line: TwistLine, low: float, high: float, inside: float) -> bool:
    """Whether the power vanishes at several angles, though the ranges of single feet do not.

    Between feet that rest it is a smooth function of the angle.
    """
    for k in range(1, PLACES_OF_FLAT):
        angle = low + (high - low) * float(k) / float(PLACES_OF_FLAT)
        if fabs(power_on_line(line, angle, inside).value) > line.noise:
            return False
    return True


def _write_cell(cells: Numbers, low: float, high: float, first: Power, last: Power) -> None:
    """Write an interval of angles."""
    cell = Cell(cells)
    cell.low, cell.high = low, high
    cell.first, cell.first_slope = first.value, first.slope
    cell.last, cell.last_slope = last.value, last.slope


def _write_once(roots: Numbers, count: int, angle: float) -> int:
    """Write a root unless it is the last one."""
    if count > 0 and fabs(LineRoot(roots[LINE_ROOT * (count - 1) :]).angle - angle) <= COINCIDENT:
        return count
    return _write_line_root(roots, count, angle, False, NO_POINT)


def _write_flat(roots: Numbers, count: int, first: float, last: float) -> int:
    """Write both ends of a stretch without power, or a double root, if there is one."""
    if first == INFINITY:
        return count
    if last - first <= FLAT_WIDTH:
        return _write_once(roots, count, (first + last) / 2.0)
    count = _write_line_root(roots, count, first, True, NO_POINT)
    return _write_line_root(roots, count, last, True, NO_POINT)


def _root_between(
    line: TwistLine, low: float, high: float, first: float, last: float, inside: float
) -> float:
    """The root between two angles at which the power has opposite signs."""
    bracket = open_bracket(low, high, first, last, ROUNDING)
    for _ in range(INTERVALS):
        if is_narrow(bracket):
            break
        angle = next_number(bracket)
        if angle == bracket.a or angle == bracket.b:
            break
        bracket = narrow_bracket(bracket, angle, power_on_line(line, angle, inside).value)
    return best_number(bracket)


def _cubic_ranges(width: float, one: Power, other: Power, center: Power) -> Ranges:
    """Ranges between two angles, from the cubic through values and slopes there, and its error halfway."""
    first, last = one.value, other.value
    secant = (last - first) / width
    error = fabs(center.value - (first + last) / 2.0 - width * (one.slope - other.slope) / 8.0)
    bend = fabs(center.slope - 1.5 * secant + (one.slope + other.slope) / 4.0)
    bend += 4.0 * error / width
    near, far = first + width * one.slope / 3.0, last - width * other.slope / 3.0
    control = 3.0 * secant - one.slope - other.slope
    return Ranges(
        low=min(min(first, last), min(near, far)) - 2.0 * error,
        high=max(max(first, last), max(near, far)) + 2.0 * error,
        least_slope=min(min(one.slope, other.slope), control) - 2.0 * bend,
        most_slope=max(max(one.slope, other.slope), control) + 2.0 * bend,
    )


def _pivot_at(line: TwistLine, angle: float) -> int:
    """Number of the foot that rests at an angle, `NO_POINT` without one."""
    for i in range(line.effects.feet):
        if fabs(angle_of_rest(line, term_of_foot(line, i)) - angle) <= COINCIDENT:
            return i
    return NO_POINT


def _next_pivot(line: TwistLine, low: float, high: float) -> int:
    """Number of the first foot that rests between two angles or at the second, `NO_POINT` without one."""
    nearest, number = INFINITY, NO_POINT
    for i in range(line.effects.feet):
        angle = angle_of_rest(line, term_of_foot(line, i))
        if low + COINCIDENT < angle <= high + COINCIDENT and angle < nearest:
            nearest, number = angle, i
    return number
