"""Slices of a study: the values that one dataset reads; other changes to the study do not affect it."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Mapping
from typing import Any

from planar_pushing.scenes.fields import FileModel
from pulling_by_pushing.study.catalog import COUNTS, DATASETS, SIMULATIONS
from pulling_by_pushing.study.model import SECTIONS, Part, PushEntry, StudyFile

#: Plain values of a study: parameters, and the values along each axis under `grid`.
StudyValues = Mapping[str, Any]
#: A range along each dimension that is split; the others are whole.
Ranges = Mapping[str, slice]


def computes(study: StudyFile, name: str) -> bool:
    """Whether a study has the axes and the effects that a dataset needs."""
    entry = DATASETS[name]
    if entry.section:
        return bool(getattr(study, name))
    has_grid = name in study.fine_grids or not entry.fine
    effects = entry.effects is None or entry.effects in study.grid.effects
    return has_grid and effects and all(study.values(axis, name) for axis in entry.axes)


def result_names(study: StudyFile) -> list[str]:
    """Names of the results of a study that do not differ from run to run, as in `open_dataset`."""
    computed = [name for name in DATASETS if computes(study, name)]
    logs = [f"{SIMULATIONS}/{name}" for name in study.simulations]
    pushed = study.grid.effects and study.grid.rod_length  # `effects` pushes a slider of the grid
    counts = [name for name in COUNTS if name != "effects" or pushed]
    return [*computed, *logs, *(counts if "scenes" in computed else ())]


def study_slice(study: StudyFile, name: str) -> dict[str, Any]:
    """Plain values of a study that a dataset reads."""
    entry = DATASETS[name]
    if name == "scenes":
        return {"scenes": {key: push.model_dump() for key, push in study.scenes.items()}}
    if entry.section:
        return {name: getattr(study, name).model_dump()}
    grid = {axis: list(study.values(axis, name)) for axis in entry.axes}
    if entry.pushes:
        grid["force_angle"] = [angle for angle in grid["force_angle"] if 0 <= angle <= 180]
    if "support" in grid:
        supports = {key: support.model_dump() for key, support in study.supports.items()}
        # An angle is required, but not read by the other datasets.
        slider = study.slider.model_dump(include=None if entry.rod else {"rod_angle"})
        return {"slider": slider, "supports": supports, "grid": grid}
    parts = {part: parameters.model_dump() for part, parameters in study.parts.items()}
    return {"slider": study.slider.model_dump(), **parts, "grid": grid}


def part_of(values: StudyValues) -> Part:
    """Validate plain values as part of a study."""
    return Part.model_validate(values)


def section_of(name: str, values: StudyValues) -> FileModel:
    """Validate plain values as the section of a study with the name of a dataset."""
    return SECTIONS[name].model_validate(values[name])


def pushes(values: StudyValues) -> dict[str, PushEntry]:
    """Scenes of a slice of a study."""
    return {name: PushEntry.model_validate(push) for name, push in values["scenes"].items()}


def sizes(name: str, values: StudyValues) -> dict[str, int]:
    """Lengths of the dimensions along which a slice can be split; empty for the scenes."""
    return {dim: len(values["grid"][dim]) for dim in DATASETS[name].dims}


def select_ranges(values: StudyValues, ranges: Ranges) -> dict[str, Any]:
    """Part of a slice with only the values in a range of each axis."""
    part = dict(values)
    if ranges:
        grid = {
            axis: axis_values[ranges.get(axis, slice(None))]
            for axis, axis_values in values["grid"].items()
        }
        part["grid"] = grid
        if "support" in grid:
            part["supports"] = {name: values["supports"][name] for name in grid["support"]}
    return part


def split_ranges(lengths: Mapping[str, int], steps: Mapping[str, int]) -> Iterator[Ranges]:
    """Ranges that split dimensions of these lengths at multiples of the given steps."""
    spans = [
        [slice(start, min(start + step, lengths[dim])) for start in range(0, lengths[dim], step)]
        for dim, step in steps.items()
    ]
    for part in itertools.product(*spans):
        yield dict(zip(steps, part, strict=True))


def points(name: str, values: StudyValues) -> int:
    """Number of grid points of a slice."""
    return math.prod(sizes(name, values).values())
