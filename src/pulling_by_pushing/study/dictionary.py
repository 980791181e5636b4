"""The data dictionary, results/README.md, from the attributes of the datasets: `make dictionary`."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterable, Iterator
from pathlib import Path

import xarray as xr

from planar_pushing.terms.netcdf import group_names
from planar_pushing.terms.quantities import FINGER, LOG, NOTES, unit_of
from planar_pushing.terms.replacing import replacing
from pulling_by_pushing.study.catalog import DATASETS, EVIDENCE, SIMULATIONS, TABLES
from pulling_by_pushing.study.running.jobs import run_command
from pulling_by_pushing.study.store import open_dataset
from pulling_by_pushing.study.studies import SLIDERS_FILE, study_name

#: The study of sliders.
STUDY = study_name(SLIDERS_FILE)
#: Variables that only some logs have.
MORE_OF_LOGS = {
    "A log of a fence and a slider with an outline or a side on the fence": ("flush", "contact_position"),
    "A log with the object's pose in the world": (
        "object_position", "object_angle", "pusher_position",
    ),
}  # fmt: skip

HEAD = """# Data dictionary

The pipeline generates everything in this folder except this page:

- `data/` holds the datasets.
- `figures/` holds the figures.
- `tables/` holds the golden verdict and the tables of the report.
- `paper.pdf` is the report.
- `manual/` is the manual, and `report.html` Snakemake's report.
- `logs/` and `benchmarks/` hold a file for each job.
- `studies/NAME/` holds the same for a study other than the paper's, and in `chunks/` the parts from which
  its datasets are assembled; `studies/sliders/` belongs to the study of sliders.

`make dictionary` writes this page from the attributes of the datasets.

The datasets are netCDF4 files that follow the CF conventions. `planar_pushing.open_dataset("motion_cones")`
opens a dataset with xarray, `open_dataset(name, study="NAME")` opens one of another study, and
`planar-pushing query` prints part of a dataset. The attributes `study` and `study_digest` are the name of
the study and a hash of the values from which the dataset is computed.
Angles are in degrees, counterclockwise from the fence. NaN marks values that do not exist. The center of
rotation of a translation has infinite coordinates. Booleans are stored as bytes and read back as
`bool`.
"""


def dictionary_text(results: str = "results") -> str:
    """Text of the page for the datasets in a results folder."""
    units = "\n".join(f"- *{unit}*: {note}." for unit, note in NOTES.items())
    of_paper = [name for name in DATASETS if not name.startswith("support")]
    sections = [
        *(_section(name, DATASETS[name].about, results) for name in of_paper),
        _simulations(results),
        *(_section(name, about, results) for name, about in EVIDENCE.items()),
        _tables(),
        *_sliders(results, [name for name in DATASETS if name not in of_paper]),
    ]
    scaled = (
        "Dimensional quantities are stored in scaled units: `units` is 1, and the attribute `quantity` is "
        "one of these:\n"
    )
    return "\n".join([HEAD, scaled, units, "", *sections])


def _lines(title: str, about: str, *lines: str) -> str:
    return "\n".join([f"## {title}", "", f"{about[0].upper()}{about[1:]}.", "", *lines]) + "\n"


def _simulations(results: str) -> str:
    """Section of the simulation logs, which share their variables."""
    first = min((Path(results) / "data" / SIMULATIONS).glob("*.nc")).stem
    dataset = open_dataset(f"{SIMULATIONS}/{first}", results)
    about = "motion over time, one log for each simulation"
    finger = "The log of a finger differs in these variables:"
    rows = [*_table([dataset]), "", finger, "", *_finger_table()]
    for log, names in MORE_OF_LOGS.items():
        rows += ["", f"{log} also holds:", "", *_added_table(names)]
    return _lines(f"data/{SIMULATIONS}/NAME.nc", about, *_source(dataset), *rows)


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
    parts = [open_dataset(f"{name}/{each}", results) for each in groups]
    if parts:
        listed = "Groups: " + ", ".join(f"`{group}`" for group in groups) + "."
        return _lines(f"data/{name}.nc", about, listed, "", *_table(parts))
    dataset = open_dataset(name, results)
    return _lines(f"data/{name}.nc", about, *_source(dataset), *_table([dataset]))


def _sliders(results: str, names: Iterable[str]) -> Iterator[str]:
    """Sections of the datasets of the study of sliders."""
    for name in names:
        dataset = open_dataset(name, results, study=STUDY)
        place = f"studies/{STUDY}/data/{name}.nc"
        yield _lines(place, DATASETS[name].about, *_source(dataset), *_table([dataset]))


def _tables() -> str:
    rows = [f"- `tables/{name}`: {what}." for name, what in TABLES.items()]
    return _lines("tables/", "the tables that the report is typeset from", *rows)


def _source(dataset: xr.Dataset) -> tuple[str, ...]:
    return f"Source: {dataset.attrs['source']}.", ""


def _table(datasets: Iterable[xr.Dataset]) -> Iterator[str]:
    """Rows of variables and coordinates, without duplicates."""
    yield "| name | dims | unit | meaning |"
    yield "| --- | --- | --- | --- |"
    rows = (_row(name, data[name]) for data in datasets for name in (*data.coords, *data.data_vars))
    yield from dict.fromkeys(rows)


def _row(name: object, variable: xr.DataArray) -> str:
    meaning = variable.attrs["long_name"]
    if "flag_meanings" in variable.attrs:
        flags = variable.attrs.get("flag_values", variable.attrs.get("flag_masks", ()))
        words = variable.attrs["flag_meanings"].split()
        meaning += ": " + ", ".join(
            f"{value} {word}" for value, word in zip(flags, words, strict=True)
        )
    if "comment" in variable.attrs:
        meaning += f"; {variable.attrs['comment']}"
    dims = ", ".join(map(str, variable.dims)) or "-"
    return f"| `{name}` | {dims} | {unit_of(variable.attrs)} | {meaning} |"


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
