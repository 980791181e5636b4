"""The exceptions of the package: they state the given value, the allowed values, and a remedy.

The command line imports this module to print its help, so it does not import numpy.
"""

from __future__ import annotations

import difflib
import math
import os
import reprlib
import sys
from collections.abc import Callable, Iterable, Mapping, Set
from enum import StrEnum
from typing import Any, TypeVar

Kind = TypeVar("Kind")
Option = TypeVar("Option", bound=StrEnum)

#: Maximum number of characters, entries and levels of a value that a message shows.
SHORT = reprlib.Repr()
SHORT.maxstring = SHORT.maxother = 120
SHORT.maxlist = SHORT.maxtuple = SHORT.maxdict = SHORT.maxset = 8


class PlanarPushingError(Exception):
    """Base of every error that the package raises on purpose."""


class InvalidValue(PlanarPushingError, ValueError):
    """A value outside its allowed range.

    Parameters
    ----------
    name : str
        Name of the parameter in the public interface.
    given : object
        The given value.
    allowed : str
        Description of the allowed values.
    remedy : str
        Advice to the user.
    """

    def __init__(self, name: str, given: object, allowed: str, remedy: str) -> None:
        super().__init__(name, given, allowed, remedy)
        self.name, self.given, self.allowed, self.remedy = name, given, allowed, remedy

    def __str__(self) -> str:
        return f"{self.name}: {shown(self.given)} given; allowed: {self.allowed}; {self.remedy}"


class InvalidFile(PlanarPushingError):
    """A scene, study or dataset file that cannot be used; the message names file and key."""


class InvalidResult(PlanarPushingError):
    """Results that differ from the golden data; the message is the verdict."""


class MissingExtra(PlanarPushingError, ImportError):
    """A feature whose dependencies are not installed; the message names the extra."""


class PlainCoreWarning(UserWarning):
    """The mechanics run as plain Python, about 100 times slower; the message says why, and what to do."""


def shown(given: object) -> str:
    """A value as one line of a message, truncated if too long."""
    try:
        text = SHORT.repr(given)
    except ValueError:  # Python refuses to print an integer of thousands of digits
        text = "an integer of thousands of digits"
    return " ".join(text.splitlines())


def number_of(count: int, noun: str) -> str:
    """A count and its noun, such as "1 push" or "2 pushes"."""
    return f"{count} {noun}" + ("" if count == 1 else "es" if noun.endswith("sh") else "s")


def as_float(given: object) -> float:
    """A real number as a float; NaN for anything else, such as strings, booleans, decimals and arrays.

    The door for arrays is `planar_pushing.terms.numbers`.
    """
    plain = isinstance(given, (int, float)) and not isinstance(given, bool)
    single = getattr(getattr(given, "dtype", None), "kind", "") in ("i", "u", "f")
    if not plain and not (single and getattr(given, "ndim", 1) == 0 and not _is_masked(given)):
        return math.nan
    try:
        return float(given)  # type: ignore[arg-type]
    except OverflowError:
        return math.nan


def _is_masked(given: object) -> bool:
    """Whether a number of numpy is masked, without importing numpy."""
    numpy = sys.modules.get("numpy")
    return numpy is not None and bool(numpy.ma.is_masked(given))


def as_floats(given: Any) -> tuple[float, ...]:
    """The entries of a sequence as floats; an empty tuple for anything else."""
    return tuple(map(as_float, given)) if has_entries(given) else ()


def has_entries(given: Any) -> bool:
    """Whether a value has entries in order: a sequence or an array, even an empty one."""
    ordered = hasattr(given, "__len__") and not isinstance(given, (Mapping, Set))
    return ordered and getattr(given, "ndim", 1) > 0


def require_flag(name: str, given: Any) -> bool:
    """Return an option that is on or off, or raise `InvalidValue`."""
    single = getattr(getattr(given, "dtype", None), "kind", "") == "b" and given.ndim == 0
    if not single and not isinstance(given, bool) and as_float(given) not in (0.0, 1.0):
        raise InvalidValue(name, given, "True or False", "give one of them")
    return bool(given)


def require_number(
    name: str, given: object, allows: Callable[[float], bool], allowed: str, remedy: str
) -> float:
    """Return `given` as a float, or raise `InvalidValue` when `allows` refuses it."""
    number = as_float(given)
    if math.isnan(number) or not allows(number):
        plain = math.isnan(number) and not isinstance(given, float)
        raise InvalidValue(
            name, given if plain or isinstance(given, int) else number, allowed, remedy
        )
    return number


def require_positive(name: str, given: object, remedy: str) -> float:
    """Return `given` as a positive finite float, or raise `InvalidValue`."""
    return require_number(name, given, lambda x: 0 < x < math.inf, "a finite number > 0", remedy)


def require_kind(name: str, given: object, kind: type[Kind], remedy: str = "construct one") -> Kind:
    """Return `given` if it is an instance of `kind`, or raise `InvalidValue`."""
    if not isinstance(given, kind):
        raise InvalidValue(name, given, f"a {kind.__name__}", remedy)
    return given


def require_path(name: str, given: Any) -> Any:
    """Return the path that was given, or raise `InvalidValue`."""
    if not isinstance(given, (str, os.PathLike)) or "\0" in str(given):
        raise InvalidValue(name, given, "the path of a file", "give it as text or as a Path")
    return given


def suggestion(given: object, options: Iterable[str], otherwise: str) -> str:
    """Remedy for an unknown option: the option with a similar spelling, or another text."""
    near = difflib.get_close_matches(str(given), list(options), n=1)
    return f"did you mean {near[0]}?" if near else otherwise


def require_option(name: str, given: Any, options: type[Option], remedy: str) -> Option:
    """Return the option that `given` is or names, or raise `InvalidValue`."""
    if not isinstance(given, str) or given not in list(options):
        raise InvalidValue(name, given, ", ".join(options), remedy)
    return options(given)
