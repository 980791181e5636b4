"""Parts of a study: what one dataset reads of it, so that a change elsewhere leaves it alone."""

from __future__ import annotations

from typing import Any

from pydantic import TypeAdapter

from planar_pushing.study.catalog import AXES, PUSHES
from planar_pushing.study.files.models import Grid, PushEntry, StudyFile
from planar_pushing.terms.options import EffectKind

COMMON = ("slider", *map(str, EffectKind))


def study_slice(study: StudyFile, name: str) -> dict[str, Any]:
    """Plain values of a study that the dataset `name` reads."""
    if name == "scenes":
        return {"scenes": {key: push.model_dump() for key, push in study.scenes.items()}}
    grid = {axis: list(getattr(study.grid, axis)) for axis in AXES[name]}
    if name in PUSHES:
        grid["force_angle"] = [angle for angle in grid["force_angle"] if 0 <= angle <= 180]
    common = {part: getattr(study, part) for part in COMMON}
    listed = {part: each.model_dump() for part, each in common.items() if each is not None}
    return listed | {"grid": grid}


def sliced_study(values: dict[str, Any]) -> StudyFile:
    """Study of a slice; what the slice leaves out cannot be read."""
    fields = StudyFile.model_fields
    parts: dict[str, Any] = {
        part: TypeAdapter[Any](fields[part].annotation or Any).validate_python(values[part])
        for part in COMMON
        if part in values
    }
    if "scenes" in values:
        parts["scenes"] = {k: PushEntry.model_validate(v) for k, v in values["scenes"].items()}
    if "grid" in values:
        parts["grid"] = Grid.model_construct(**values["grid"])
    return StudyFile.model_construct(**parts)
