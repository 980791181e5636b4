"""Conversion between the state of the page and the query of its address, and lines that refuse values."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from pathlib import Path
from typing import Any
from urllib.parse import urlencode

from pydantic import ValidationError

from planar_pushing.explorer.lengths import METERS
from planar_pushing.explorer.several import open_state
from planar_pushing.explorer.state import Handle, Start, State, with_push
from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.scenes.contacts_model import ContactsFile
from planar_pushing.scenes.files import explain
from planar_pushing.scenes.scene_model import SceneFile
from planar_pushing.terms.errors import (
    InvalidFile,
    InvalidValue,
    PlanarPushingError,
    as_float,
    format_value,
)

#: Named components of the state outside the scene file, and their values.
NAMES: dict[str, tuple[str, ...]] = {
    "start": tuple(Start),
    "shown": tuple(mode.name for mode in ContactMode),
    "across": ("magnitude", "friction", "rod angle", "rod length"),
    "handle": tuple(Handle),
    "unit": tuple(METERS),
}
#: Numeric components of the state outside the scene file: smallest value and description.
NUMBERS = {
    "angle": (-math.inf, "a finite number, degrees"),
    "magnitude": (5e-324, "a finite number > 0"),
    "time": (0.0, "a finite number >= 0"),
}
DEFAULTS = {"shown": "", "across": "", "time": None, "handle": Handle.PUSHER, "unit": ""}
#: Keys of scene files with mappings as values; the inner keys are appended after a dot.
NESTED = ("slider", "contact", "simulate")
REMEDY = "the page shows its first preset instead"


def query(state: State) -> str:
    """Query of an address for a state."""
    if state.several is not None:
        whole = state.several.model_dump(mode="json", exclude_none=True, exclude_defaults=True)
        return urlencode({key: _text(value) for key, value in whole.items()})
    parts = {name: getattr(state, name) for name in NAMES | NUMBERS}
    entries = {
        name: value
        for name, value in parts.items()
        if name not in DEFAULTS or value != DEFAULTS[name]
    }
    content = state.file.model_dump(mode="json", exclude_none=True, exclude_defaults=True)
    for name in NESTED:
        entries |= {f"{name}.{key}": value for key, value in content.pop(name, {}).items()}
    return urlencode({key: _text(value) for key, value in (entries | content).items()})


def state_in(arguments: Mapping[str, str]) -> State:
    """State given by the arguments of an address.

    Raises
    ------
    InvalidValue, InvalidFile
        If the arguments do not make a state; one line gives the key, its value and the allowed values.
    """
    if "contacts" in arguments:
        return _with_contacts(arguments)
    content: dict[str, Any] = {}
    parts = {key: _part(key, arguments[key]) for key in arguments if key in NAMES | NUMBERS}
    for key in sorted(arguments.keys() - parts.keys(), key=lambda key: "." in key):
        name, _, inner = key.partition(".")
        holder = content.setdefault(name, {}) if inner else content
        if isinstance(holder, dict):  # otherwise the validation reports it
            holder[inner or name] = _value(arguments[key])
    try:
        state = State(file=SceneFile.model_validate(content), **parts)
        state = state if state.file.simulate else with_push(state, state.angle, state.magnitude)
        _ = state.scene
    except ValidationError as error:
        line = explain_problem("address", error)
        raise InvalidFile(f"{line.rpartition('; ')[0]}; {REMEDY}") from None
    return state


def _with_contacts(arguments: Mapping[str, str]) -> State:
    """State of a scene with several contacts, whose sections are the arguments of an address."""
    content = {key: _value(text) for key, text in arguments.items()}
    try:
        return open_state(ContactsFile.model_validate(content))
    except ValidationError as error:
        line = explain_problem("address", error)
        raise InvalidFile(f"{line.rpartition('; ')[0]}; {REMEDY}") from None


def _part(key: str, text: str) -> Any:
    """Component of the state outside the scene file."""
    if key in NAMES:
        allowed = " or ".join(NAMES[key])
        if text in NAMES[key]:
            return {"start": Start, "handle": Handle}.get(key, str)(text)
        raise InvalidValue(f"address: {key}", text, allowed, REMEDY)
    lowest, allowed = NUMBERS[key]
    value = as_float(_value(text))
    if not (math.isfinite(value) and value >= lowest):
        raise InvalidValue(f"address: {key}", text, allowed, REMEDY)
    return value


def _text(value: Any) -> str:
    """A word unchanged, and any other value as JSON."""
    return str(value) if isinstance(value, str) else json.dumps(value, separators=(",", ":"))


def _value(text: str) -> Any:
    """Inverse of `_text`; text that is not JSON is returned unchanged."""
    try:
        return json.loads(text)
    except (ValueError, RecursionError):  # a text of thousands of brackets
        return text


def refusal(error: BaseException, name: str = "", value: Any = None) -> str:
    """One-line message with the changed widget and its value, if any, and the allowed values."""
    if isinstance(error, ValidationError):
        line = explain_problem("scene", error)
        text = "nothing" if value is None or value == [] else format_value(value)
        return f"{name}: {text} given; {line.partition(' given; ')[2]}" if name else line
    known = isinstance(error, PlanarPushingError)
    return " ".join((str(error) if known else f"{type(error).__name__}: {error}").split())


def explain_problem(start: str, error: ValidationError) -> str:
    """First error of a scene file as the package states it, after a prefix."""
    return explain(Path(start), error.errors()[0])
