"""Integration of smooth equations to about thirty digits: Gragg's method, extrapolated; not validated.

Steps of the midpoint rule have an error in even powers of the step size, which Neville's scheme
extrapolates to zero (Hairer, Norsett and Wanner I, Sec. II.9). Numbers are midpoints of balls; the
error that is reported is the difference between two runs with different orders and steps.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from itertools import count, islice, pairwise

from flint import arb

from planar_pushing.certified.balls import Undecided

#: The state of an autonomous system; its components are exact.
State = tuple[arb, ...]
Rates = Callable[[State], State]
#: Maximum number of halvings of a step if the extrapolation does not converge.
HALVINGS = 12


@dataclass(frozen=True, slots=True)
class Scheme:
    """A scheme of extrapolation.

    Attributes
    ----------
    rows : int
        Maximum number of rows of Neville's scheme; the order is twice this number.
    tolerance : arb
        Difference between the last values of two rows at which a step is complete.
    steps : int
        Initial number of equal steps.
    """

    rows: int
    tolerance: arb
    steps: int = 1


#: Two schemes of different orders and steps; the result is from the first.
FINE = Scheme(16, arb(2) ** -122)
COARSE = Scheme(12, arb(2) ** -108, steps=2)


def advance(rates: Rates, state: State, time: arb, scheme: Scheme) -> State:
    """The state after some time.

    Raises
    ------
    Undecided
        If the extrapolation does not converge.
    """
    for _ in range(scheme.steps):
        state = _over(rates, state, (time / scheme.steps).mid(), scheme, HALVINGS)
    return state


def _over(rates: Rates, state: State, step: arb, scheme: Scheme, halvings: int) -> State:
    for before, now in pairwise(islice(extrapolated(rates, state, step), scheme.rows)):
        if _apart(before, now) < scheme.tolerance:
            return now
    if halvings == 0:
        raise Undecided("the extrapolation does not converge: the motion is not smooth")
    middle = _over(rates, state, step / 2, scheme, halvings - 1)
    return _over(rates, middle, step / 2, scheme, halvings - 1)


def extrapolated(rates: Rates, state: State, step: arb) -> Iterator[State]:
    """The state after a step by methods of order 2, 4, 6, and so on."""
    slope, row = rates(state), list[State]()
    for j in count(1):
        above, row = row, [_midpoint(rates, state, slope, step, 2 * j)]
        for i, coarser in enumerate(above, start=1):
            factor = arb(j * j) / ((j - i) * (j - i)) - 1
            row.append(_line(row[-1], _line(row[-1], coarser, arb(-1)), 1 / factor))
        yield row[-1]


def _apart(a: State, b: State) -> arb:
    """Largest difference between the components of two states."""
    return max((abs(x - y) for x, y in zip(a, b, strict=True)), key=float)


def _midpoint(rates: Rates, state: State, slope: State, step: arb, parts: int) -> State:
    """The state after a number of steps of the midpoint rule, the first of which is an Euler step."""
    size = (step / parts).mid()
    before, now = state, _line(state, slope, size)
    for _ in range(parts - 1):
        before, now = now, _line(before, rates(now), 2 * size)
    return now


def _line(start: State, direction: State, size: arb) -> State:
    """Midpoints of ``start + size direction``."""
    return tuple((a + size * b).mid() for a, b in zip(start, direction, strict=True))
