"""Comparison of a dataset with its golden file: each kind of difference is a failed check."""

import json

import numpy as np
import pytest
import xarray as xr

from pulling_by_pushing.evidence.golden.compare import (
    KIND,
    UP_TO_TURNS,
    Kind,
    Tolerance,
    TolerancesFile,
    compare,
    load_tolerances,
)
from pulling_by_pushing.evidence.golden.verdict import verdict, verdict_text
from pulling_by_pushing.evidence.writing import json_text

TOLERANCES = TolerancesFile(tolerances={"one": {"time": Tolerance(absolute=1e-9)}})
#: Radius of the finite numbers, and the size from which on a number counts as infinite.
RADIUS, LARGE = 2.0**-40, 2.0**50
#: A direction, which is compared up to whole turns.
(TURN,) = UP_TO_TURNS


@pytest.fixture
def wanted():
    """A golden dataset: a number that is enclosed, flags, labels and an axis."""
    force = np.array([[1.0, np.nan], [np.inf, 2.0]])
    return xr.Dataset(
        {
            "force": (("law", "angle"), force, {"units": "1", "quantity": "force"}),
            "force_radius": (("law", "angle"), np.array([[-40, -40], [50, -40]], np.int8)),
            TURN: (("angle",), np.array([-179.0, 10.0]), {"units": "degree"}),
            f"{TURN}_radius": (("angle",), np.full(2, -40, np.int8)),
            "time": (("angle",), np.array([0.0, 1.0])),
            "mode": (("law",), np.array([0, 3], np.int8), {"flag_meanings": "A B C D"}),
        },
        {"law": ["rough", "slippery"], "angle": [0.0, 5.0]},
        {KIND: str(Kind.ENCLOSED), "study": "mine", "versions": "old"},
    )


@pytest.fixture
def found(wanted):
    return (
        wanted.drop_vars(["force_radius", f"{TURN}_radius"])
        .copy(deep=True)
        .assign_attrs({"versions": "new"})
    )


def failed(found, wanted):
    return [each for each in compare("one", found, wanted, TOLERANCES) if not each.passes]


def test_what_agrees_passes(found, wanted):
    checks = compare("one", found, wanted, TOLERANCES)
    assert all(each.passes for each in checks)
    (force,) = (each for each in checks if each.variable == "force")
    assert (force.count, force.labels, force.kind) == (2, 2, Kind.ENCLOSED)


def test_numbers_may_differ_by_their_radius(found, wanted):
    found["force"].values[0, 0] = 1 + 0.9 * RADIUS
    assert not failed(found, wanted)
    found["force"].values[0, 0] = 1 + 1.1 * RADIUS
    (check,) = failed(found, wanted)
    assert (check.variable, check.failed) == ("force", 1)
    assert "law=rough, angle=0.0" in check.where
    assert check.error == pytest.approx(1.1 * RADIUS, rel=1e-3)


def test_what_has_no_radius_has_a_tolerance_and_is_not_enclosed(found, wanted):
    found["time"].values[1] += 0.9e-9
    checks = compare("one", found, wanted, TOLERANCES)
    assert [(each.passes, each.kind) for each in checks if each.variable == "time"] == [
        (True, Kind.PLAIN)
    ]
    found["time"].values[1] += 0.2e-9
    assert [each.variable for each in failed(found, wanted)] == ["time"]


def test_directions_agree_up_to_whole_turns(found, wanted):
    found[TURN].values[:] = 181.0, -350.0
    assert not failed(found, wanted)
    found[TURN].values[0] = 181.0 + 1.1 * RADIUS
    (check,) = failed(found, wanted)
    assert check.error == pytest.approx(1.1 * RADIUS, rel=1e-2)


@pytest.mark.parametrize("value", [np.inf, 1.1 * LARGE, -1.1 * LARGE])
def test_what_is_beyond_a_reciprocal_counts_as_infinite(found, wanted, value):
    found["force"].values[1, 0] = value
    assert not failed(found, wanted)


@pytest.mark.parametrize("value", [-np.inf, 0.9 * LARGE, np.nan])
def test_what_is_not_beyond_a_reciprocal_is_not_infinite(found, wanted, value):
    found["force"].values[1, 0] = value
    assert [each.variable for each in failed(found, wanted)] == ["force"]


def test_a_verdict_on_a_number_in_place_of_infinity_can_be_written(found, wanted):
    found["force"].values[1, 0] = 3.0
    (entry,) = (each for each in verdict(failed(found, wanted))["checks"] if each["variable"])
    assert (entry["error"], entry["ulp"], entry["failed"]) == (None, 0.0, 1)
    assert json.loads(json_text(entry)) == entry


def test_a_difference_from_zero_has_no_end_of_units_in_the_last_place(found, wanted):
    wanted["force"].values[0, 0] = 0.0
    found["force"].values[0, 0] = 1.0
    (check,) = failed(found, wanted)
    assert (check.error, check.ulp) == (1.0, np.inf)


@pytest.mark.parametrize("place", [(0, 1), (1, 0)])
def test_nan_and_infinity_are_the_same_or_fail(found, wanted, place):
    found["force"].values[place] = 1.0
    (check,) = failed(found, wanted)
    assert check.variable == "force"


def test_flags_and_labels_must_be_equal(found, wanted):
    found["mode"].values[1] = 2
    assert [each.variable for each in failed(found, wanted)] == ["mode"]
    other = found.assign_coords(law=["rough", "sticky"]).assign(mode=wanted["mode"].variable)
    assert "law" in [each.variable for each in failed(other, wanted)]


@pytest.mark.parametrize(
    ("change", "problem"),
    [
        (lambda data: data.drop_vars("mode"), "mode is missing from the result"),
        (lambda data: data.assign(more=data["mode"]), "more is not in the golden data"),
        (lambda data: data.assign_attrs(study="other"), "has study 'other', not 'mine'"),
        (lambda data: data.isel(angle=[0]), "force has the shape (2, 1), not (2, 2)"),
        (lambda data: data.transpose(), "force has the dims ('angle', 'law')"),
        (lambda data: data.assign(mode=data["mode"].astype(float)), "mode has the type float64"),
        (lambda data: data.assign(mode=data["mode"].astype("int16")), "mode has the type int16"),
        (
            lambda data: data.assign(force=data["force"].assign_attrs(units="2")),
            "force has units '2', not '1'",
        ),
    ],
)
def test_what_is_not_a_number_is_compared_too(found, wanted, change, problem):
    assert any(problem in each.problem for each in failed(change(found), wanted))


def test_another_study_is_the_first_thing_that_is_said(found, wanted):
    wanted = wanted.assign_attrs(study_digest="sha256:9e00")
    assert not failed(found.assign_attrs(study_digest="sha256:9e00"), wanted)
    checks = failed(found.assign_attrs(study_digest="sha256:d200"), wanted)
    assert checks[0].problem == "has study_digest 'sha256:d200', not 'sha256:9e00'"
    said = "FAILED: the study differs from the one of the golden data ("
    for given, named in (checks, "one"), (2 * checks, "one and 1 more"):
        first, second, *_ = verdict_text(verdict(given)).splitlines()
        assert first.startswith(
            f"{said}{named}); `make golden` shows the differences, `planar-pushing check"
        )
        assert second.startswith("FAILED: ")
    other = failed(found.assign_attrs(study_digest="sha256:9e00", study="other"), wanted)
    assert said not in verdict_text(verdict(other))


def test_versions_of_packages_may_differ(found, wanted):
    assert not failed(found.assign_attrs(versions="newest"), wanted)


def test_a_variable_without_a_tolerance_must_be_exact(found, wanted):
    later = found.assign(time=found["time"] + 1e-14)
    assert [
        each.variable for each in compare("two", later, wanted, TOLERANCES) if not each.passes
    ] == ["time"]


def test_a_folder_of_files_has_tolerances():
    file = TolerancesFile(
        tolerances={"logs": {"time": Tolerance(ulp=1)}, "logs/long": {"time": Tolerance(ulp=2)}}
    )
    assert file.of("logs/long", "time").ulp == 2
    assert file.of("logs/short", "time").ulp == 1
    assert file.of("logs", "mode") == Tolerance()


def test_the_verdict_prints_what_each_dataset_uses_of_what_is_allowed(found, wanted):
    found["force"].values[0, 0] = 1 + 0.5 * RADIUS
    judged = verdict(compare("one", found, wanted, TOLERANCES))
    assert judged["used"]["one"] == pytest.approx(0.5, rel=1e-3)
    assert "  0.5 of the allowed difference is used in one\n" in verdict_text(judged)


def test_the_package_has_tolerances_only_for_what_has_no_radius():
    assert set(load_tolerances().tolerances) == {
        "accuracy", "model_errors", "model_estimates", "simulations", "supports"
    }  # fmt: skip
