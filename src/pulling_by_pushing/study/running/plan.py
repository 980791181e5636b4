"""Estimate the points, jobs, memory, disk space and CPU time of each dataset before a study runs.

Rates are measured on this machine with blocks from the whole grid.
"""

from __future__ import annotations

import tempfile
import time
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from planar_pushing.terms.netcdf import write_dataset
from pulling_by_pushing.study import chunks
from pulling_by_pushing.study.catalog import DATASETS
from pulling_by_pushing.study.model import StudyFile
from pulling_by_pushing.study.running.build import build_dataset
from pulling_by_pushing.study.slices import computes, points, select_ranges, sizes, study_slice

#: Number of blocks for measuring a rate, four for each set of effects if a study has all, and their points.
SAMPLES, SAMPLE_POINTS = 12, 2**14
#: CPU seconds to start a job, in addition to those of its points (measured: 2.9).
START_SECONDS = 3.0


@dataclass(frozen=True, slots=True, kw_only=True)
class Plan:
    """Resources for a dataset: memory in MB for each job, disk space in MB including chunks."""

    dataset: str
    points: int
    chunks: int
    jobs: int
    memory: int
    disk: float
    cpu_hours: float


def study_plan(study: StudyFile) -> list[Plan]:
    """Plan of each dataset of a study that has a grid."""
    return [
        _plan(study, name) for name in DATASETS if DATASETS[name].dims and computes(study, name)
    ]


def counts_beyond_grids(study: StudyFile) -> dict[str, int]:
    """Numbers of scenes and other outputs beyond the grids, whose cost is known only after a run."""
    return {
        "scenes": len(study.scenes),
        "simulations": len(study.simulations),
        "figures": len(study.figures),
    }


def _plan(study: StudyFile, name: str) -> Plan:
    values = study_slice(study, name)
    count = points(name, values)
    seconds, stored = measured_rates(name, values)
    number = len(chunks.chunk_parts(study, name)) if name in study.chunks else 0
    copies = 2 if number and study.gather.get(name, True) else 1
    return Plan(
        dataset=name,
        points=count,
        chunks=max(number, 1),
        jobs=number + 1,  # the last job combines or indexes the chunks, or is the only job
        memory=chunks.MEMORY,
        disk=count * stored * copies / 1e6,
        cpu_hours=(count * seconds * copies + (number + 1) * START_SECONDS) / 3600,
    )


def measured_rates(name: str, values: dict[str, Any]) -> tuple[float, float]:
    """CPU seconds and bytes per point, measured on blocks at the middles of equal parts of a grid."""
    blocks = chunks.blocks(sizes(name, values), SAMPLE_POINTS)
    number = min(SAMPLES, len(blocks))
    samples = [blocks[(2 * i + 1) * len(blocks) // (2 * number)] for i in range(number)]
    # The first block has one point and imports what the others need.
    _measure_block(name, select_ranges(values, {dim: slice(0, 1) for dim in blocks[0]}))
    rows = [_measure_block(name, select_ranges(values, part)) for part in samples]
    count = sum(row[0] for row in rows)
    return sum(row[1] for row in rows) / count, sum(row[2] for row in rows) / count


def _measure_block(name: str, values: dict[str, Any]) -> tuple[int, float, int]:
    """Points of a block, CPU seconds to compute and write it, and its bytes."""
    with tempfile.TemporaryDirectory() as folder:
        path, start = Path(folder) / "block.nc", time.process_time()
        write_dataset(build_dataset(name, values), path)
        return points(name, values), time.process_time() - start, path.stat().st_size
