"""Derivatives of a solution with respect to each parameter of its problem, from one linear system.

The unknowns are the changes of the origin's twist and of the force at the contact. Of the five equations,
three balance the wrenches, and two are the condition at the contact, on its motion or on its force. While
the slider pivots about a support point, the friction of the point absorbs every change of the balance of
forces: two equations that keep the point at rest replace it, and torques are about the point. A change of a
parameter changes the right-hand sides, at the same motion and force.

The twist is that of the body frame's origin, not of the contact: the length of the rod is then only a
coefficient in three equations, and nothing cancels, however long it is.
"""

from __future__ import annotations

from math import fabs, sqrt
from typing import NamedTuple

from planar_pushing.core._record import Record
from planar_pushing.core.instant.directions import Rod, direction_at, rod_at
from planar_pushing.core.instant.elimination import SIDE, SQUARE, factor_matrix, solve_factored
from planar_pushing.core.instant.kernels import RodRow
from planar_pushing.core.instant.solution import Pair, Twist
from planar_pushing.core.numbers import UNKNOWN, Numbers, cross, zeros
from planar_pushing.core.supports.resistance import (
    FAR_CENTER,
    Resistance,
    effect_resistance,
    resistance,
    rough_mass,
    support_resistance,
)
from planar_pushing.core.supports.rows import (
    SUPPORT,
    Effects,
    Position,
    SupportRow,
    Vector,
    column_of,
    count_columns,
    foot_position,
    kind_of,
    pressure_of,
    read_effects,
)
from planar_pushing.core.supports.tolerances import BALANCED, SINGULAR, SLOW

#: Conditions at the contact, whose order matters: it moves with the pusher; it has the pusher's normal
#: motion and a force along an edge; a force along a line, with a contact motion of constant magnitude; a
#: given force; none.
STICK_CASE, SLIP_CASE, LINE_CASE, FORCE_CASE, FREE_CASE = range(5)
#: Status of the derivatives of a row; the last one is that of a solution about to change its mode.
NO_MOTION, SMOOTH, ABOUT_POINT, OPEN, CHANGE = range(5)
#: Number of parameters before the effects: two of the condition, the position of the contact, and the angle
#: of the force.
FIRST = 5
#: Step of the rotation in fourth-order differences, in units of speed per extent, and their coefficients.
TURN_STEP = 1e-3
STENCIL = (1.0, 8.0, -1.0, -8.0, 2.0, -1.0, -2.0, 1.0)


class ResponseRow(RodRow):
    """A solution whose derivatives are sought, in the frame of the contact.

    Attributes
    ----------
    twist, force : Twist, Pair
    edge : float
        Angle of the force.
    condition : int
        `STICK_CASE` to `FREE_CASE`.
    pivot : int
        Number of the support point about which the slider pivots.
    changes : bool
        Whether the mode is about to change.
    place : float
        Position of the contact along the fence, from the end of the rod.
    held : bool
        Whether a side stays on the fence.
    """

    twist: Twist
    force: Pair
    edge: float
    condition: int
    pivot: int
    changes: bool
    place: float
    held: bool


class ResponseHead(Record):
    """Status of derivatives, `SMOOTH` to `CHANGE`, with which a row of results begins."""

    status: int


class State(NamedTuple):
    """A solution.

    Attributes
    ----------
    effects : Effects
    total : Resistance
        Of all effects about the origin, without the friction of a pivot.
    condition : int
    x, y, spin : float
        Twist of the origin.
    blur : float
        Speed below which a support point is at rest.
    contact : Position
        Position of the contact.
    held : bool
        Whether a side stays on the fence, so that the slider does not rotate and any couple is in balance.
    t_x, t_y : float
        The pusher's tangent.
    f_x, f_y, e_x, e_y : float
        Force, and the unit vector of its edge or line.
    m_x, m_y : float
        Direction in which the condition fixes the contact's motion: the pusher's normal, or the motion.
    unit : float
        Unit of force per motion, in which the unknown force is of the same order as the unknown motion.
    pivots : bool
    pivot : Position
        Position of the support point about which the slider turns, otherwise the origin.
    """

    effects: Effects
    total: Resistance
    condition: int
    x: float
    y: float
    spin: float
    blur: float
    contact: Position
    held: bool
    t_x: float
    t_y: float
    f_x: float
    f_y: float
    e_x: float
    e_y: float
    m_x: float
    m_y: float
    unit: float
    pivots: bool
    pivot: Position


def responses(
    data: Numbers, rows: Numbers, count: int, columns: int, results: Numbers, width: int
) -> None:
    """Derivatives of each solution with respect to each parameter.

    After the effects, a row holds a `ResponseRow`. A row of results holds a `ResponseHead`; then for each
    component of the twist, and for each of the force, its derivatives with respect to the motion of the
    pusher along and across the fence (for a given force: its magnitude, and nothing), the position of the
    contact likewise, the angle of the force, a factor of each effect, and the weight on each support point.
    Derivatives that do not exist are NaN.
    """
    first, parameters = count_columns(data), (width - 1) // 5
    for i in range(count):
        row, result = rows[i * columns :], results[i * width :]
        solution, head = ResponseRow(row[first:]), ResponseHead(result)
        for k in range(width):
            result[k] = UNKNOWN
        head.status = CHANGE
        effects, twist = read_effects(data, row), solution.twist
        known = min(parameters, FIRST + effects.length + effects.feet)
        if solution.changes:
            continue
        if twist.x == 0.0 and twist.y == 0.0 and twist.spin == 0.0:
            head.status = SMOOTH
            for k in range(known):
                for component in range(5):
                    result[1 + component * parameters + k] = 0.0
        else:
            state = _state_at(effects, rod_at(solution.length, solution.angle), solution)
            if not _is_changing(state):
                _write_responses(state, known, parameters, result)


def _state_at(effects: Effects, rod: Rod, solution: ResponseRow) -> State:
    """The solution in the columns after the effects."""
    t_x, t_y, condition, place = rod.x, -rod.y, solution.condition, solution.place
    contact, twist, force = (
        Position(place * t_x - rod.length, place * t_y),
        solution.twist,
        solution.force,
    )
    x, y = t_x * twist.x - t_y * twist.y, t_y * twist.x + t_x * twist.y
    spin = twist.spin
    pivots: bool = solution.pivot >= 0
    pivot = Position(0.0, 0.0)
    if pivots:
        pivot = foot_position(effects, solution.pivot)
        x, y = spin * pivot.y, -spin * pivot.x
    edge = direction_at(rod, solution.edge)
    m_x, m_y = -t_y, t_x
    if condition == LINE_CASE:
        m_x, m_y = x - spin * contact.y, y + spin * contact.x
    blur = SLOW * (sqrt(x * x + y * y) + fabs(spin))
    total = _sharp_resistance(effects, x, y, spin, blur)
    return State(
        effects,
        total,
        condition,
        x,
        y,
        spin,
        blur,
        contact,
        solution.held,
        t_x,
        t_y,
        f_x=t_x * force.x - t_y * force.y,
        f_y=t_y * force.x + t_x * force.y,
        e_x=edge.along,
        e_y=-edge.across,
        m_x=m_x,
        m_y=m_y,
        unit=fabs(total.xx) + fabs(total.xy) + fabs(total.yy),
        pivots=pivots,
        pivot=pivot,
    )


def _sharp_resistance(effects: Effects, x: float, y: float, spin: float, blur: float) -> Resistance:
    """`Resistance` with accurate second derivatives, even for near-translations.

    If the center of rotation is far away, the sums for the second derivatives with respect to the rotation
    cancel: those of `resistance` are good enough for Newton's method only, with relative errors up to 1e-3.
    """
    total = resistance(effects, x, y, spin, blur)
    xs, ys, ss = total.xs, total.ys, total.ss
    for effect in range(effects.length):
        if kind_of(effects.data, effect) == SUPPORT:
            more = _far_terms(effects, effect, x, y, spin)
            xs, ys, ss = xs + more.x, ys + more.y, ss + more.spin
    return Resistance(
        total.f_x, total.f_y, total.torque, total.xx, total.xy, total.yy, xs, ys, ss,
        total.limit, total.point, total.terms,
    )  # fmt: skip


def _far_terms(effects: Effects, effect: int, x: float, y: float, spin: float) -> Vector:
    """Corrections to xs, ys and ss of a support, from differences of its wrench over small rotations.

    The wrench is accurate and smooth there, and the differences have ten digits.
    """
    support = SupportRow(effects.row[column_of(effects.data, effect) :])
    pressure = pressure_of(effects, effect)
    weight, extent = effects.one * support.weight, support.extent
    p_x, p_y, rate = pressure.center_x, pressure.center_y, spin * extent
    w_x, w_y = x - rate * p_y, y + rate * p_x
    speed = sqrt(w_x * w_x + w_y * w_y)
    if speed <= FAR_CENTER * fabs(rate):
        return Vector(0.0, 0.0, 0.0)
    # Force, and torque about the center of pressure, which moves by w; lengths in extents.
    b_x, b_y, bend, step = 0.0, 0.0, 0.0, TURN_STEP * speed
    for i in range(0, len(STENCIL), 2):
        turned, size = rate + STENCIL[i] * step, STENCIL[i + 1] / (12.0 * step)
        part = support_resistance(
            weight,
            extent,
            pressure,
            x=w_x + turned * p_y,
            y=w_y - turned * p_x,
            spin=turned / extent,
            blur=0.0,
        )
        torque = part.torque / extent - (p_x * part.f_y - p_y * part.f_x)
        b_x, b_y, bend = b_x + size * part.f_x, b_y + size * part.f_y, bend + size * torque
    rough = support_resistance(weight, extent, pressure, x, y, spin, 0.0)
    a_x, a_y = rough.xy * p_x - rough.xx * p_y, rough.yy * p_x - rough.xy * p_y
    bend += -p_y * (2.0 * b_x + a_x) + p_x * (2.0 * b_y + a_y)
    return Vector(
        extent * (b_x + a_x) - rough.xs, extent * (b_y + a_y) - rough.ys,
        extent * extent * bend - rough.ss,
    )  # fmt: skip


def _is_changing(state: State) -> bool:
    """Whether a support point is about to become a pivot or to stop being one."""
    total, limit = state.total, (1.0 - BALANCED) * state.total.limit
    if not state.pivots:
        return limit > 0.0
    g_x, g_y = state.f_x - total.f_x, state.f_y - total.f_y
    friction = sqrt(g_x * g_x + g_y * g_y)
    if state.condition == STICK_CASE:
        # The balance determines only the friction across the line to the contact.
        c_x, c_y = state.contact.x, state.contact.y
        r_x, r_y = state.pivot.x - c_x, state.pivot.y - c_y
        friction = fabs(total.torque - cross(c_x, c_y, total.f_x, total.f_y))
        limit *= sqrt(r_x * r_x + r_y * r_y)
    return not friction <= limit


def _write_responses(state: State, known: int, parameters: int, result: Numbers) -> None:
    """Write status and derivatives for the parameters that exist; nothing if the system is singular."""
    matrix, noise, order = zeros(SQUARE), zeros(SQUARE), zeros(SIDE)
    right, change = zeros(SIDE), zeros(SIDE)
    if not state.unit > 0.0:
        return
    _write_system(state, matrix)
    _write_noise(state, matrix, noise)
    if not factor_matrix(matrix, noise, order):
        return
    open_force: bool = state.pivots and state.condition == STICK_CASE
    head = ResponseHead(result)
    head.status = OPEN if open_force else ABOUT_POINT if state.pivots else SMOOTH
    for k in range(known):
        _write_change(state, k, right)
        if open_force and _makes_point_slide(state, right[3], right[4]):
            continue
        solve_factored(matrix, order, right, solution=change, count=SIDE)
        x, y = change[0], change[1]
        result[1 + k] = state.t_x * x + state.t_y * y
        result[1 + parameters + k] = state.t_x * y - state.t_y * x
        result[1 + 2 * parameters + k] = change[2]
        if not open_force:
            x, y = state.unit * change[3], state.unit * change[4]
            result[1 + 3 * parameters + k] = state.t_x * x + state.t_y * y
            result[1 + 4 * parameters + k] = state.t_x * y - state.t_y * x


def _write_change(state: State, k: int, right: Numbers) -> None:
    """Write the right-hand sides of a change of the k-th parameter, at the same twist and force."""
    for i in range(SIDE):
        right[i] = 0.0
    x, y, condition = state.t_x, state.t_y, state.condition
    if k == 1 or k == 3:
        x, y = -state.t_y, state.t_x
    if k >= FIRST:
        wrench = _wrench_of(state, k - FIRST)
        right[0] = cross(state.pivot.x, state.pivot.y, wrench.x, wrench.y) - wrench.spin
        if not state.pivots:
            right[1], right[2] = -wrench.x, -wrench.y
    elif k == 4:
        force = (state.e_x * state.f_x + state.e_y * state.f_y) / state.unit
        if condition == FORCE_CASE:
            right[3], right[4] = -force * state.e_y, force * state.e_x
        elif SLIP_CASE <= condition <= LINE_CASE:
            right[4] = force
    elif k >= 2:
        # At the new contact, the lever of the force and the motion of the slider differ.
        right[0] = cross(x, y, state.f_x, state.f_y)
        _write_motion_change(state, state.spin * y, -state.spin * x, right)
    elif condition <= SLIP_CASE:
        _write_motion_change(state, x, y, right)
    elif condition == FORCE_CASE and k == 0:
        right[3], right[4] = state.e_x / state.unit, state.e_y / state.unit
    if state.held:
        right[0] = 0.0


def _write_motion_change(state: State, x: float, y: float, right: Numbers) -> None:
    """Write the right-hand sides of a change of the motion of the pusher at the contact."""
    if state.condition == STICK_CASE:
        right[3], right[4] = x, y
    elif state.condition <= LINE_CASE:
        right[3] = state.m_x * x + state.m_y * y


def _makes_point_slide(state: State, x: float, y: float) -> bool:
    """Whether a change of a sticking contact's motion moves the pivot along its line to the contact."""
    r_x, r_y = state.pivot.x - state.contact.x, state.pivot.y - state.contact.y
    ahead, size = x * r_x + y * r_y, fabs(x) + fabs(y)
    return fabs(ahead) > SINGULAR * sqrt(r_x * r_x + r_y * r_y) * size


def _wrench_of(state: State, number: int) -> Vector:
    """The wrench of an effect or, for a larger number, of unit friction at a support point.

    The friction of a point at rest is below its limit, so a change of the limit has no effect.
    """
    x, y, spin, effects = state.x, state.y, state.spin, state.effects
    if number < effects.length:
        part = effect_resistance(effects, number, x, y, spin, state.blur)
        return Vector(part.f_x, part.f_y, part.torque)
    foot = foot_position(effects, number - effects.length)
    w_x, w_y = x - spin * foot.y, y + spin * foot.x
    speed = sqrt(w_x * w_x + w_y * w_y)
    if speed <= state.blur:
        return Vector(0.0, 0.0, 0.0)
    w_x, w_y = w_x / speed, w_y / speed
    return Vector(w_x, w_y, cross(foot.x, foot.y, w_x, w_y))


def _write_system(state: State, matrix: Numbers) -> None:
    """Write the matrix: balance of torques; balance of forces, or a pivot at rest; the condition."""
    total, unit = state.total, state.unit
    p_x, p_y = state.pivot.x, state.pivot.y
    r_x, r_y = p_x - state.contact.x, p_y - state.contact.y
    torque, one, other = matrix, matrix[SIDE:], matrix[2 * SIDE :]
    torque[0] = total.xs - (p_x * total.xy - p_y * total.xx)
    torque[1] = total.ys - (p_x * total.yy - p_y * total.xy)
    torque[2] = total.ss - (p_x * total.ys - p_y * total.xs)
    torque[3], torque[4] = -unit * r_y, unit * r_x
    if state.held:
        torque[0], torque[1], torque[2], torque[3], torque[4] = 0.0, 0.0, 1.0, 0.0, 0.0
    if not state.pivots:
        one[0], one[1], one[2], one[3] = total.xx, total.xy, total.xs, -unit
        other[0], other[1], other[2], other[4] = total.xy, total.yy, total.ys, -unit
    elif state.condition != STICK_CASE:
        one[0], one[2] = 1.0, -p_y
        other[1], other[2] = 1.0, p_x
    else:
        # Sticking keeps the point at rest along r, its line to the contact. It leaves the force along r
        # undetermined, and every value gives the same twist.
        one[0], one[1], one[2] = -r_y, r_x, r_x * p_x + r_y * p_y
        other[3], other[4] = r_x, r_y
    _write_condition(state, matrix[3 * SIDE :], matrix[4 * SIDE :])


def _write_condition(state: State, one: Numbers, other: Numbers) -> None:
    """Write the two equations of the contact."""
    c_x, c_y = state.contact.x, state.contact.y
    if state.condition == STICK_CASE:
        one[0], one[2], other[1], other[2] = 1.0, -c_y, 1.0, c_x
    elif state.condition <= LINE_CASE:
        one[0], one[1], one[2] = state.m_x, state.m_y, state.m_y * c_x - state.m_x * c_y
        other[3], other[4] = -state.e_y, state.e_x
    else:
        one[3], other[4] = 1.0, 1.0


def _write_noise(state: State, matrix: Numbers, noise: Numbers) -> None:
    """Write the errors of the matrix: rounding of its numbers, or of the terms of second derivatives."""
    for i in range(SQUARE):
        noise[i] = SINGULAR * fabs(matrix[i])
    rough = rough_mass(state.effects, 1.0, 0.0, 0.0)
    extent = sqrt(rough.inertia / rough.mass)
    arm = extent + fabs(state.pivot.x) + fabs(state.pivot.y)
    for i in range(1 if state.pivots else 3):
        for j in range(3):
            terms = state.unit * (arm if i == 0 else 1.0) * (extent if j == 2 else 1.0)
            noise[SIDE * i + j] = max(noise[SIDE * i + j], SINGULAR * terms)
