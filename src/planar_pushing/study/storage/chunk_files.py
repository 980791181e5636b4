"""A dataset that stays in its chunks: opened as one, which is read when it is used.

In its place in the results stands an index, a file with its coordinates and attributes alone.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path

import xarray as xr

from planar_pushing.study.catalog import SPLIT
from planar_pushing.study.storage.hdf5 import readable
from planar_pushing.study.storage.parts import chunk_name, ranges
from planar_pushing.terms.errors import InvalidFile
from planar_pushing.terms.extras import require_extra

#: Attribute of an index: the most values of a chunk along each dimension that is cut.
ATTRIBUTE = "chunks"


def open_chunks(folder: Path, lengths: Mapping[str, int], steps: Mapping[str, int]) -> xr.Dataset:
    """Open the chunks in a folder as one dataset.

    Parameters
    ----------
    folder : path
    lengths : mapping
        Of the whole along the dimensions that are cut.
    steps : mapping
        Of a chunk along them.
    """
    require_extra("chunks")
    files = [_opened(folder / f"{chunk_name(part)}.nc") for part in ranges(lengths, steps)]
    for dim, step in reversed(list(steps.items())):
        number = -(-lengths[dim] // step)
        files = [_joined(files[i : i + number], dim) for i in range(0, len(files), number)]
    return files[0]


def _opened(path: Path) -> xr.Dataset:
    with readable(path):
        return xr.open_dataset(path, engine="h5netcdf", chunks="auto", decode_times=False)


def _joined(files: list[xr.Dataset], dim: str) -> xr.Dataset:
    return xr.concat(
        files, dim, data_vars="minimal", coords="minimal", compat="override", join="override",
        combine_attrs="override",
    )  # fmt: skip


def index_of(whole: xr.Dataset, steps: Mapping[str, int]) -> xr.Dataset:
    """The index of a dataset."""
    return whole.drop_vars(list(whole.data_vars)).assign_attrs({ATTRIBUTE: json.dumps(dict(steps))})


def behind_index(found: xr.Dataset, path: Path) -> xr.Dataset:
    """The dataset that an index stands for, with its attributes; any other dataset unchanged."""
    if ATTRIBUTE not in found.attrs:
        return found
    steps = _steps(found, path)
    folder = path.parent.parent / "chunks" / path.stem
    whole = open_chunks(folder, {dim: found.sizes[dim] for dim in steps}, steps)
    if not all(whole[dim].equals(found[dim]) for dim in steps):
        raise InvalidFile(
            f"{path}: its chunks are those of another grid; remove it and build it anew"
        )
    return whole.assign_attrs({key: each for key, each in found.attrs.items() if key != ATTRIBUTE})


def _steps(index: xr.Dataset, path: Path) -> dict[str, int]:
    """Lengths of the chunks that an index names, or `InvalidFile`."""
    try:
        steps = {str(dim): int(step) for dim, step in json.loads(index.attrs[ATTRIBUTE]).items()}
    except (TypeError, ValueError, AttributeError):
        steps = {}
    if not steps or not set(steps) <= set(SPLIT.get(path.stem, ())) or min(steps.values()) < 1:
        raise InvalidFile(f"{path}: names no chunks; remove it and build it anew")
    return steps
