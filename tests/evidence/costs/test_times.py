"""Times of methods: calls in turns, on a machine that is described; everything but how long it took."""

import json
import platform

import numpy as np
import pytest

from planar_pushing.evidence.costs import motion, tables, times
from planar_pushing.evidence.costs.methods import METHODS
from planar_pushing.evidence.costs.times import TIMED, accuracy, accuracy_time, machine, seconds


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
    assert np.array_equal(found.spin_ratio, TIMED)
    for name in ("method", "setting"):
        assert np.array_equal(found[name], errors[name])
    assert (found.batch >= 1).all()


def test_errors_are_those_of_accuracy_errors(found, errors):
    assert np.array_equal(found.error, errors.error.sel(spin_ratio=TIMED))


def test_counts_stay_in_accuracy_errors(found):
    assert set(found.data_vars) == {"error", "wrench_seconds", "batch"}


def test_it_says_what_it_holds_and_where_it_was_measured(found):
    assert found.wrench_seconds.attrs["units"] == "s"
    assert all({"units", "long_name"} <= set(each.attrs) for each in found.variables.values())
    assert {"processor", "cores", "python", "numpy"} <= set(json.loads(found.attrs["machine"]))
    assert json.loads(found.attrs["parameters"]) == {"repeats": 2}
    assert {"title", "source"} <= set(found.attrs)


def test_every_quantity_is_measured(monkeypatch):
    for name in ("REPEATS", "MOTION_REPEATS"):
        monkeypatch.setattr(times, name, 1)
    for quantity, each in METHODS.items():
        monkeypatch.setitem(METHODS, quantity, each[:1])
    monkeypatch.setattr(motion, "ROWS", motion.ROWS[:1])
    found = accuracy()
    assert list(found) == ["wrench", "cone", "motion"]
    for name, each in found.items():
        assert (each[f"{name}_seconds"] > 0).all()
        assert all({"units", "long_name"} <= set(v.attrs) for v in each.variables.values())
        assert json.loads(each.attrs["machine"])["cores"]


def test_calls_are_timed_in_turns_after_a_round_that_does_not_count():
    calls = []
    taken = seconds([lambda: calls.append("a"), lambda: calls.append("b")], 5)
    assert taken.shape == (2, 5)
    assert (taken >= 0).all()
    assert calls == ["a", "b"] * 6


def test_the_machine_is_described_without_its_name():
    found = machine()
    assert {"processor", "cores", "system", "python", "numpy", "scipy"} <= set(found)
    assert platform.node() not in found.values()
