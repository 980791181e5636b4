"""Figures of a study: those that its file lists, with the values that each takes from it."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

from planar_pushing.scenes.yaml_text import shown
from planar_pushing.terms.errors import InvalidFile
from planar_pushing.terms.replacing import PathLike
from pulling_by_pushing.figures.figure import Figure, entry, figure_names
from pulling_by_pushing.study.catalog import DATASETS, SIMULATIONS
from pulling_by_pushing.study.model import FigureEntry, StudyFile
from pulling_by_pushing.study.slices import computes
from pulling_by_pushing.study.study_file import load_study

#: Figures on measured pushes, drawn from numbers in the project's folder.
PUSHES = ("measured_pressures", "measured_errors")
#: Figures on the computations and predictions of this work, in the order of the report; they are the same
#: for every study.
OURS = (*PUSHES, "accuracy_wrench", "accuracy_cone_motion", "effects", "hard_cases")


def numbered() -> list[str]:
    """Names of the numbered figures, which a study can list, in order."""
    return [name for name in figure_names() if name not in OURS]


def load_drawn_study(path: PathLike) -> StudyFile:
    """Read a study file and check its figures too; errors as in `load_study`."""
    study = load_study(path)
    for problem in problems(study):
        raise InvalidFile(f"{path}: {problem}")
    return study


def settings(study: StudyFile, name: str) -> dict[str, Any]:
    """Values of a figure: those of its entry, and the rod of the study if the entry gives none."""
    given = study.figures.get(name, FigureEntry()).model_dump()
    rod = {"rod_length": study.slider.rod_length, "rod_angle": study.slider.rod_angle}
    return rod | {key: each for key, each in given.items() if each is not None}


def problems(study: StudyFile) -> Iterator[str]:
    """Reasons why figures listed by a study cannot be drawn."""
    known = numbered()
    for name, given in study.figures.items():
        if name not in known:
            yield f"figures.{name}: unknown; allowed: {', '.join(known)}; remove it"
            continue
        figure = entry(name)
        yield from _missing_sources(study, name, figure)
        yield from _missing_values(study, name, figure)
        for key, values, allowed in given.grid_values(study.grid):
            if not set(values) <= set(allowed):
                yield (
                    f"figures.{name}.{key}: {shown(values)} given; allowed: values of the grid, "
                    f"{shown(allowed)}; change it or add it to the grid"
                )


def _missing_sources(study: StudyFile, name: str, figure: Figure) -> Iterator[str]:
    """Problems with datasets, scenes, logs and effects that a figure needs and the study lacks."""
    if figure.needs and figure.needs not in study.grid.effects:
        yield f"figures.{name}: shows {figure.needs}; allowed: where grid.effects lists it; remove it"
        return
    for source in figure.reads:
        stem, _, group = source.partition("/")
        parts: dict[str, Any] = {"scenes": study.scenes, SIMULATIONS: study.simulations}
        part = parts.get(stem)
        if part is not None and group not in part:
            yield f"{stem}.{group}: missing; allowed: an entry, from which figures.{name} is drawn; add it"
        if part is None and stem in DATASETS and not computes(study, stem):
            axes = ", ".join(DATASETS[stem].axes)
            yield f"figures.{name}: drawn from {stem}; allowed: where the grid has {axes}; remove it"


def _missing_values(study: StudyFile, name: str, figure: Figure) -> Iterator[str]:
    """Problems with values that a figure lacks, and with axis values at which it cuts a dataset."""
    found = settings(study, name)
    for key in figure.takes:
        if found.get(key) is None:
            yield f"figures.{name}.{key}: missing; allowed: values of the grid; add it"
    axes = {axis for source in figure.reads for axis in _axes(source)}
    cuts: dict[str, Any] = {
        "rod_angle": study.slider.rod_angle,
        "rod_length": study.slider.rod_length,
        **figure.at,
    }
    for axis, value in cuts.items():
        given = getattr(study.grid, axis)
        own = axis == "rod_length" and study.figures[name].rod_length is not None
        if axis in axes and value is not None and value not in given and not own:
            yield (
                f"grid.{axis}: {shown(given)} given; allowed: values that include {value!r}, "
                f"at which figures.{name} is drawn; add it, or remove the figure"
            )


def _axes(source: str) -> tuple[str, ...]:
    stem = source.partition("/")[0]
    return tuple(DATASETS[stem].axes) if stem in DATASETS and stem != "scenes" else ()


def pictures(results: Path, study: StudyFile) -> dict[str, Path]:
    """PNG files of the figures of a study and of their variants, by name."""
    found = {}
    for name in study.figures:
        for variant in entry(name).variants:
            found[name + variant] = results / "figures" / f"{name}{variant}.png"
    return found
