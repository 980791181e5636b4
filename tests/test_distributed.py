"""Array calls on dask's own cluster, as in a notebook."""

import numpy as np
import pytest
import xarray as xr

import planar_pushing as pp


def scenes(length):
    slider = pp.Slider(rod_length=length, rod_angle=np.pi / 4)
    return pp.Scene(slider=slider, contact=pp.Coulomb(2.0), effects=(pp.RingFriction(),))


@pytest.mark.slow
def test_two_worker_processes_solve_scenes():
    from distributed import Client, LocalCluster

    length = xr.DataArray(np.linspace(0.5, 5.0, 40), dims="rod_length")
    angle = xr.DataArray(np.deg2rad(np.arange(-30.0, 180.0, 15.0)), dims="pusher_angle")
    lazy = pp.solve(scenes(length.chunk(rod_length=10)), angle)
    assert lazy.mode.chunks
    with (
        LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster,
        Client(cluster) as client,
    ):
        found = lazy.compute()
        assert len(client.scheduler_info(n_workers=-1)["workers"]) == 2
    xr.testing.assert_identical(found, pp.solve(scenes(length), angle))
