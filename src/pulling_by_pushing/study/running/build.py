"""Build datasets: from the values of a study to a file, in bounded memory.

A large grid is computed in blocks. Each block is written to a temporary file next to the dataset, and
xarray and dask then combine the blocks into one file.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from importlib import import_module
from pathlib import Path
from typing import Any

import xarray as xr

from planar_pushing.mechanics.kernels.arrays import CORES
from planar_pushing.terms.netcdf import write_dataset
from planar_pushing.terms.replacing import PathLike, working_folder
from pulling_by_pushing.study.catalog import DATASETS
from pulling_by_pushing.study.chunks import blocks, chunk_name, open_chunks
from pulling_by_pushing.study.describe import add_study_attributes, apply_declaration
from pulling_by_pushing.study.slices import (
    StudyValues,
    part_of,
    pushes,
    section_of,
    select_ranges,
    sizes,
)
from pulling_by_pushing.study.store import index_of

Built = xr.Dataset | dict[str, xr.Dataset]
Attributes = Mapping[str, str]


def build_dataset(name: str, values: StudyValues) -> Built:
    """Build a dataset, or one for each group, from a slice of a study or part of a slice."""
    module = import_module(f"pulling_by_pushing.study.datasets.{DATASETS[name].module}")
    build = getattr(module, name)
    if name == "scenes":
        groups: dict[str, xr.Dataset] = build(pushes(values))
        return groups
    part = section_of(name, values) if DATASETS[name].section else part_of(values)
    return apply_declaration(build(part), name, part)


def dataset(
    path: PathLike,
    *,
    name: str,
    study: StudyValues,
    marks: Attributes | None = None,
    threads: int = 1,
) -> None:
    """Write a dataset, or a chunk of one, from its slice of the study.

    A chunk has no attributes that name the study (`marks`), so changes elsewhere in the study do not make
    it outdated.
    """
    CORES.set(threads)
    lengths = sizes(name, study)
    parts = blocks(lengths)
    if len(parts) < 2:
        write_built(build_dataset(name, study), path, name, marks)
        return
    with working_folder(path) as folder:
        for part in parts:
            write_built(
                build_dataset(name, select_ranges(study, part)),
                folder / _file(part),
                name,
                None,
            )
        steps = {dim: span.stop - span.start for dim, span in parts[0].items()}
        with _open_one_by_one(folder, lengths, steps) as combined:
            write_built(combined, path, name, marks)


def gather(
    path: PathLike,
    *,
    chunks: Sequence[str],
    name: str,
    chunking: Mapping[str, Any],
    marks: Attributes,
) -> None:
    """Write the chunks of a dataset into one file."""
    with _open_one_by_one(
        Path(chunks[0]).parent, chunking["lengths"], chunking["steps"]
    ) as combined:
        write_built(combined, path, name, marks)


def index(
    path: PathLike,
    *,
    chunks: Sequence[str],
    name: str,
    chunking: Mapping[str, Any],
    marks: Attributes,
) -> None:
    """Write the index of a dataset that is stored in chunks."""
    with _open_one_by_one(
        Path(chunks[0]).parent, chunking["lengths"], chunking["steps"]
    ) as combined:
        write_built(index_of(combined, chunking["steps"]), path, name, marks)


def _file(part: Mapping[str, slice]) -> str:
    return f"{chunk_name(part)}.nc"


@contextmanager
def _open_one_by_one(
    folder: PathLike, lengths: Mapping[str, int], steps: Mapping[str, int]
) -> Iterator[xr.Dataset]:
    """Open blocks or chunks as one dataset, which reads them one by one as it is written."""
    with open_chunks(folder, lengths, steps) as combined:
        import dask  # an extra that grids of one block do not need

        with dask.config.set(scheduler="synchronous"):
            yield combined


def write_built(built: Built, path: PathLike, name: str, marks: Attributes | None) -> None:
    """Write a dataset; a whole dataset is written without unused entries along `solution`."""
    if marks is None:
        write_dataset(built, path)
        return
    if isinstance(built, xr.Dataset) and "solutions" in built and "solution" in built.dims:
        built = built.isel(solution=slice(max(1, int(built["solutions"].max()))))
    write_dataset(add_study_attributes(built, name, marks), path)
