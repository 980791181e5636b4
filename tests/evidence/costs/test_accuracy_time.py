"""Errors of the methods for the wrench and their times: everything but how long it took."""

import json

import numpy as np
import pytest

from planar_pushing.evidence.costs import tables
from planar_pushing.evidence.costs.measurements import accuracy_time


@pytest.fixture(scope="module")
def found():
    return accuracy_time(2)


@pytest.fixture(scope="module")
def errors():
    return tables.wrench_errors()


def test_every_method_is_timed_at_every_setting_and_spin_ratio(found, errors):
    assert dict(found.sizes) == {"point": errors.sizes["point"], "spin_ratio": 4, "repeat": 2}
    assert found.wrench_seconds.dims == ("point", "spin_ratio", "repeat")
    assert (found.wrench_seconds > 0).all()
    assert np.array_equal(found.spin_ratio, tables.TIMED)
    for name in ("method", "setting"):
        assert np.array_equal(found[name], errors[name])
    assert (found.batch >= 1).all()


def test_errors_are_those_of_accuracy_errors(found, errors):
    assert np.array_equal(found.error, errors.error.sel(spin_ratio=tables.TIMED))


def test_counts_stay_in_accuracy_errors(found):
    assert set(found.data_vars) == {"error", "wrench_seconds", "batch"}


def test_it_says_what_it_holds_and_where_it_was_measured(found):
    assert found.wrench_seconds.attrs["units"] == "s"
    assert all({"units", "long_name"} <= set(each.attrs) for each in found.variables.values())
    assert {"processor", "cores", "python", "numpy"} <= set(json.loads(found.attrs["machine"]))
    assert json.loads(found.attrs["parameters"]) == {"repeats": 2}
    assert {"title", "source"} <= set(found.attrs)
