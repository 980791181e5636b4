"""Select the pushes of one object, and combine the pushes of several objects."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.mechanics.outline import require_outline
from planar_pushing.mechanics.plane import Array
from planar_pushing.pushes.logs.schema import (
    NOISE,
    OUTLINE,
    VARIABLES,
    outline_arrays,
    require_pushes,
)
from planar_pushing.terms.errors import InvalidValue, require_name, require_path

#: Dimensions padded with NaN, each with a variable that has it as its second dimension.
PADDED = {"corner": "outline", "piece": "outline_pieces", "foot": "feet", "sample": "finger_path"}


def of_object(pushes: xr.Dataset, name: str) -> xr.Dataset:
    """The pushes of one object, with the dimension `object` and without its unknown variables.

    Raises
    ------
    InvalidValue
        If the dataset contains no object of this name or no push of it.
    """
    names = [str(label) for label in pushes["object"].values]
    require_name("object", name, names, "name one of these")
    rows = np.flatnonzero(pushes["pushed"].values == name)
    if not len(rows):
        raise InvalidValue("object", name, "an object that is pushed", "name another one")
    selection = pushes.isel(push=rows, object=[names.index(name)])
    unknown = [
        key for key, variable in VARIABLES.items()
        if key in selection and not variable.complete and not selection[key].notnull().any()
    ]  # fmt: skip
    selection = selection.drop_vars(unknown)
    lengths = {
        dim: int(np.max(np.nonzero(np.isfinite(selection[key].values))[1])) + 1
        for dim, key in PADDED.items()
        if key in selection
    }
    return selection.isel({dim: slice(length) for dim, length in lengths.items()})


def with_outline(pushes: xr.Dataset, outline: Any) -> xr.Dataset:
    """Pushes of one object with another outline, checked again: the contacts must be on it."""
    changed = pushes.drop_vars(OUTLINE, errors="ignore")
    for name, array in outline_arrays([require_outline(outline)]).items():
        changed[name] = VARIABLES[name].dims, array
    changed["outline"].attrs = pushes["outline"].attrs
    return require_pushes(changed)


def concat_pushes(pushes: Sequence[xr.Dataset]) -> xr.Dataset:
    """Concatenate the pushes of several datasets in order.

    Parameters
    ----------
    pushes : sequence of xarray.Dataset
        Datasets of pushes in the same units. They can share an object if its outline and feet are the same.

    Returns
    -------
    xarray.Dataset
        All pushes. The attribute `source` lists the sources of the datasets, each noise attribute is the
        largest of theirs, and `left_out` is their sum.

    Raises
    ------
    InvalidValue
        If the sequence is empty, a dataset does not contain pushes, units differ, or two objects share a
        name.
    """
    datasets = list(pushes) if isinstance(pushes, (list, tuple)) else []
    if not datasets:
        raise InvalidValue("pushes", pushes, "a list of at least one dataset", "list the datasets")
    checked = [require_pushes(one) for one in datasets]
    _require_same_units(checked)
    objects = _objects(checked)
    parts: dict[str, Any] = {
        "pushed": ("push", np.concatenate([one["pushed"].values for one in checked]))
    }
    for name, variable in VARIABLES.items():
        held = [one for one in checked if name in one]
        if held and variable.dims[0] == "push":
            arrays = [_array(one, name) for one in checked]
            parts[name] = variable.dims, _join(arrays), held[0][name].attrs
        elif held:
            arrays = [_array(one.sel(object=[label]), name) for label, one in objects.items()]
            parts[name] = variable.dims, _join(arrays), held[0][name].attrs
    joined = xr.Dataset(parts, {"object": list(objects), "xy": ["x", "y"]}, _attributes(checked))
    return require_pushes(joined)


def require_file_names(files: Sequence[Any]) -> None:
    """Refuse an empty list of files, and files that would give two objects the same name."""
    stems = [Path(require_path("files", file)).stem for file in files]
    if not stems:
        raise InvalidValue("files", "none", "at least one file", "name the files to read")
    if len(set(stems)) < len(stems):
        again = next(stem for k, stem in enumerate(stems) if stem in stems[:k])
        raise InvalidValue(
            "files", f"two files named {again}", "files with different names, which name the objects",
            "rename one of them",
        )  # fmt: skip


def _require_same_units(datasets: list[xr.Dataset]) -> None:
    for name in VARIABLES:
        units = {one[name].attrs["units"] for one in datasets if name in one}
        if len(units) > 1:
            raise InvalidValue(
                "units",
                f"{name} in {' and '.join(sorted(units))}",
                "one unit",
                "convert one dataset",
            )


def _objects(datasets: list[xr.Dataset]) -> dict[str, xr.Dataset]:
    """The dataset that describes each object; objects with the same name must be identical."""
    objects: dict[str, xr.Dataset] = {}
    for one in datasets:
        for label in map(str, one["object"].values):
            known = objects.setdefault(label, one)
            if known is not one and not _same_object(known, one, label):
                raise InvalidValue(
                    "object",
                    label,
                    "a different name for each object",
                    "rename one of the objects",
                )
    return objects


def _same_object(one: xr.Dataset, other: xr.Dataset, label: str) -> bool:
    """Whether two datasets describe an object identically except for padding."""
    for name in (*OUTLINE, "feet", "foot_weight", "center_of_mass", "mass"):
        here, there = (_array(dataset.sel(object=[label]), name) for dataset in (one, other))
        here, there = (values[np.isfinite(values)] for values in (here, there))
        if not np.array_equal(here, there):
            return False
    return True


def _array(pushes: xr.Dataset, name: str) -> Array:
    """Values of a variable; NaN, possibly over empty dimensions, if the dataset lacks it."""
    if name in pushes:
        return np.asarray(pushes[name].values)
    sizes = {dim: pushes.sizes.get(dim, 0) for dim in VARIABLES[name].dims}
    return np.full(tuple(sizes.values()), np.nan)


def _join(arrays: list[Array]) -> Array:
    """Arrays concatenated along the first dimension, with the other dimensions padded with NaN."""
    lengths = np.max([array.shape[1:] for array in arrays], axis=0, initial=0).astype(int)
    return np.concatenate([
        np.pad(
            array,
            [(0, 0), *((0, most - has) for most, has in zip(lengths, array.shape[1:], strict=True))],
            constant_values=np.nan,
        )
        for array in arrays
    ])  # fmt: skip


def _attributes(datasets: list[xr.Dataset]) -> dict[str, Any]:
    """Attributes of the concatenated dataset."""
    sources = dict.fromkeys(str(one.attrs["source"]) for one in datasets if one.attrs["source"])
    noise = {
        key: max(float(one.attrs[key]) for one in datasets if key in one.attrs)
        for key in NOISE
        if any(key in one.attrs for one in datasets)
    }
    out = [int(one.attrs["left_out"]) for one in datasets if "left_out" in one.attrs]
    return {"source": "; ".join(sources), **noise, **({"left_out": sum(out)} if out else {})}
