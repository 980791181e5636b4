"""The one exception family: what was given, what is allowed, what to do."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np


class PlanarPushingError(Exception):
    """Base of every error that the package raises on purpose."""


class InvalidValue(PlanarPushingError, ValueError):
    """A value outside what the mechanics allow.

    Parameters
    ----------
    name : str
        The parameter, in the words of the public interface.
    given : object
        What was given.
    allowed : str
        What is allowed.
    remedy : str
        What to do about it.
    """

    def __init__(self, name: str, given: object, allowed: str, remedy: str) -> None:
        super().__init__(name, given, allowed, remedy)
        self.name, self.given, self.allowed, self.remedy = name, given, allowed, remedy

    def __str__(self) -> str:
        return f"{self.name}: {self.given!r} given; allowed: {self.allowed}; {self.remedy}"


class InvalidFile(PlanarPushingError):
    """A scene, study or dataset file that cannot be used; the message names file and key."""


class InvalidResult(PlanarPushingError):
    """Results that differ from the golden data; the message is the verdict."""


def require_number(
    name: str, given: object, allows: Callable[[float], bool], allowed: str, remedy: str
) -> float:
    """Return `given` as a float, or raise `InvalidValue` when `allows` refuses it."""
    try:
        number = math.nan if isinstance(given, (str, bool)) else float(given)  # type: ignore[arg-type]
    except (TypeError, ValueError, OverflowError):
        number = math.nan
    if math.isnan(number) or not allows(number):
        raise InvalidValue(name, number if isinstance(given, np.number) else given, allowed, remedy)
    return number


def require_positive(name: str, given: object, remedy: str) -> float:
    """Return `given` as a positive finite float, or raise `InvalidValue`."""
    return require_number(name, given, lambda x: 0 < x < math.inf, "a finite number > 0", remedy)
