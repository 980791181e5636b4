"""The centre of rotation under a line of force: Newton's method, and Krawczyk's test around its end.

Newton's method minimises the potential ``|omega| D(P + J u / omega)`` over the motions of the contact
``u = t + a n`` and the rotations omega. It only has to come near: the enclosure is proved afterwards, on a box
that the operator of Krawczyk maps into itself, with the second derivatives over the whole box.
"""

from __future__ import annotations

from typing import NamedTuple

from flint import arb, ctx, fmpq

from planar_pushing.certified.balls import Undecided
from planar_pushing.certified.supports.moments import Moments, Vector, moments
from planar_pushing.certified.supports.pieces import Pieces

#: Newton steps at most, and halvings of one.
STEPS, HALVINGS = 200, 60
#: Square of the radius of gyration that stands for a support in a first guess, in its extents.
ROUGH = fmpq(61, 100)

Matrix = tuple[arb, arb, arb, arb]


class Place(NamedTuple):
    """A motion of the contact with unit part along the force: its part across, and the rotation."""

    across: arb
    spin: arb


class Problem(NamedTuple):
    """A support, the rod's length, and the direction of the force."""

    support: Pieces
    length: fmpq
    t: Vector

    def center(self, at: Place) -> Vector:
        """Centre of rotation of a motion."""
        (x, y), (a, spin) = self.t, at
        u_x, u_y = x - a * y, y + a * x
        return -self.length - u_y / spin, u_x / spin

    def equations(self, now: Moments, c: Vector) -> Vector:
        """Part of G along the force, and torque about the contact of a unit rotation."""
        return now.x * self.t[0] + now.y * self.t[1], now.torque(c, (-self.length, 0))

    def slopes(self, now: Moments, c: Vector) -> Matrix:
        """Derivatives of the equations by the centre, with their signs changed."""
        first = _product(now, self.t)
        second = _product(now, (c[0] + self.length, c[1]))
        return (*first, *second)


def _product(now: Moments, v: Vector) -> Vector:
    return now.xx * v[0] + now.xy * v[1], now.xy * v[0] + now.yy * v[1]


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
    at = _guess(problem)
    power = _power(problem, at)
    for _ in range(STEPS):
        step, fall = _step(problem, at)
        part, small = arb(1), _is_small(step, at)
        for _ in range(HALVINGS):
            tried = Place(*((x + part * dx).mid() for x, dx in zip(at, step, strict=True)))
            now = _power(problem, tried)
            if small or now < power - part * fall / 8:
                break
            part = part / 2
        at, power = tried, now
        if small:
            break
    x, y = problem.center(at)
    return x.mid(), y.mid()


def _is_small(step: Place, at: Place) -> bool:
    last = arb(2) ** (-ctx.prec // 4)  # the next step would square it
    return bool(
        abs(step.across) < last * (1 + abs(at.across)) and abs(step.spin) < last * abs(at.spin)
    )


def _power(problem: Problem, at: Place) -> arb:
    return (abs(at.spin) * moments(problem.support, problem.center(at)).distance).mid()


def _step(problem: Problem, at: Place) -> tuple[Place, arb]:
    """Newton's step, and how fast the potential falls along it."""
    c, spin = problem.center(at), abs(at.spin)
    now = moments(problem.support, c)
    r = c[0] + problem.length, c[1]
    sense = 1 if at.spin > 0 else -1
    one, other = (sense * each for each in problem.equations(now, c))
    first, second = _product(now, problem.t), _product(now, r)
    bend = (first[0] * problem.t[0] + first[1] * problem.t[1]) / spin
    turn = (first[0] * r[0] + first[1] * r[1]) / spin
    stiff = (second[0] * r[0] + second[1] * r[1]) / spin
    whole = bend * stiff - turn * turn
    step = Place(
        ((turn * other - stiff * one) / whole).mid(), ((turn * one - bend * other) / whole).mid()
    )
    return step, -(one * step.across + other * step.spin).mid()


def _guess(problem: Problem) -> Place:
    """The motion as if the support were a mass."""
    x, y = (arb(each) for each in problem.support.center)
    r_x, r_y = -problem.length - x, -y
    arm = r_x * problem.t[1] - r_y * problem.t[0]
    extent = problem.support.extent
    spin = arm / (ROUGH * extent * extent + arm * arm)
    return Place((spin * (r_x * problem.t[0] + r_y * problem.t[1])).mid(), spin.mid())
