"""What every dataset says of itself: units and long names, title, source and provenance."""

from __future__ import annotations

import xarray as xr

from planar_pushing.mechanics.contact import ContactMode, Outcome
from planar_pushing.mechanics.entries import to_json, versions
from planar_pushing.terms.quantities import DATASET, NOTES, attributes

FLAGS = {"mode": ContactMode, "outcome": Outcome}


def describe(dataset: xr.Dataset, *, title: str, source: str, parameters: object) -> xr.Dataset:
    """Give every variable its unit and name, and the dataset its title, source and provenance."""
    for name, variable in dataset.variables.items():
        variable.attrs = dict(attributes(DATASET, str(name)))
        flags = FLAGS.get(str(name))
        if flags and variable.dtype.kind == "i":
            variable.attrs["flag_values"] = [int(flag) for flag in flags]
            variable.attrs["flag_meanings"] = " ".join(flag.name for flag in flags)
    dataset.attrs = {
        "title": title,
        "source": f"Lynch and Mason, Pulling by Pushing, Slip with Infinite Friction, "
        f"and Perfectly Rough Surfaces, {source}",
        "parameters": to_json(parameters),
        "unit_notes": to_json(NOTES),
        "versions": versions(),
    }
    return dataset
