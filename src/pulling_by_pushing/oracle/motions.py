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

from pulling_by_pushing.oracle.balls import Direction, Undecided, Vector, cross, remember
from pulling_by_pushing.oracle.body import Body, Row, Wrench
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
from pulling_by_pushing.oracle.guesses import guess_beside, guess_ray, guess_rotation
from pulling_by_pushing.oracle.pivots import pivot_at, pivot_under
from pulling_by_pushing.oracle.prove import (
    Equation,
    Proved,
    Slider,
    along,
    differences,
    energy,
    krawczyk,
    moves,
    torque,
    with_roundings,
)

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
    equations = [torque, along(e.ball, e.roundings), last]
    return with_roundings(body, equations, *krawczyk(body, equations, guess), exact_motion(body, e))


def _translate(body: Body, e: Direction, last: Equation) -> Proved:
    """The translation along a force through the center, scaled to an equation."""
    equations = [torque, along(e.ball, e.roundings), last]
    q = _scale_to(last, [*e.ball, arb(0)])
    return with_roundings(body, equations, q, body.wrench(q), exact_motion(body, e))


def _with_slopes(
    body: Body, e: Direction, last: Equation, q: Row, wrench: Wrench, slopes: Wrench
) -> Proved:
    equations = [torque, along(e.ball, e.roundings), last]
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
    rise, degree = one - zero, ((two - zero) / (one - zero)).mid()
    factor = (-zero / rise) if degree < 3 else (-zero / rise).sqrt()
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
            near = (middle - limit).mid(), (middle + limit).mid()
            if not moment(near[0]) < 0 < moment(near[1]):
                raise Undecided("a torque that hardly changes with the rotation")
            low, high = near
            break
        low, high = (middle, high) if value < 0 else (low, middle)
    omega = low.union(high)
    q = [*u, omega]
    return q, body.wrench(q), differences(body, q)
