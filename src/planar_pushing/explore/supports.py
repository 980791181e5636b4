"""Supports as scene files have them: another size, and which of the gallery one is."""

from __future__ import annotations

from typing import Any

import numpy as np

#: Keys of a support that hold lengths.
LENGTHS = frozenset(
    ("radius", "inner", "outer", "center", "start", "end", "positions", "vertices", "x", "y")
)
#: Sizes that differ by less are the same.
ROUNDING = 1e-9


def scaled(entry: dict[str, Any], factor: float) -> dict[str, Any]:
    """The support `factor` times as large."""
    found = {key: _times(each, factor) if key in LENGTHS else each for key, each in entry.items()}
    if "members" in entry:
        found["members"] = [
            {**each, "support": scaled(each["support"], factor)} for each in entry["members"]
        ]
    return found


def _times(given: Any, factor: float) -> Any:
    if isinstance(given, (list, tuple)):
        return [_times(each, factor) for each in given]
    return given * factor


def name_in(gallery: dict[str, Any], entry: dict[str, Any] | None, size: float) -> str:
    """Name of a support in the gallery, whose supports have size 1; empty for one that is not there."""
    if entry is None:
        return "ring"
    own = scaled(entry, 1.0 / size)
    return next((name for name, each in gallery.items() if _alike(own, each)), "")


def _alike(one: Any, other: Any) -> bool:
    """Whether two supports are the same up to rounding."""
    if isinstance(one, dict):
        kept = {key for key, each in one.items() if not _is_origin(key, each)}
        kin = {key for key, each in other.items() if not _is_origin(key, each)}
        return kept == kin and all(_alike(one[key], other[key]) for key in kept)
    if isinstance(one, (list, tuple)):
        return len(one) == len(other) and all(map(_alike, one, other))
    if isinstance(one, str):
        return bool(one == other)
    return bool(np.isclose(one, other, rtol=ROUNDING, atol=ROUNDING))


def _is_origin(key: str, given: Any) -> bool:
    """Whether a key says what holds without it: that the support lies about the origin."""
    return key == "center" and not any(given)
