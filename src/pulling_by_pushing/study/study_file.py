"""Read study files, and find reasons why a well-formed study cannot be computed."""

from __future__ import annotations

import math
import os
from collections.abc import Collection, Iterable, Iterator, Mapping
from functools import lru_cache
from pathlib import Path

from planar_pushing.mechanics.effects import EFFECTS
from planar_pushing.scenes.files import load_model, load_scene_file
from planar_pushing.scenes.scene_model import SceneFile
from planar_pushing.terms.domain import LONGEST
from planar_pushing.terms.errors import InvalidFile, suggestion
from planar_pushing.terms.replacing import PathLike
from pulling_by_pushing.study.catalog import DATASETS
from pulling_by_pushing.study.model import StudyFile
from pulling_by_pushing.study.slices import computes

#: Maximum number of points of a dataset's grid, which fill a terabyte.
POINTS = 10**10


def load_study(path: PathLike) -> StudyFile:
    """Read a study file and check its scenes; errors as in `load_scene`.

    Paths in the file are relative to its folder; in the returned study, to the current folder.
    """
    study = _resolve_paths(load_model(path, StudyFile), Path(path).parent)
    for problem in _study_problems(study):
        raise InvalidFile(f"{path}: {problem}")
    return study


def scene_file(path: PathLike) -> SceneFile:
    """Scene file that a study names, read again only if it has changed; errors as in `load_scene_file`."""
    file = Path(path)
    state = file.stat() if file.is_file() else None
    return _scene_file(file, state and (state.st_mtime_ns, state.st_size))


@lru_cache(maxsize=64)
def _scene_file(file: Path, stamp: object) -> SceneFile:
    return load_scene_file(file)


def _resolve_paths(study: StudyFile, folder: Path) -> StudyFile:
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
    """Reasons why a well-formed study cannot be computed."""
    computed = [name for name in DATASETS if computes(study, name)]
    if not computed:
        yield "grid: no dataset has all its axes; allowed: all axes of at least one; add axes"
    yield from _effects_problems(study)
    yield from _support_problems(study)
    yield from _rod_problems(study, computed)
    yield from _size_problems(study, computed)
    yield from _chunk_problems(study, computed)
    yield from _scene_problems(study)
    yield from _simulation_problems(study.simulations)
    if study.inertia and study.inertia.gyration_radius != study.slider.radius:
        yield (
            f"inertia.gyration_radius: {study.inertia.gyration_radius!r} given; allowed: the radius of "
            f"the ring, {study.slider.radius!r}, which the paper's bound assumes; change it"
        )
    if study.golden and not Path(study.golden).is_dir():
        yield f"golden: {study.golden!r} given; allowed: a folder of golden data; leave the key out"


def _size_problems(study: StudyFile, computed: Iterable[str]) -> Iterator[str]:
    """Datasets with too many points."""
    for name in computed:
        axes = DATASETS[name].axes
        count = math.prod(len(study.values(axis, name)) for axis in axes)
        if count > POINTS:
            yield (
                f"grid: {count} points of {name} given; allowed: {POINTS}; "
                f"shorten the axes {', '.join(axes)}"
            )


def _chunk_problems(study: StudyFile, computed: Collection[str]) -> Iterator[str]:
    """Chunks of datasets that cannot be split, chunks along invalid axes, and `gather` without chunks."""
    splittable = [name for name in computed if DATASETS[name].dims]
    for name, chunk in study.chunks.items():
        allowed = DATASETS[name].dims if name in splittable else ()
        if not allowed:
            remedy = suggestion(name, splittable, "remove it")
            yield f"chunks.{name}: unknown, or not computed; allowed: {', '.join(splittable)}; {remedy}"
        elif not chunk or not set(chunk) <= set(allowed):
            yield f"chunks.{name}: {list(chunk)} given; allowed: {', '.join(allowed)}; name some of these"
    for name in study.gather:
        if name not in study.chunks:
            known = ", ".join(study.chunks) or "none, as there are no chunks"
            remedy = suggestion(name, study.chunks, "remove it, or give its chunks")
            yield f"gather.{name}: unknown; allowed: {known}; {remedy}"


def _support_problems(study: StudyFile) -> Iterator[str]:
    """Supports that are too small for the rods."""
    grids = {"grid": study.grid} | {
        f"fine_grids.{key}": grid for key, grid in study.fine_grids.items()
    }
    lengths = {key: grid.rod_length for key, grid in grids.items() if grid.rod_length}
    if study.slider.rod_length:
        lengths["slider"] = (study.slider.rod_length,)
    for key, values in lengths.items():
        for name, support in study.gallery().items():
            if values[-1] > LONGEST * support.extent:
                yield (
                    f"{key}.rod_length: {values[-1]!r} given; allowed: at most {LONGEST:g} times the "
                    f"extent of supports.{name}, {support.extent!r}; shorten the rod"
                )


def _rod_problems(study: StudyFile, computed: Iterable[str]) -> Iterator[str]:
    """Datasets for the rod of a slider without a rod length."""
    for name in computed:
        if DATASETS[name].rod and study.slider.rod_length is None:
            yield f"slider.rod_length: missing; allowed: a length > 0, for {name}; add it"


def _scene_problems(study: StudyFile) -> Iterator[str]:
    """Scene files that cannot be read, or that have a side on the fence or effects that the study lacks."""
    for name, push in study.scenes.items():
        try:
            file = scene_file(push.file)
        except InvalidFile as error:
            yield f"scenes.{name}.file: {error}"
            continue
        kinds = {EFFECTS[effect.type].kind for effect in file.effects}
        if file.slider.flush:
            yield (
                f"scenes.{name}.file: {push.file} has a side on the fence; allowed: contacts at one point; "
                "name another scene, or list this one under simulations"
            )
        if not kinds <= set(study.parts):
            yield (
                f"scenes.{name}.file: {push.file} lists {', '.join(sorted(kinds))}; allowed: the effects "
                f"of the study, {', '.join(study.parts)}; name another scene"
            )


def _simulation_problems(simulations: Mapping[str, str]) -> Iterator[str]:
    """Scene files that cannot be simulated."""
    for name, path in simulations.items():
        try:
            section = scene_file(path).simulate
        except InvalidFile as error:
            yield f"simulations.{name}: {error}"
            continue
        if section is None:
            yield (
                f"simulations.{name}: {path} given; allowed: scene files with the section simulate; "
                "add it to the file"
            )


def _effects_problems(study: StudyFile) -> Iterator[str]:
    """Effects of the grid without parameters in the study."""
    for name in study.grid.effects:
        for part in name.split("+"):
            if part not in study.parts:
                yield (
                    f"grid.effects: {name!r} given; allowed: effects that the study has parameters for; "
                    f"add the key {part}, or remove the entry"
                )
