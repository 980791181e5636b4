"""Roots of increasing functions, enclosed by a change of sign between two balls."""

from __future__ import annotations

from collections.abc import Callable

from flint import arb

from planar_pushing.certified.balls import Undecided

#: Relative width of an enclosure, far below the resolution of stored numbers.
WIDTH = arb(2) ** -128

#: Maximum number of steps to an enclosure; bisection alone needs fewer.
_LIMIT = 500


def increasing_root(function: Callable[[arb], arb], low: arb, high: arb, width: arb = WIDTH) -> arb:
    """Enclose the root of an increasing function between two points of opposite sign.

    Parameters
    ----------
    function : callable
        Maps an exact positive ball to an enclosure of the function's value.
    low, high : arb
        Exact, 0 <= low < high.
    width : arb
        Relative width of the enclosure.

    Returns
    -------
    arb
        Ball that contains the only root.

    Raises
    ------
    Undecided
        If no change of sign can be certified.

    Notes
    -----
    Illinois steps, with a bisection at every fifth step. The enclosure rests only on the signs at the last
    two points, whatever the steps that lead to them.
    """
    below, above = function(low), function(high)
    if not (below < 0 and above > 0):
        raise Undecided(f"no change of sign between {low} and {high}: {below}, {above}")
    side = 0
    for step in range(_LIMIT):
        guess = (
            (low + high) / 2 if step % 5 == 4 else (low * above - high * below) / (above - below)
        )
        margin = (width * guess).mid()
        if high - low <= 2 * margin:
            return low.union(high)
        point = arb.max(low + margin, arb.min(high - margin, guess.mid())).mid()
        value = function(point)
        if value.contains(0):
            return _pinched(function, point, margin)
        if value < 0:
            low, below, above, side = point, value.mid(), above / (2 if side < 0 else 1), -1
        else:
            high, above, below, side = point, value.mid(), below / (2 if side > 0 else 1), 1
    raise Undecided(f"no enclosure of the root between {low} and {high}")


def _pinched(function: Callable[[arb], arb], point: arb, margin: arb) -> arb:
    """Enclosure around a point where the function vanishes to working precision."""
    low, high = (point - margin).mid(), (point + margin).mid()
    if function(low) < 0 and function(high) > 0:
        return low.union(high)
    raise Undecided(f"the function is flat next to {point}")
