"""The part of a study from which each result is computed, and its digest, which the result stores."""

from __future__ import annotations

import hashlib
from collections.abc import Callable
from typing import Any

from planar_pushing.mechanics.entries import to_json
from planar_pushing.terms.replacing import PathLike
from pulling_by_pushing.study.catalog import DATASETS, SIMULATIONS
from pulling_by_pushing.study.model import StudyFile
from pulling_by_pushing.study.slices import study_slice
from pulling_by_pushing.study.studies import study_name
from pulling_by_pushing.study.study_file import scene_file

#: Keys of a study that do not affect values: the golden data to compare with, and the chunks.
IGNORED_KEYS = {"golden", "chunks", "gather"}
#: Results about the computation itself, and the keys that they do not use.
UNUSED_KEYS = {
    "effects": ("title", "scenes", "model_errors", "model_estimates", "simulations", "figures")
}

#: Function from the name of a result to the attributes that identify its study.
Marks = Callable[[str], dict[str, str]]


def provenance(study: StudyFile, file: PathLike) -> Marks:
    """Function that gives the attributes `study` and `study_digest` of a result by its name.

    The digest covers the validated values from which the result is computed. Comments, layout, and values
    of other results do not affect it. Results are named as in `open_dataset`. Scene files are read once,
    when this function is called.
    """
    name, values = study_name(file), contents(study)

    def marks(result: str) -> dict[str, str]:
        return {
            "study": name,
            "study_digest": f"sha256:{digest(_source_values(study, values, result))}",
        }

    return marks


def digest(values: object) -> str:
    """SHA-256 of plain values; keys without a value are ignored, so that new keys do not change digests."""
    return hashlib.sha256(to_json(_without_none(values)).encode()).hexdigest()


def _without_none(values: Any) -> Any:
    """Plain values without the keys that hold None."""
    if isinstance(values, dict):
        return {key: _without_none(value) for key, value in values.items() if value is not None}
    return list(map(_without_none, values)) if isinstance(values, (list, tuple)) else values


def whole_digest(study: StudyFile) -> str:
    """Digest of all values from which results of a study are computed."""
    return digest(contents(study))


def contents(study: StudyFile) -> dict[str, Any]:
    """Plain values of a study, with paths of scene files replaced by their contents."""

    def scene(path: str) -> dict[str, Any]:
        return _without_unit_gyration(scene_file(path).model_dump(exclude_defaults=True))

    values = study.model_dump(exclude=IGNORED_KEYS)
    values["simulations"] = {name: scene(path) for name, path in study.simulations.items()}
    for push in values["scenes"].values():
        push["file"] = scene(push["file"])
    return values


def _without_unit_gyration(scene: dict[str, Any]) -> dict[str, Any]:
    """A scene without the radii of gyration that its masses would have anyway: 1, if it has no outline."""
    if "outline" in scene["slider"]:
        return scene
    effects = [
        {key: value for key, value in effect.items() if (key, value) != ("gyration_radius", 1.0)}
        for effect in scene["effects"]
    ]
    return scene | {"effects": effects}


def _source_values(study: StudyFile, values: dict[str, Any], result: str) -> object:
    """Values from which a result is computed; empty for a result that does not depend on the study."""
    folder, _, name = result.rpartition("/")
    if folder == SIMULATIONS:
        return values[SIMULATIONS][name]
    if name == "scenes":
        return values["scenes"]
    if name in DATASETS:
        return study_slice(study, name)
    if name in UNUSED_KEYS:
        return {key: value for key, value in values.items() if key not in UNUSED_KEYS[name]}
    return None
