"""Numbers and tables about accuracy, hard cases, effects and times, from small datasets."""

import csv
import io
from pathlib import Path

import numpy as np
import pytest
from report.costs import GROUPS, accuracy, effects, write_costs

from planar_pushing.terms.errors import InvalidFile
from pulling_by_pushing.report.costs.numbers import count_absent, count_listed
from pulling_by_pushing.report.costs.tables import COST_TABLES, case_text, time_text
from pulling_by_pushing.report.parts.costs import ACCURACY, EFFECTS, HARD_CASES, TIMES
from pulling_by_pushing.report.results import MEASURED, Results

NUMBERS = ACCURACY | TIMES | HARD_CASES | EFFECTS


@pytest.fixture(scope="module")
def results(tmp_path_factory):
    folder = tmp_path_factory.mktemp("costs")
    write_costs(folder)
    return Results(folder, folder)


def rows(text):
    return list(csv.DictReader(io.StringIO(text)))


@pytest.mark.parametrize(
    ("key", "text"),
    [
        ("spin-ratios", "9"),
        ("trapezoid-error", "9.6e-11"),
        ("event-driven-error", "2.4e-12"),
        ("time-stepping-error", "8.8e-04"),
        # Least times grow by 1 us along the spin ratios, and by 9 us from setting to setting.
        ("closed-form-time-least", "1000"),
        ("closed-form-time-most", "9000"),
        ("quad-time-least", str(10 * (9 * 32 + 1))),
        ("quad-time-most", str(10 * (9 * 32 + 9))),
        ("closed-form-call-time", "90"),
        ("trapezoid-time", "0.2"),
        ("cone-time", "1.0"),
        ("cone-call-time", "10"),
        ("brentq-time-ratio", "7"),
        ("event-driven-time", "0.0"),
        ("tolerance-time-ratio", "9.0"),  # of two scenes and five tolerances
        ("log-time", "2.0"),
        ("hard-cases", "14"),
        ("hard-well", "13"),
        ("hard-ill", "1"),
        ("hard-accurate", "10"),
        ("hard-largest", "9"),
        ("hard-largest-condition", "17"),
        ("hard-largest-elsewhere", "3.5"),
        ("hard-thin", "6.0e+05"),
        ("hard-motions", "1"),
        ("hard-motion", "700"),
        ("hard-digits", "12"),
        ("hard-tolerance", "1e-12"),
        ("hard-share", "1.5"),
        ("hard-limit", "1e+06"),
        ("effects-single", "4"),
        ("effects-listed", str((1 + 10) * (3 + 5))),
        ("effects-absent", "0"),
    ],
)
def test_number(results, key, text):
    assert NUMBERS[key].entry(results)["text"] == text


def test_an_effect_that_is_evaluated_though_absent_is_counted():
    data = effects()
    data.evaluations[0, 0, 1] = 13
    assert count_absent(data) == 13
    assert count_listed(data) == (1 + 10) * (3 + 5)


def test_each_method_is_shown_at_its_best_setting(results):
    listed = {
        (row["computed"], row["method"]): row for row in rows(COST_TABLES["accuracy"](results))
    }
    for group in GROUPS:
        data = accuracy(group)
        errors = data[f"{group}_error"].values.reshape(data.sizes["point"], -1).max(axis=1)
        for name in np.unique(data.method.values):
            row = listed.pop((group, str(name)))
            error = np.inf if row["error"] == "NaN" else float(row["error"])
            least = errors[data.method.values == name].min()
            assert error == pytest.approx(least, rel=0.06, abs=0)
            if row["setting"] != "\u2013":
                chosen = np.isclose(data.setting, float(row["setting"]), rtol=0.1, atol=0)
                assert errors[chosen & (data.method.values == name)] == least
    assert listed == {}


def test_calls_and_the_longest_time_stand_beside_an_error(results):
    found = {row["method"]: row for row in rows(COST_TABLES["accuracy"](results))}
    assert found["hyp2f1"]["calls"] == "\u2013"
    assert (
        found["hyp2f1"]["time in an array"] == "18 \u00b5s"
    )  # of nine spin ratios, the second row
    assert found["hyp2f1"]["time of a call"] == "180 \u00b5s"
    assert found["quad"]["time in an array"] == "\u2013"
    assert found["event-driven"]["calls"] == "8"


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (2.51e-8, "25 ns"),
        (1.5e-6, "1.5 \u00b5s"),
        (0.0101, "10 ms"),
        (3.0, "3.0 s"),
        (2e-10, "0.20 ns"),
        (float("nan"), "\u2013"),
    ],
)
def test_times_as_text(value, text):
    assert time_text(value) == text


def test_hard_places_leave_out_the_errors_of_ill_conditioned_cases(results):
    found = rows(COST_TABLES["hard_places"](results))
    assert [row["cases"] for row in found] == ["1"] * 6 + ["2"] + ["1"] * 6
    assert list(found[6].values())[1:] == ["2", "1", "1", "9.0"]


def test_ill_conditioned_cases_with_their_digits(results):
    (row,) = rows(COST_TABLES["hard_ill"](results))
    assert list(row.values()) == ["case at phi = 7", "3.0e+08", "7", "4.0e+07"]


def test_evaluations_by_what_is_listed(results):
    found = [list(row.values()) for row in rows(COST_TABLES["effects"](results))]
    counts = [[int(each) for each in row[1:]] for row in found[:4]]
    assert counts == [[3, 0, 70], [0, 5, 90], [30, 0, 700], [0, 50, 900]]
    assert found[0][0] == "motion by events, evaluations of friction"
    assert len(found) == 4


def test_a_missing_measurement_is_named(tmp_path):
    for name in MEASURED:
        with pytest.raises(InvalidFile, match=rf"{name}\.nc: no such dataset"):
            Results(Path(tmp_path), tmp_path).dataset(name)


def test_names_of_cases_as_prose_has_them():
    assert case_text("inertia, l = 1e+06, phi = 0.7853981633974484") == (
        "inertia, l = 1\u2009000\u2009000, phi = 0.7854"
    )
    assert case_text("slip at n . u = -0.0400296") == "slip at n \u00b7 u = -0.04003"
