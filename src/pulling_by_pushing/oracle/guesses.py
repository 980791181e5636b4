"""Guesses of motions, in coarse arithmetic: the minimum of a potential, the rotation without torque."""

from __future__ import annotations

from collections.abc import Sequence

from flint import arb, ctx

from pulling_by_pushing.oracle.balls import Undecided, Vector, cross, dot, norm
from pulling_by_pushing.oracle.body import Body, Row, Wrench, holding_force

#: Precision of guesses in bits, and most steps to one.
COARSE, STEPS = 80, 80


def guess_ray(body: Body, e: Vector) -> Row:
    """A motion with ``e . u = 1`` at which the potential is least, by damped Newton steps."""
    with ctx.workprec(COARSE):
        e = e[0].mid(), e[1].mid()
        across = -e[1], e[0]
        place = _start(body, e)

        def at(place: Sequence[arb]) -> Row:
            return [
                (e[0] + place[0] * across[0]).mid(),
                (e[1] + place[0] * across[1]).mid(),
                place[1].mid(),
            ]

        def slope(wrench: Wrench) -> tuple[arb, arb]:
            return dot(across, wrench.value[:2]).mid(), wrench.value[2].mid()

        for _ in range(STEPS):
            wrench = body.wrench(at(place))
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
            if fall < arb(2) ** (8 - COARSE):
                break
            for _ in range(STEPS):
                there = [(x + part * s).mid() for x, s in zip(place, step, strict=True)]
                try:
                    if dot(slope(body.wrench(at(there))), step) <= fall * arb(0.9):
                        break
                except Undecided:
                    pass
                part = (part * arb(0.4)).mid()
            place = there
        return at(place)


def _start(body: Body, e: Vector) -> list[arb]:
    """The motion of a mass with the second moments of the pressure: component across e, and rotation."""
    if body.weight == 0:
        x, y, second = body.mass_center[0] + body.length, body.mass_center[1], None
    else:
        (x, y), second = body.pressure, body.spread
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
    with ctx.workprec(COARSE):
        e, r = (e[0].mid(), e[1].mid()), body.foot(foot)
        arm = cross(e, r)
        q = [r[1] / arm, -r[0] / arm, 1 / arm]
        h = holding_force(body.wrench(q, foot).value, e, r)
        size = norm(*h)
        p, turn = dot(r, h) / arm / size, -dot(e, h) / arm / size
        step = [-e[1] * p, e[0] * p, turn]  # moves the foot by h / |h|
        part = arb(1)
        for _ in range(2 * COARSE):
            guess = [(a + part * b).mid() for a, b in zip(q, step, strict=True)]
            if dot(step, body.wrench(guess).value) < 0:
                break
            part = part / 2
        return guess


def guess_rotation(body: Body, u: Vector) -> arb:
    """A rotation without torque: the torque increases with it; Newton steps inside a bracket."""
    with ctx.workprec(COARSE):
        motion = [u[0].mid(), u[1].mid()]
        square = body.lever**2 if body.weight != 0 else arb(body.matrix[2][2] / body.mass)
        reach = ((motion[0] ** 2 + motion[1] ** 2) / square).sqrt().mid()
        low, high, omega, fine = arb.neg_inf(), arb.pos_inf(), arb(0), arb(2) ** (20 - COARSE)
        for _ in range(4 * STEPS):
            wrench = body.wrench([*motion, omega])
            value, slope = wrench.value[2].mid(), wrench.jacobian[2][2].mid()
            low, high = (low, omega) if value > 0 else (omega, high)
            target = (omega - value / slope).mid() if slope > 0 else arb.nan()
            if value.is_zero() or abs(target - omega) < fine * abs(omega):
                return target if target.is_finite() else omega
            if high - low < fine * (abs(low) + abs(high)):
                return omega
            far = (4 * abs(omega) + reach).mid()
            if arb.max(low, -far) < target < arb.min(high, far):
                omega = target
            elif low.is_finite() and high.is_finite():
                omega = ((low + high) / 2).mid()
            else:
                omega = -far if value > 0 else far
        return omega
