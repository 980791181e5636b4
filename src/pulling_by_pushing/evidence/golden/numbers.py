"""Numbers of a proved motion: angle, spin ratio, center of rotation."""

from __future__ import annotations

from collections.abc import Iterable

from flint import arb, fmpq

from pulling_by_pushing.oracle.balls import (
    Direction,
    Number,
    Vector,
    cross,
    dot,
    in_degrees,
    is_zero,
    norm,
)
from pulling_by_pushing.oracle.prove import Proved, Slider, State
from pulling_by_pushing.oracle.support import Support


def smaller(a: Number, b: Number) -> Number:
    """The smaller of two numbers, with the larger rounding."""
    return Number(arb.min(a.ball, b.ball), arb.max(a.rounding, b.rounding))


def larger(a: Number, b: Number) -> Number:
    """The larger of two numbers, with the larger rounding."""
    return Number(arb.max(a.ball, b.ball), arb.max(a.rounding, b.rounding))


def motion_angle(slider: Slider, force: Direction, motion: Proved) -> Number:
    """Angle of the contact's motion in degrees, on the branch within 90 degrees of the force."""

    def turn(state: State) -> list[arb]:
        u, e = state.to_fence(state.u_x, state.u_y), force.ball
        return [in_degrees(arb.atan2(cross(e, u), dot(e, u)))]

    number = motion.numbers(slider, turn)[0]
    angle = force.angle + number.ball
    return Number(angle, number.rounding + abs(force.angle) + abs(angle))


def force_angle(slider: Slider, pusher: Direction, motion: Proved) -> Number:
    """Angle of a sticking force in degrees, on the branch within 90 degrees of the motion."""

    def turn(state: State) -> list[arb]:
        f, u = state.to_fence(state.f_x, state.f_y), pusher.ball
        return [in_degrees(arb.atan2(cross(u, f), dot(u, f)))]

    number = motion.numbers(slider, turn)[0]
    angle = pusher.angle + number.ball
    return Number(angle, number.rounding + abs(pusher.angle) + abs(angle))


def spin_ratio(slider: Slider, motion: Proved, size: fmpq | arb) -> Number:
    """Rotation times a length over the speed of the slider's center; infinite for a rotation about it."""

    def parts(state: State) -> list[arb]:
        v = state.u_x, state.u_y + state.omega * state.length
        return [state.omega * size, *v]

    turn, v_x, v_y = motion.numbers(slider, parts)
    if turn.ball.is_zero():
        return turn
    speed = norm(v_x.ball, v_y.ball)
    if speed <= v_x.allowance + v_y.allowance:
        return Number(
            arb.pos_inf() * turn.ball.sgn(),
            abs(turn.ball) / (speed + v_x.allowance + v_y.allowance),
        )
    return motion.numbers(slider, lambda state: [parts(state)[0] / norm(*parts(state)[1:])])[0]


def center(slider: Slider, motion: Proved) -> list[Number]:
    """Center of rotation from the contact, in the frame of the fence.

    A translation has the limit of slow rotations to the left: infinite along the axes on which the slider
    moves across, and the slider's center along the others.
    """

    def parts(state: State) -> list[arb]:
        return [state.omega, *state.to_fence(-state.u_y, state.u_x)]

    omega, *across = motion.numbers(slider, parts)
    if abs(omega.ball) > omega.allowance:
        return motion.numbers(
            slider, lambda state: [part / state.omega for part in parts(state)[1:]]
        )
    centers = motion.numbers(slider, lambda state: state.to_fence(state.length, arb(0)))
    for i, part in enumerate(across):
        if abs(part.ball) > part.allowance:
            most = abs(omega.ball) + omega.allowance
            smallest_distance = arb(0) if most == 0 else (abs(part.ball) - part.allowance) / most
            centers[i] = Number(arb.pos_inf() * part.ball.sgn(), smallest_distance)
        elif not (omega.ball.is_zero() and _moves_along(motion, i)):
            centers[i] = centers[i]._replace(rounding=arb.pos_inf())
    return centers


def _moves_along(motion: Proved, axis: int) -> bool:
    """Whether a translation is exactly along an axis of the fence's frame."""
    return motion.exact is not None and is_zero(motion.exact[1 - axis])


def centers_of(slider: Slider, motions: Iterable[Proved | None]) -> list[tuple[Support, Vector]]:
    """The supports and centers of rotation of motions with friction, in the frame of the body."""
    body, centers = slider.body, []
    for motion in motions:
        if (
            motion is not None
            and body.weight != 0
            and body.support is not None
            and not motion.q[2].contains(0)
        ):
            x, y, omega = (part.mid() for part in motion.q)
            centers.append((body.support, ((-y / omega).mid() - body.length, (x / omega).mid())))
    return centers
