"""Grids of the limit curves: the same in blocks of any size, and errors that fall with the size."""

import pytest
import xarray as xr

from planar_pushing.evidence.costs import grids


def test_a_grid_is_the_same_in_blocks_of_any_size(tmp_path):
    for block in (64, 10**6):
        grids.write_grid(5000, block, tmp_path / f"{block}.h5")
    few, many = (xr.open_dataset(tmp_path / f"{b}.h5", engine="h5netcdf", phony_dims="sort")
                 for b in (64, 10**6))  # fmt: skip
    with few, many:
        xr.testing.assert_identical(few.load(), many.load())


def test_errors_of_a_grid_fall_with_its_size(tmp_path):
    found = []
    for size in (10**4, 10**5):
        grids.write_grid(size, grids.BLOCK, tmp_path / "grid.h5")
        found.append(grids.grid_errors(tmp_path / "grid.h5"))
    assert all(at_points < 1e-13 for at_points, _ in found)
    # Linear interpolation: a hundredth of the error at a tenth of the step.
    assert found[1][1] == pytest.approx(found[0][1] / 100, rel=0.2)


def test_memory_depends_on_the_block_alone(tmp_path):
    """At four times the points the memory stays what it was."""
    path = tmp_path / "grid.h5"
    grids.peak_memory(1000, 1000, path)
    small, large = (grids.peak_memory(size, 1000, path) for size in (10000, 40000))
    assert large < 1.2 * small
