"""Long axes in blocks, so that memory is bounded by the block and temporaries stay small."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np

from planar_pushing.mechanics.plane import Array

#: Points that a kernel takes at once.
BLOCK = 2**16


def blocks(size: int, block: int = BLOCK) -> Iterator[slice]:
    """Slices of at most `block` elements that cover `size` elements."""
    return (slice(start, min(start + block, size)) for start in range(0, size, block))


def in_blocks(
    kernel: Callable[[Array], dict[str, Array]], axis: Array, block: int = BLOCK
) -> dict[str, Array]:
    """Evaluate a kernel that works elementwise on an axis of shape (n,), `block` points at a time.

    Returns
    -------
    dict of ndarray
        The kernel's variables, each of shape (n,).
    """
    values: dict[str, Array] = {}
    for part in blocks(axis.size, block):
        for name, value in kernel(axis[part]).items():
            values.setdefault(name, np.empty(axis.shape))[part] = value
    return values
