"""The number, from zero to a largest one, at which a convex function is smallest, by signs of its slope.

The number is doubled until the slope is no longer negative, and the bracket is then narrowed. The caller
evaluates the slope at `trial`, until `is_found`.
"""

from __future__ import annotations

from typing import NamedTuple

from planar_pushing.core.supports.roots import (
    Bracket,
    best_number,
    is_narrow,
    narrow_bracket,
    next_number,
    open_bracket,
)
from planar_pushing.core.supports.tolerances import COINCIDENT

#: A search ends at this multiple of its first step, 60 times doubled.
LARGEST_MULTIPLE = 1152921504606846976.0


class Descent(NamedTuple):
    """A search: where the slope is needed next, the largest number, and the latest numbers.

    While the number is doubled, the slopes at both ends of the bracket are negative, and its end `a` is the
    latest number.
    """

    trial: float
    most: float
    bracket: Bracket


def open_descent(at_zero: float, step: float, most: float) -> Descent:
    """A search from zero, with the slope there, its first step, and the largest number."""
    farthest = min(most, LARGEST_MULTIPLE * step)
    start = open_bracket(0.0, 0.0, at_zero, at_zero, COINCIDENT)
    return Descent(min(step, farthest), farthest, start)


def is_found(descent: Descent) -> bool:
    """Whether the number is known."""
    bracket = descent.bracket
    if bracket.at_a < 0.0 and bracket.at_b < 0.0:
        return bracket.a >= descent.most
    return (bracket.at_a >= 0.0 and bracket.at_b >= 0.0) or is_narrow(bracket)


def continue_descent(descent: Descent, slope: float) -> Descent:
    """The search after the slope at its trial."""
    bracket, trial, most = descent.bracket, descent.trial, descent.most
    if bracket.at_a < 0.0 and bracket.at_b < 0.0:
        if slope < 0.0:
            latest = open_bracket(bracket.a, trial, bracket.at_a, slope, COINCIDENT)
            return Descent(min(2.0 * trial, most), most, latest)
        bracket = open_bracket(bracket.a, trial, bracket.at_a, slope, COINCIDENT)
    else:
        bracket = narrow_bracket(bracket, trial, slope)
    return Descent(next_number(bracket), most, bracket)


def lowest_number(descent: Descent) -> float:
    """The number at which the function is smallest, of those that were tried."""
    bracket = descent.bracket
    if bracket.at_a < 0.0 and bracket.at_b < 0.0:
        return bracket.a
    return best_number(bracket)
