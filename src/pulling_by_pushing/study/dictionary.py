"""The data dictionary, results/README.md, from the attributes of the datasets: `make dictionary`."""

from __future__ import annotations

import argparse
import math
import re
import sys
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any

import xarray as xr

from planar_pushing.terms.netcdf import group_names
from planar_pushing.terms.quantities import FINGER, LOG, NOTES, PAPER, unit_of
from planar_pushing.terms.replacing import replacing
from pulling_by_pushing.study.catalog import DATASETS, EVIDENCE, GROUPS, SIMULATIONS, TABLES
from pulling_by_pushing.study.running.jobs import run_command
from pulling_by_pushing.study.store import open_dataset, read_dataset
from pulling_by_pushing.study.studies import PAPER_FILE, SLIDERS_FILE, study_name
from pulling_by_pushing.study.study_file import load_study

#: The study of sliders.
STUDY = study_name(SLIDERS_FILE)
#: Variables that only some logs have.
MORE_OF_LOGS = {
    "A log of a fence and a slider with an outline or a side on the fence": ("flush", "contact_position"),
    "A log of a slider with inertia, integrated from event to event,": ("impulse",),
    "A log with the object's pose in the world": (
        "object_position", "object_angle", "pusher_position",
    ),
}  # fmt: skip

#: What each dataset answers, and an example: the words after `planar-pushing query`.
QUESTIONS: Mapping[str, tuple[str, str]] = {
    "limit_curves": (
        "How does the slider move under a force through the contact, and how large is the force?",
        "limit_curves --effects inertia --rod-length 2 --rod-angle 45 --force-angle 90",
    ),
    "curves": (
        "The same at fine force angles, for drawing",
        "curves --effects support_friction --rod-length 2 --force-angle 135",
    ),
    "motion_cones": (
        "For which motions of the fence does the contact stick? Can it pull? Can a push slip?",
        "motion_cones --effects support_friction --rod-length 2 --rod-angle 45 --friction-coefficient 2",
    ),
    "contact_modes": (
        "Which motions of the slider are consistent with a motion of the fence?",
        "contact_modes --effects support_friction --contact coulomb_2 --rod-length 2 "
        "--pusher-magnitude 1 --pusher-angle -10",
    ),
    "mode_maps": (
        "Which contact modes are possible, over friction and directions of the fence?",
        "mode_maps --effects support_friction --contact coulomb_2 --rod-length 2 "
        "--pusher-magnitude 1 --pusher-angle -10",
    ),
    "acceleration_centers": (
        "About which point does the slider accelerate, for each share of inertia?",
        "acceleration_centers --rod-length 5 --force-angle 90 --inertia-share 0.5",
    ),
    "center_regions": (
        "Where can this point be, by the bound of the paper and exactly?",
        "center_regions --rod-length 5 --rod-angle 45 --force-angle 90",
    ),
    "scenes": ("What happens in the scenes of Figs. 2, 3, 8, 9, 11 and 12?", "scenes/figure_03"),
    "model_errors": (
        "What changes in a push if inertia or friction is left out, and what do both cost?",
        "model_errors --support base --left-out inertia --speed 0.05",
    ),
    "model_estimates": (
        "How well does an estimate tell what an effect changes that is left out?",
        "model_estimates --effect inertia",
    ),
    SIMULATIONS: ("How does the slider move over time?", "simulations/pulling"),
    "accuracy": ("How accurate is each method, after how many evaluations?", "accuracy/cone"),
    "accuracy_time": ("How long does each method take?", "accuracy_time/cone"),
    "effects": ("What does each effect cost?", "effects"),
    "hard_cases": ("How large are the errors where the problem is hard?", "hard_cases"),
    "supports": (
        "Which wrench does a motion need on each support, and how far off is its ellipsoid?",
        "supports --study sliders --support tripod --center-x 1 --center-y 0.5",
    ),
    "support_cones": (
        "For which motions of the fence does the contact stick on each support?",
        "support_cones --study sliders --support tripod --rod-length 2 --rod-angle 45 "
        "--friction-coefficient 0.25",
    ),
    "support_modes": (
        "Which motions are consistent on each support?",
        "support_modes --study sliders --support tripod --rod-length 2 --rod-angle 45 "
        "--friction-coefficient 2 --pusher-angle -10",
    ),
    "support_curves": (
        "How large is the force on each support?",
        "support_curves --study sliders --support square --force-angle 135",
    ),
    "support_rods": (
        "How much friction does pulling need, over lengths and angles of the rod?",
        "support_rods --study sliders --support square",
    ),
}  # fmt: skip
#: Largest number of flags that a cell of a table lists.
FLAGS = 6

HEAD = """# Data dictionary

This page describes the results. `make dictionary` writes it from the attributes of the datasets; the
pipeline writes everything else in this folder:

- `data/` holds the datasets.
- `figures/` holds the figures.
- `tables/` holds the golden verdict and the tables of the report.
- `paper.pdf` is the report, and `manual/` the manual.
- `logs/` and `benchmarks/` hold a file for each job.
- `studies/NAME/` holds the same for a study other than the paper's, and in `chunks/` the parts from which
  its datasets are assembled; `studies/sliders/` belongs to the study `sliders`.

## Datasets

`planar-pushing query` with the words in the last column prints an example, and `planar-pushing query NAME
--axes` prints the values along the axes of a dataset.

"""
CONVENTIONS = """
In Python, `planar_pushing.open_dataset("motion_cones")` opens a dataset with xarray, and
`open_dataset("supports", study="sliders")` opens one of another study.

The datasets are netCDF4 files that follow the CF conventions. Angles are in degrees, counterclockwise from
the fence. NaN marks values that do not exist. The center of rotation of a translation has infinite
coordinates. Booleans are stored as bytes and read back as `bool`. The attributes `study` and `study_digest`
are the name of the study and a hash of the values from which the dataset is computed. *Source* is the place
in Lynch and Mason, *Pulling by Pushing, Slip with Infinite Friction, and Perfectly Rough Surfaces* (1995).

`model_errors` and `model_estimates` are in SI units. In the other datasets, dimensional quantities are
stored in scaled units: `units` is 1, and the attribute `quantity` is one of these:
"""


def dictionary_text(results: str = "results") -> str:
    """Text of the page for the datasets in a results folder."""
    units = "\n".join(f"- *{unit}*: {note}." for unit, note in NOTES.items())
    of_paper = [name for name in DATASETS if not _is_of_sliders(name)]
    sections = [
        *(_section(name, DATASETS[name].about, results) for name in of_paper),
        _simulations(results),
        *(_section(name, about, results) for name, about in EVIDENCE.items()),
        _tables(),
        *_sliders(results, [name for name in DATASETS if name not in of_paper]),
    ]
    return "\n".join([HEAD + "\n".join(_overview(results)), CONVENTIONS, units, "", *sections])


def _overview(results: str) -> Iterator[str]:
    """Rows of the datasets with their questions, for the grids of the project's studies."""
    yield "| dataset | question | axes or groups | points | query |"
    yield "| --- | --- | --- | --- | --- |"
    for name, (question, query) in QUESTIONS.items():
        axes, points = _size(name, results)
        link = f"[`{name}`](#{_anchor(_title(name))})"
        yield f"| {link} | {question} | {axes} | {points} | `{query}` |"


def _size(name: str, results: str) -> tuple[str, str]:
    """Axes of a dataset with their sizes, or its groups, and the number of points of its grid."""
    study = load_study(SLIDERS_FILE if _is_of_sliders(name) else PAPER_FILE)
    groups = {**GROUPS, "scenes": study.scenes, SIMULATIONS: study.simulations}
    if name in groups:
        return ", ".join(f"`{group}`" for group in groups[name]), ""
    if name in EVIDENCE:
        return _axes(open_dataset(name, results).sizes), ""
    dataset = DATASETS[name]
    if dataset.section:
        sizes_of_section = read_dataset(Path(study.golden) / f"{name}.nc").sizes
        return _axes(sizes_of_section), f"{math.prod(sizes_of_section.values()):,}"
    sizes = {axis: len(study.values(axis, name)) for axis in dataset.axes}
    if dataset.pushes:
        sizes["force_angle"] = sum(0 <= angle <= 180 for angle in study.values("force_angle", name))
    if dataset.reads:  # two sweeps, one after the other
        sizes["rod"] = sum(sizes.pop(axis) for axis in dataset.reads)
    return _axes(sizes), f"{math.prod(sizes.values()):,}"


def _axes(sizes: Mapping[Any, int]) -> str:
    return ", ".join(f"`{axis}` {size}" for axis, size in sizes.items())


def _is_of_sliders(name: str) -> bool:
    return name in DATASETS and "support" in DATASETS[name].dims


def _title(name: str) -> str:
    """Heading of the section of a dataset, its file in the results."""
    file = f"data/{name}/NAME.nc" if name == SIMULATIONS else f"data/{name}.nc"
    return f"studies/{STUDY}/{file}" if _is_of_sliders(name) else file


def _anchor(title: str) -> str:
    """Anchor of a heading, as Sphinx and GitHub make it."""
    return re.sub(r"[^\w-]", "", title.lower())


def _lines(title: str, about: str, *lines: str) -> str:
    return "\n".join([f"## {title}", "", f"{about[0].upper()}{about[1:]}.", "", *lines]) + "\n"


def _simulations(results: str) -> str:
    """Section of the simulation logs, which share their variables, from that of a pull."""
    dataset = open_dataset(f"{SIMULATIONS}/pulling", results)
    about = "motion over time, one log for each simulation"
    finger = "The log of a finger differs in these variables:"
    rows = [*_table([dataset]), "", finger, "", *_finger_table()]
    for log, names in MORE_OF_LOGS.items():
        rows += ["", f"{log} also holds:", "", *_added_table(names)]
    return _lines(_title(SIMULATIONS), about, *_source(dataset), *rows)


def _finger_table() -> Iterator[str]:
    """Rows of the variables that a finger's log adds or defines differently."""
    yield "| name | unit | meaning |"
    yield "| --- | --- | --- |"
    for name, (unit, meaning) in FINGER.items():
        if LOG.get(name) != (unit, meaning):
            yield f"| `{name}` | {unit} | {meaning} |"


def _added_table(names: Iterable[str]) -> Iterator[str]:
    """Rows of variables that only some logs have."""
    yield "| name | unit | meaning |"
    yield "| --- | --- | --- |"
    for name in names:
        unit, meaning = LOG[name]
        yield f"| `{name}` | {unit} | {meaning} |"


def _section(name: str, about: str, results: str) -> str:
    """Section of a dataset, or of its groups if it has any."""
    groups = group_names(Path(results) / "data" / f"{name}.nc")
    datasets = [open_dataset(f"{name}/{group}", results) for group in groups]
    if datasets:
        group_line = "Groups: " + ", ".join(f"`{group}`" for group in groups) + "."
        return _lines(_title(name), about, group_line, "", *_table(datasets))
    dataset = open_dataset(name, results)
    return _lines(_title(name), about, *_source(dataset), *_table([dataset]))


def _sliders(results: str, names: Iterable[str]) -> Iterator[str]:
    """Sections of the datasets of the study of sliders."""
    for name in names:
        dataset = open_dataset(name, results, study=STUDY)
        yield _lines(_title(name), DATASETS[name].about, *_source(dataset), *_table([dataset]))


def _tables() -> str:
    rows = [f"- `tables/{name}`: {what}." for name, what in TABLES.items()]
    return _lines("tables/", "the tables that the report is typeset from", *rows)


def _source(dataset: xr.Dataset) -> tuple[str, ...]:
    section = dataset.attrs["source"].removeprefix(f"{PAPER}, ")
    return f"Source: {section}.", ""


def _table(datasets: Iterable[xr.Dataset]) -> Iterator[str]:
    """Rows of variables and coordinates, without duplicates, and the flags of those that have many."""
    yield "| name | dims | unit | meaning |"
    yield "| --- | --- | --- | --- |"
    variables = [(str(name), data[name]) for data in datasets
                 for name in (*data.coords, *data.data_vars)]  # fmt: skip
    yield from dict.fromkeys(_row(name, variable) for name, variable in variables)
    for name, variable in variables:
        if len(flags := _flags(variable)) > FLAGS:
            yield from ("", f"Values of `{name}`:", "", *(f"- `{flag}`" for flag in flags))


def _row(name: str, variable: xr.DataArray) -> str:
    meaning = variable.attrs["long_name"]
    if flags := _flags(variable):
        meaning += (
            f": {', '.join(flags)}" if len(flags) <= FLAGS else "; the values are listed below"
        )
    if "comment" in variable.attrs:
        meaning += f"; {variable.attrs['comment']}"
    dims = ", ".join(map(str, variable.dims)) or "-"
    return f"| `{name}` | {dims} | {unit_of(variable.attrs)} | {meaning} |"


def _flags(variable: xr.DataArray) -> list[str]:
    """Values of a flag variable with their names."""
    values = variable.attrs.get("flag_values", variable.attrs.get("flag_masks", ()))
    names = variable.attrs.get("flag_meanings", "").split()
    return [f"{value} {name}" for value, name in zip(values, names, strict=True)]


def main() -> int:
    """Write the page into the results folder that it describes."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--results", default="results")
    folder = parser.parse_args().results
    path = Path(folder) / "README.md"
    with replacing(path) as temporary:
        temporary.write_text(dictionary_text(folder), encoding="utf-8")
    print(f"wrote {path}")
    return 0


if __name__ == "__main__":
    sys.exit(run_command(main))
