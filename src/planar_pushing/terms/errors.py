"""The exceptions of the package: they state the given value, the allowed values, and a remedy.

The command line imports this module to print its help, so it does not import numpy.
"""

from __future__ import annotations

import difflib
import math
import os
import reprlib
import sys
import warnings
from collections.abc import Callable, Iterable, Mapping, Set
from enum import StrEnum
from typing import Any, TypeVar

Kind = TypeVar("Kind")
Option = TypeVar("Option", bound=StrEnum)

#: Maximum number of characters, entries and levels of a value that a message shows.
SHORT = reprlib.Repr()
SHORT.maxstring = SHORT.maxother = 120
SHORT.maxlist = SHORT.maxtuple = SHORT.maxdict = SHORT.maxset = 8
#: Smallest similarity, from 0 to 1, of a name that a message suggests.
SIMILAR = 0.65
#: Minimum number of characters of an abbreviated name, and maximum number of those of a mistyped one.
SHORTEST_NAME, LONGEST_NAME = 3, 80


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
        return (
            f"{self.name}: {format_value(self.given)} given; allowed: {self.allowed}; {self.remedy}"
        )


class InvalidCall(PlanarPushingError, TypeError):
    """A call whose arguments do not fit the parameters; the message says which, and what to do."""


class InvalidFile(PlanarPushingError):
    """A scene, study or dataset file that cannot be used; the message names file and key."""


class InvalidResult(PlanarPushingError):
    """Results that differ from the golden data; the message is the verdict."""


class MissingExtra(PlanarPushingError, ImportError):
    """A feature whose dependencies are not installed; the message names the extra."""


class PlainCoreWarning(UserWarning):
    """The mechanics run as plain Python, about 100 times slower; the message says why, and what to do."""


class SceneWarning(UserWarning):
    """An object or a push that is probably not meant as given; the message says why, and what to do."""


class EarlyEndWarning(UserWarning):
    """A run over time that ends before its duration; the message says when and why."""


def warn_user(warning: Warning) -> None:
    """Issue a warning that points at the line of the user's code that called the package."""
    frame, level = sys._getframe(1), 2
    while frame.f_back is not None and _is_of_package(frame.f_globals.get("__name__", "")):
        frame, level = frame.f_back, level + 1
    warnings.warn(warning, stacklevel=level)


def _is_of_package(module: str) -> bool:
    """Whether a module belongs to this package."""
    return module.partition(".")[0] == __name__.partition(".")[0]


def format_value(value: object) -> str:
    """A value as one line of a message, truncated if too long."""
    try:
        text = SHORT.repr(value)
    except ValueError:  # Python refuses to print an integer of thousands of digits
        text = "an integer of thousands of digits"
    return " ".join(text.splitlines())


def number_of(count: int, noun: str) -> str:
    """A count and its noun, such as "1 push" or "2 pushes"."""
    return f"{count} {noun}" + ("" if count == 1 else "es" if noun.endswith("sh") else "s")


def as_float(value: object) -> float:
    """A real number as a float; NaN for anything else, such as strings, booleans, decimals and arrays.

    The door for arrays is `planar_pushing.terms.numbers`.
    """
    plain = isinstance(value, (int, float)) and not isinstance(value, bool)
    single = getattr(getattr(value, "dtype", None), "kind", "") in ("i", "u", "f")
    if not plain and not (single and getattr(value, "ndim", 1) == 0 and not _is_masked(value)):
        return math.nan
    try:
        return float(value)  # type: ignore[arg-type]
    except OverflowError:
        return math.nan


def _is_masked(value: object) -> bool:
    """Whether a number of numpy is masked, without importing numpy."""
    numpy = sys.modules.get("numpy")
    return numpy is not None and bool(numpy.ma.is_masked(value))


def as_floats(value: Any) -> tuple[float, ...]:
    """The entries of a sequence as floats; an empty tuple for anything else."""
    return tuple(map(as_float, value)) if has_entries(value) else ()


def has_entries(value: Any) -> bool:
    """Whether a value has entries in order: a sequence or an array, even an empty one."""
    ordered = hasattr(value, "__len__") and not isinstance(value, (Mapping, Set))
    return ordered and getattr(value, "ndim", 1) > 0


def require_flag(name: str, value: Any) -> bool:
    """Return an option that is on or off, or raise `InvalidValue`."""
    single = getattr(getattr(value, "dtype", None), "kind", "") == "b" and value.ndim == 0
    if not single and not isinstance(value, bool) and as_float(value) not in (0.0, 1.0):
        raise InvalidValue(name, value, "True or False", "give one of them")
    return bool(value)


def require_number(
    name: str, value: object, allows: Callable[[float], bool], allowed: str, remedy: str
) -> float:
    """Return `value` as a float, or raise `InvalidValue` when `allows` refuses it."""
    number = as_float(value)
    if math.isnan(number) or not allows(number):
        plain = math.isnan(number) and not isinstance(value, float)
        raise InvalidValue(
            name, value if plain or isinstance(value, int) else number, allowed, remedy
        )
    return number


def require_positive(name: str, value: object, remedy: str) -> float:
    """Return `value` as a positive finite float, or raise `InvalidValue`."""
    return require_number(name, value, lambda x: 0 < x < math.inf, "a finite number > 0", remedy)


def require_kind(name: str, value: object, kind: type[Kind], remedy: str = "construct one") -> Kind:
    """Return `value` if it is an instance of `kind`, or raise `InvalidValue`."""
    if not isinstance(value, kind):
        raise InvalidValue(name, value, f"a {kind.__name__}", remedy)
    return value


def require_path(name: str, value: Any) -> Any:
    """Return the path that was given, or raise `InvalidValue`."""
    if not isinstance(value, (str, os.PathLike)) or "\0" in str(value):
        raise InvalidValue(name, value, "the path of a file", "give it as text or as a Path")
    return value


def suggestion(value: object, options: Iterable[str], otherwise: str, *, before: str = "") -> str:
    """Remedy for an unknown name: the names that may be meant, each after a text, or another remedy."""
    names = [f"{before}{name}" for name in similar_names(value, options)]
    if not names:
        return otherwise
    *first, last = names
    return f"did you mean {', '.join(first)} or {last}?" if first else f"did you mean {last}?"


def similar_names(value: object, options: Iterable[str]) -> list[str]:
    """The names that a mistyped one abbreviates, or else the one with the most similar spelling, if any.

    Capitals and the hyphens before an option do not count, and a hyphen is as good as an underscore.
    """
    spellings = {_spelling(option): option for option in options}
    is_short = isinstance(value, str) and len(value) <= LONGEST_NAME
    word = _spelling(value) if is_short else ""
    if word in spellings:
        return [spellings[word]]
    if len(word) >= SHORTEST_NAME:
        longer = [option for name, option in spellings.items() if name.startswith(word)]
        if longer:
            return longer
    near = difflib.get_close_matches(word, spellings, n=1, cutoff=SIMILAR)
    return [spellings[name] for name in near]


def _spelling(name: object) -> str:
    """A name as it is compared with others."""
    return str(name).casefold().replace("_", "-").lstrip("-")


def require_option(name: str, value: Any, options: type[Option], remedy: str) -> Option:
    """Return the option that `value` is or names, or raise `InvalidValue`."""
    return options(require_name(name, value, options, remedy))


def require_name(name: str, value: Any, options: Iterable[str], remedy: str) -> str:
    """Return `value` if it is one of some names, or raise `InvalidValue`, which suggests a similar one."""
    names = list(options)
    if not isinstance(value, str) or value not in names:
        raise InvalidValue(name, value, ", ".join(names), suggestion(value, names, remedy))
    return value
