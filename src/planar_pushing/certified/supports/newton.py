"""The centre of rotation under a line of force: Newton's method, and Krawczyk's test around its end.

Newton's method minimises the potential ``|omega| D(P + J u / omega)`` over the motions of the contact
``u = t + a n`` and the rotations omega. It only has to come near: the enclosure is proved afterwards, on a
box that the operator of Krawczyk maps into itself, with the second derivatives over the whole box.
"""

from __future__ import annotations

from flint import arb, ctx, fmpq

from planar_pushing.certified.balls import Undecided
from planar_pushing.certified.supports.pressure.moments import Vector, moments
from planar_pushing.certified.supports.pressure.pieces import Pieces
from planar_pushing.certified.supports.problem import Evaluation, Matrix, Motion, Problem, product
from planar_pushing.certified.supports.start import start

#: Newton steps at most, and halvings of one.
STEPS, HALVINGS = 200, 60


def enclosed(support: Pieces, length: fmpq, t: Vector) -> Vector:
    """Ball of the centre of rotation, and proof that it is the only one.

    Raises
    ------
    Undecided
        Where the box is not mapped into itself.
    """
    problem = Problem(support, length, t)
    c = _near(problem)
    reach = 1 + abs(c[0]) + abs(c[1])
    half = (reach * arb(2) ** (-2 * ctx.prec // 5)).mid()
    box = c[0] + arb(0, half), c[1] + arb(0, half)
    image = _image(problem, c, box)
    if not all(whole.contains_interior(part) for whole, part in zip(box, image, strict=True)):
        raise Undecided(f"no centre of rotation is proved at {c}")
    return image


def _image(problem: Problem, c: Vector, box: Vector) -> Vector:
    """Krawczyk's operator ``c - Y F(c) + (1 - Y F'(box)) (box - c)``."""
    here = moments(problem.support, c)
    values = problem.equations(here, c)
    y_1, y_2, y_3, y_4 = _inverse(tuple(each.mid() for each in problem.slopes(here, c)))  # type: ignore[arg-type]
    p, q, r, s = problem.slopes(moments(problem.support, box), box)
    d_x, d_y = box[0] - c[0], box[1] - c[1]
    # F' is the negative of the slopes.
    return (
        c[0] + y_1 * values[0] + y_2 * values[1]
        + (1 - (y_1 * p + y_2 * r)) * d_x - (y_1 * q + y_2 * s) * d_y,
        c[1] + y_3 * values[0] + y_4 * values[1]
        - (y_3 * p + y_4 * r) * d_x + (1 - (y_3 * q + y_4 * s)) * d_y,
    )  # fmt: skip


def _inverse(matrix: Matrix) -> Matrix:
    a, b, c, d = matrix
    whole = a * d - b * c
    return (d / whole).mid(), (-b / whole).mid(), (-c / whole).mid(), (a / whole).mid()


def _near(problem: Problem) -> Vector:
    """Centre of rotation to about the last step, without a bound."""
    at = start(problem)
    here = problem.evaluate(at)
    for _ in range(STEPS):
        step, fall = _step(problem, at, here)
        part, small = arb(1), _is_small(step, at)
        for _ in range(HALVINGS):
            tried = at.after(step, part)
            there = problem.evaluate(tried)
            if small or there.power < here.power - part * fall / 8:
                break
            part = part / 2
        at, here = tried, there
        if small:
            break
    x, y = here.center
    return x.mid(), y.mid()


def _is_small(step: Motion, at: Motion) -> bool:
    last = arb(2) ** (-ctx.prec // 4)  # the next step would square it
    return bool(
        abs(step.across) < last * (1 + abs(at.across)) and abs(step.spin) < last * abs(at.spin)
    )


def _step(problem: Problem, at: Motion, here: Evaluation) -> tuple[Motion, arb]:
    """Newton's step, and how fast the potential falls along it."""
    (c, now, _), spin = here, abs(at.spin)
    r = c[0] + problem.length, c[1]
    sense = 1 if at.spin > 0 else -1
    one, other = (sense * each for each in problem.equations(now, c))
    first, second = product(now, problem.t), product(now, r)
    bend = (first[0] * problem.t[0] + first[1] * problem.t[1]) / spin
    turn = (first[0] * r[0] + first[1] * r[1]) / spin
    stiff = (second[0] * r[0] + second[1] * r[1]) / spin
    whole = bend * stiff - turn * turn
    step = Motion(
        ((turn * other - stiff * one) / whole).mid(), ((turn * one - bend * other) / whole).mid()
    )
    return step, -(one * step.across + other * step.spin).mid()
