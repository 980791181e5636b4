"""Pivots: rotations about a foot of the support, whose friction is any force up to its share."""

from __future__ import annotations

from dataclasses import replace

from flint import arb, fmpq

from pulling_by_pushing.oracle.balls import (
    ROUNDINGS,
    UNIT,
    ZERO,
    Direction,
    Exact,
    Position,
    Undecided,
    Vector,
    dot,
    settle,
    sign,
    terms,
)
from pulling_by_pushing.oracle.body import Body, Matrix, Row, Wrench, holding_force
from pulling_by_pushing.oracle.exact import is_across, is_even
from pulling_by_pushing.oracle.prove import Proved, differences, numbers_of


def pivot_under(body: Body, e: Direction, foot: int) -> Proved | None:
    """The rotation about a foot under a force; None if the foot would have to carry more than its share.

    The other friction requires the force f and the torque T. With the foot at r from the contact, its force
    ``h = (T e - r (e x f)) / (e x r)`` makes f + h parallel to e, without torque.
    """
    r, (x, y) = body.foot(foot), e.ball
    if e.across(r) == 0:
        return None
    arm = x * r[1] - y * r[0]
    q = [r[1] / arm, -r[0] / arm, 1 / arm]
    wrench = body.wrench(q, foot)
    jacobian = _slopes(body, q, wrench, foot)

    def balance(f_x: arb, f_y: arb, moment: arb, e_x: arb, e_y: arb) -> list[arb]:
        """The force with that of the foot, and the square of the latter."""
        h_x, h_y = holding_force([f_x, f_y, moment], (e_x, e_y), r)
        return [f_x + h_x, f_y + h_y, h_x * h_x + h_y * h_y]

    inputs = [*wrench.value, x, y]
    size = [*wrench.size]
    size[2] = size[2] + body.share(foot) * arb(r[0] * r[0] + r[1] * r[1]).sqrt()
    changes = [[size[i] if k == i else arb(0) for k in range(3)] + [arb(0)] * 2 for i in range(3)]
    turn = e.roundings
    changes.append([arb(0)] * 3 + [-y * turn, x * turn])
    motion_shifts = [[arb(0)] * 3] * 4
    for i in range(3):
        dq = [abs(q[i].mid()) if k == i else arb(0) for k in range(3)]
        changes.append([dot(row, dq) for row in jacobian] + [arb(0)] * 2)
        motion_shifts.append(dq)
    load = numbers_of(lambda *parts: balance(*parts)[2:], inputs, changes)[0]
    share = body.share(foot)
    excess = load.ball - share * share
    if sign(excess) >= 0:
        if not excess > load.allowance:
            raise Undecided(f"rounding decides whether the slider pivots about the point {foot}")
        return None
    f_x, f_y, _ = balance(*inputs)
    unit = ROUNDINGS * UNIT
    shifts = []
    for change, dq in zip(changes, motion_shifts, strict=True):
        changed = balance(*((a + unit * b).mid() for a, b in zip(inputs, change, strict=True)))
        shifts.append([*dq, (changed[0] - f_x.mid()) / unit, (changed[1] - f_y.mid()) / unit])
    exact = _across_rod(e, r, sign(q[2]))
    return Proved(q, (f_x, f_y), shifts, foot, exact)


def _across_rod(e: Direction, r: Position, turn: int) -> tuple[Exact, Exact] | None:
    """Exact direction of a contact that rotates about a foot on the rod's line."""
    return None if r[1] else e.to_fence((ZERO, fmpq(-turn if r[0] > 0 else turn)))


def pivot_at(body: Body, t: Direction, u: Vector, foot: int) -> tuple[Proved, Proved] | None:
    """The rotation about a foot across the motion of the contact; None if the foot slides.

    The friction of the foot along the line from the contact is free: the two ends are those at which all
    of its share is used.
    """
    r = body.foot(foot)
    square = r[0] * r[0] + r[1] * r[1]
    omega = (r[1] * u[0] - r[0] * u[1]) / square
    q = [omega * r[1], -omega * r[0], omega]
    wrench, reach = body.wrench(q, foot), arb(square).sqrt()
    jacobian = _slopes(body, q, wrench, foot)
    share = body.share(foot)

    def ends(f_x: arb, f_y: arb, moment: arb) -> list[arb]:
        part = -moment / reach
        middle = f_x - part * r[1] / reach, f_y + part * r[0] / reach
        free = (arb(share * share) - part * part).sqrt() / reach
        low, high = (
            (middle[0] + side * free * r[0], middle[1] + side * free * r[1]) for side in (-1, 1)
        )
        return [*low, *high]

    slack = arb(share) - abs(wrench.value[2]) / reach
    if settle(terms(slack, arb(share), wrench.size[2] / reach)) <= 0:
        return None
    changes = [[wrench.size[i] if k == i else arb(0) for k in range(3)] for i in range(3)]
    motion_shifts = [[arb(0)] * 3] * 3
    for i in range(3):
        dq = [abs(q[i].mid()) * t.roundings if k == i else arb(0) for k in range(3)]
        changes.append([dot(row, dq) for row in jacobian])
        motion_shifts.append(dq)
    base, unit = ends(*wrench.value), ROUNDINGS * UNIT
    shifts: list[list[Row]] = [[], []]
    for change, dq in zip(changes, motion_shifts, strict=True):
        changed = ends(*((a + unit * b).mid() for a, b in zip(wrench.value, change, strict=True)))
        by = [(b - a.mid()) / unit for a, b in zip(base, changed, strict=True)]
        for side in (0, 1):
            shifts[side].append([*dq, *by[2 * side : 2 * side + 2]])
    exact = t.in_fence_frame if is_even(body) and is_across(t) else None
    low, high = (Proved(q, (base[2 * i], base[2 * i + 1]), shifts[i], foot, exact) for i in (0, 1))
    return low, high


def clip(end: Proved, body: Body, edge: Direction) -> Proved:
    """The force of a pivot on an edge of the friction cone, where it meets the line of possible forces."""
    r, (x, y) = body.foot(end.pivot), edge.ball
    turn = ROUNDINGS * UNIT * edge.roundings

    def on_edge(f_x: arb, f_y: arb, x: arb, y: arb) -> Vector:
        size = (f_x * r[1] - f_y * r[0]) / (x * r[1] - y * r[0])
        return size * x, size * y

    f_x, f_y = end.force
    force = on_edge(f_x, f_y, x, y)
    shifts = [[*shift[:3], *on_edge(shift[3], shift[4], x, y)] for shift in end.shifts]
    other = on_edge(f_x, f_y, x - turn * y, y + turn * x)
    shifts.append(
        [arb(0)] * 3
        + [(a - b).mid() / turn * edge.roundings for a, b in zip(other, force, strict=True)]
    )
    return replace(end, force=force, shifts=shifts, exact=None)


def _slopes(body: Body, q: Row, wrench: Wrench, foot: int) -> Matrix:
    """Slopes of the other friction; difference quotients where there are none, as for a foot on a rim."""
    rows = wrench.jacobian
    if not all(part.is_finite() for row in rows for part in row):
        rows = differences(body, q, foot).jacobian
    return [[part.mid() for part in row] for row in rows]
