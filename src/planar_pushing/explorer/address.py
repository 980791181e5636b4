"""Conversion between the state of the page and the query of its address, and lines that refuse values."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from pathlib import Path
from typing import Any
from urllib.parse import urlencode

from pydantic import ValidationError

from planar_pushing.explorer.state import Handle, Start, State, pushed
from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.scenes.files import explain
from planar_pushing.scenes.scene_model import SceneFile
from planar_pushing.terms.errors import (
    InvalidFile,
    InvalidValue,
    PlanarPushingError,
    as_float,
    shown,
)

#: Named components of the state outside the scene file, and their values.
NAMES: dict[str, tuple[str, ...]] = {
    "start": tuple(Start),
    "shown": tuple(mode.name for mode in ContactMode),
    "across": ("magnitude", "friction", "rod angle", "rod length"),
    "handle": tuple(Handle),
}
#: Numeric components of the state outside the scene file: smallest value and description.
NUMBERS = {
    "angle": (-math.inf, "a finite number, degrees"),
    "magnitude": (5e-324, "a finite number > 0"),
    "time": (0.0, "a finite number >= 0"),
}
DEFAULTS = {"shown": "", "across": "", "time": None, "handle": Handle.PUSHER}
#: Keys of scene files with mappings as values; the inner keys are appended after a dot.
NESTED = ("slider", "contact", "simulate")
REMEDY = "the page shows its first preset instead"


def query(state: State) -> str:
    """Query of an address for a state."""
    parts = {name: getattr(state, name) for name in NAMES | NUMBERS}
    kept = {k: each for k, each in parts.items() if k not in DEFAULTS or each != DEFAULTS[k]}
    content = state.file.model_dump(mode="json", exclude_none=True, exclude_defaults=True)
    for name in NESTED:
        kept |= {f"{name}.{key}": each for key, each in content.pop(name, {}).items()}
    return urlencode({key: _text(each) for key, each in (kept | content).items()})


def state_in(arguments: Mapping[str, str]) -> State:
    """State given by the arguments of an address.

    Raises
    ------
    InvalidValue, InvalidFile
        If the arguments do not make a state; one line gives the key, its value and the allowed values.
    """
    content: dict[str, Any] = {}
    parts = {key: _part(key, arguments[key]) for key in arguments if key in NAMES | NUMBERS}
    for key in sorted(arguments.keys() - parts.keys(), key=lambda key: "." in key):
        name, _, inner = key.partition(".")
        holder = content.setdefault(name, {}) if inner else content
        if isinstance(holder, dict):  # otherwise the validation reports it
            holder[inner or name] = _value(arguments[key])
    try:
        state = State(file=SceneFile.model_validate(content), **parts)
        state = state if state.file.simulate else pushed(state, state.angle, state.magnitude)
        _ = state.scene
    except ValidationError as error:
        line = explain_problem("address", error)
        raise InvalidFile(f"{line.rpartition('; ')[0]}; {REMEDY}") from None
    return state


def _part(key: str, given: str) -> Any:
    """Component of the state outside the scene file."""
    if key in NAMES:
        allowed = " or ".join(NAMES[key])
        if given in NAMES[key]:
            return {"start": Start, "handle": Handle}.get(key, str)(given)
        raise InvalidValue(f"address: {key}", given, allowed, REMEDY)
    least, allowed = NUMBERS[key]
    value = as_float(_value(given))
    if not (math.isfinite(value) and value >= least):
        raise InvalidValue(f"address: {key}", given, allowed, REMEDY)
    return value


def _text(given: Any) -> str:
    """A word unchanged, and any other value as JSON."""
    return str(given) if isinstance(given, str) else json.dumps(given, separators=(",", ":"))


def _value(given: str) -> Any:
    """Inverse of `_text`; text that is not JSON is returned unchanged."""
    try:
        return json.loads(given)
    except (ValueError, RecursionError):  # a text of thousands of brackets
        return given


def refusal(error: BaseException, name: str = "", given: Any = None) -> str:
    """One-line message with the changed widget and its value, if any, and the allowed values."""
    if isinstance(error, ValidationError):
        line = explain_problem("scene", error)
        value = "nothing" if given is None or given == [] else shown(given)
        return f"{name}: {value} given; {line.partition(' given; ')[2]}" if name else line
    known = isinstance(error, PlanarPushingError)
    return " ".join((str(error) if known else f"{type(error).__name__}: {error}").split())


def explain_problem(start: str, error: ValidationError) -> str:
    """First error of a scene file as the package states it, after a prefix."""
    return explain(Path(start), error.errors()[0])
