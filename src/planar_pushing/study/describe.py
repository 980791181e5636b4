"""What every dataset says of itself: units and long names, title, source and provenance."""

from __future__ import annotations

import json
import math
from importlib.metadata import version

import xarray as xr
from pydantic import BaseModel

from planar_pushing.mechanics.contact import ContactMode, Outcome
from planar_pushing.mechanics.quantities import DATASET, NOTES, attributes

FLAGS = {"mode": ContactMode, "outcome": Outcome}
PACKAGES = ("planar-pushing", "numpy", "scipy", "xarray", "h5netcdf", "h5py")


def to_json(value: object) -> str:
    """JSON of plain values and models, with infinities as the word inf and keys in order."""
    return json.dumps(plain(value), sort_keys=True, allow_nan=False)


def plain(value: object) -> object:
    """Value as JSON has it; infinities, which JSON lacks, become the words inf and -inf."""
    if isinstance(value, BaseModel):
        return plain(value.model_dump())
    if isinstance(value, dict):
        return {str(key): plain(each) for key, each in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(each) for each in value]
    return str(value) if isinstance(value, float) and not math.isfinite(value) else value


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
        "versions": to_json({name: version(name) for name in PACKAGES}),
    }
    return dataset
