"""One root of a small system of equations, proved by interval Newton (Krawczyk) next to a guess.

An equation is a function of a motion and its wrench that returns a value, its gradient by the motion, and
the magnitude of its terms with the roundings of its inputs. The potential of the effects is convex, so
that a root near a guess is the root.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

from flint import arb, arb_mat, ctx, fmpq

from pulling_by_pushing.oracle.balls import (
    ROUNDINGS,
    UNIT,
    Exact,
    Number,
    Undecided,
    Vector,
    cosine_sine,
    dot,
)
from pulling_by_pushing.oracle.body import Body, Matrix, Row, Wrench

#: Most Newton steps, and most widenings of a box.
KRAWCZYK_STEPS, WIDENINGS = 30, 5
#: A root or a wrench that is known less accurately than this, relative to its terms, is tried again.
WORST_ACCURACY = arb(2) ** -80


class Row3(NamedTuple):
    """An equation at a motion: value, gradient, and magnitude of its terms."""

    value: arb
    gradient: Sequence[arb]
    size: arb


ONE_ROUNDING = arb(1)
Equation = Callable[[Sequence[arb], Wrench], Row3]


def torque(q: Sequence[arb], wrench: Wrench) -> Row3:
    """No torque about the contact."""
    return Row3(wrench.value[2], wrench.jacobian[2], wrench.size[2])


def force_along(direction: Vector, roundings: arb = ONE_ROUNDING) -> Equation:
    """The force is along a direction, or against it; `roundings` are those of the direction."""
    x, y = direction

    def row(q: Sequence[arb], wrench: Wrench) -> Row3:
        (f_x, f_y, _), (by_x, by_y, _) = wrench.value, wrench.jacobian
        gradient = [x * b - y * a for a, b in zip(by_x, by_y, strict=True)]
        return Row3(x * f_y - y * f_x, gradient, roundings * (wrench.size[0] + wrench.size[1]))

    return row


def moves(direction: Sequence[Any], value: Any, roundings: arb = ONE_ROUNDING) -> Equation:
    """A linear condition on the motion: its part along a direction of (u_x, u_y, omega)."""

    def row(q: Sequence[arb], wrench: Wrench) -> Row3:
        largest = max(abs(arb(part)) for part in direction)
        size = roundings * largest * (abs(q[0]) + abs(q[1])) + abs(arb(value))
        return Row3(dot(direction, q) - value, [arb(part) for part in direction], size)

    return row


def energy(matrix: Matrix, value: fmpq) -> Equation:
    """Twice the kinetic energy of a mass."""

    def row(q: Sequence[arb], wrench: Wrench) -> Row3:
        momentum = [dot(line, q) for line in matrix]
        twice = dot(q, momentum)
        return Row3(twice - value, [2 * part for part in momentum], 2 * abs(arb(twice)))

    return row


@dataclass(frozen=True, eq=False)
class Slider:
    """A body whose rod is at an angle to the fence, in exact degrees."""

    body: Body
    rod_angle: fmpq

    @property
    def rod(self) -> Vector:
        """Cosine and sine of the rod's angle."""
        return cosine_sine(self.rod_angle)


class State(NamedTuple):
    """A proved motion and its force, with the rod to which their frame belongs."""

    u_x: arb
    u_y: arb
    omega: arb
    f_x: arb
    f_y: arb
    cosine: arb
    sine: arb
    length: arb

    def to_fence(self, x: arb, y: arb) -> Vector:
        """A vector of the rod's frame in the frame of the fence."""
        return x * self.cosine - y * self.sine, x * self.sine + y * self.cosine


@dataclass(frozen=True, eq=False)
class Proved:
    """A motion with its force, both enclosed.

    Attributes
    ----------
    q : list of arb
        (u_x, u_y, omega) in the frame of the rod.
    force : tuple of arb
        With the force of the foot about which the slider pivots.
    shifts : list
        Changes of (u_x, u_y, omega, f_x, f_y) by one rounding of a term or an input, over `UNIT`.
    pivot : int
        Index of the point of the support about which the slider rotates, or -1.
    exact : tuple, optional
        Exact direction, in the frame of the fence, of the motion (under a force) or of the force (of a
        sticking motion); in a translation the two are the same.
    """

    q: Row
    force: Vector
    shifts: list[Row]
    pivot: int = -1
    exact: tuple[Exact, Exact] | None = None

    def numbers(self, slider: Slider, function: Callable[[State], Iterable[arb]]) -> list[Number]:
        """Functions of motion and force, with what roundings of terms and inputs change in them."""
        cosine, sine = slider.rod
        state = [*self.q, *self.force, cosine, sine, arb(slider.body.length)]
        turn = 1 + math.radians(float(slider.rod_angle))
        shifts = [[*shift, arb(0), arb(0), arb(0)] for shift in self.shifts]
        shifts.append([arb(0)] * 5 + [-sine * turn, cosine * turn, arb(0)])
        shifts.append([arb(0)] * 7 + [arb(slider.body.length)])
        return numbers_of(lambda *parts: function(State(*parts)), state, shifts)


def numbers_of(
    function: Callable[..., Iterable[arb]], inputs: Sequence[arb], shifts: Iterable[Sequence[arb]]
) -> list[Number]:
    """Values of a function, with their roundings from shifts of its inputs that are given over `UNIT`."""
    size, balls = ROUNDINGS * UNIT, list(function(*inputs))
    roundings = [abs(ball).upper() for ball in balls]
    for shift in shifts:
        ends = [
            function(*((a + side * size * b).mid() for a, b in zip(inputs, shift, strict=True)))
            for side in (-1, 1)
        ]
        for i, (ball, low, high) in enumerate(zip(balls, *ends, strict=True)):
            middle = ball.mid()
            roundings[i] += arb.max(abs(low - middle).upper(), abs(high - middle).upper()) / size
    return [Number(ball, rounding) for ball, rounding in zip(balls, roundings, strict=True)]


def with_roundings(
    body: Body,
    equations: Sequence[Equation],
    q: Row,
    wrench: Wrench,
    exact: tuple[Exact, Exact] | None = None,
) -> Proved:
    """A root of equations, with the effect of roundings on it.

    These are a rounding of each equation's terms, of each unknown, and of the length of the rod and of the
    support's points, which change the velocities of all of them.
    """
    value, jacobian, size = (
        [part.mid() for part in wrench.value],
        _middles(wrench.jacobian),
        wrench.size,
    )
    middle, middle_wrench = [part.mid() for part in q], Wrench(value, jacobian, size)
    rows = [equation(middle, middle_wrench) for equation in equations]
    inverse = _inverse(rows)
    shifts = []
    for i, row in enumerate(rows):
        dq = [inverse[k, i] * row.size for k in range(3)]
        shifts.append([*dq, *(dot(line, dq) for line in jacobian[:2])])
    for i in range(3):
        dq = [abs(middle[i]) if k == i else arb(0) for k in range(3)]
        shifts.append([*dq, *(dot(line, dq) for line in jacobian[:2])])
    extent = body.support.extent if body.support is not None else arb(0)
    for i, reach in enumerate((extent, extent + abs(arb(body.length)))):
        change = [line[i] * middle[2] * reach for line in jacobian]
        change[2] = change[2] + value[1 - i] * reach
        shifted = middle_wrench._replace(value=[a + b for a, b in zip(value, change, strict=True)])
        defect = [
            equation(middle, shifted).value - row.value
            for equation, row in zip(equations, rows, strict=True)
        ]
        dq = [-dot((inverse[k, m] for m in range(3)), defect) for k in range(3)]
        shifts.append(
            [*dq, *(dot(line, dq) + part for line, part in zip(jacobian[:2], change, strict=False))]
        )
    return Proved(q, (wrench.value[0], wrench.value[1]), shifts, exact=exact)


def differences(body: Body, q: Row, skip: int = -1) -> Wrench:
    """The wrench with difference quotients over roundings, where there are no second derivatives."""
    middle = [part.mid() for part in q]
    floor = sum((abs(part) for part in middle), arb(0)) * UNIT
    columns = []
    for i in range(3):
        size = (ROUNDINGS * UNIT * arb.max(abs(middle[i]), floor)).mid()
        low, high = (
            body.wrench(
                [(part + side * size * (k == i)).mid() for k, part in enumerate(middle)], skip
            ).value
            for side in (-1, 1)
        )
        columns.append([((b - a) / (2 * size)).mid() for a, b in zip(low, high, strict=True)])
    wrench = body.wrench(q, skip)
    return wrench._replace(jacobian=[[column[i] for column in columns] for i in range(3)])


def _middles(matrix: Matrix) -> Matrix:
    return [[part.mid() for part in row] for row in matrix]


def krawczyk(body: Body, equations: Sequence[Equation], guess: Sequence[Any]) -> tuple[Row, Wrench]:
    """Enclose the root of three equations near a guess.

    Returns
    -------
    q : list of arb
    wrench : Wrench
        At the root.

    Raises
    ------
    Undecided
        If interval Newton does not contract, as where the equations have no finite slopes.
    """

    def rows(q: Sequence[arb]) -> list[Row3]:
        wrench = body.wrench(q)
        return [equation(q, wrench) for equation in equations]

    x = [arb(part).mid() for part in guess]
    for _ in range(KRAWCZYK_STEPS):
        step = _newton_step(rows(x))
        x = [(a - b).mid() for a, b in zip(x, step, strict=True)]
        scale = _scale(body, x)
        if all(abs(b) <= a * arb(2) ** (-ctx.prec // 2) for a, b in zip(scale, step, strict=True)):
            break
    if abs(x[2]) < scale[2] * arb(2) ** (-ctx.prec // 3):
        x[2] = arb(0)
    equation_rows = rows(x)
    inverse = _inverse(equation_rows)
    correction = inverse * arb_mat([[row.value] for row in equation_rows])
    floor = [part * arb(2) ** (16 - ctx.prec) for part in scale]
    width = [arb.max(2 * abs(correction[i, 0]).upper(), floor[i]).upper() for i in range(3)]
    for _ in range(WIDENINGS):
        box = [a + arb(0, b) for a, b in zip(x, width, strict=True)]
        defect = inverse * arb_mat([list(row.gradient) for row in rows(box)])
        for i in range(3):
            defect[i, i] = defect[i, i] - 1
        move = defect * arb_mat([[arb(0, b)] for b in width])
        image = [x[i] - correction[i, 0] - move[i, 0] for i in range(3)]
        if all(b.contains_interior(a) for a, b in zip(image, box, strict=True)):
            wrench = body.wrench(image)
            force = sum(wrench.size, arb(0))
            sizes = [*scale, force, force, force]
            if any(
                a.rad() > b * WORST_ACCURACY
                for a, b in zip((*image, *wrench.value), sizes, strict=True)
            ):
                raise Undecided("a root that is known to few digits")
            return image, wrench
        width = [arb(64 * b).upper() for b in width]
    raise Undecided("interval Newton does not contract")


def _scale(body: Body, q: Sequence[arb]) -> list[arb]:
    """Magnitudes of a motion, which do not vanish for a translation or for a motion along an axis."""
    size = body.support.extent if body.support is not None else arb(1)
    speed = arb.max(arb.max(abs(q[0]), abs(q[1])), abs(q[2]) * size).mid()
    return [speed, speed, arb.max(abs(q[2]), speed / (size + abs(arb(body.length)))).mid()]


def _newton_step(rows: Sequence[Row3]) -> list[arb]:
    try:
        step = _mid(arb_mat([list(row.gradient) for row in rows])).solve(
            arb_mat([[row.value.mid()] for row in rows])
        )
    except ZeroDivisionError:
        raise Undecided("a singular system") from None
    return [step[i, 0] for i in range(3)]


def _inverse(rows: Sequence[Row3]) -> arb_mat:
    try:
        return _mid(_mid(arb_mat([list(row.gradient) for row in rows])).inv())
    except ZeroDivisionError:
        raise Undecided("a singular system") from None


def _mid(matrix: arb_mat) -> arb_mat:
    """Midpoints of a matrix; Undecided if they are not finite."""
    rows = [[matrix[i, k].mid() for k in range(matrix.ncols())] for i in range(matrix.nrows())]
    if not all(part.is_finite() for row in rows for part in row):
        raise Undecided("no finite slopes")
    return arb_mat(rows)
