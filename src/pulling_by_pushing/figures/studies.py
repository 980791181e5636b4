"""Figures of a study: those that its file lists, with the values at which they cut its datasets."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from planar_pushing.scenes.yaml_text import format_entry
from planar_pushing.terms.errors import InvalidFile, suggestion
from planar_pushing.terms.replacing import PathLike
from pulling_by_pushing.figures.figure import Figure, cuts_of, entry
from pulling_by_pushing.study.catalog import DATASETS, SIMULATIONS
from pulling_by_pushing.study.model import StudyFile
from pulling_by_pushing.study.slices import computes
from pulling_by_pushing.study.study_file import load_study

#: Figures by section of the workflow. One job draws a section, because its figures share datasets, and
#: because starting Python and importing what draws takes longer than drawing one figure.
SECTIONS = {
    "quasi_static": tuple(f"figure_{number:02}" for number in range(1, 9)),
    "dynamic": tuple(f"figure_{number:02}" for number in range(9, 13)),
    "contact_modes": ("figure_13",),
    "motion": ("pulling_over_time", "slip_over_time"),
    "effects": ("model_errors",),
    "any_slider": (
        "friction_for_pulling", "support_limit_curves", "slip_of_supports", "pivoting_tripod",
    ),
    "accuracy": ("accuracy", "hard_cases"),
    "pushes": ("measured_pressures", "measured_errors"),
}  # fmt: skip
#: Figures on measured pushes, drawn from numbers in the project's folder.
PUSHES = SECTIONS["pushes"]
#: Figures on the computations and predictions of this work; they are the same for every study.
OURS = (*PUSHES, *SECTIONS["accuracy"])
#: Figures in the order in which the report mentions them; numbers of its supplement begin with S.
BODY = (
    *(f"figure_{number:02}" for number in range(1, 14)),
    "friction_for_pulling", "measured_errors", "accuracy", "model_errors", "hard_cases",
)  # fmt: skip
SUPPLEMENT = (
    "pulling_over_time", "slip_over_time", "support_limit_curves", "slip_of_supports", "pivoting_tripod",
    "measured_pressures",
)  # fmt: skip
#: Printed number of each figure.
NUMBERS = {name: str(number) for number, name in enumerate(BODY, 1)} | {
    name: f"S{number}" for number, name in enumerate(SUPPLEMENT, 1)
}


def study_figures() -> list[str]:
    """Names of the figures that a study can list, in the order of the report."""
    return [name for name in NUMBERS if name not in OURS]


def load_drawn_study(path: PathLike) -> StudyFile:
    """Read a study file and check its figures too; errors as in `load_study`."""
    study = load_study(path)
    for problem in problems(study):
        raise InvalidFile(f"{path}: {problem}")
    return study


def cuts(study: StudyFile, name: str) -> dict[str, Any]:
    """Values at which a figure cuts its datasets: those of its entry, and otherwise the study's rod."""
    rod = study.slider.model_dump(include={"rod_length", "rod_angle"}, exclude_none=True)
    listed = study.figures.get(name)
    return rod | (listed.model_dump(exclude_none=True) if listed else {})


def problems(study: StudyFile) -> Iterator[str]:
    """Reasons why figures listed by a study cannot be drawn."""
    known = study_figures()
    for name in study.figures:
        if name not in known:
            remedy = suggestion(name, known, "remove it")
            yield f"figures.{name}: unknown; allowed: {', '.join(known)}; {remedy}"
            continue
        figure = entry(name)
        yield from _missing_sources(study, name, figure)
        yield from _missing_entries(study, name, figure)
        for source in figure.reads:
            yield from _missing_values(study, name, figure, source)


def _missing_sources(study: StudyFile, name: str, figure: Figure) -> Iterator[str]:
    """Problems with datasets, scenes and logs that a figure reads and the study lacks."""
    for source in figure.reads:
        stem, _, group = source.partition("/")
        parts: dict[str, Any] = {"scenes": study.scenes, SIMULATIONS: study.simulations}
        part = parts.get(stem)
        if part is not None and group not in part:
            yield f"{stem}.{group}: missing; allowed: an entry, from which figures.{name} is drawn; add it"
        if part is None and stem in DATASETS and not computes(study, stem):
            yield (
                f"figures.{name}: drawn from {stem}; allowed: where the study gives "
                f"{DATASETS[stem].needs or stem}; remove it"
            )


def _missing_entries(study: StudyFile, name: str, figure: Figure) -> Iterator[str]:
    """Problems with values that a figure takes from its entry, and with datasets that it does not read."""
    values = cuts(study, name)
    for key in figure.takes:
        source, _, axis = key.rpartition(".")
        if axis not in (values.get(source, {}) if source else values):
            yield f"figures.{name}.{key}: missing; allowed: values of the grid; add it"
    for key, value in values.items():
        if isinstance(value, Mapping) and key not in figure.reads:
            yield f"figures.{name}.{key}: given; allowed: {', '.join(figure.reads)}; remove it"


def _missing_values(study: StudyFile, name: str, figure: Figure, source: str) -> Iterator[str]:
    """Problems with values at which a figure cuts a dataset that does not have them."""
    listed = study.figures[name].model_dump(exclude_none=True)
    for axis, value in cuts_of(figure, source, cuts(study, name)).items():
        if source not in DATASETS or axis not in DATASETS[source].dims:
            continue
        values = tuple(value) if isinstance(value, (list, tuple)) else (value,)
        allowed, axis_key = study.values(axis, source), study.axis_key(axis, source)
        lacking = [item for item in values if item not in allowed]
        key = f"{source}.{axis}" if axis in listed.get(source, {}) else axis
        if lacking and (key != axis or axis in listed):
            yield (
                f"figures.{name}.{key}: {format_entry(values)} given; allowed: values of {axis_key}, "
                f"{format_entry(allowed)}; change it or add it there"
            )
        elif lacking:
            yield (
                f"{axis_key}: {format_entry(allowed)} given; allowed: values that include {lacking[0]!r}, "
                f"at which figures.{name} is drawn; add it, or remove the figure"
            )


def pictures(results: Path, study: StudyFile) -> dict[str, Path]:
    """PNG files of the figures of a study, by name."""
    return {name: results / "figures" / f"{name}.png" for name in study.figures}
