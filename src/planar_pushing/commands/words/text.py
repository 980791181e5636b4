"""Text output of command results."""

from __future__ import annotations

from collections.abc import Iterable
from math import isfinite
from typing import Any

#: Components of a vector below this, relative to the largest, are rounding errors.
ROUNDING = 1e-12


def numbers(values: Iterable[Any]) -> list[float]:
    """Components of a vector as plain numbers, without negative zeros."""
    return [float(value) + 0.0 for value in values]


def text(value: Any, indent: int = 0) -> str:
    """Readable lines of nested results."""
    if _nested(value):
        blocks = (
            f"{' ' * indent}{i}:\n{text(each, indent + 2)}" for i, each in enumerate(value, 1)
        )
        return "\n".join(blocks)
    if isinstance(value, dict):
        return "\n".join(_line(str(key), each, indent) for key, each in value.items())
    entries = value if isinstance(value, list) else [value]
    finite = [abs(v) for v in entries if isinstance(v, float) and isfinite(v)]
    least = ROUNDING * max(finite, default=0.0)
    return " ".join(_word(v, least) for v in entries)


def _word(value: Any, least: float) -> str:
    """Twelve digits of a number; 0 for a vector component that is only rounding error."""
    if value is None:
        return "none"
    return (
        f"{0.0 if abs(value) < least else value:.12g}" if isinstance(value, float) else str(value)
    )


def _nested(value: Any) -> bool:
    return isinstance(value, list) and bool(value) and isinstance(value[0], dict)


def _line(key: str, value: Any, indent: int) -> str:
    if _nested(value):
        return f"{' ' * indent}{key}:\n{text(value, indent + 2)}"
    return f"{' ' * indent}{key}: {text(value)}" if key else str(value)
