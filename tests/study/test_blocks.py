"""Axes in blocks."""

import numpy as np
import pytest

from planar_pushing.study.blocks import blocks, in_blocks


@pytest.mark.parametrize(("size", "block"), [(10, 3), (9, 3), (2, 5), (0, 4)])
def test_blocks_cover_an_axis_once(size, block):
    parts = [list(range(size))[part] for part in blocks(size, block)]
    assert [each for part in parts for each in part] == list(range(size))
    assert all(0 < len(part) <= block for part in parts)


def test_a_kernel_sees_one_block_at_a_time():
    seen = []

    def kernel(x):
        seen.append(x.size)
        return {"square": x**2, "half": x / 2}

    axis = np.arange(10.0)
    found = in_blocks(kernel, axis, 4)
    assert seen == [4, 4, 2]
    assert np.array_equal(found["square"], axis**2)
    assert np.array_equal(found["half"], axis / 2)
