"""Several contacts that leave the slider a line of twists: slips, or contacts at one point."""

from __future__ import annotations

from math import atan2, fabs

from planar_pushing.core._record import (
    Record,
    size_of,
)
from planar_pushing.core.contacts.line_problem import (
    LINE_ROOT,
    MOST_ON_LINE,
    LineRoot,
    find_on_line,
)
from planar_pushing.core.contacts.several_frames import (
    MotionSet,
    Several,
    as_vector,
    cross_vectors,
    frame_of,
    gap_rate,
    keeps_modes,
    reach_of_rows,
    slip_rate,
)
from planar_pushing.core.contacts.several_solutions import (
    Sharing,
    add_balanced,
    balances,
)
from planar_pushing.core.contacts.twist_line import (
    TwistLine,
    dot_vectors,
    length_of_twist,
    line_through,
    scale_vector,
    twist_on_line,
)
from planar_pushing.core.contacts.unit_forces import (
    INDEPENDENT,
    UNIT_FORCE,
    UnitForce,
)
from planar_pushing.core.instant.directions import (
    QUARTER_TURN,
)
from planar_pushing.core.instant.solution import (
    SEPARATE,
    SLIP_LEFT,
    STICK,
    UNSOLVED,
    Twist,
)
from planar_pushing.core.numbers import (
    INFINITY,
    Numbers,
    zeros,
)
from planar_pushing.core.supports.resistance import (
    resistance,
)
from planar_pushing.core.supports.rows import (
    Vector,
    scale_effects,
)
from planar_pushing.core.supports.tolerances import (
    BALANCED,
    COINCIDENT,
    SHARE,
)

#: Maximum number of angles among which the ends of intervals of twists are.
MOST_ANGLES = 64
#: Number of parts of a stretch at whose ends forces are tried, of halvings of one that ends there, and the
#: shortest stretch, in radians.
PARTS_OF_STRETCH, BISECTIONS, SHORT_STRETCH = 32, 50, 1e-6
#: Slack of a load that is balanced along two unit forces whatever its third component is.
ANY_LOAD = 1e9


class Bounds(Record):
    """How far one can go along a line of twists in both senses, in multiples of its direction."""

    low: float
    high: float


BOUNDS, TWIST = size_of(Bounds), size_of(Twist)


def write_bounds(several: Several, sharing: Sharing, motions: MotionSet, bounds: Bounds) -> bool:
    """Write how far one can go along a line of twists in both senses; whether any of it is left.

    Every contact keeps its mode, and without loads the power of at nearest one unit force is positive.
    """
    bounds.low, bounds.high = -INFINITY, INFINITY
    size = 1.0 + length_of_twist(motions.twist)
    if not several.loaded:
        _bound_by_power(sharing, motions, bounds)
    for i in range(several.number):
        frame, mode = frame_of(several, i), int(sharing.modes[i])
        if mode == STICK:
            continue
        value, row = gap_rate(frame, motions.twist), as_vector(frame.across)
        if mode != SEPARATE:
            value, row = slip_rate(frame, motions.twist), as_vector(frame.along)
        sign = -1.0 if mode == SLIP_LEFT else 1.0
        slope, reach = sign * dot_vectors(row, motions.direction), reach_of_rows(frame)
        value = sign * value
        if fabs(slope) <= SHARE * reach:
            if value < -COINCIDENT * reach * size:
                return False
        elif slope > 0.0:
            bounds.low = max(bounds.low, -value / slope)
        else:
            bounds.high = min(bounds.high, -value / slope)
    if bounds.low == INFINITY or bounds.high == -INFINITY:
        return False
    if bounds.low > bounds.high:
        if bounds.low - bounds.high > COINCIDENT * (size + fabs(bounds.low)):
            return False
        bounds.low = bounds.high
    return True


def _bound_by_power(sharing: Sharing, motions: MotionSet, bounds: Bounds) -> None:
    """Narrow a line of twists to the smallest interval with all those at which a contact does work."""
    low, high = INFINITY, -INFINITY
    for k in range(sharing.number):
        unit = _unit_vector(sharing.units, k)
        value, slope = dot_vectors(unit, motions.twist), dot_vectors(unit, motions.direction)
        length = length_of_twist(unit)
        slack = COINCIDENT * length * (1.0 + length_of_twist(motions.twist))
        if fabs(slope) <= SHARE * length:
            if value > -slack:
                low, high = -INFINITY, INFINITY
        elif slope > 0.0:
            low, high = min(low, -(value + slack) / slope), INFINITY
        else:
            low, high = -INFINITY, max(high, -(value + slack) / slope)
    bounds.low, bounds.high = max(bounds.low, low), min(bounds.high, high)


def span_of_forces(sharing: Sharing, probes: Numbers) -> int:
    """Dimension of the span of the unit forces; write the twists on which all of them have no power."""
    units, number = sharing.units, sharing.number
    best, one, other = INDEPENDENT, 0, -1
    for i in range(number):
        for j in range(i + 1, number):
            first, second = _unit_vector(units, i), _unit_vector(units, j)
            size = length_of_twist(cross_vectors(first, second))
            size /= length_of_twist(first) * length_of_twist(second)
            if size > best:
                best, one, other = size, i, j
    first = _unit_vector(units, one)
    if other < 0:
        x, y, z = fabs(first.x), fabs(first.y), fabs(first.spin)
        axis = Vector(0.0, 0.0, 1.0)
        if x <= y and x <= z:
            axis = Vector(1.0, 0.0, 0.0)
        elif y <= z:
            axis = Vector(0.0, 1.0, 0.0)
        across = cross_vectors(first, axis)
        _write_probe(across, Twist(probes))
        _write_probe(cross_vectors(first, across), Twist(probes[TWIST:]))
        return 1
    normal = cross_vectors(first, _unit_vector(units, other))
    _write_probe(normal, Twist(probes))
    for k in range(number):
        vector = _unit_vector(units, k)
        part = fabs(dot_vectors(vector, normal))
        if part > INDEPENDENT * length_of_twist(vector) * length_of_twist(normal):
            return 3
    return 2


def _unit_vector(units: Numbers, k: int) -> Vector:
    """The wrench of a unit force."""
    force = UnitForce(units[UNIT_FORCE * k :])
    return Vector(force.x, force.y, force.torque)


def _write_probe(vector: Vector, probe: Twist) -> None:
    """Write a twist in a row."""
    probe.x, probe.y, probe.spin = vector.x, vector.y, vector.spin


def add_on_line(
    several: Several, sharing: Sharing, motions: MotionSet, solutions: Numbers, count: int
) -> int:
    """Add the solutions on a line of twists, and return the number of solutions.

    With slips alone the lines of force span a plane of wrenches, and the load must be in it.
    """
    numbers, probes = zeros(BOUNDS), zeros(2 * TWIST)
    bounds = Bounds(numbers)
    if not write_bounds(several, sharing, motions, bounds):
        return count
    span = span_of_forces(sharing, probes)
    if span == 3:
        return _add_interval(several, sharing, motions, bounds, solutions=solutions, count=count)
    roots = zeros(MOST_ON_LINE * LINE_ROOT)
    slack = ANY_LOAD if span == 2 else BALANCED
    for k in range(3 - span):
        probe = as_vector(Twist(probes[TWIST * k :]))
        line = line_through(several.effects, motions.twist, motions.direction, probe)
        number = find_on_line(line, bounds.low / line.size, bounds.high / line.size, roots)
        if number < 0:
            return UNSOLVED
        for i in range(number):
            root = LineRoot(roots[LINE_ROOT * i :])
            if root.continuum:
                # Both ends of a stretch follow one another.
                if i + 1 < number and LineRoot(roots[LINE_ROOT * (i + 1) :]).continuum:
                    last = LineRoot(roots[LINE_ROOT * (i + 1) :])
                    last.continuum = False
                    count = _add_stretch(
                        several, sharing, line, root.angle, last=last.angle, slack=slack,
                        solutions=solutions, count=count,
                    )  # fmt: skip
                continue
            twist = twist_on_line(line, root.angle)
            if length_of_twist(twist) > COINCIDENT and keeps_modes(several, sharing.modes, twist):
                count = add_balanced(
                    several, sharing, twist, slack, continuum=False, solutions=solutions,
                    count=count,
                )  # fmt: skip
    return count


def _balances_at(
    several: Several, sharing: Sharing, line: TwistLine, angle: float, slack: float
) -> bool:
    """Whether a twist of a line keeps the modes, and the contacts balance its load."""
    twist = twist_on_line(line, angle)
    if fabs(angle) > QUARTER_TURN - COINCIDENT or length_of_twist(twist) <= COINCIDENT:
        return False
    return keeps_modes(several, sharing.modes, twist) and balances(several, sharing, twist, slack)


def _add_stretch(
    several: Several, sharing: Sharing, line: TwistLine, first: float,
    last: float, slack: float, solutions: Numbers, count: int,
) -> int:  # fmt: skip
    """Add the ends of the parts of a stretch without power in which the contacts balance the load."""
    holds: bool = False
    start = first
    for k in range(PARTS_OF_STRETCH + 2):
        # One step beyond the end, where nothing holds.
        part = float(k) / float(PARTS_OF_STRETCH)
        angle = first + (last - first) * min(part, 1.0)
        keeps: bool = k <= PARTS_OF_STRETCH and _balances_at(several, sharing, line, angle, slack)
        if keeps == holds:
            continue
        end, other = angle, first + (last - first) * max(part - 1.0 / float(PARTS_OF_STRETCH), 0.0)
        if not keeps:
            end, other = other, end
        # The part in which the contacts balance the load reaches from `end` towards `other`.
        for _ in range(BISECTIONS):
            middle = (end + other) / 2.0
            if _balances_at(several, sharing, line, middle, slack):
                end = middle
            else:
                other = middle
        if keeps:
            start = end
        else:
            longer: bool = end - start > SHORT_STRETCH
            for side in range(2 if longer else 1):
                twist = twist_on_line(line, start if side == 0 else end)
                count = add_balanced(
                    several, sharing, twist, slack, continuum=longer, solutions=solutions,
                    count=count,
                )  # fmt: skip
        holds = keeps
    return count


def add_from_rest(
    several: Several, sharing: Sharing, motions: MotionSet, solutions: Numbers, count: int
) -> int:
    """Add the solutions on a line of twists through rest, and return the number of solutions.

    The direction of friction is the same all along each half of it, so one of its twists is a solution.
    With friction alone all are, and the end of that continuum which is not at rest is written.
    """
    numbers, probes = zeros(BOUNDS), zeros(2 * TWIST)
    bounds = Bounds(numbers)
    if not write_bounds(several, sharing, motions, bounds):
        return count
    span = span_of_forces(sharing, probes)
    probe = as_vector(Twist(probes))
    for half in range(2):
        sign = 1.0 if half == 0 else -1.0
        nearest = bounds.low if half == 0 else -bounds.high
        farthest = bounds.high if half == 0 else -bounds.low
        nearest = max(nearest, 0.0)
        if farthest <= COINCIDENT or farthest < nearest:
            continue
        twist = scale_vector(motions.direction, sign)
        if not several.effects.massive:
            if farthest == INFINITY:
                continue
            if balances(several, sharing, twist, BALANCED):
                count = add_balanced(
                    several, sharing, scale_vector(twist, farthest), BALANCED,
                    continuum=farthest > nearest, solutions=solutions, count=count,
                )  # fmt: skip
        elif span < 3:
            friction = _load_with(several, twist, 0.0)
            mass = _load_with(several, twist, 1.0)
            power = dot_vectors(friction, probe)
            rise = dot_vectors(mass, probe) - power
            s = -power / rise if fabs(rise) > SHARE * length_of_twist(probe) else INFINITY
            slack = COINCIDENT * (1.0 + farthest) if farthest < INFINITY else COINCIDENT
            if COINCIDENT < s < INFINITY and nearest - slack <= s <= farthest + slack:
                count = add_balanced(
                    several, sharing, scale_vector(twist, s),
                    ANY_LOAD if span == 2 else BALANCED,
                    continuum=False, solutions=solutions, count=count,
                )  # fmt: skip
    return count


def _load_with(several: Several, twist: Vector, two: float) -> Vector:
    """The wrench that sustains a twist, with a factor for masses."""
    effects = scale_effects(several.effects, 1.0, two)
    total = resistance(effects, x=twist.x, y=twist.y, spin=twist.spin, blur=0.0)
    return Vector(total.f_x, total.f_y, total.torque)


def _add_interval(
    several: Several, sharing: Sharing, motions: MotionSet, bounds: Bounds,
    solutions: Numbers, count: int,
) -> int:  # fmt: skip
    """Add the ends of the intervals of a line on which the contacts balance every load.

    An interval ends at a bound, or where the load leaves the cone of the unit forces. There it is in the
    plane of two of them.
    """
    roots, angles = zeros(MOST_ON_LINE * LINE_ROOT), zeros(MOST_ANGLES)
    effects, units, number = several.effects, sharing.units, 0
    size = length_of_twist(motions.twist)
    for i in range(sharing.number):
        for j in range(i + 1, sharing.number):
            probe = cross_vectors(_unit_vector(units, i), _unit_vector(units, j))
            scale = length_of_twist(_unit_vector(units, i)) * length_of_twist(
                _unit_vector(units, j)
            )
            if length_of_twist(probe) <= INDEPENDENT * scale:
                continue
            line = line_through(effects, motions.twist, motions.direction, probe)
            some = find_on_line(line, bounds.low / size, bounds.high / size, roots)
            if some < 0:
                return UNSOLVED
            for k in range(some):
                number = _insert_angle(angles, number, LineRoot(roots[LINE_ROOT * k :]).angle)
    number = _insert_angle(angles, number, atan2(bounds.low / size, 1.0))
    number = _insert_angle(angles, number, atan2(bounds.high / size, 1.0))
    if number > MOST_ANGLES:
        return UNSOLVED
    line = line_through(effects, motions.twist, motions.direction, motions.direction)
    joined = False
    for k in range(number):
        twist = twist_on_line(line, angles[k])
        follows = False
        if k + 1 < number:
            middle = twist_on_line(line, (angles[k] + angles[k + 1]) / 2.0)
            follows = balances(several, sharing, middle, BALANCED)
        inside: bool = joined and follows
        bounded: bool = fabs(angles[k]) < QUARTER_TURN - COINCIDENT
        if bounded and not inside and keeps_modes(several, sharing.modes, twist):
            count = add_balanced(
                several, sharing, twist, BALANCED, continuum=joined or follows,
                solutions=solutions, count=count,
            )  # fmt: skip
        joined = follows
    return count


def _insert_angle(angles: Numbers, count: int, angle: float) -> int:
    """Insert an angle in order unless it is there; return the number of angles, too large without room."""
    if count >= MOST_ANGLES:
        return MOST_ANGLES + 1
    index = count
    while index > 0 and angles[index - 1] > angle:
        index -= 1
    if index > 0 and fabs(angles[index - 1] - angle) <= COINCIDENT:
        return count
    if index < count and fabs(angles[index] - angle) <= COINCIDENT:
        return count
    for k in range(count, index, -1):
        angles[k] = angles[k - 1]
    angles[index] = angle
    return count + 1
