"""Calls whose arguments do not fit: a sentence with the remedy instead of Python's own.

The package explains the calls of its public names where they are first used, so that no function has to.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from enum import Enum
from functools import wraps
from types import FunctionType
from typing import Any

from planar_pushing.terms.errors import InvalidCall, format_value, number_of, suggestion

#: Returns a public name of the package.
Load = Callable[[str], Any]


def explain_calls(name: str, value: Any, load: Load) -> Any:
    """A public function or class whose wrong calls raise `InvalidCall`, and those of its methods.

    Any other value, and enumerations and exceptions, which Python calls in its own ways, stay as they are.
    """
    if isinstance(value, FunctionType):
        explained: Any = _explain_function(value, name, load, bound=0)
        # Under these names pickle finds the function that it is given.
        explained.__module__, explained.__qualname__ = __name__.partition(".")[0], name
        return explained
    if isinstance(value, type) and not issubclass(value, Enum | BaseException):
        for label, member in list(vars(value).items()):
            if label == "__init__" or not label.startswith("_"):
                full = name if label == "__init__" else f"{name}.{label}"
                if (explained := _explain_member(member, full, load)) is not None:
                    setattr(value, label, explained)
    return value


def _explain_member(member: Any, name: str, load: Load) -> Any:
    """A method or a class method that explains a wrong call; None for anything else in a class."""
    if isinstance(member, FunctionType):
        return _explain_function(member, name, load, bound=1)
    if isinstance(member, classmethod):
        return classmethod(_explain_function(member.__func__, name, load, bound=1))
    return None


def _explain_function(function: Callable[..., Any], name: str, load: Load, bound: int) -> Any:
    """A function that explains a wrong call; its first arguments can be bound."""

    @wraps(function)
    def call(*arguments: Any, **named: Any) -> Any:
        try:
            return function(*arguments, **named)
        except TypeError as error:
            text = _mistake(function, name, load, arguments[bound:], named, bound)
            if not text:
                raise
            raise InvalidCall(f"{name}: {text}") from error

    return call


def _mistake(
    function: Callable[..., Any], name: str, load: Load,
    arguments: tuple[Any, ...], named: Mapping[str, Any], bound: int,
) -> str:  # fmt: skip
    """The mistake in the arguments of a call and its remedy; empty if they fit the parameters."""
    import inspect

    parameters = list(inspect.signature(function).parameters.values())[bound:]
    if any(
        parameter.kind in (parameter.VAR_POSITIONAL, parameter.VAR_KEYWORD)
        for parameter in parameters
    ):
        return ""
    names = [parameter.name for parameter in parameters]
    unknown = next((key for key in named if key not in names), None)
    if unknown is not None:
        remedy = _maker_of(unknown, names, load) or suggestion(unknown, names, "give one of these")
        value = format_value(named[unknown])
        return f"{unknown}={value} given; allowed: {', '.join(names) or 'no argument'}; {remedy}"
    places = [p.name for p in parameters if p.kind != p.KEYWORD_ONLY]
    free = [p for p in parameters if p.name not in places and p.name not in named]
    if len(arguments) > len(places):
        given = number_of(len(arguments), "argument")
        free.sort(key=lambda parameter: parameter.default is not parameter.empty)
        pairs = zip(free, arguments[len(places) :], strict=False)
        rest = ", ".join(f"{parameter.name}={format_value(value)}" for parameter, value in pairs)
        remedy = f"name the rest, as in {rest}" if rest else "leave out the rest"
        return f"{given} without a name given; allowed: {', '.join(places) or 'none'}; {remedy}"
    twice = next((key for key in places[: len(arguments)] if key in named), None)
    if twice is not None:
        return f"{twice} given twice; allowed: once; leave out {twice}= or the one without a name"
    missing = [p.name for p in parameters[len(arguments) :] if p.default is p.empty]
    missing = [name for name in missing if name not in named]
    if missing:
        return f"no {missing[0]} given; allowed: {', '.join(names)}; give {missing[0]}=..."
    return ""


def _maker_of(unknown: str, names: list[str], load: Load) -> str:
    """Remedy for a parameter of a function that computes one of these: mass, for the weight."""
    import inspect

    for name in names:
        try:
            maker = load(name)
        except AttributeError:
            continue
        if isinstance(maker, FunctionType) and unknown in inspect.signature(maker).parameters:
            return f"give {name}=pp.{name}{inspect.Signature(_required_parameters(maker))}"
    return ""


def _required_parameters(function: Callable[..., Any]) -> list[Any]:
    """The parameters without a default, by name only."""
    import inspect

    parameters = inspect.signature(function).parameters.values()
    return [p.replace(annotation=p.empty) for p in parameters if p.default is p.empty]
