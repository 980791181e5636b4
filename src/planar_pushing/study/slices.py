"""Parts of a study: what one dataset reads of it, so that a change elsewhere leaves it alone."""

from __future__ import annotations

from typing import Any

from pydantic import TypeAdapter

from planar_pushing.study.catalog import AXES, PUSHES, SLIDERS_AXES
from planar_pushing.study.files.models import Grid, PushEntry
from planar_pushing.study.files.sliders_model import KEY, SlidersFile, SlidersGrid, Study, kind_of
from planar_pushing.terms.options import STUDIED

COMMON = ("slider", *map(str, STUDIED))


def study_slice(study: Study, name: str) -> dict[str, Any]:
    """Plain values of a study that the dataset `name` reads."""
    if isinstance(study, SlidersFile):
        entries = {key: entry.model_dump() for key, entry in study.supports.items()}
        return {KEY: entries, "grid": _axes(study, SLIDERS_AXES[name])}
    if name == "scenes":
        return {"scenes": {key: push.model_dump() for key, push in study.scenes.items()}}
    grid = _axes(study, AXES[name])
    if name in PUSHES:
        grid["force_angle"] = [angle for angle in grid["force_angle"] if 0 <= angle <= 180]
    common = {part: getattr(study, part) for part in COMMON}
    listed = {part: each.model_dump() for part, each in common.items() if each is not None}
    return listed | {"grid": grid}


def _axes(study: Study, names: tuple[str, ...]) -> dict[str, list[Any]]:
    return {axis: list(getattr(study.grid, axis)) for axis in names}


def sliced_study(values: dict[str, Any]) -> Study:
    """Study of a slice; what the slice leaves out cannot be read."""
    model = kind_of(values)
    parts = {
        part: TypeAdapter[Any](model.model_fields[part].annotation or Any).validate_python(given)
        for part, given in values.items()
        if part in (*COMMON, KEY)
    }
    if "scenes" in values:
        parts["scenes"] = {k: PushEntry.model_validate(v) for k, v in values["scenes"].items()}
    if "grid" in values:
        grid = SlidersGrid if model is SlidersFile else Grid
        parts["grid"] = grid.model_construct(**values["grid"])
    return model.model_construct(**parts)
