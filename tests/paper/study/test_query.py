"""Parts of a dataset by the names of its axes."""

import numpy as np
import pytest
import xarray as xr

from planar_pushing import InvalidFile, InvalidValue
from planar_pushing.terms import netcdf
from planar_pushing.terms.netcdf import write_dataset
from pulling_by_pushing.study.query import axis_names, select
from pulling_by_pushing.study.store import read_dataset

CLOSE = xr.Dataset(
    {"angle": (("contact", "side"), [[1.0, 2.0], [3.0, 4.0], [5.0, 6.0]])},
    coords={
        "side": ["right", "left"],
        "friction_coefficient": ("contact", [1.4, 1.4000001, 2.0]),
    },
)


def test_labels_along_an_axis_are_axes_too():
    assert axis_names(CLOSE) == ["friction_coefficient", "side"]
    found = select(CLOSE, {"friction_coefficient": "1.4000001", "side": "left"})
    assert float(found.angle) == 4.0


def test_damage_in_what_is_read_late_is_one_line(tmp_path, monkeypatch):
    monkeypatch.setattr(netcdf, "LARGE", 2**23)
    noise = np.random.default_rng(3).random((300, 4000))
    write_dataset(
        xr.Dataset({"grid": (("a", "b"), noise)}, {"a": range(300)}), tmp_path / "large.nc"
    )
    content = bytearray((tmp_path / "large.nc").read_bytes())
    middle = len(content) // 2
    content[middle : middle + 4000] = bytes(4000)
    (tmp_path / "large.nc").write_bytes(content)
    with pytest.raises(
        InvalidFile,
        match=r"large\.nc: is not a netCDF4 file; give a dataset, or rebuild a damaged one",
    ):
        select(read_dataset(tmp_path / "large.nc"), {})


def test_close_values_are_listed_apart():
    with pytest.raises(InvalidValue, match=r"allowed: 1\.4, 1\.4000001, 2; choose a value"):
        select(CLOSE, {"friction_coefficient": "1.5"})
