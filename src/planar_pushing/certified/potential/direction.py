"""Exact directions: by degrees, by radians, or along a rational vector."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from flint import arb, fmpq

from planar_pushing.certified.balls import (
    Exact,
    cosine_sine,
    exact_direction,
    has_exact_direction,
    settle,
)
from planar_pushing.certified.supports.pressure.moments import Vector


@dataclass(frozen=True, slots=True, eq=False)
class Direction:
    """A unit vector; directions are compared by identity.

    Attributes
    ----------
    ball : callable
        Encloses the vector at the precision in use.
    exact : tuple, optional
        A positive multiple of the vector in the cyclotomic field.
    """

    ball: Callable[[], Vector]
    exact: tuple[Exact, Exact] | None = None


def degrees(angle: fmpq) -> Direction:
    """The direction at an angle in degrees."""
    exact = exact_direction(angle) if has_exact_direction(angle) else None
    return Direction(lambda: cosine_sine(angle), exact)


def radians(angle: fmpq) -> Direction:
    """The direction at an angle in radians."""

    def ball() -> Vector:
        sine, cosine = arb(angle).sin_cos()
        return cosine, sine

    return Direction(ball)


def along(x: fmpq, y: fmpq) -> Direction:
    """The direction of a rational vector."""

    def ball() -> Vector:
        size = arb(x * x + y * y).sqrt()
        return x / size, y / size

    return Direction(ball, (x, y))


def relative(direction: Direction, rod: Direction) -> Direction:
    """A direction of the fence's frame in the body frame of a rod; zeros are exact if they are known."""

    def ball() -> Vector:
        return turned(direction.ball(), rod.ball(), exact)

    exact = None
    if direction.exact is not None and rod.exact is not None:
        exact = exact_turned(direction.exact, rod.exact)
    return Direction(ball, exact)


def turned(vector: Vector, rod: Vector, exact: tuple[Exact, Exact] | None = None) -> Vector:
    """A vector of the fence's frame in the body frame."""
    x, y = exact_turned(vector, rod)
    if exact is None:
        return x, y
    return settle(x, lambda: exact[0]), settle(y, lambda: exact[1])


def returned(vector: Vector, rod: Vector) -> Vector:
    """A vector of the body frame in the fence's frame."""
    (x, y), (c, s) = vector, rod
    return x * c - y * s, x * s + y * c


def exact_turned(vector: tuple[Exact, Exact], rod: tuple[Exact, Exact]) -> tuple[Exact, Exact]:
    """The same rotation for numbers of any kind."""
    (x, y), (c, s) = vector, rod
    return x * c + y * s, y * c - x * s
