"""Axes in blocks."""

import pytest

from planar_pushing.study.storage.blocks import blocks


@pytest.mark.parametrize(("size", "block"), [(10, 3), (9, 3), (2, 5), (0, 4)])
def test_blocks_cover_an_axis_once(size, block):
    parts = [list(range(size))[part] for part in blocks(size, block)]
    assert [each for part in parts for each in part] == list(range(size))
    assert all(0 < len(part) <= block for part in parts)
