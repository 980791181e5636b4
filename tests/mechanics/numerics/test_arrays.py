"""Kernels over blocks of rows in threads, and results of the kind of the arguments."""

from __future__ import annotations

import contextvars
import threading

import numba
import numpy as np
import pytest
import xarray as xr

import planar_pushing as pp
from mechanics.builders import BOTH, make_scene
from planar_pushing.mechanics.numerics import arrays
from planar_pushing.mechanics.numerics.arrays import BLOCK, Output, elementwise, mapped


def kernel(kinds, rows, sums, parts):
    """Write down the sum of a row and its entries doubled."""
    for i in range(len(rows)):
        sums[i] = rows[i].sum()
        parts[i] = 2 * rows[i]


OUTPUTS = (Output("sum"), Output("parts", (("part", 2),), "f4"))


@pytest.mark.parametrize("size", [0, 1, BLOCK - 1, BLOCK, BLOCK + 1, 2 * BLOCK + 3])
@pytest.mark.parametrize("threads", [1, 3])
def test_blocks_cover_every_row_once(size, threads, monkeypatch):
    monkeypatch.setattr(numba.config, "NUMBA_NUM_THREADS", threads)
    column = np.arange(size, dtype=float)
    sums, parts = mapped(kernel, (), [column, 1.0], OUTPUTS)
    assert np.array_equal(sums, column + 1)
    assert parts.shape == (size, 2)
    assert parts.dtype == np.float32
    assert np.array_equal(parts[:, 1], np.full(size, 2.0))


@pytest.mark.parametrize("cores", [1, 2])
def test_a_call_uses_the_cores_that_its_caller_gives_it(cores):
    threads = set()

    def noting(kinds, rows, sums):
        threads.add(threading.get_ident())

    def call():
        arrays.CORES.set(cores)
        mapped(noting, (), [np.arange(8.0 * BLOCK)], OUTPUTS[:1])

    contextvars.copy_context().run(call)
    assert (threads == {threading.get_ident()}) == (cores == 1)


def test_rows_of_broadcast_columns():
    sums, parts = mapped(kernel, (), [np.arange(3.0)[:, None], np.arange(4.0) * 10], OUTPUTS)
    assert np.array_equal(sums, np.add.outer(np.arange(3.0), 10 * np.arange(4.0)))
    assert parts.shape == (3, 4, 2)


def test_an_error_in_a_block_is_raised():
    def broken(kinds, rows, sums):
        if rows[0, 0] > 0:
            raise OSError("no room")

    with pytest.raises(OSError, match="no room"):
        mapped(broken, (), [np.arange(3.0 * BLOCK)], OUTPUTS[:1])


def test_elementwise_gives_what_it_is_given():
    def doubled(x):
        return [np.asarray(x) * 2.0]

    outputs = [Output("spin_ratio")]
    assert elementwise(doubled, [3.0], outputs) == [6.0]
    assert type(elementwise(doubled, [3.0], outputs)[0]) is float
    assert np.array_equal(elementwise(doubled, [np.ones(2)], outputs)[0], [2.0, 2.0])
    (found,) = elementwise(doubled, [xr.DataArray([1.0], dims="a")], outputs)
    assert found.attrs == {"units": "1", "long_name": "spin ratio R omega / v"}
    assert not arrays.is_labeled(np.ones(2))


@pytest.mark.parametrize("block", [1, 7, 64])
def test_blocks_and_threads_do_not_change_a_bit(block, monkeypatch):
    random = np.random.default_rng(5)
    scene = make_scene(10 ** random.uniform(-1, 1, 64), 1.0, BOTH, random.uniform(0.1, 3, 64))
    angle = random.uniform(-3, 3, 64)
    whole = pp.solve(scene, angle)
    monkeypatch.setattr(arrays, "BLOCK", block)
    monkeypatch.setattr(numba.config, "NUMBA_NUM_THREADS", 4)
    cut = pp.solve(scene, angle)
    for name in set(whole.__slots__) - {"derivatives"}:
        assert getattr(whole, name).tobytes() == getattr(cut, name).tobytes()
