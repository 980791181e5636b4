"""The data dictionary, results/README.md, from the attributes of the datasets: `make dictionary`."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterator
from pathlib import Path

import xarray as xr

from planar_pushing.study.catalog import DATASETS, SIMULATIONS
from planar_pushing.study.jobs import run_command
from planar_pushing.study.store import group_names, open_dataset
from planar_pushing.terms.quantities import NOTES

HEAD = """# Data dictionary

The pipeline generates everything in this folder except this page: `data/` holds the datasets, `figures/`
the figures, with the numbers that they plot in `figures/data/`, `tables/` the golden verdict and the tables
of the report, `paper.pdf` the report, `logs/` and `benchmarks/` a file for each job. `make dictionary`
writes this page from the attributes of the datasets.

The datasets are netCDF4 files; `planar_pushing.open_dataset("motion_cones")` opens one with xarray. Angles
are degrees, counter-clockwise from the fence.
"""


def dictionary_text(results: str = "results") -> str:
    """Text of the page for the datasets in a results folder."""
    units = "\n".join(f"- *{unit}*: {note}." for unit, note in NOTES.items())
    sections = [_section(name, results) for name in DATASETS]
    sections += _simulations(results)
    return "\n".join([HEAD, "Units other than degrees:\n", units, "", *sections])


def _simulations(results: str) -> list[str]:
    """Section of the logs of motion over time, which share their variables; none without logs."""
    names = sorted(path.stem for path in (Path(results) / "data" / SIMULATIONS).glob("*.nc"))
    if not names:
        return []
    dataset = open_dataset(f"{SIMULATIONS}/{names[0]}", results)
    lines = [
        f"## data/{SIMULATIONS}/NAME.nc",
        "",
        "Motion over time, a log of each simulation.",
        "",
    ]
    lines += [f"Source: {dataset.attrs['source']}.", ""]
    return ["\n".join([*lines, *_table(dataset)]) + "\n"]


def _section(name: str, results: str) -> str:
    lines = [f"## data/{name}.nc", "", DATASETS[name][0].upper() + DATASETS[name][1:] + ".", ""]
    if name == "scenes":
        groups = group_names(Path(results) / "data" / "scenes.nc")
        lines += ["Groups: " + ", ".join(f"`{group}`" for group in groups) + ".", ""]
        dataset = open_dataset(f"scenes/{groups[-1]}", results)
    else:
        dataset = open_dataset(name, results)
        lines += [f"Source: {dataset.attrs['source']}.", ""]
    return "\n".join([*lines, *_table(dataset)]) + "\n"


def _table(dataset: xr.Dataset) -> Iterator[str]:
    yield "| name | dims | unit | meaning |"
    yield "| --- | --- | --- | --- |"
    for name in [*dataset.coords, *dataset.data_vars]:
        variable = dataset[name]
        meaning = variable.attrs["long_name"]
        if "flag_meanings" in variable.attrs:
            flags = zip(
                variable.attrs["flag_values"], variable.attrs["flag_meanings"].split(), strict=True
            )
            meaning += ": " + ", ".join(f"{value} {word}" for value, word in flags)
        dims = ", ".join(map(str, variable.dims)) or "-"
        yield f"| `{name}` | {dims} | {variable.attrs['units']} | {meaning} |"


def main() -> int:
    """Write the page into the results folder that it describes."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--results", default="results")
    folder = parser.parse_args().results
    path = Path(folder) / "README.md"
    path.write_text(dictionary_text(folder), encoding="utf-8")
    print(f"wrote {path}")
    return 0


if __name__ == "__main__":
    sys.exit(run_command(main))
