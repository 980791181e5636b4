"""The part of a study that each of its results is computed from, and its digest, which the result holds."""

from __future__ import annotations

import hashlib
from collections.abc import Callable
from typing import Any

from planar_pushing.mechanics.entries import to_json
from planar_pushing.study.catalog import DATASETS, SIMULATIONS
from planar_pushing.study.files.replacing import PathLike
from planar_pushing.study.files.scenes import load_scene_file
from planar_pushing.study.files.study_model import StudyFile
from planar_pushing.study.slices import study_slice
from planar_pushing.study.studies import study_name

#: Keys of a study that no value depends on: where it is compared with golden data, and how it is cut.
ASIDE = {"golden", "chunks", "gather"}
#: Results on how a study is computed, and the keys that they do not read.
UNREAD = {
    "evaluations": ("title", "scenes", "simulations", "figures"),
    "effects": ("simulations", "figures"),
}

#: Gives the attributes that name the study in a result, by the name of the result.
Marks = Callable[[str], dict[str, str]]


def provenance(study: StudyFile, file: PathLike) -> Marks:
    """Attributes `study` and `study_digest` of each result of a study, by its name.

    The digest is that of the validated values that the result is computed from: comments, layout, and
    values of other results leave it as it is. Results are named as in `open_dataset`, a figure without
    its folder. Scene files are read once, here.
    """
    name, whole = study_name(file), contents(study)

    def marks(result: str) -> dict[str, str]:
        return {"study": name, "study_digest": f"sha256:{digest(_read(study, whole, result))}"}

    return marks


def digest(values: object) -> str:
    """SHA-256 of plain values; a key without a value counts as absent: new keys change no digest."""
    return hashlib.sha256(to_json(_given(values)).encode()).hexdigest()


def _given(values: Any) -> Any:
    """Plain values without the keys that hold None."""
    if isinstance(values, dict):
        return {key: _given(each) for key, each in values.items() if each is not None}
    return list(map(_given, values)) if isinstance(values, (list, tuple)) else values


def whole_digest(study: StudyFile) -> str:
    """Digest of every value that a result of a study is computed from."""
    return digest(contents(study))


def contents(study: StudyFile) -> dict[str, Any]:
    """Plain values of a study, with what its scene files hold in the place of their paths."""

    def scene(path: str) -> dict[str, Any]:
        return load_scene_file(path).model_dump(exclude_defaults=True)

    values = study.model_dump(exclude=ASIDE)
    values["simulations"] = {name: scene(path) for name, path in study.simulations.items()}
    for push in values["scenes"].values():
        push["file"] = scene(push["file"])
    return values


def _read(study: StudyFile, whole: dict[str, Any], result: str) -> object:
    """The values that a result is computed from: none for one that is the same for every study."""
    folder, _, name = result.rpartition("/")
    if folder == SIMULATIONS:
        return whole[SIMULATIONS][name]
    if name == "scenes":
        return whole["scenes"]
    if name in DATASETS:
        return study_slice(study, name)
    if name in study.figures:
        return {"figure": whole["figures"][name], "slider": whole["slider"]}
    if name in UNREAD:
        return {key: each for key, each in whole.items() if key not in UNREAD[name]}
    return None
