"""Study files: reading one, and what keeps a well-formed study from being computed and drawn."""

from __future__ import annotations

import os
from collections.abc import Collection, Iterable, Iterator, Mapping
from pathlib import Path

from planar_pushing.study.catalog import AXES, SPLIT
from planar_pushing.study.figures import FIGURES, SCENES, computes
from planar_pushing.study.files.models import FigureEntry, Grid, StudyFile
from planar_pushing.study.files.replacing import PathLike
from planar_pushing.study.files.scenes import load_model, load_scene_file
from planar_pushing.study.files.yaml_text import shown
from planar_pushing.study.slices import study_slice
from planar_pushing.study.storage.parts import points, sizes
from planar_pushing.terms.errors import InvalidFile
from planar_pushing.terms.options import EFFECT_TYPES

#: Most points of a dataset's grid: a terabyte.
POINTS = 10**10


def load_study(path: PathLike) -> StudyFile:
    """Read a study file and check the scenes that it names; errors as in `load_scene`.

    The paths in the study become those from here, where the file has them from its own folder.
    """
    study = _located(load_model(path, StudyFile), Path(path).parent)
    for problem in _study_problems(study):
        raise InvalidFile(f"{path}: {problem}")
    return study


def _located(study: StudyFile, folder: Path) -> StudyFile:
    def from_here(file: str) -> str:
        return os.path.normpath(folder / file)

    scenes = {
        name: push.model_copy(update={"file": from_here(push.file)})
        for name, push in study.scenes.items()
    }
    simulations = {name: from_here(file) for name, file in study.simulations.items()}
    golden = study.golden and from_here(study.golden)
    return study.model_copy(update={"scenes": scenes, "simulations": simulations, "golden": golden})


def _study_problems(study: StudyFile) -> Iterator[str]:
    """What keeps a well-formed study from being computed and drawn."""
    yield from _effects_problems(study)
    yield from _size_problems(study)
    yield from _chunk_problems(study)
    yield from _scene_problems(study)
    yield from simulation_problems(study.simulations)
    yield from _entry_problems(study, "scenes", study.scenes, SCENES)
    yield from _entry_problems(
        study, "figures", study.figures, [name for name, figure in FIGURES.items() if figure.takes]
    )
    yield from _axis_problems(study)
    for name, figure in study.figures.items():
        yield from _figure_problems(name, figure, study.grid)
    if study.inertia and study.inertia.gyration_radius != study.slider.radius:
        yield (
            f"inertia.gyration_radius: {study.inertia.gyration_radius!r} given; allowed: the radius of "
            f"the ring, {study.slider.radius!r}, which the paper's bound presumes; change it"
        )
    if study.golden and not list(Path(study.golden).glob("*.nc")):
        yield f"golden: {study.golden!r} given; allowed: a folder of golden data; leave the key out"


def _size_problems(study: StudyFile) -> Iterator[str]:
    """Datasets of more points than a cluster computes."""
    for name, axes in AXES.items():
        count = points(sizes(name, study_slice(study, name)))
        if count > POINTS:
            yield (
                f"grid: {count} points of {name} given; allowed: {POINTS}; "
                f"shorten the axes {', '.join(axes)}"
            )


def _chunk_problems(study: StudyFile) -> Iterator[str]:
    """Chunks of datasets that have none, chunks along wrong axes, and `gather` without chunks."""
    for name, chunk in study.chunks.items():
        allowed = SPLIT.get(name, ()) if computes(study, name) else ()
        if not allowed:
            yield f"chunks.{name}: unknown, or not computed; allowed: {', '.join(SPLIT)}; remove it"
        if not chunk or not set(chunk) <= set(allowed):
            yield f"chunks.{name}: {list(chunk)} given; allowed: {', '.join(allowed)}; name some of these"
    for name in study.gather:
        if name not in study.chunks:
            known = ", ".join(study.chunks) or "none, as there are no chunks"
            yield f"gather.{name}: unknown; allowed: {known}; remove it, or give its chunks"


def _scene_problems(study: StudyFile) -> Iterator[str]:
    """Scene files that cannot be read, or that list effects the study has no parameters for."""
    for name, push in study.scenes.items():
        try:
            kinds = {EFFECT_TYPES[effect.type] for effect in load_scene_file(push.file).effects}
        except InvalidFile as error:
            yield f"scenes.{name}.file: {error}"
            continue
        if not kinds <= set(study.parts):
            yield (
                f"scenes.{name}.file: {push.file} lists {', '.join(sorted(kinds))}; allowed: the effects "
                f"of the study, {', '.join(study.parts)}; name another scene"
            )


def _entry_problems(
    study: StudyFile, kind: str, given: Collection[str], known: Iterable[str]
) -> Iterator[str]:
    """Scenes or figures of the paper that have no entry, and entries that are none of them."""
    needed = [name for name in known if computes(study, name)]
    for name in needed:
        if name not in given:
            yield f"{kind}.{name}: missing; allowed: an entry for each of {', '.join(needed)}; add it"
    for name in given:
        if name not in needed:
            yield (
                f"{kind}.{name}: unknown, or of effects that grid.effects does not list; "
                f"allowed: {', '.join(needed)}; remove it"
            )


def _axis_problems(study: StudyFile) -> Iterator[str]:
    """Axes of the grid without a value that the figures plot."""
    for key, values, wanted in study.needed_values():
        missing = [value for value in wanted if value not in values]
        if missing:
            yield (
                f"grid.{key}: {shown(values)} given; allowed: values that include {missing!r}, "
                "which the figures plot; add them"
            )


def simulation_problems(simulations: Mapping[str, str]) -> Iterator[str]:
    """Scene files that cannot be simulated."""
    for name, path in simulations.items():
        try:
            section = load_scene_file(path).simulate
        except InvalidFile as error:
            yield f"simulations.{name}: {error}"
            continue
        if section is None:
            yield (
                f"simulations.{name}: {path} given; allowed: scene files with the section simulate; "
                "add it to the file"
            )


def _effects_problems(study: StudyFile) -> Iterator[str]:
    """Effects of the grid that the study has no parameters for."""
    for name in study.grid.effects:
        for part in name.split("+"):
            if part not in study.parts:
                yield (
                    f"grid.effects: {name!r} given; allowed: effects that the study has parameters for; "
                    f"add the key {part}, or remove the entry"
                )


def _figure_problems(name: str, figure: FigureEntry, grid: Grid) -> Iterator[str]:
    """Values of a figure that are missing, or not on the grid."""
    for key in FIGURES[name].takes:
        if getattr(figure, key) is None:
            yield f"figures.{name}.{key}: missing; allowed: values of the grid; add it"
    for key, values, allowed in figure.grid_values(grid):
        if not set(values) <= set(allowed):
            yield (
                f"figures.{name}.{key}: {shown(values)} given; "
                f"allowed: values of the grid, {shown(allowed)}; change it or add it to the grid"
            )
