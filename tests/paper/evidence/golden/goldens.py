"""The stored golden data, and the results that they stand for."""

from functools import cache
from pathlib import Path

from planar_pushing.terms.netcdf import group_names
from pulling_by_pushing.evidence.golden.enclosures import holds_radii
from pulling_by_pushing.study.store import read_dataset

FOLDER = Path("tests/golden")


def names():
    """Files and groups of the golden data of both studies."""
    for path in sorted(FOLDER.rglob("*.nc")):
        for group in group_names(path) or [""]:
            yield path.relative_to(FOLDER).with_suffix("").as_posix(), group


@cache
def golden(file, group=""):
    return read_dataset(FOLDER / f"{file}.nc", group or None).load()


def result(dataset):
    """The dataset that is computed without an error."""
    return dataset.drop_vars([name for name in dataset.variables if holds_radii(name, dataset)])


def dataset_name(file):
    """Name of a golden file in its study."""
    return file.removeprefix("sliders/")
