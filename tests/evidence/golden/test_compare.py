"""The comparison with golden data finds every kind of difference, and passes only without any."""

import re

import numpy as np
import pytest
import xarray as xr

from planar_pushing.evidence.golden.build.enclosures import golden_variables
from planar_pushing.evidence.golden.compare import compare
from planar_pushing.evidence.golden.tolerances import Tolerance

VALUES = np.array([[1.0, 2.0, np.inf], [4.0, 5.0, 0.0]])


def result(**changes):
    """A result over (a, x) with a count and a label, some of it changed."""
    variables = {
        "size": (("a", "x"), VALUES.copy(), {"units": "length"}),
        "turn": (("x",), np.array([10.0, 20.0, 30.0, 40.0]), {"units": "degree"}),
        "count": (("a",), np.array([1, 2], np.int8), {"units": "1"}),
    }
    variables["size"] = (("a", "x"), np.c_[VALUES, [7.0, 8.0]], {"units": "length"})
    coords = {
        "a": ("a", ["one", "two"], {"units": "1"}),
        "x": ("x", [0.0, 1.0, 2.0, 3.0], {"units": "length"}),
    }
    return xr.Dataset(variables | changes, coords)


def golden(radius=0.0):
    """Golden data over a part of the axis x."""
    whole = result().isel(x=slice(3))
    whole["size_low"] = (("a", "x"), np.zeros((2, 3)))
    whole["size_radius"] = (("a", "x"), np.full((2, 3), radius))
    return whole


def only(checks, name):
    return next(check for check in checks if check.name == f"data: {name}")


def test_equal_data_pass():
    checks = compare("data", result(), golden(), {})
    assert [check.name for check in checks] == ["data: size", "data: turn", "data: count"]
    assert all(check.passed for check in checks)
    assert sum(check.count for check in checks) == 11


def test_parts_of_an_enclosure_are_no_variables():
    assert golden_variables(golden()) == ["size", "turn", "count"]


@pytest.mark.parametrize(
    ("step", "radius", "tolerance", "passes"),
    [
        (1e-15, 0.0, Tolerance(), False),
        (1e-15, 1e-14, Tolerance(), True),
        (1e-15, 0.0, Tolerance(absolute=1e-14), True),
        (3e-15, 0.0, Tolerance(ulp=4), True),
        (8e-15, 0.0, Tolerance(ulp=4), False),
    ],
)
def test_tolerance_and_radius(step, radius, tolerance, passes):
    values = np.c_[VALUES, [7.0, 8.0]]
    values[1, 0] += step
    changed = result(size=(("a", "x"), values, {"units": "length"}))
    check = only(compare("data", changed, golden(radius), {"size": tolerance}), "size")
    assert check.passed is passes
    assert "a=two, x=0.0: computed 4.0000000000000" in check.where
    assert check.error == pytest.approx(step, rel=0.3, abs=0)
    assert check.ulp == pytest.approx(check.error / np.spacing(4.0))


def test_the_low_part_counts():
    data = golden()
    data["size_low"][:] = 1e-17
    assert not only(compare("data", result(), data, {}), "size").passed
    tolerance = {"size": Tolerance(absolute=2e-17)}
    assert only(compare("data", result(), data, tolerance), "size").passed


@pytest.mark.parametrize("value", [np.inf, -np.inf, 3.0])
def test_infinities_are_values(value):
    values = np.c_[VALUES, [7.0, 8.0]]
    values[0, 2] = value
    changed = result(size=(("a", "x"), values, {"units": "length"}))
    generous = {"size": Tolerance(ulp=1e300, absolute=1e300)}
    check = only(compare("data", changed, golden(), generous), "size")
    assert check.passed is (value == np.inf)


def test_a_full_turn_is_a_difference():
    angles = np.array([10.0, 380.0, 30.0, 40.0])
    changed = result(turn=(("x",), angles, {"units": "degree"}))
    assert not only(compare("data", changed, golden(), {}), "turn").passed


def test_a_wrong_count_fails():
    changed = result(count=(("a",), np.array([1, 3], np.int8), {"units": "1"}))
    check = only(compare("data", changed, golden(), {"count": Tolerance(ulp=4)}), "count")
    assert (check.passed, check.failed) == (False, 1)


@pytest.mark.parametrize(
    ("changed", "problem"),
    [
        (result().drop_vars("size"), "is missing from the result"),
        (result(size=(("a", "x"), np.c_[VALUES, [7.0, 8.0]], {"units": "1"})),
         "has units '1', not 'length'"),
        (result(size=(("a", "x"), np.full((2, 4), np.nan), {"units": "length"})),
         "has NaN, or none, at 6 points"),
        (result().isel(x=[0, 2, 3]), "has no x 1.0"),
        (result(size=(("a",), np.ones(2), {"units": "length"})), r"has the dims \('a',\), not"),
        (result().assign_coords(x=("x", [0.0, 1.0, 2.0, 3.0], {"units": "degree"})),
         "has x in 'degree'"),
    ],
)  # fmt: skip
def test_problems_fail(changed, problem):
    check = only(compare("data", changed, golden(), {"size": Tolerance(absolute=1e9)}), "size")
    assert not check.passed
    assert re.match(problem, check.problem), check.problem
