"""Supports in the format of scene files: scaling, and recognition of those in the gallery."""

from __future__ import annotations

from typing import Any

import numpy as np

#: Keys of a support with lengths as values.
LENGTHS = frozenset(
    (
        "radius",
        "inner",
        "outer",
        "center",
        "start",
        "end",
        "positions",
        "vertices",
        "holes",
        "x",
        "y",
    )
)
#: Relative tolerance for equal sizes.
ROUNDING = 1e-9


def scaled(entry: dict[str, Any], factor: float) -> dict[str, Any]:
    """Support enlarged by a factor."""
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
    """Name of a support in the gallery, which has supports of size 1; empty if it is not there."""
    if entry is None:
        return "ring"
    own = scaled(entry, 1.0 / size)
    return next((name for name, each in gallery.items() if _alike(own, each)), "")


def _alike(one: Any, other: Any) -> bool:
    """Whether two supports are equal up to rounding."""
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
    """Whether a key only states the default, that the support is centered at the origin."""
    return key == "center" and not any(given)
