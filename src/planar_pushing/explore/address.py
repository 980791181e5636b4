"""The address of the page: the whole state as a query, and back."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any
from urllib.parse import urlencode

from pydantic import ValidationError

from planar_pushing.explore.state import Start, State, pushed
from planar_pushing.study.files.scene_model import SceneFile
from planar_pushing.terms.errors import InvalidValue

#: Parts of the state beside the scene file: how each is read.
PARTS: dict[str, Any] = {
    "angle": float,
    "magnitude": float,
    "start": Start,
    "shown": str,
    "across": str,
    "time": float,
}
DEFAULTS = {"shown": "", "across": "", "time": None}
#: Keys of scene files that hold mappings, whose keys are joined to theirs by a dot.
NESTED = ("slider", "contact", "simulate")


def query(state: State) -> str:
    """The state as the query of an address."""
    found = {name: getattr(state, name) for name in PARTS}
    kept = {k: each for k, each in found.items() if k not in DEFAULTS or each != DEFAULTS[k]}
    content = state.file.model_dump(mode="json", exclude_none=True, exclude_defaults=True)
    for name in NESTED:
        kept |= {f"{name}.{key}": each for key, each in content.pop(name, {}).items()}
    return urlencode({key: _text(each) for key, each in (kept | content).items()})


def state_in(arguments: Mapping[str, str]) -> State:
    """The state in the arguments of an address.

    Raises
    ------
    InvalidValue
        Where they make no state.
    """
    content: dict[str, Any] = {}
    parts: dict[str, Any] = {}
    try:
        for key, given in arguments.items():
            name, _, inner = key.partition(".")
            if key in PARTS:
                parts[key] = PARTS[key](_value(given))
            elif inner:
                content.setdefault(name, {})[inner] = _value(given)
            else:
                content[name] = _value(given)
        state = State(file=SceneFile.model_validate(content), **parts)
        state = state if state.file.simulate else pushed(state, state.angle, state.magnitude)
        _ = state.scene
    except (ValidationError, ValueError, TypeError) as error:
        said = str(error).splitlines()
        raise InvalidValue(
            "address", ", ".join(arguments), "an address that the page has shown",
            f"start from a preset ({' '.join(said[:3])})",
        ) from None  # fmt: skip
    return state


def _text(given: Any) -> str:
    """A word as it is, anything else as JSON."""
    return str(given) if isinstance(given, str) else json.dumps(given, separators=(",", ":"))


def _value(given: str) -> Any:
    """The inverse of `_text`: text that is not JSON is returned as it is."""
    try:
        return json.loads(given)
    except ValueError:
        return given
