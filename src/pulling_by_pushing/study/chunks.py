"""Large grids: the blocks of a job, the chunks of a study, and the resources they need.

A chunk is a file named after the indices at which it starts along each dimension that is split. Its borders
are multiples of the chunk lengths of the study, and its job reads only its own values of the axes.
"""

from __future__ import annotations

import json
import math
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from planar_pushing.mechanics.entries import to_json
from planar_pushing.terms.extras import require_extra
from pulling_by_pushing.study.catalog import DATASETS
from pulling_by_pushing.study.slices import (
    Ranges,
    points,
    select_ranges,
    sizes,
    split_ranges,
    study_slice,
)

if TYPE_CHECKING:
    import xarray as xr

    from planar_pushing.terms.replacing import PathLike
    from pulling_by_pushing.study.model import StudyFile

#: Maximum number of points of a block, which one call computes.
BLOCK = 2**17
#: Bytes of a variable that dask reads at once.
PIECE = 2**24
#: Points per thread of a job, and the maximum number of threads.
POINTS_PER_THREAD, MOST_THREADS = 2**20, 4
#: Memory limit of a job in MB (measured maximum: 540, for contact modes with both effects).
MEMORY = 900
#: Time limit of a job: minutes, plus seconds per point, 3 times the rate measured for contact modes (3e-5).
MINUTES, SECONDS_PER_POINT = 10, 1e-4


def blocks(lengths: Mapping[str, int], most: int = BLOCK) -> list[Ranges]:
    """Split a grid into blocks of at most `most` points."""
    from planar_pushing.terms.netcdf import block_shape

    steps = block_shape(list(lengths.values()), most)
    return list(split_ranges(lengths, dict(zip(lengths, steps, strict=True))))


def in_blocks(study: StudyFile, name: str) -> bool:
    """Whether a dataset is computed in blocks, because it has more points than one."""
    return bool(DATASETS[name].dims) and points(name, study_slice(study, name)) > BLOCK


def chunk_name(part: Ranges) -> str:
    """Name of a chunk from the indices at which it starts, such as contact_10.pusher_angle_90."""
    return ".".join(f"{dim}_{span.start}" for dim, span in part.items())


def chunk_steps(study: StudyFile, name: str) -> dict[str, int]:
    """Maximum length of a chunk along each dimension that is split, in the dataset's order."""
    steps = study.chunks.get(name, {})
    return {dim: steps[dim] for dim in sizes(name, study_slice(study, name)) if dim in steps}


def chunk_parts(study: StudyFile, name: str) -> dict[str, Ranges]:
    """Ranges of each chunk along the dimensions that are split, by the name of the chunk."""
    lengths = sizes(name, study_slice(study, name))
    return {chunk_name(part): part for part in split_ranges(lengths, chunk_steps(study, name))}


def chunk_slice(study: StudyFile, name: str, part: Ranges) -> dict[str, Any]:
    """Plain values of a study that a chunk reads."""
    return select_ranges(study_slice(study, name), part)


def open_chunks(
    folder: PathLike, lengths: Mapping[str, int], steps: Mapping[str, int]
) -> xr.Dataset:
    """Open the chunks in a folder as one dataset, which dask reads on demand.

    Parameters
    ----------
    folder : path
    lengths, steps : mapping
        Lengths of the whole dataset and of a chunk along the dimensions that are split.

    Raises
    ------
    MissingExtra
        If dask is not installed.
    """
    require_extra("chunks")
    import dask
    import xarray as xr

    files = [Path(folder, f"{chunk_name(part)}.nc") for part in split_ranges(lengths, steps)]
    counts = [-(-lengths[dim] // step) for dim, step in steps.items()]
    # With pieces as small as those stored, dask would spend more time on scheduling than on reading.
    with dask.config.set({"array.chunk-size": PIECE}):
        return xr.open_mfdataset(
            np.array(files).reshape(counts).tolist(), combine="nested", concat_dim=list(steps),
            data_vars="minimal", coords="minimal", compat="override", join="override",
            combine_attrs=_attributes, engine="h5netcdf", chunks="auto", decode_times=False,
        )  # fmt: skip


def _attributes(parts: Sequence[dict[str, Any]], context: object = None) -> dict[str, Any]:
    """Attributes of the first part, with the supports of all parts in its parameters, in order."""
    attrs = dict(parts[0])
    if "parameters" in attrs:
        parameters = [json.loads(part["parameters"]) for part in parts]
        supports = {
            name: support
            for entry in parameters
            for name, support in entry.get("supports", {}).items()
        }
        attrs["parameters"] = to_json(parameters[0] | ({"supports": supports} if supports else {}))
    return attrs


def threads(count: int) -> int:
    """Number of threads for a job with this number of points."""
    return min(max(math.ceil(count / POINTS_PER_THREAD), 1), MOST_THREADS)


def minutes(count: int) -> int:
    """Time limit in minutes for a job with this number of points on one core."""
    return MINUTES + math.ceil(count * SECONDS_PER_POINT / 60)
