"""The datasets in a results folder, the commands that build the others, and values by axis name."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import xarray as xr

from planar_pushing.terms.errors import InvalidFile, InvalidValue
from planar_pushing.terms.netcdf import group_names, read_attributes, reading
from planar_pushing.terms.replacing import PathLike
from pulling_by_pushing.study.catalog import FOLDERS, WHOLE, building, number_label, opened
from pulling_by_pushing.study.store import built_results


def axis_names(dataset: xr.Dataset) -> list[str]:
    """Names of axes and of labels along them that a query can use."""
    return sorted(str(name) for name, coord in dataset.coords.items() if coord.ndim == 1)


def select(dataset: xr.Dataset, wanted: dict[str, str]) -> xr.Dataset:
    """Part of a dataset in which each named axis has the requested value.

    Raises
    ------
    InvalidValue
        If there is no such axis, or no such value on it.
    """
    for name, text in wanted.items():
        if name not in axis_names(dataset):
            allowed = ", ".join(axis_names(dataset))
            raise InvalidValue(name, text, f"the axes {allowed}", "name one of the dataset's axes")
        coord = dataset.coords[name]
        value = _parse(name, text) if coord.dtype.kind == "f" else text
        found = np.flatnonzero(coord.values == value)
        if not found.size:
            raise InvalidValue(name, text, listed(coord), "choose a value of the study's grid")
        dataset = dataset.isel({coord.dims[0]: found[0] if found.size == 1 else found})
    # A large dataset is read only here, so damage to the file can first appear here.
    with reading(dataset.encoding.get("source", "the dataset")):
        return dataset.load()


def _parse(name: str, text: str) -> float:
    try:
        return float(text)
    except ValueError:
        raise InvalidValue(name, text, "a number, or inf", "give one number") from None


def listed(coord: xr.DataArray, most: int = 12) -> str:
    """Values of an axis as text; a long axis is abbreviated."""
    label = number_label if coord.dtype.kind == "f" else str
    values = list(dict.fromkeys(label(value) for value in coord.values))
    if len(values) > most:
        values = [*values[: most - 1], "...", values[-1]]
    return ", ".join(values)


def built_datasets(results: PathLike, study: str | None = None) -> dict[str, str]:
    """Names that `open_dataset` accepts for the results of a study, and their titles.

    Errors as in `open_dataset`; for a damaged file, the error message replaces the title.
    """
    folder = built_results(results, study)
    found: dict[str, str] = {}
    for stem in WHOLE:
        found |= _named(folder / f"data/{stem}.nc", stem)
    for stem, place in FOLDERS.items():
        for path in sorted((folder / place).glob("*.nc")):
            found |= _named(path, f"{stem}/{path.stem}")
    return found


def _named(path: Path, name: str) -> dict[str, str]:
    """Title of a file by its name or those of its groups; empty if the file does not exist."""
    if not path.is_file():
        return {}
    try:
        title = str(read_attributes(path).get("title", ""))
        names = [f"{name}/{group}" for group in group_names(path)] or [name]
    except InvalidFile as error:
        return {name: str(error)}
    return dict.fromkeys(names, title[:1].lower() + title[1:])


def other_datasets(built: dict[str, str]) -> dict[str, str]:
    """Names of datasets that are not built, and the command for each; NAME is a placeholder."""
    stems = {name.partition("/")[0] for name in built}
    return {
        name: building(name)
        for name in opened()
        if name not in built and not (name.endswith("/NAME") and name[:-5] in stems)
    }
