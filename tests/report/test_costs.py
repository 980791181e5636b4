"""Numbers and tables about accuracy, hard cases, effects and times, from small datasets."""

import csv
import io
import json
from pathlib import Path

import numpy as np
import pytest

from planar_pushing.report import supplement
from planar_pushing.report.costs.numbers import absent, listed
from planar_pushing.report.costs.tables import COST_TABLES, case_text, spin_ratio_text
from planar_pushing.report.parts.costs import ACCURACY, EFFECTS, HARD_CASES, TIMES
from planar_pushing.report.results import MEASURED, Results
from planar_pushing.study.store import read_dataset
from planar_pushing.terms.errors import InvalidFile
from report.costs import STORED, evaluations, write_costs, write_times

NUMBERS = ACCURACY | TIMES | HARD_CASES | EFFECTS


@pytest.fixture(scope="module")
def results(tmp_path_factory):
    folder = tmp_path_factory.mktemp("costs")
    write_costs(folder)
    write_times(folder)
    return Results(folder, folder)


def rows(text):
    return list(csv.DictReader(io.StringIO(text)))


@pytest.mark.parametrize(
    ("key", "text"),
    [
        ("spin-ratios", "9"),
        ("trapezoid-evaluations", "131072"),
        ("trapezoid-error", "9.6e-11"),
        ("quad-evaluations-near", "2478"),
        ("quad-evaluations-on", "42"),
        ("ellipsoid-error", "100"),
        ("quartic-error", "3.0"),
        ("brentq-evaluations", "3360"),
        ("rim-ellipsoid", "7.86"),
        ("rim-quartic", "0.19"),
        ("ellipsoid-cone-error", "9.6"),
        ("quartic-cone-error", "0.31"),
        # Least times grow by 1 us along the spin ratios, and by 4 us from setting to setting.
        ("closed-form-time-least", "1000"),
        ("closed-form-time-most", "4000"),
        ("quad-time-least", str(4 * 32 + 1)),
        ("quad-time-most", str(4 * 32 + 4)),
        ("quad-time-ratio", str((4 * 32 + 4) // 4)),
        ("trapezoid-time", "0.1"),
        ("hard-cases", "8"),
        ("hard-well", "7"),
        ("hard-ill", "1"),
        ("hard-accurate", "6"),
        ("hard-largest", "9"),
        ("hard-largest-condition", "17"),
        ("hard-largest-elsewhere", "3.5"),
        ("hard-share", "1.5"),
        ("hard-limit", "1e+06"),
        ("hard-least-condition", "3.0e+08"),
        ("effects-single", "4"),
        ("effects-listed", str((1 + 10) * (3 + 5))),
        ("effects-absent", "0"),
    ],
)
def test_number(results, key, text):
    assert NUMBERS[key].entry(results)["text"] == text


def test_an_effect_that_is_evaluated_though_absent_is_counted():
    data = evaluations()
    data.evaluations[0, 0, 1] = 13
    assert absent(data) == 13
    assert listed(data) == (1 + 10) * (3 + 5)


def test_each_method_is_shown_at_its_best_setting(results):
    wrench = read_dataset(STORED, "wrench")
    found = {row["method"]: row for row in rows(COST_TABLES["accuracy_wrench"](results))}
    assert set(found) == set(wrench.method.values)
    for name, row in found.items():
        worst = wrench.error[wrench.method.values == name].max("spin_ratio").values
        shown = np.inf if row["worst error"] == "NaN" else float(row["worst error"])
        assert shown == pytest.approx(worst.min(), rel=0.06, abs=0)
    assert found["closed form"]["calls"] == "\u2013"
    assert found["textbook E and K"]["at k"] == "1"


def test_cone_methods_stand_at_their_last_setting(results):
    cone = read_dataset(STORED, "cone")
    for row in rows(COST_TABLES["accuracy_cone"](results)):
        last = cone.cone_error[cone.method.values == row["method"]][-1]
        assert float(row["error, degrees"]) == pytest.approx(float(last), rel=0.06, abs=0)


def test_hard_places_leave_out_the_errors_of_ill_conditioned_cases(results):
    found = rows(COST_TABLES["hard_places"](results))
    assert [row["cases"] for row in found] == ["1"] * 6 + ["2"]
    assert list(found[-1].values())[1:] == ["2", "1", "1", "9.0"]


def test_ill_conditioned_cases_with_their_digits(results):
    (row,) = rows(COST_TABLES["hard_ill"](results))
    assert list(row.values()) == ["case at phi = 7", "3.0e+08", "7", "4.0e+07"]


def test_evaluations_by_what_is_listed(results):
    found = rows(COST_TABLES["evaluations"](results))
    for row, factor in zip(found, [1, 10], strict=True):
        counts = list(map(int, list(row.values())[1:]))
        assert counts == [factor * each for each in (3, 0, 0, 5, 70, 90)]


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (1e-8, "1e-08"),
        (0.1, "0.1"),
        (1 + 1e-9, "1 + 1e-09"),
        (1 - 1e-3, "1 - 1e-03"),
        (1.0, "1"),
        (1e8, "1e+08"),
    ],
)
def test_spin_ratios_as_text(value, text):
    assert spin_ratio_text(value) == text


def test_numbers_of_the_supplement_are_least_times(results):
    found = json.loads(supplement.numbers_text(results))
    assert list(found) == list(supplement.NUMBERS)
    assert found["closed-form-least"]["text"] == "1000"
    assert found["closed-form-most"]["text"] == "9000"
    assert found["cone-time"]["text"] == "1.00"
    assert found["event-driven-time"]["text"] == "12.5"
    assert found["event-driven-error"]["text"] == "3.0e-12"
    assert found["time-stepping-error"]["text"] == "4.0e-03"
    # Cases 6, 7 and 8: modes of one push with friction, inertia and both.
    assert found["both-solve-ratio"]["text"] == f"{9 / (7 + 8):.1f}"
    assert found["supports"]["text"] == "4"
    assert found["supports-ratio"]["text"] == f"{24 / 22:.1f}"  # the last cases of 24


def test_times_of_effects_in_milliseconds(results):
    found = rows(supplement.effects_text(results))
    assert list(found[0].values()) == ["motion cone", "0.00100", "0.00200", "0.00300"]
    (scene,) = rows(supplement.scenes_text(results))
    assert list(scene.values()) == ["figure 02", "support friction", "0.0190", "0.0200", "0.0210"]


def test_two_machines_are_refused(results, tmp_path):
    assert rows(supplement.machine_text(results)) == [{"what": "processor", "value": "one"}]
    write_times(tmp_path, '{"processor": "another"}')
    with pytest.raises(
        InvalidFile, match="different machines or versions; repeat the measurement with"
    ):
        supplement.machine_text(Results(tmp_path, tmp_path))


def test_a_missing_measurement_is_named(tmp_path):
    for name in MEASURED:
        with pytest.raises(InvalidFile, match=rf"{name}\.nc: no such dataset"):
            Results(Path(tmp_path), tmp_path).dataset(name)


def test_names_of_cases_as_prose_has_them():
    assert case_text("inertia, l = 1e+06, phi = 0.7853981633974484") == (
        "inertia, l = 1\u2009000\u2009000, phi = 0.7854"
    )
    assert case_text("slip at n . u = -0.0400296") == "slip at n \u00b7 u = -0.04003"
