"""One-line messages for values that a page or its address cannot accept."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from pydantic import ValidationError

from planar_pushing.scenes.files import explain
from planar_pushing.terms.errors import PlanarPushingError, shown


def refusal(error: BaseException, name: str = "", given: Any = None) -> str:
    """One-line message with the changed widget and its value, if any, and the allowed values."""
    if isinstance(error, ValidationError):
        line = explained("scene", error)
        value = "nothing" if given is None or given == [] else shown(given)
        return f"{name}: {value} given; {line.partition(' given; ')[2]}" if name else line
    known = isinstance(error, PlanarPushingError)
    return " ".join((str(error) if known else f"{type(error).__name__}: {error}").split())


def explained(start: str, error: ValidationError) -> str:
    """First error of a scene file as the package states it, after a prefix."""
    return explain(Path(start), error.errors()[0])
