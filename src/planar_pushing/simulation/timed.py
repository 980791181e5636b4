"""Piecewise constant values over time: start times, the first of which is 0, and a value for each."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Sequence
from typing import Any, TypeVar

from planar_pushing.terms.errors import InvalidValue, require_number

Value = TypeVar("Value")


def timed(
    name: str, given: Any, read: Callable[[Any], Value], allowed: str, remedy: str
) -> tuple[tuple[float, Value], ...]:
    """Read pairs of start time and value, with a function that reads the values.

    Raises
    ------
    InvalidValue
        If an entry is not a pair, or the times do not start at 0 and increase; the error has this name.
    """
    pieces = []
    for item in given:
        if not isinstance(item, Sequence) or len(item) != 2:
            raise InvalidValue(name, given, allowed, remedy)
        pieces.append((_time(name, item[0]), read(item[1])))
    times = [time for time, _ in pieces]
    if times[:1] != [0] or any(b <= a for a, b in itertools.pairwise(times)):
        raise InvalidValue(
            name, given, "start times that begin at 0 and increase", "put the pieces in order"
        )
    return tuple(pieces)


def _time(name: str, given: object) -> float:
    return require_number(
        name, given, lambda t: 0 <= t < math.inf, "times >= 0", "start the first piece at time 0"
    )
