"""Parts of a dataset by the names of its axes."""

import pytest
import xarray as xr

from planar_pushing import InvalidValue
from planar_pushing.study.query import axis_names, select

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


def test_close_values_are_listed_apart():
    with pytest.raises(InvalidValue, match=r"allowed: 1\.4, 1\.4000001, 2; choose a value"):
        select(CLOSE, {"friction_coefficient": "1.5"})
