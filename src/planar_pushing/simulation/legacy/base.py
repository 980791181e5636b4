"""The interface of an effect: a convex potential of the twist, whose gradient is the wrench.

Formulas are dimensionless: lengths are in radii of the slider, and twists ``(x, y, spin)`` are those of the
body frame's origin, in the body frame. Each effect is a module with a named tuple of numbers, and compiled
functions of it with the names below. Effects add up, so a scene holds a tuple of any effects in any order.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

from planar_pushing.simulation.legacy.compiled import compiled, generic, generic_owning, owning

#: Module of each kind of effect.
KINDS: dict[type, Any] = {}


class Resistance(NamedTuple):
    """Gradient and Hessian of a potential at a twist (x, y, spin) about a point.

    Attributes
    ----------
    f_x, f_y, torque : float
        The wrench that sustains the twist, without friction of support points at the center of rotation.
    xx, xy, yy, xs, ys, ss : float
        Second derivatives.
    most : float
        Maximum friction of the points at the center of rotation.
    point : int
        Number of the first of these points, -1 without one.
    gross : float
        Magnitude of the terms of the force, whose rounding error is a few units in the last place of it.
    """

    f_x: float
    f_y: float
    torque: float
    xx: float
    xy: float
    yy: float
    xs: float
    ys: float
    ss: float
    most: float
    point: int
    gross: float


class Moment(NamedTuple):
    """Mass, first moments and moment of inertia about a point."""

    mass: float
    x: float
    y: float
    whole: float


def member(kind: type, name: str) -> Callable[..., Any]:
    """A function of an effect's module."""
    found: Callable[..., Any] = getattr(KINDS[kind], name)
    return found


def _summed(name: str, first: Callable[..., Any], both: Callable[..., Any]) -> Any:
    """Selector of a member's function, or of the sum over a tuple of effects."""

    def choose(kind: Any) -> Callable[..., Any]:
        if isinstance(kind, tuple):
            return first if len(kind) == 1 else both
        return member(kind, name)

    return choose


@compiled
def _resistance(effects, x, y, spin, blur):
    return resistance(effects[0], x, y, spin, blur)


@compiled
def _resistances(effects, x, y, spin, blur):
    one = resistance(effects[0], x, y, spin, blur)
    other = resistance(effects[1:], x, y, spin, blur)
    point = one.point
    if point < 0 and other.point >= 0:
        point = count_points(effects[0]) + other.point
    return Resistance(
        one.f_x + other.f_x, one.f_y + other.f_y, one.torque + other.torque,
        one.xx + other.xx, one.xy + other.xy, one.yy + other.yy,
        one.xs + other.xs, one.ys + other.ys, one.ss + other.ss,
        one.most + other.most, point, one.gross + other.gross,
    )  # fmt: skip


#: `Resistance` at a nonzero twist, about the origin: effect or effects, x, y, spin, and the rounding error
#: of x and y, within which points are at the center of rotation.
resistance = generic(_summed("resistance", _resistance, _resistances))


@compiled
def _moment(effects, speed, x, y):
    return moment(effects[0], speed, x, y)


@compiled
def _moments(effects, speed, x, y):
    one, other = moment(effects[0], speed, x, y), moment(effects[1:], speed, x, y)
    return Moment(one.mass + other.mass, one.x + other.x, one.y + other.y, one.whole + other.whole)


#: `Moment` about (x, y) of a mass that roughly matches an effect at a given speed, for first guesses:
#: effect or effects, speed, x, y.
moment = generic(_summed("moment", _moment, _moments))


@compiled
def moment_of(mass, gyration, x, y):
    """Moments of a mass at (x, y) from a point; `gyration` is the square of its radius of gyration."""
    return Moment(mass, mass * x, mass * y, mass * (x * x + y * y + gyration))


@compiled
def _count(effects):
    return count_points(effects[0])


@compiled
def _counts(effects):
    return count_points(effects[0]) + count_points(effects[1:])


#: Number of support points: effect or effects.
count_points = generic(_summed("count_points", _count, _counts))


@compiled
def _place(effects, i):
    return place(effects[0], i)


@compiled
def _places(effects, i):
    count = count_points(effects[0])
    return place(effects[0], i) if i < count else place(effects[1:], i - count)


#: Position of a support point in the body frame: effect or effects, number of the point.
place = generic(_summed("place", _place, _places))


@compiled
def _pull(effects):
    return pull(effects[0])


@compiled
def _pulls(effects):
    (a, b, c), (d, e, f) = pull(effects[0]), pull(effects[1:])
    return a + d, b + e, c + f


#: Wrench about the origin that acts on the slider at rest and in any motion: effect or effects.
pull = generic(_summed("pull", _pull, _pulls))


@compiled
def _energy(effects, x, y, spin):
    return energy(effects[0], x, y, spin)


@compiled
def _energies(effects, x, y, spin):
    return energy(effects[0], x, y, spin) + energy(effects[1:], x, y, spin)


#: Potential of degree 2 at a twist, the kinetic energy for inertia: effect or effects, x, y, spin.
energy = generic(_summed("energy", _energy, _energies))


@owning
def _made(kinds, row, start):
    return (made(kinds[0], row, start),)


@owning
def _made_all(kinds, row, start):
    return (made(kinds[0], row, start), *made(kinds[1:], row, start + count_fields(kinds[0])))


def _make(kind: Any) -> Callable[..., Any]:
    if isinstance(kind, tuple):
        return _made if len(kind) == 1 else _made_all
    return member(kind, "made")


#: Effects of the given kinds, with the numbers of a row starting at a column: kinds, row, column.
made = generic_owning(_make)


@compiled
def _count_fields(kinds):
    return count_fields(kinds[0])


@compiled
def _count_all_fields(kinds):
    return count_fields(kinds[0]) + count_fields(kinds[1:])


#: Number of columns of effects: effect or effects.
count_fields = generic(_summed("count_fields", _count_fields, _count_all_fields))


@compiled
def no_points(effect):
    """`count_points` of members without support points."""
    return 0


@compiled
def no_place(effect, i):
    """`place` of members without support points."""
    return 0.0, 0.0


@compiled
def no_pull(effect):
    """`pull` of members that exert nothing at rest."""
    return 0.0, 0.0, 0.0


@compiled
def no_energy(effect, x, y, spin):
    """`energy` of members with a potential of another degree than 2."""
    return 0.0


def is_steady(kinds: tuple[Any, ...]) -> bool:
    """Whether all potentials have one degree, so that directions of motion do not depend on magnitudes."""
    return len({KINDS[kind].DEGREE for kind in kinds}) == 1
