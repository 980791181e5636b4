"""What the workflow's jobs on datasets and simulations call."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import xarray as xr

from planar_pushing.study.builders import build_dataset
from planar_pushing.study.describe import of_study
from planar_pushing.study.files.replacing import PathLike
from planar_pushing.study.files.scenes import load_scene_file
from planar_pushing.study.grids.streaming import COMPUTED, COPIED, stream_dataset
from planar_pushing.study.storage.chunk_files import index_of, open_chunks
from planar_pushing.study.storage.parts import cut, sizes
from planar_pushing.study.storage.store import write_dataset

Values = dict[str, Any]
Attributes = Mapping[str, str]


def dataset(path: PathLike, *, name: str, study: Values, marks: Attributes, threads: int) -> None:
    """Write a dataset from its slice of the study, block by block, with the study's attributes."""

    def block(part: Any) -> Any:
        return of_study(build_dataset(name, cut(study, part)), name, marks)

    stream_dataset(block, sizes(name, study), path, most=COMPUTED, threads=threads)


def chunk(path: PathLike, *, name: str, study: Values, threads: int) -> None:
    """Write a chunk of a dataset from its own slice; it names no study, and outlives its changes."""

    def block(part: Any) -> Any:
        return build_dataset(name, cut(study, part))

    stream_dataset(block, sizes(name, study), path, most=COMPUTED, threads=threads)


def gather(
    path: PathLike, *, chunks: list[str], name: str, whole: Values, marks: Attributes, threads: int
) -> None:
    """Write the chunks of a dataset into one file, block by block."""
    found = of_study(_opened(chunks, whole), name, marks)
    assert isinstance(found, xr.Dataset)
    stream_dataset(
        lambda part: found.isel(part).load(), whole["lengths"], path, most=COPIED, threads=threads
    )


def index(
    path: PathLike, *, chunks: list[str], name: str, whole: Values, marks: Attributes
) -> None:
    """Write the index of a dataset that stays in its chunks."""
    write_dataset(of_study(index_of(_opened(chunks, whole), whole["steps"]), name, marks), path)


def _opened(chunks: list[str], whole: Values) -> xr.Dataset:
    return open_chunks(Path(chunks[0]).parent, whole["lengths"], whole["steps"])


def simulation(path: PathLike, *, name: str, scene: str, marks: Attributes) -> None:
    """Simulate a scene file and write the log."""
    from planar_pushing.study.simulations import simulate_file

    write_dataset(of_study(simulate_file(load_scene_file(scene)), name, marks), path)
