"""The datasets in a results folder, the commands that build the others, and values by axis name."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import xarray as xr

from planar_pushing.terms.errors import InvalidFile, InvalidValue, suggestion
from planar_pushing.terms.netcdf import group_names, read_attributes, reading
from planar_pushing.terms.replacing import PathLike
from pulling_by_pushing.study.catalog import (
    FILE_DATASETS,
    FOLDERS,
    build_command,
    dataset_names,
    number_label,
)
from pulling_by_pushing.study.store import built_results, study_advice


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
        axes = axis_names(dataset)
        if name not in axes:
            remedy = suggestion(name, axes, "name one of the dataset's axes")
            raise InvalidValue("axis", name, ", ".join(axes), remedy)
        coord = dataset.coords[name]
        value = _parse(name, text) if coord.dtype.kind == "f" else text
        indices = np.flatnonzero(coord.values == value)
        if not indices.size:
            raise InvalidValue(name, text, axis_text(coord), "choose a value of the study's grid")
        dataset = dataset.isel({coord.dims[0]: indices[0] if indices.size == 1 else indices})
    # A large dataset is read only here, so damage to the file can first appear here.
    with reading(dataset.encoding.get("source", "the dataset")):
        return dataset.load()


def _parse(name: str, text: str) -> float:
    try:
        return float(text)
    except ValueError:
        raise InvalidValue(name, text, "a number, or inf", "give one number") from None


def axis_text(coord: xr.DataArray, most: int = 12) -> str:
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
    titles: dict[str, str] = {}
    for stem in FILE_DATASETS:
        titles |= _titles(folder / f"data/{stem}.nc", stem)
    for stem, subfolder in FOLDERS.items():
        for path in sorted((folder / subfolder).glob("*.nc")):
            titles |= _titles(path, f"{stem}/{path.stem}")
    return titles


def _titles(path: Path, name: str) -> dict[str, str]:
    """Title of a file by its name or those of its groups; empty if the file does not exist."""
    if not path.is_file():
        return {}
    try:
        title = str(read_attributes(path).get("title", ""))
        names = [f"{name}/{group}" for group in group_names(path)] or [name]
    except InvalidFile as error:
        return {name: str(error)}
    return dict.fromkeys(names, title[:1].lower() + title[1:])


def other_datasets(built: dict[str, str], results: PathLike) -> dict[str, str]:
    """Names of datasets that a study lacks, and how to get each: of which study, or by which command.

    NAME is a placeholder.
    """
    stems = {name.partition("/")[0] for name in built}
    return {
        name: study_advice(name, results) or build_command(name)
        for name in dataset_names()
        if name not in built and not (name.endswith("/NAME") and name[:-5] in stems)
    }
