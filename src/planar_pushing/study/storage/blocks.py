"""Long axes in blocks, so that memory is bounded by the block and temporaries stay small."""

from __future__ import annotations

from collections.abc import Iterator

#: Points that a kernel takes at once.
BLOCK = 2**16


def blocks(size: int, block: int = BLOCK) -> Iterator[slice]:
    """Slices of at most `block` elements that cover `size` elements."""
    return (slice(start, min(start + block, size)) for start in range(0, size, block))
