"""Sums of two doubles, and their arithmetic (Dekker 1971; Hida, Li and Bailey 2001).

Each operation is good to a few times 2^-104 as long as no product leaves the range of the doubles.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

Floats = npt.NDArray[np.float64]
#: Splits the 53 bits of a double into two halves of at most 26 bits.
_SPLITTER = 2.0**27 + 1.0
#: More than the rounding of a difference of numbers near one, and less than any of doubles.
_NOTHING = 1e-29


def two_sum(a: Any, b: Any) -> tuple[Any, Any]:
    """Sum of two doubles and its rounding error (Knuth)."""
    total = a + b
    back = total - a
    return total, (a - (total - back)) + (b - back)


def _ordered_sum(a: Any, b: Any) -> tuple[Any, Any]:
    """The same for ``|a| >= |b|`` (Dekker)."""
    total = a + b
    return total, b - (total - a)


def _halves(a: Any) -> tuple[Any, Any]:
    """The upper and the lower bits of a double (Veltkamp)."""
    scaled = _SPLITTER * a
    upper = scaled - (scaled - a)
    return upper, a - upper


def two_product(a: Any, b: Any) -> tuple[Any, Any]:
    """Product of two doubles and its rounding error (Dekker)."""
    product = a * b
    a_high, a_low = _halves(a)
    b_high, b_low = _halves(b)
    rest = ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low
    return product, rest


@dataclass(frozen=True, slots=True, eq=False)
class Doubled:
    """Numbers ``high + low`` with ``|low|`` at most half a unit in the last place of ``high``.

    Attributes
    ----------
    high, low : ndarray
        Doubles of one shape.
    """

    high: Any
    low: Any

    #: numpy leaves ``array * doubled`` to this class.
    __array_ufunc__ = None

    def __add__(self, other: Any) -> Doubled:
        other = doubled(other)
        high, rest = two_sum(self.high, other.high)
        low, left = two_sum(self.low, other.low)
        high, rest = _ordered_sum(high, rest + low)
        return Doubled(*_ordered_sum(high, rest + left))

    def __neg__(self) -> Doubled:
        return Doubled(-self.high, -self.low)

    def __sub__(self, other: Any) -> Doubled:
        return self + -doubled(other)

    def __rsub__(self, other: Any) -> Doubled:
        return doubled(other) + -self

    def __mul__(self, other: Any) -> Doubled:
        other = doubled(other)
        product, rest = two_product(self.high, other.high)
        rest = rest + (self.high * other.low + self.low * other.high)
        return Doubled(*_ordered_sum(product, rest))

    def __truediv__(self, other: Any) -> Doubled:
        other = doubled(other)
        first = self.high / other.high
        rest = self - other * first
        second = rest.high / other.high
        rest = rest - other * second
        return Doubled(*_ordered_sum(first, second)) + doubled(rest.high / other.high)

    def __rtruediv__(self, other: Any) -> Doubled:
        return doubled(other) / self

    __radd__, __rmul__ = __add__, __mul__

    def __abs__(self) -> Doubled:
        side = np.where(self.high < 0, -1.0, 1.0)
        return Doubled(self.high * side, self.low * side)

    def __getitem__(self, place: Any) -> Doubled:
        return Doubled(self.high[place], self.low[place])

    def sqrt(self) -> Doubled:
        """Square root of numbers >= 0 (Karp and Markstein)."""
        root = np.sqrt(self.high)
        rest = self - doubled(root) * root
        return doubled(root) + doubled(rest.high / np.where(root > 0, 2 * root, 1.0))

    def value(self) -> Floats:
        """The nearest doubles."""
        return np.asarray(self.high + self.low)


def doubled(number: Any) -> Doubled:
    """Doubles as they are; numbers of this class unchanged."""
    if isinstance(number, Doubled):
        return number
    high = np.asarray(number, dtype=float)
    return Doubled(high, np.zeros_like(high))


def choose(condition: Any, one: Any, other: Any) -> Doubled:
    """Numbers of `one` where the condition holds, else those of `other`."""
    one, other = doubled(one), doubled(other)
    return Doubled(
        np.where(condition, one.high, other.high), np.where(condition, one.low, other.low)
    )


def settled(number: Doubled, rounding: float = _NOTHING) -> Doubled:
    """The same, zero where nothing but rounding is left of a difference of numbers near one."""
    return choose(np.abs(number.high) < rounding, 0.0, number)
