"""Types for arrays of numbers, and the constants and functions that all modules share."""

from __future__ import annotations

from typing import Protocol, overload


class Coefficients(Protocol):
    """A tuple of floats at module level: an array of constants in compiled code."""

    def __getitem__(self, index: int, /) -> float:
        """Read a number."""


class Numbers(Protocol):
    """A row of floats: a memory view in Python, the address of its first number in compiled code."""

    @overload
    def __getitem__(self, index: int, /) -> float: ...
    @overload
    def __getitem__(self, index: slice, /) -> Numbers: ...
    def __setitem__(self, index: int, number: float, /) -> None:
        """Store a number."""


def zeros(count: int) -> Numbers:
    """A row of zeros for use within one call; compiled code allocates it on the stack."""
    row: Numbers = memoryview(bytearray(8 * count)).cast("d")
    return row


#: The distance from 1 to the next float.
EPSILON = 2.220446049250313e-16
INFINITY = float("inf")
UNKNOWN = float("nan")
#: Nodes and weights of the Gauss rule with 8 nodes on [-1, 1].
GAUSS_NODES = (
    -0.9602898564975362317, -0.7966664774136267396, -0.5255324099163289858, -0.1834346424956498049,
    0.1834346424956498049, 0.5255324099163289858, 0.7966664774136267396, 0.9602898564975362317,
)  # fmt: skip
GAUSS_WEIGHTS = (
    0.1012285362903762592, 0.2223810344533744705, 0.3137066458778872873, 0.3626837833783619830,
    0.3626837833783619830, 0.3137066458778872873, 0.2223810344533744705, 0.1012285362903762592,
)  # fmt: skip


def cross(x: float, y: float, other_x: float, other_y: float) -> float:
    """The cross product of two vectors of the plane, a scalar."""
    return x * other_y - y * other_x
