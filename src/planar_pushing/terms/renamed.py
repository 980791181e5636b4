"""Former names in the public interface: each still works, and warns that version 2.0 removes it."""

from __future__ import annotations

import sys
import warnings
from collections.abc import Callable, Mapping
from functools import wraps
from typing import Any, TypeVar

Function = TypeVar("Function", bound=Callable[..., Any])
Kind = TypeVar("Kind", bound=type)

#: Packages of a call from the user's line to a former name; pydantic calls the validators of files.
INSIDE = ("planar_pushing", "pydantic")


def warn(former: str, name: str) -> None:
    """Issue a `DeprecationWarning` for the line outside the package that uses a former name."""
    frame, level = sys._getframe(), 1
    while frame.f_back and frame.f_globals.get("__name__", "").split(".")[0] in INSIDE:
        frame, level = frame.f_back, level + 1
    text = f"{former} is now {name}; it will be removed in 2.0"
    warnings.warn(text, DeprecationWarning, stacklevel=level)


def renamed_value(given: Any, names: Mapping[str, str]) -> Any:
    """The present name if a former one is given; any other value unchanged."""
    if not isinstance(given, str) or given not in names:
        return given
    warn(given, names[given])
    return names[given]


def renamed_keywords(**names: str) -> Callable[[Function], Function]:
    """Decorator of a function that also accepts keywords by their former names, ``former="present"``."""

    def decorate(function: Any) -> Any:
        @wraps(function)
        def call(*args: Any, **options: Any) -> Any:
            for former in names.keys() & options.keys():
                name = names[former]
                if name in options:
                    raise TypeError(
                        f"{function.__name__}() got {name} and its former name {former}"
                    )
                warn(former, name)
                options[name] = options.pop(former)
            return function(*args, **options)

        return call

    return decorate


def renamed_attributes(**names: str) -> Callable[[Kind], Kind]:
    """Decorator of a dataclass whose attributes and keywords also have former names."""

    def reads(former: str, name: str) -> property:
        def read(self: Any) -> Any:
            warn(former, name)
            return getattr(self, name)

        return property(read, doc=f"Former name of `{name}`.")

    def decorate(kind: Any) -> Any:
        kind.__init__ = renamed_keywords(**names)(kind.__init__)
        for former, name in names.items():
            setattr(kind, former, reads(former, name))
        return kind

    return decorate
