"""Presets to start from, and the gallery of supports."""

from __future__ import annotations

import math
from functools import cache
from importlib.resources import files
from typing import Any

from ruamel.yaml import YAML

from planar_pushing.explorer.state import State, state_of
from planar_pushing.mechanics.force.cones import angle_under_force
from planar_pushing.scenes.object_model import ObjectFile
from planar_pushing.scenes.scene_model import SceneFile

#: Preset that the page shows first.
FIRST = "figure_03"
EFFECTS = {"ring": {"type": "ring_friction"}, "inertia": {"type": "inertia"}}


@cache
def _table() -> dict[str, Any]:
    text = (files("planar_pushing.explorer") / "presets.yaml").read_text(encoding="utf-8")
    found: dict[str, Any] = YAML(typ="safe", pure=True).load(text)
    return found


def gallery() -> dict[str, Any]:
    """Supports of size 1 in the format of scene files, by name."""
    found: dict[str, Any] = _table()["gallery"]
    return found


def titles() -> dict[str, str]:
    """Titles of the presets by name."""
    return {name: each["title"] for name, each in _table()["presets"].items()}


def preset_file(name: str) -> SceneFile:
    """Scene file of a preset."""
    given = _table()["presets"][name]
    if "object" in given:
        return ObjectFile.model_validate(given).scene_file()
    slider = dict(zip(("rod_length", "rod_angle"), given["rod"], strict=True))
    effects = [_effect(each) for each in given.get("effects", ["ring"])]
    if "radius" in given or all("support" not in each for each in effects):
        slider["radius"] = 1.0
    law: dict[str, Any] = {"law": "coulomb", "friction_coefficient": given["friction"]}
    content = {
        "title": given["title"], "slider": slider, "effects": effects, "simulate": given.get("simulate"),
        "contact": law if math.isfinite(given["friction"]) else {"law": "infinite_friction"},
    }  # fmt: skip
    return SceneFile.model_validate(content)


def _effect(given: Any) -> dict[str, Any]:
    """Effect given by its name, or unchanged if it is already an entry."""
    if not isinstance(given, str):
        return dict(given)
    if given in EFFECTS:
        return EFFECTS[given]
    support = (_table()["gallery"] | _table()["others"])[given]
    return {"type": "support_friction", "support": support}


def preset(name: str) -> State:
    """Initial state of a preset."""
    file, given = preset_file(name), _table()["presets"][name]
    if file.simulate is not None:
        return state_of(file)
    if "pusher_angle" in given:
        return state_of(file, float(given["pusher_angle"]))
    return state_of(file, round(angle_under_force(file.build(), given["force_angle"]), 6))
