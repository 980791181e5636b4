"""Declarations of parameters: what is allowed, in code and in words, for Python and for files.

A parameter is declared once, in the annotation of its field::

    weight: Annotated[Number, positive("leave the effect out of the scene if ...")] = 1.0

`require_declared` checks the fields of a dataclass. The same annotations say how a file is read, written
and refused, and its schema; `planar_pushing.scenes` derives this from them. Pydantic is only then imported.
"""

from __future__ import annotations

import inspect
import math
from abc import abstractmethod
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field, fields
from functools import cache
from typing import Any, TypeVar, get_type_hints

import numpy as np

from planar_pushing.terms.errors import InvalidValue, require_number, suggestion
from planar_pushing.terms.numbers import Number, as_numbers, is_lazy, pair_of, remedy_for

Checked = TypeVar("Checked")
#: A JSON schema.
Schema = Mapping[str, Any]
NUMBER: dict[str, Any] = {"type": "number"}
PAIR: dict[str, Any] = {"type": "array", "minItems": 2, "maxItems": 2, "items": NUMBER}

#: Remedy for an angle of NaN.
FINITE = "give finite numbers: NaN is the result of a missing or an impossible one"


class Declaration:
    """Base of the declarations, each of which states the allowed values of a parameter.

    Attributes
    ----------
    words : str
        Description of the allowed values, for the schema.
    schema : mapping
        JSON schema of the values in files.
    """

    words: str
    schema: Schema

    @abstractmethod
    def require(self, name: str, value: Any) -> Any:
        """The value that a user gives in Python, or `InvalidValue` under a name."""

    def read(self, entry: Any) -> Any:
        """The value in a file, as it is kept in the file's form, or `InvalidValue` without a name."""
        return self.require("", entry)

    def from_file(self, entry: Any) -> Any:
        """The parameter for a value in a file's form."""
        return entry

    def to_file(self, value: Any) -> Any:
        """The value of a parameter in a file's form."""
        return _plain(value)

    def __get_pydantic_core_schema__(self, source: Any, handler: Any) -> Any:
        from pydantic_core import PydanticCustomError, core_schema

        def read(entry: Any) -> Any:
            try:
                return self.read(entry)
            except InvalidValue as error:
                raise PydanticCustomError("refused", "{allowed}", vars(error)) from None

        return core_schema.no_info_plain_validator_function(read)

    def __get_pydantic_json_schema__(self, core: Any, handler: Any) -> dict[str, Any]:
        return {"description": self.words} | dict(self.schema)


@dataclass(frozen=True, eq=False)
class Within(Declaration):
    """A number in a range, or in Python an array of them.

    Parameters
    ----------
    allows : callable
        Whether the numbers of an array are in the range.
    allowed, remedy : str
        The range in words, and advice for a value outside it.
    schema : mapping, optional
    """

    allows: Callable[[Any], Any]
    allowed: str
    remedy: str
    schema: Schema = field(default_factory=lambda: NUMBER)

    @property
    def words(self) -> str:  # type: ignore[override]
        return self.allowed

    def require(self, name: str, value: Number) -> Number:
        """The given numbers in double precision; blocks of a lazy array are checked when computed.

        Raises
        ------
        InvalidValue
            If a number is outside the range, with the name, the first number outside, and the range.
        """
        if type(value) is float and self.allows(value):  # most calls; the rest is for the others
            return value
        if is_lazy(value):
            blocks = value.data.map_blocks(lambda block: self._block(name, block), dtype=float)
            return value.copy(data=blocks)
        numbers = as_numbers(value)
        if numbers is None:
            raise InvalidValue(name, value, self.allowed, remedy_for(value, self.remedy))
        array = np.asarray(numbers)
        wrong = array[~np.asarray(self.allows(array), dtype=bool)]
        if wrong.size:
            one_number = array.ndim == 0 and not isinstance(value, np.number)
            number = value if one_number else float(wrong.flat[0])
            raise InvalidValue(name, number, self.allowed, self.remedy_for(number))
        return numbers

    def remedy_for(self, value: Any) -> str:
        """Remedy for a value: no conversion from degrees makes an angle of NaN."""
        is_nan = isinstance(value, float) and math.isnan(value)
        return FINITE if is_nan and "deg2rad" in self.remedy else self.remedy

    def _block(self, name: str, block: Any) -> Any:
        """A block of a lazy array; a block of one number stays an array."""
        return np.asarray(self.require(name, block))

    def read(self, entry: Any) -> float:
        """One number, or the word inf."""
        number = (
            {"inf": math.inf, "-inf": -math.inf}.get(entry, entry)
            if isinstance(entry, str)
            else entry
        )
        value = as_numbers(number) if isinstance(number, (int, float)) else None
        if value is None or not self.allows(value):
            raise InvalidValue("", entry, self.allowed, self.remedy)
        return float(value)


@dataclass(frozen=True, eq=False)
class Single(Within):
    """One number in a range, also in Python."""

    def require(self, name: str, value: Any) -> float:
        return require_number(name, value, self.allows, self.allowed, self.remedy_for(value))


@dataclass(frozen=True, eq=False)
class Degrees(Within):
    """An angle in radians, which files give in degrees.

    Parameters
    ----------
    degrees : Within
        The range in degrees.
    """

    degrees: Within = field(kw_only=True)

    @property
    def words(self) -> str:  # type: ignore[override]
        return self.degrees.allowed

    def read(self, entry: Any) -> float:
        return self.degrees.read(entry)

    def from_file(self, entry: float) -> float:
        return float(np.deg2rad(entry if abs(entry) <= 720.0 else math.fmod(entry, 360.0)))

    def to_file(self, value: Number) -> float:
        """Shortest number of degrees that converts back to the same radians."""
        degrees = float(np.rad2deg(value))
        rounded = [float(f"{degrees:.{digits}g}") for digits in range(1, 18)]
        beside = [float(np.nextafter(degrees, end)) for end in (-math.inf, math.inf)]
        return next((angle for angle in rounded + beside if np.deg2rad(angle) == value), degrees)

    def __get_pydantic_json_schema__(self, core: Any, handler: Any) -> dict[str, Any]:
        return self.degrees.__get_pydantic_json_schema__(core, handler)


@dataclass(frozen=True, eq=False)
class OneAngle(Degrees, Single):
    """One angle in radians, which files give in degrees."""


@dataclass(frozen=True, eq=False)
class Pair(Declaration):
    """Two numbers in a range, such as the components of a vector; in Python also two arrays.

    Parameters
    ----------
    within : Within
        The range of each number.
    words : str
        The two numbers in words.
    """

    within: Within
    words: str = "two finite numbers"
    schema: Schema = field(default_factory=lambda: PAIR)

    def require(self, name: str, value: Any) -> tuple[Number, Number]:
        pair = pair_of(value)
        if pair is None:
            raise InvalidValue(name, value, self.words, self.within.remedy)
        x, y = (self.within.require(name, component) for component in pair)
        return x, y

    def read(self, entry: Any) -> tuple[float, float]:
        pair = pair_of(entry)
        try:
            x, y = map(self.within.read, pair or ())
        except (InvalidValue, ValueError):
            raise InvalidValue("", entry, self.words, self.within.remedy) from None
        return x, y


@dataclass(frozen=True, eq=False)
class Read(Declaration):
    """Any other value, which a function checks and converts.

    Parameters
    ----------
    function : callable
        Returns the value for a name and what was given, or raises `InvalidValue`.
    words : str
        The allowed values.
    schema : mapping
    """

    function: Callable[[str, Any], Any]
    words: str
    schema: Schema

    def require(self, name: str, value: Any) -> Any:
        return self.function(name, value)


def positive(remedy: str) -> Within:
    """A finite number > 0."""
    schema = {"type": "number", "exclusiveMinimum": 0}
    return Within(lambda x: (x > 0) & (x < math.inf), "a finite number > 0", remedy, schema)


def nonnegative(remedy: str) -> Within:
    """A finite number >= 0."""
    schema = {"type": "number", "minimum": 0}
    return Within(lambda x: (x >= 0) & (x < math.inf), "a finite number >= 0", remedy, schema)


def finite(remedy: str, allowed: str = "a finite number") -> Within:
    """A finite number."""
    return Within(np.isfinite, allowed, remedy)


def one_of(options: Iterable[str], allowed: str, remedy: str) -> Read:
    """One of several words."""
    words = tuple(map(str, options))

    def require(name: str, value: Any) -> Any:
        if not isinstance(value, str) or value not in words:
            raise InvalidValue(name, value, allowed, suggestion(value, words, remedy))
        return value

    return Read(require, allowed, {"type": "string", "enum": list(words)})


@cache
def declarations_of(maker: Callable[..., Any]) -> dict[str, tuple[Declaration, Any]]:
    """The declared parameters of a class or a function, each with its default, by name."""
    hints = get_type_hints(maker, include_extras=True)
    declarations = {
        name: declaration
        for name, hint in hints.items()
        for declaration in getattr(hint, "__metadata__", ())
        if isinstance(declaration, Declaration)
    }
    parameters = inspect.signature(maker).parameters
    return {
        name: (declaration, parameters[name].default) for name, declaration in declarations.items()
    }


def require_declared(value: object) -> None:
    """Check the declared fields of a frozen value, and replace them with the results."""
    kind: Any = type(value)
    for name, (declaration, default) in declarations_of(kind).items():
        parameter = getattr(value, name)
        if parameter is not None or default is not None:
            object.__setattr__(value, name, declaration.require(name, parameter))


def replace_checked(value: Checked, **others: Any) -> Checked:
    """A copy of a frozen value with other fields, all of which were checked before."""
    kind: Any = type(value)
    copy: Checked = object.__new__(kind)
    for name in _field_names(kind):
        object.__setattr__(copy, name, others[name] if name in others else getattr(value, name))
    return copy


@cache
def _field_names(kind: Any) -> tuple[str, ...]:
    """Names of the fields of a dataclass."""
    return tuple(part.name for part in fields(kind))


def _plain(value: Any) -> Any:
    """Numbers as floats, truth values as they are, and sequences as lists."""
    if isinstance(value, bool):
        return value
    if isinstance(value, (tuple, list)):
        return [_plain(entry) for entry in value]
    return float(value) if isinstance(value, (int, float, np.generic)) else value
