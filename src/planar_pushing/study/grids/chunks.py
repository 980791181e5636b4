"""Chunks of a dataset: what one job computes of a large grid, in a file of its own.

A chunk is named by the index at which it starts along each dimension that is cut. Its borders are multiples
of the study's numbers and do not depend on how many chunks there are; its job depends on its own values of
the axes.
"""

from __future__ import annotations

from typing import Any

from planar_pushing.study.files.models import StudyFile
from planar_pushing.study.slices import study_slice
from planar_pushing.study.storage.parts import Part, chunk_name, cut, ranges, sizes


def chunk_steps(study: StudyFile, name: str) -> dict[str, int]:
    """Most values of a chunk along each dimension that is cut, in the order of the dataset's."""
    given = study.chunks.get(name, {})
    return {dim: given[dim] for dim in sizes(name, study_slice(study, name)) if dim in given}


def chunk_parts(study: StudyFile, name: str) -> dict[str, Part]:
    """Chunks of a dataset by name, in order."""
    lengths = sizes(name, study_slice(study, name))
    return {chunk_name(part): part for part in ranges(lengths, chunk_steps(study, name))}


def chunk_slice(study: StudyFile, name: str, part: Part) -> dict[str, Any]:
    """Plain values of a study that a chunk reads."""
    return cut(study_slice(study, name), part)
