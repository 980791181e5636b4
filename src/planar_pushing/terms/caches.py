"""Caches of functions whose arguments include supports of users, which need not be hashable."""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache, wraps
from typing import Any, TypeVar

Function = TypeVar("Function", bound=Callable[..., Any])


def cache_results(size: int) -> Callable[[Function], Function]:
    """Keep the latest results of a function, up to a number; those of unhashable arguments are not kept."""

    def decorate(function: Any) -> Any:
        kept = lru_cache(size)(function)

        @wraps(function)
        def call(*arguments: Any) -> Any:
            try:
                return kept(*arguments)
            except TypeError:
                try:
                    hash(arguments)
                except TypeError:
                    return function(*arguments)
                raise

        return call

    return decorate
