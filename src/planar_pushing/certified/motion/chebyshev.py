"""Integrals of smooth functions by Chebyshev series, to about thirty digits; not validated.

The series of an analytic function converges geometrically. Numbers are midpoints of balls; the error
that is reported is the difference between two runs with different numbers of nodes.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from flint import arb, fmpq

#: Derivatives of some quantities at an exact place.
Rates = Callable[[arb], Sequence[arb]]


@dataclass(frozen=True, slots=True)
class Series:
    """A Chebyshev series between two exact places, zero at the first."""

    start: arb
    end: arb
    coefficients: tuple[arb, ...]

    def at(self, place: arb) -> arb:
        """Value by Clenshaw's recurrence."""
        return self._sum(place) - self._sum(self.start)

    def _sum(self, place: arb) -> arb:
        x = (2 * place - self.start - self.end) / (self.end - self.start)
        one, two = arb(0), arb(0)
        for each in self.coefficients[:0:-1]:
            one, two = 2 * x * one - two + each, one
        return x * one - two + self.coefficients[0]


def integrals(rates: Rates, start: arb, end: arb, nodes: int) -> list[Series]:
    """Integrals from the start, by the rates at the zeros of a Chebyshev polynomial."""
    half = (end - start) / 2
    places = [(start + half + half * _cosine(2 * j + 1, nodes)).mid() for j in range(nodes)]
    columns = zip(*(rates(place) for place in places), strict=True)
    return [Series(start, end, _integrated(_coefficients(each), half)) for each in columns]


def _cosine(count: int, nodes: int) -> arb:
    """Cosine of a multiple of 90 degrees divided by the number of nodes."""
    return arb.cos_pi_fmpq(fmpq(count, 2 * nodes))


def _coefficients(values: Sequence[arb]) -> list[arb]:
    nodes = len(values)
    found = []
    for k in range(nodes):
        terms = (value * _cosine(k * (2 * j + 1), nodes) for j, value in enumerate(values))
        found.append((2 * sum(terms, arb(0)) / nodes).mid())
    return [found[0] / 2, *found[1:]]


def _integrated(c: Sequence[arb], half: arb) -> tuple[arb, ...]:
    """Coefficients of the integral: for T_k they are ``(c_(k-1) - c_(k+1)) / 2k``, and c_0 counts twice."""
    padded = [2 * c[0], *c[1:], arb(0), arb(0)]
    terms = (half * (padded[k - 1] - padded[k + 1]) / (2 * k) for k in range(1, len(c) + 1))
    return (arb(0), *(each.mid() for each in terms))
