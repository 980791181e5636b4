"""The address of the page: the whole state as a query, and back."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from typing import Any
from urllib.parse import urlencode

from pydantic import ValidationError

from planar_pushing.explore.refusals import explained
from planar_pushing.explore.state import Handle, Start, State, pushed
from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.study.files.scene_model import SceneFile
from planar_pushing.terms.errors import InvalidFile, InvalidValue, as_float

#: Parts of the state beside the scene file that are names, and their values.
NAMES: dict[str, tuple[str, ...]] = {
    "start": tuple(Start),
    "shown": tuple(mode.name for mode in ContactMode),
    "across": ("magnitude", "friction", "rod angle", "rod length"),
    "handle": tuple(Handle),
}
#: Those that are numbers: the smallest value, and a description.
NUMBERS = {
    "angle": (-math.inf, "a finite number, degrees"),
    "magnitude": (5e-324, "a finite number > 0"),
    "time": (0.0, "a finite number >= 0"),
}
DEFAULTS = {"shown": "", "across": "", "time": None, "handle": Handle.PUSHER}
#: Keys of scene files that hold mappings, whose keys are joined to theirs by a dot.
NESTED = ("slider", "contact", "simulate")
REMEDY = "the page shows its first preset instead"


def query(state: State) -> str:
    """The state as the query of an address."""
    parts = {name: getattr(state, name) for name in NAMES | NUMBERS}
    kept = {k: each for k, each in parts.items() if k not in DEFAULTS or each != DEFAULTS[k]}
    content = state.file.model_dump(mode="json", exclude_none=True, exclude_defaults=True)
    for name in NESTED:
        kept |= {f"{name}.{key}": each for key, each in content.pop(name, {}).items()}
    return urlencode({key: _text(each) for key, each in (kept | content).items()})


def state_in(arguments: Mapping[str, str]) -> State:
    """The state in the arguments of an address.

    Raises
    ------
    InvalidValue, InvalidFile
        Naming the key, its value and what is allowed, in one line, where they make no state.
    """
    content: dict[str, Any] = {}
    parts = {key: _part(key, arguments[key]) for key in arguments if key in NAMES | NUMBERS}
    for key in sorted(arguments.keys() - parts.keys(), key=lambda key: "." in key):
        name, _, inner = key.partition(".")
        holder = content.setdefault(name, {}) if inner else content
        if isinstance(holder, dict):  # else the validation says so
            holder[inner or name] = _value(arguments[key])
    try:
        state = State(file=SceneFile.model_validate(content), **parts)
        state = state if state.file.simulate else pushed(state, state.angle, state.magnitude)
        _ = state.scene
    except ValidationError as error:
        line = explained("address", error)
        raise InvalidFile(f"{line.rpartition('; ')[0]}; {REMEDY}") from None
    return state


def _part(key: str, given: str) -> Any:
    """A part of the state beside the scene file."""
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
    """A word as it is, anything else as JSON."""
    return str(given) if isinstance(given, str) else json.dumps(given, separators=(",", ":"))


def _value(given: str) -> Any:
    """The inverse of `_text`: text that is not JSON is returned as it is."""
    try:
        return json.loads(given)
    except ValueError:
        return given
