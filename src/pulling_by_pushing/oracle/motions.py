"""Proved motions: under a line of force, at a limit point, with a given contact motion, and about a foot.

Each is the root of one system of equations of `prove` next to a guess. Where an equation has no finite
slope the answer is exact (a line of force tangent to the ring, Sec. 3.1) or enclosed by a change of sign
of the torque.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from flint import arb, ctx, fmpq

from pulling_by_pushing.oracle.balls import Direction, Undecided, Vector, cross, dot, norm, remember
from pulling_by_pushing.oracle.body import Body, Row, Wrench, holding_force
from pulling_by_pushing.oracle.exact import (
    ONE,
    exact_force,
    exact_motion,
    is_across,
    is_even,
    is_straight,
    is_tangent,
    ring_radius,
)
from pulling_by_pushing.oracle.pivots import pivot_at, pivot_under
from pulling_by_pushing.oracle.prove import (
    Equation,
    Proved,
    Slider,
    differences,
    energy,
    force_along,
    krawczyk,
    moves,
    torque,
    with_roundings,
)

#: Matrix of the square of the contact's motion.
CONTACT = [[arb(1), arb(0), arb(0)], [arb(0), arb(1), arb(0)], [arb(0), arb(0), arb(0)]]

# --- Motions under a line of force --------------------------------------------------------------------


@remember(1 << 14)
def ray(slider: Slider, force: Direction) -> Proved:
    """The motion under a force along a direction e, with ``e . u = 1``, for effects of one degree.

    Raises
    ------
    Undecided
        If the motion is not unique, or rounding decides whether the slider pivots about a foot.
    """
    body, e = slider.body, force.about(slider.rod_angle)
    last = moves((*e.ball, 0), 1, e.roundings)
    if is_tangent(body, e):
        return _tangent(body, e, last)
    if is_straight(body, e):
        return _translate(body, e, last)
    for foot in range(len(body.support.points) if body.weight != 0 and body.support else 0):
        pivot = pivot_under(body, e, foot)
        if pivot is not None:
            return pivot
    if is_even(body) and is_across(e) and body.weight != 0:
        u = e.ball
        motion, wrench, slopes = rotation(body, u)
        if not cross(u, wrench.value[:2]).contains(0):
            raise Undecided("a force across the rod that is not along the motion")
        return _with_slopes(body, e, last, motion, wrench, slopes)
    try:
        return _enclose(body, e, last, guess_ray(body, e.ball))
    except Undecided:
        for foot in range(len(body.support.points) if body.weight != 0 and body.support else 0):
            try:
                return _enclose(body, e, last, guess_beside(body, e.ball, foot))
            except Undecided:
                pass
        raise


def _enclose(body: Body, e: Direction, last: Equation, guess: Sequence[Any]) -> Proved:
    equations = [torque, force_along(e.ball, e.roundings), last]
    return with_roundings(body, equations, *krawczyk(body, equations, guess), exact_motion(body, e))


def _translate(body: Body, e: Direction, last: Equation) -> Proved:
    """The translation along a force through the center, scaled to an equation."""
    equations = [torque, force_along(e.ball, e.roundings), last]
    q = _scale_to(last, [*e.ball, arb(0)])
    return with_roundings(body, equations, q, body.wrench(q), exact_motion(body, e))


def _with_slopes(
    body: Body, e: Direction, last: Equation, q: Row, wrench: Wrench, slopes: Wrench
) -> Proved:
    equations = [torque, force_along(e.ball, e.roundings), last]
    return with_roundings(
        body, equations, q, slopes._replace(value=wrench.value), exact_motion(body, e)
    )


def _tangent(body: Body, e: Direction, last: Equation) -> Proved:
    """The rotation about the point at which a line of force is tangent to the ring."""
    (x, y), radius = e.ball, ring_radius(body)
    assert radius is not None
    side = -y.sgn() * (1 if body.length > 0 else -1)
    q = [x, y - side * body.length / radius, side / radius + arb(0)]
    q = _scale_to(last, q)
    wrench = body.wrench(q)
    return _with_slopes(body, e, last, q, wrench, differences(body, q))


def _scale_to(last: Equation, q: Row) -> Row:
    """A multiple of a motion that satisfies an equation of degree 1 or 2 in it."""
    empty = Wrench([arb(0)] * 3, [[arb(0)] * 3] * 3, [arb(0)] * 3)
    zero, one = (last(motion, empty).value for motion in ([arb(0)] * 3, q))
    two = last([2 * part for part in q], empty).value
    change, degree = one - zero, ((two - zero) / (one - zero)).mid()
    factor = (-zero / change) if degree < 3 else (-zero / change).sqrt()
    return [factor * part for part in q]


@remember(1 << 14)
def limit_point(slider: Slider, force: Direction) -> Proved:
    """The motion under a force with the kinetic energy of a unit translation (ring, or inertia)."""
    body, e = slider.body, force.about(slider.rod_angle)
    unit = replace(body, support=None, weight=fmpq(0), mass=ONE, gyration=_gyration(body))
    return _solve(body, e, energy(unit.matrix, ONE))


@remember(1 << 14)
def unit_motion(slider: Slider, force: Direction) -> Proved:
    """The motion under a force whose center moves with unit speed along it (ring, or inertia)."""
    body, e = slider.body, force.about(slider.rod_angle)
    x, y = e.ball
    return _solve(body, e, moves((x, y, y * body.length), 1, e.roundings))


@remember(1 << 14)
def contact_motion(slider: Slider, force: Direction, size: fmpq) -> Proved:
    """The motion under a force whose contact moves by `size` (ring, or inertia)."""
    body, e = slider.body, force.about(slider.rod_angle)
    return _solve(body, e, energy(CONTACT, size**2))


def _gyration(body: Body) -> fmpq:
    return (
        body.gyration if body.mass != 0 or body.gyration != 0 else (ring_radius(body) or ONE) ** 2
    )


def _solve(body: Body, e: Direction, last: Equation) -> Proved:
    if is_tangent(body, e):
        return _tangent(body, e, last)
    if is_straight(body, e):
        return _translate(body, e, last)
    guess = [part.mid() for part in guess_ray(body, e.ball)]
    return _enclose(body, e, last, _scale_to(last, guess))


# --- Motions of a contact -----------------------------------------------------------------------------


@remember(1 << 14)
def stick(slider: Slider, motion: Direction, size: fmpq) -> tuple[Proved, Proved]:
    """The motion whose contact moves by `size` along a direction, at both ends of its interval of forces.

    The two are the same unless the slider pivots about a foot across the motion.

    Raises
    ------
    Undecided
        If rounding decides whether the slider pivots.
    """
    body, t = slider.body, motion.about(slider.rod_angle)
    u = size * t.ball[0], size * t.ball[1]
    for foot in range(len(body.support.points) if body.weight != 0 and body.support else 0):
        r = body.foot(foot)
        if any(r) and t.along(r) == 0:
            ends = pivot_at(body, t, u, foot)
            if ends is not None:
                return ends
    return (_stick(body, t, u),) * 2


def _stick(body: Body, t: Direction, u: Vector) -> Proved:
    equations, exact = _contact_equations(u, t.roundings), exact_force(body, t)
    if is_straight(body, t):
        q = [*u, arb(0)]
        return with_roundings(body, equations, q, body.wrench(q), exact)
    try:
        return with_roundings(
            body, equations, *krawczyk(body, equations, [*u, guess_rotation(body, u)]), exact
        )
    except Undecided:
        q, wrench, slopes = rotation(body, u)
        return with_roundings(body, equations, q, slopes._replace(value=wrench.value), exact)


def _contact_equations(u: Vector, roundings: arb) -> list[Equation]:
    return [torque, moves((1, 0, 0), u[0], roundings), moves((0, 1, 0), u[1], roundings)]


def rotation(body: Body, u: Vector) -> tuple[Row, Wrench, Wrench]:
    """The rotation without torque at a contact motion, also where the torque has no finite slope.

    The torque increases with the rotation, so that a change of its sign proves that there is one.

    Returns
    -------
    q : list of arb
    wrench : Wrench
    slopes : Wrench
        With difference quotients instead of slopes.
    """

    def moment(omega: arb) -> arb:
        return body.wrench([*u, omega]).value[2]

    guess = guess_rotation(body, u)
    step = (abs(guess) + 1) * arb(2) ** (24 - ctx.prec)
    for _ in range(ctx.prec):
        low, high = (guess - step).mid(), (guess + step).mid()
        if moment(low) < 0 < moment(high):
            break
        step = 2 * step
    else:
        raise Undecided("no change of sign of the torque")
    limit = arb(2) ** (24 - ctx.prec) * (abs(guess) + 1)
    while high - low > 4 * limit:
        middle = ((low + high) / 2).mid()
        value = moment(middle)
        if value.contains(0):
            bracket = (middle - limit).mid(), (middle + limit).mid()
            if not moment(bracket[0]) < 0 < moment(bracket[1]):
                raise Undecided("a torque that hardly changes with the rotation")
            low, high = bracket
            break
        low, high = (middle, high) if value < 0 else (low, middle)
    omega = low.union(high)
    q = [*u, omega]
    return q, body.wrench(q), differences(body, q)


#: Precision of guesses in bits, and most steps to one.
GUESS_BITS, GUESS_STEPS = 80, 80


def guess_ray(body: Body, e: Vector) -> Row:
    """A motion with ``e . u = 1`` at which the potential is least, by damped Newton steps."""
    with ctx.workprec(GUESS_BITS):
        e = e[0].mid(), e[1].mid()
        across = -e[1], e[0]
        unknowns = _start(body, e)

        def motion_at(unknowns: Sequence[arb]) -> Row:
            return [
                (e[0] + unknowns[0] * across[0]).mid(),
                (e[1] + unknowns[0] * across[1]).mid(),
                unknowns[1].mid(),
            ]

        def slope(wrench: Wrench) -> tuple[arb, arb]:
            return dot(across, wrench.value[:2]).mid(), wrench.value[2].mid()

        wrench = body.wrench(motion_at(unknowns))
        for _ in range(GUESS_STEPS):
            g, j = slope(wrench), wrench.jacobian
            rows = [dot(across, (j[0][k], j[1][k])) for k in range(3)]
            a, b, d = dot(across, rows[:2]).mid(), rows[2].mid(), j[2][2].mid()
            determinant = (a * d - b * b).mid()
            if not determinant > 0:
                break
            step = (
                ((b * g[1] - d * g[0]) / determinant).mid(),
                ((b * g[0] - a * g[1]) / determinant).mid(),
            )
            fall, part = abs(dot(g, step)), arb(1)
            if fall < arb(2) ** (8 - GUESS_BITS):
                break
            for _ in range(GUESS_STEPS):
                trial = [(x + part * s).mid() for x, s in zip(unknowns, step, strict=True)]
                try:
                    wrench = body.wrench(motion_at(trial))
                    if dot(slope(wrench), step) <= fall * arb(0.9):
                        break
                except Undecided:
                    pass
                part = (part * arb(0.4)).mid()
            else:
                wrench = body.wrench(motion_at(trial))  # may be undecided
            unknowns = trial
        return motion_at(unknowns)


def _start(body: Body, e: Vector) -> list[arb]:
    """The motion of a mass with the second moments of the pressure: component across e, and rotation."""
    if body.weight == 0:
        x, y, second = body.mass_center[0] + body.length, body.mass_center[1], None
    else:
        (x, y), second = body.pressure, body.second_moments
    gyration = body.gyration if second is None else second[0] + second[2] - x * x - y * y
    turn = (x * e[1] - y * e[0]) / arb(gyration)
    u = e[0] - turn * y, e[1] + turn * x
    power = dot(u, e)
    return [(cross(e, u) / power).mid(), (turn / power).mid()]


def guess_beside(body: Body, e: Vector, foot: int) -> Row:
    """A motion with ``e . u = 1`` next to the rotation about a foot, at which Newton steps end too early.

    The potential falls fastest if the foot moves along h, the force that would hold it, up to where its
    slope changes sign.
    """
    with ctx.workprec(GUESS_BITS):
        e, r = (e[0].mid(), e[1].mid()), body.foot(foot)
        arm = cross(e, r)
        q = [r[1] / arm, -r[0] / arm, 1 / arm]
        h = holding_force(body.wrench(q, foot).value, e, r)
        size = norm(*h)
        p, turn = dot(r, h) / arm / size, -dot(e, h) / arm / size
        step = [-e[1] * p, e[0] * p, turn]  # moves the foot by h / |h|
        part = arb(1)
        for _ in range(2 * GUESS_BITS):
            guess = [(a + part * b).mid() for a, b in zip(q, step, strict=True)]
            if dot(step, body.wrench(guess).value) < 0:
                break
            part = part / 2
        return guess


def guess_rotation(body: Body, u: Vector) -> arb:
    """A rotation without torque: the torque increases with it; Newton steps inside a bracket."""
    with ctx.workprec(GUESS_BITS):
        motion = [u[0].mid(), u[1].mid()]
        square = body.lever**2 if body.weight != 0 else arb(body.matrix[2][2] / body.mass)
        reach = ((motion[0] ** 2 + motion[1] ** 2) / square).sqrt().mid()
        low, high, omega, fine = arb.neg_inf(), arb.pos_inf(), arb(0), arb(2) ** (20 - GUESS_BITS)
        for _ in range(4 * GUESS_STEPS):
            wrench = body.wrench([*motion, omega])
            value, slope = wrench.value[2].mid(), wrench.jacobian[2][2].mid()
            low, high = (low, omega) if value > 0 else (omega, high)
            target = (omega - value / slope).mid() if slope > 0 else arb.nan()
            if value.is_zero() or abs(target - omega) < fine * abs(omega):
                return target if target.is_finite() else omega
            if high - low < fine * (abs(low) + abs(high)):
                return omega
            limit = (4 * abs(omega) + reach).mid()
            if arb.max(low, -limit) < target < arb.min(high, limit):
                omega = target
            elif low.is_finite() and high.is_finite():
                omega = ((low + high) / 2).mid()
            else:
                omega = -limit if value > 0 else limit
        return omega
