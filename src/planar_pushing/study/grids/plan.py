"""What a study takes before anything runs: points, jobs, memory, disk and CPU time of each dataset.

Rates are measured on this machine, on blocks from all over the grid.
"""

from __future__ import annotations

import tempfile
import time
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import xarray as xr

from planar_pushing.study.builders import build_dataset
from planar_pushing.study.catalog import SPLIT
from planar_pushing.study.figures import computes
from planar_pushing.study.files.models import StudyFile
from planar_pushing.study.grids import effort
from planar_pushing.study.grids.chunks import chunk_parts
from planar_pushing.study.grids.streaming import COMPUTED, pieces
from planar_pushing.study.slices import study_slice
from planar_pushing.study.storage.parts import blocks, cut, points, sizes
from planar_pushing.study.storage.store import read_dataset, stored_chunks, write_dataset

#: Blocks on which a rate is measured, four for each set of effects of a study with all.
SAMPLES = 12
#: CPU seconds that a job takes to start, beside its points (measured: 2.9).
START = 3.0


@dataclass(frozen=True, slots=True, kw_only=True)
class Rates:
    """What a point takes: CPU seconds to compute and to copy, and bytes on disk."""

    computed: float
    copied: float
    stored: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Plan:
    """What a dataset takes: memory in MB for each job, disk in MB with its chunks."""

    dataset: str
    points: int
    chunks: int
    jobs: int
    memory: int
    disk: float
    cpu_hours: float


def study_plan(study: StudyFile) -> list[Plan]:
    """Plan of each dataset of a study that has a grid."""
    return [_plan(study, name) for name in SPLIT if computes(study, name)]


def _plan(study: StudyFile, name: str) -> Plan:
    values = study_slice(study, name)
    count, rates = points(sizes(name, values)), measured_rates(name, values)
    parts = chunk_parts(study, name) if name in study.chunks else {}
    first = next(iter(parts.values()), {})  # no chunk is larger
    largest = points(sizes(name, cut(values, first)))
    gathered = bool(parts) and study.gather.get(name, True)
    jobs = len(parts) + 1  # which gathers the chunks, lists them, or is the one
    seconds = count * (rates.computed + rates.copied * gathered) + jobs * START
    return Plan(
        dataset=name,
        points=count,
        chunks=max(len(parts), 1),
        jobs=jobs,
        memory=effort.memory(largest, effort.threads(largest)),
        disk=count * rates.stored * (1 + gathered) / 1e6,
        cpu_hours=seconds / 3600,
    )


def measured_rates(name: str, values: dict[str, Any]) -> Rates:
    """Rates of a dataset's blocks, from the middles of equal parts of its grid."""
    found = blocks(sizes(name, values), COMPUTED)
    number = min(SAMPLES, len(found))
    chosen = [found[(2 * i + 1) * len(found) // (2 * number)] for i in range(number)]
    with tempfile.TemporaryDirectory() as folder:
        # First of one point, which compiles or loads what the others take.
        _timed(name, cut(values, {dim: slice(0, 1) for dim in found[0]}), Path(folder) / "one.nc")
        rows = [_timed(name, cut(values, part), Path(folder) / "block.nc") for part in chosen]
    count = sum(row[0] for row in rows)
    computed, copied, stored = (sum(row[i] for row in rows) / count for i in (1, 2, 3))
    return Rates(computed=computed, copied=copied, stored=stored)


def _timed(name: str, values: dict[str, Any], path: Path) -> tuple[int, float, float, int]:
    """Points of a block, CPU seconds to compute and to copy it, and its bytes."""
    lengths = sizes(name, values)
    start = time.process_time()
    built: Any = build_dataset(name, values)
    stored = _packed(built, lengths)
    middle = time.process_time()
    write_dataset(built, path)
    written = time.process_time()
    _packed(read_dataset(path).load(), lengths)
    end = time.process_time()
    return points(lengths), middle - start, end - written, stored


def _packed(built: xr.Dataset, lengths: dict[str, int]) -> int:
    """Bytes of a block as a stream stores it."""
    layout = {
        str(name): stored_chunks(each.shape, each.dtype) for name, each in built.variables.items()
    }
    whole = {dim: slice(0, length) for dim, length in lengths.items()}
    return sum(len(piece.packed or b"") for piece in pieces(built, whole, layout))
