"""Parts of a dataset's grid: the chunks of a study, the blocks of a job, and the shape of what is stored.

All three are cut by one rule from the last dimension on, and by powers of two, so that what is stored never
lies across two blocks.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from planar_pushing.study.catalog import SPLIT, contact_labels

#: A range along each dimension that is cut; the others are whole.
Part = Mapping[str, slice]


def sizes(name: str, values: Mapping[str, Any]) -> dict[str, int]:
    """Lengths of the dimensions along which a slice of a study can be cut; none for one without axes."""
    return {dim: len(_labels(dim, values)) for dim in SPLIT.get(name, ())}


def _labels(dim: str, values: Mapping[str, Any]) -> list[Any]:
    """What stands along a dimension."""
    grid = values["grid"]
    if dim != "contact":
        return list(grid[dim])
    chosen = values.get("only", {}).get(dim)
    return list(chosen or contact_labels(grid["contact_friction_coefficient"]))


def cut(values: Mapping[str, Any], part: Part) -> dict[str, Any]:
    """The part of a slice, with the values of its own range alone."""
    grid = dict(values["grid"]) if part else {}
    only = dict(values.get("only", {}))
    for dim, span in part.items():
        kept = _labels(dim, values)[span]
        if dim == "contact":
            only[dim], dim = kept, "contact_friction_coefficient"
            kept = grid[dim][span]
        grid[dim] = kept
    return {**values, **({"grid": grid} if part else {}), **({"only": only} if only else {})}


def shape(lengths: Sequence[int], most: int) -> tuple[int, ...]:
    """Lengths of a block of at most `most` points: whole inner dimensions, a power of two, then one."""
    found: list[int] = []
    for length in reversed(lengths):
        fits = length <= most
        found.append(length if fits else 1 << (most.bit_length() - 1))
        most = max(most // max(length, 1), 1) if fits else 1
    return tuple(reversed(found))


def blocks(lengths: Mapping[str, int], most: int) -> list[Part]:
    """Parts of at most `most` points that make up a grid, in the order in which it is stored."""
    steps = shape(list(lengths.values()), most)
    return list(ranges(lengths, dict(zip(lengths, steps, strict=True))))


def ranges(lengths: Mapping[str, int], steps: Mapping[str, int]) -> Iterator[Part]:
    """Parts of the given lengths along some dimensions; their borders are multiples of these."""
    spans = [
        [slice(start, min(start + step, lengths[dim])) for start in range(0, lengths[dim], step)]
        for dim, step in steps.items()
    ]
    for chosen in itertools.product(*spans):
        yield dict(zip(steps, chosen, strict=True))


def chunk_name(part: Part) -> str:
    """Name of a chunk, such as contact_10.pusher_angle_90: the indices at which it starts."""
    return ".".join(f"{dim}_{span.start}" for dim, span in part.items())


def points(lengths: Mapping[str, int]) -> int:
    """Number of points of a grid."""
    return math.prod(lengths.values())
