"""Files of studies of sliders: reading one, what keeps it from being computed, and which kind a file is."""

from __future__ import annotations

import math
import os
from collections.abc import Iterator
from pathlib import Path

from planar_pushing.study.catalog import SLIDERS_AXES
from planar_pushing.study.files.replacing import PathLike
from planar_pushing.study.files.scenes import load_model
from planar_pushing.study.files.sliders_model import SlidersFile, Study, kind_of
from planar_pushing.study.files.support_model import is_point
from planar_pushing.study.files.yaml_text import read_yaml, shown
from planar_pushing.study.study_file import POINTS, load_study, simulation_problems
from planar_pushing.terms.domain import LONGEST
from planar_pushing.terms.errors import InvalidFile, require_path


def load_any(path: PathLike) -> Study:
    """Read a study of either kind; errors and paths as in `load_study`."""
    content = read_yaml(Path(require_path("path", path)))
    return load_sliders(path) if kind_of(content) is SlidersFile else load_study(path)


def load_sliders(path: PathLike) -> SlidersFile:
    """Read the file of a study of sliders; errors and paths as in `load_study`."""
    study = _located(load_model(path, SlidersFile), Path(path).parent)
    for problem in _problems(study):
        raise InvalidFile(f"{path}: {problem}")
    return study


def _located(study: SlidersFile, folder: Path) -> SlidersFile:
    simulations = {
        name: os.path.normpath(folder / file) for name, file in study.simulations.items()
    }
    golden = study.golden and os.path.normpath(folder / study.golden)
    return study.model_copy(update={"simulations": simulations, "golden": golden})


def _problems(study: SlidersFile) -> Iterator[str]:
    """What keeps a well-formed study of sliders from being computed and drawn."""
    yield from _support_problems(study)
    yield from _size_problems(study)
    yield from _axis_problems(study)
    yield from simulation_problems(study.simulations)
    if study.golden and not list(Path(study.golden).glob("*.nc")):
        yield f"golden: {study.golden!r} given; allowed: a folder of golden data; leave the key out"


def _support_problems(study: SlidersFile) -> Iterator[str]:
    """Supports that resist no rotation, or that are too small for the rods."""
    longest = max(*study.grid.rod_length, study.slider.rod_length)
    for name, support in study.gallery().items():
        if is_point(support):
            yield (
                f"supports.{name}: one point given; allowed: a support that is larger than a point, which "
                "resists no rotation; leave it out"
            )
        elif longest > LONGEST * support.extent:
            yield (
                f"grid.rod_length: {longest!r} given; allowed: at most {LONGEST:g} times the extent of "
                f"supports.{name}, {support.extent!r}; shorten the rod"
            )


def _axis_problems(study: SlidersFile) -> Iterator[str]:
    """Axes of the grid without the value that the figures plot."""
    wanted = study.slider.model_dump() | {"friction_coefficient": math.inf}
    for key, value in wanted.items():
        values = getattr(study.grid, key)
        if value not in values:
            yield (
                f"grid.{key}: {shown(values)} given; allowed: values that include {value!r}, "
                "which the figures plot; add it"
            )


def _size_problems(study: SlidersFile) -> Iterator[str]:
    """Datasets of more points than a memory holds."""
    for name, axes in SLIDERS_AXES.items():
        lengths = [len(getattr(study.grid, axis)) for axis in axes]
        points = math.prod(lengths) * len(study.supports)
        if points > POINTS:
            yield (
                f"grid: {points} points of {name} given; allowed: {POINTS}; "
                f"shorten the axes {shown(', '.join(axes))}"
            )
