"""Kernels over blocks of rows in threads, and results of the kind of the arguments."""

from __future__ import annotations

import contextvars
import threading

import numpy as np
import pytest
import xarray as xr
from mechanics.builders import BOTH, make_scene

import planar_pushing as pp
from planar_pushing.mechanics.kernels import arrays
from planar_pushing.mechanics.kernels.arrays import BLOCK, Output, elementwise, map_kernel

OUTPUTS = (Output("sum"), Output("parts", (("part", 2),), "f4"))


def on_cores(cores, function, *arguments):
    """Call a function that may use a number of cores."""

    def call():
        arrays.CORES.set(cores)
        return function(*arguments)

    return contextvars.copy_context().run(call)


@pytest.fixture
def kernel(monkeypatch):
    """A kernel that writes what the rows share plus the sum of a row, and the row's entries doubled."""

    def run(name, data, rows, width):
        assert (name, width, rows.shape[1]) == ("kernel", 3, 2)
        return np.column_stack([data[0] + rows.sum(axis=1), 2.0 * rows])

    monkeypatch.setattr(arrays, "run", run)


@pytest.mark.parametrize("size", [0, 1, BLOCK - 1, BLOCK, BLOCK + 1, 2 * BLOCK + 3])
@pytest.mark.parametrize("cores", [1, 3])
@pytest.mark.usefixtures("kernel")
def test_blocks_cover_every_row_once(size, cores):
    column = np.arange(size, dtype=float)
    sums, parts = on_cores(cores, map_kernel, "kernel", np.array([0.5]), [column, 1.0], OUTPUTS)
    assert np.array_equal(sums, column + 1.5)
    assert parts.shape == (size, 2)
    assert parts.dtype == np.float32
    assert np.array_equal(parts, 2 * np.column_stack([column, np.ones(size)]))


@pytest.mark.parametrize("cores", [1, 2])
def test_a_call_uses_the_cores_that_its_caller_gives_it(cores, monkeypatch):
    threads = set()

    def run(name, data, rows, width):
        threads.add(threading.get_ident())
        return rows

    monkeypatch.setattr(arrays, "run", run)
    on_cores(cores, map_kernel, "kernel", np.zeros(0), [np.arange(8.0 * BLOCK)], OUTPUTS[:1])
    assert (threads == {threading.get_ident()}) == (cores == 1)
    assert len(threads) <= cores


@pytest.mark.usefixtures("kernel")
def test_rows_of_broadcast_columns():
    columns = np.arange(3.0)[:, None], np.arange(4.0) * 10
    sums, parts = map_kernel("kernel", np.zeros(1), columns, OUTPUTS)
    assert np.array_equal(sums, np.add.outer(*map(np.ravel, columns)))
    assert parts.shape == (3, 4, 2)


@pytest.mark.usefixtures("kernel")
def test_outputs_are_decoded_from_the_results_and_the_columns_of_each_block(monkeypatch):
    """A scalar stays a scalar, so that it is not compared a hundred thousand times."""
    monkeypatch.setattr(arrays, "BLOCK", 4)

    def decode(results, columns, outputs):
        outputs[0][:] = results[:, 2] - columns[0] + np.ndim(columns[1])

    (found,) = map_kernel("kernel", np.zeros(1), [np.arange(11.0), 7.0], OUTPUTS[:1], 3, decode)
    assert np.array_equal(found, 14.0 - np.arange(11.0))


def test_an_error_in_a_block_is_raised(monkeypatch):
    def broken(name, data, rows, width):
        if rows[0, 0] > 0:
            raise OSError("no room")
        return rows

    monkeypatch.setattr(arrays, "run", broken)
    for cores in (1, 2):
        with pytest.raises(OSError, match="no room"):
            on_cores(
                cores, map_kernel, "kernel", np.zeros(0), [np.arange(3.0 * BLOCK)], OUTPUTS[:1]
            )


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
    cut = on_cores(4, pp.solve, scene, angle)
    for name in whole.__slots__:
        if getattr(whole, name) is not None:
            assert getattr(whole, name).tobytes() == getattr(cut, name).tobytes()
