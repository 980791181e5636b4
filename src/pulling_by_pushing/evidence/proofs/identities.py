"""Polynomial identities of the ring and of the rod, decided exactly.

A direction is a pair of variables whose squares sum to 1. The relations have different leading
variables, so that the remainder of division by them is a normal form: it is zero exactly where the
identity holds.
"""

from __future__ import annotations

from typing import Any

from flint import Ordering, fmpq_mpoly_ctx

Polynomial = Any  # fmpq_mpoly

_RING = fmpq_mpoly_ctx.get(
    ("s", "c", "y", "x", "q", "p", "k", "l", "f", "t", "e", "a", "b"), Ordering.lex
)
#: s, c: sine and cosine of the angle theta on the ring; y, x: of the force angle phi; q, p: of the rod
#: angle psi. k, l: spin ratio and rod length, R = 1. f, t: force and torque. e, a, b: as stated.
s, c, y, x, q, p, k, l, f, t, e, a, b = _RING.gens()  # noqa: E741

ONE = _RING.constant(1)

#: Moment arm of the line of force, Eq. (10); cosine of the angle from the rod to the force; motion of
#: the contact per unit speed of the center.
ARM = l * (q * x - p * y)
ROD_COSINE = p * x + q * y
MOTION = (x + k * l * q, y - k * l * p)

_RELATIONS = (s**2 + c**2 - 1, y**2 + x**2 - 1, q**2 + p**2 - 1)


def normal(polynomial: Polynomial) -> Polynomial:
    """Normal form: zero exactly where the polynomial vanishes for all directions."""
    for relation in _RELATIONS:
        _, polynomial = divmod(polynomial, relation)
    return polynomial


def substitute(polynomial: Polynomial, **values: Polynomial) -> Polynomial:
    """Substitute other polynomials for variables."""
    substitutes = dict(zip(_RING.names(), _RING.gens(), strict=True)) | values
    return polynomial.compose(*substitutes.values())


def dot(first: tuple[Polynomial, Polynomial], second: tuple[Polynomial, Polynomial]) -> Polynomial:
    """Scalar product."""
    return first[0] * second[0] + first[1] * second[1]


def cross(
    first: tuple[Polynomial, Polynomial], second: tuple[Polynomial, Polynomial]
) -> Polynomial:
    """Cross product in the plane."""
    return first[0] * second[1] - first[1] * second[0]
