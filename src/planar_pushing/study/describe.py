"""What every dataset says of itself: units and long names, title, source and provenance."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import xarray as xr

from planar_pushing.mechanics.contact import ContactMode, Outcome
from planar_pushing.mechanics.entries import to_json, versions
from planar_pushing.study.catalog import DATASETS, EVIDENCE, SLIDERS, TIMES
from planar_pushing.terms.quantities import DATASET, GLOBAL, NOTES, PAPER, Quantities, attributes

FLAGS = {"mode": ContactMode, "outcome": Outcome}


def describe(
    dataset: xr.Dataset,
    *,
    title: str,
    source: str,
    parameters: object,
    quantities: Quantities = DATASET,
    notes: Mapping[str, str] = NOTES,
) -> xr.Dataset:
    """Give every variable its unit and name, and the dataset its title, source and provenance."""
    for name, variable in dataset.variables.items():
        variable.attrs = dict(attributes(quantities, str(name)))
        flags = FLAGS.get(str(name))
        if flags and variable.dtype.kind == "i":
            variable.attrs["flag_values"] = np.array(flags, variable.dtype)
            variable.attrs["flag_meanings"] = " ".join(flag.name for flag in flags)
    dataset.attrs = {
        "title": title,
        "source": f"{PAPER}, {source}",
        **GLOBAL,
        "parameters": to_json(parameters),
        "unit_notes": to_json(dict(notes)),
        "versions": versions(),
    }
    return dataset


def of_study(
    built: xr.Dataset | dict[str, xr.Dataset], name: str, study: Mapping[str, str]
) -> xr.Dataset | dict[str, xr.Dataset]:
    """Name the study and the conventions in a dataset, or in every group and above them.

    Parameters
    ----------
    built : xarray.Dataset or dict of them
        A dataset, or one for each group.
    name : str
        Name of the dataset: what it holds becomes the title of what has none.
    study : mapping
        Attributes that name the study, as `provenance` gives them.
    """
    marks = {**GLOBAL, **study}
    title = (DATASETS | SLIDERS | EVIDENCE | TIMES).get(name, name)
    if isinstance(built, xr.Dataset):
        return built.assign_attrs({"title": title} | built.attrs | marks)
    groups = {
        part: each.assign_attrs({"title": f"{title}: {part}"} | each.attrs | marks)
        for part, each in built.items()
    }
    return {"/": xr.Dataset(attrs={"title": title} | marks)} | groups
