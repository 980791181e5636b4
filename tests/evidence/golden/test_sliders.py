"""The check of a study of sliders: it passes, sees every wrong value, and counts what it saw."""

import numpy as np
import pytest

from evidence.golden import tampering
from planar_pushing.evidence.golden import check
from planar_pushing.evidence.golden.build.enclosures import golden_variables
from planar_pushing.evidence.golden.by_rule import check_dataset
from planar_pushing.evidence.golden.compare import compare
from planar_pushing.evidence.golden.rules import RULES, Rule
from planar_pushing.evidence.golden.tolerances import load_tolerances
from planar_pushing.evidence.golden.verdict import verdict
from planar_pushing.study.build import build_dataset
from planar_pushing.study.catalog import SLIDERS
from planar_pushing.study.describe import of_study
from planar_pushing.study.provenance import provenance
from planar_pushing.study.slices import study_slice
from planar_pushing.study.store import read_dataset, write_dataset
from planar_pushing.study.studies import SLIDERS_FILE
from planar_pushing.study.study_file import load_study

SMOKE = "workflow/config/sliders_smoke.yaml"
STUDY, FULL = load_study(SMOKE), load_study(SLIDERS_FILE)
MARKS = provenance(STUDY, SMOKE)
TOLERANCES = load_tolerances(check.Path(FULL.golden))
#: Variables by dataset.
VARIABLES = [(name, variable) for name in SLIDERS for variable in RULES[name]]
#: Means and maxima over motions, which are computed anew without balls.
WITHOUT_BALLS = {"worst_force_error", "mean_force_error", "worst_motion_error", "mean_motion_error"}


@pytest.fixture(scope="module")
def results(tmp_path_factory):
    """The datasets of the smallest study of sliders."""
    folder = tmp_path_factory.mktemp("results")
    for name in SLIDERS:
        built = of_study(build_dataset(name, study_slice(STUDY, name)), name, MARKS(name))
        write_dataset(built, folder / f"data/{name}.nc")
    return check.Results(folder)


@pytest.fixture(scope="module")
def expected(results):
    """What each dataset must be."""
    found = dict(check.expectations(STUDY, MARKS, results))
    return {name: found[name]()[""] for name in SLIDERS}


def with_one_wrong(dataset, variable):
    """The largest number is off by 1e-9 of itself or of 1, a count by one, or a flag is turned."""
    values = dataset[variable].values.copy()
    sizes = np.nan_to_num(np.abs(values)) if values.dtype.kind == "f" else values
    at = np.unravel_index(np.argmax(sizes), values.shape)
    old = values[at]
    values[at] = {"f": old + tampering.CHANGE * max(1.0, abs(old)), "b": not old}.get(
        values.dtype.kind, old + 1
    )
    return tampering.replaced(dataset, variable, values)


def failed(name, dataset, expected):
    return {
        each.variable for each in check_dataset(name, dataset, expected[name]) if not each.passed
    }


@pytest.mark.parametrize("name", SLIDERS)
def test_what_is_unchanged_passes_and_is_counted(results, expected, name):
    dataset = results.dataset(name)
    checks = check_dataset(name, dataset, expected[name])
    assert all(each.passed for each in checks), [each for each in checks if not each.passed]
    found = verdict(checks)["rules"][Rule.RESIDUAL]
    sizes = [dataset[each].size for each in RULES[name]]
    assert found == {"values": sum(sizes), "variables": len(sizes)}


@pytest.mark.parametrize(("name", "variable"), VARIABLES)
def test_a_wrong_value_is_seen(results, expected, name, variable):
    dataset = results.dataset(name)
    changed = with_one_wrong(dataset, variable)
    assert failed(name, changed, expected) == {variable} | follow(variable)


def follow(variable):
    """What is checked against the changed variable itself."""
    return {"consistent": {"outcome"} | VALUES}.get(variable, set())


VALUES = {"force_angle", "force_angle_end", "motion_angle", "spin"}


@pytest.mark.parametrize("kind", [k for k in tampering.KINDS if k not in (tampering.value,)])
def test_every_kind_of_change_is_seen(results, expected, kind):
    changes = {name: kind(results.dataset(name), np.random.default_rng(5)) for name in SLIDERS}
    made = {name: each for name, each in changes.items() if each is not None}
    assert made
    for name, (changed, what) in made.items():
        assert failed(name, changed, expected), what


def test_every_variable_in_balls_has_golden_data():
    for name in SLIDERS:
        stored = golden_variables(read_dataset(f"{FULL.golden}/{name}.nc"))
        assert set(stored) == set(RULES[name]) - WITHOUT_BALLS
    assert set(check.golden_names(check.Path(FULL.golden))) == set(SLIDERS)


def test_every_tolerance_is_of_a_golden_number():
    names = {each for name in SLIDERS for each in read_dataset(f"{FULL.golden}/{name}.nc")}
    assert {each for each in names if f"{each}_radius" in names} == set(TOLERANCES)


@pytest.mark.parametrize("name", SLIDERS)
def test_a_wrong_value_leaves_its_enclosure(name):
    golden = read_dataset(f"{FULL.golden}/{name}.nc")
    result = golden[golden_variables(golden)]
    assert all(each.passed for each in compare(name, result, golden, TOLERANCES))
    for variable in result:
        changed = with_one_wrong(result, variable)
        wrong = [each for each in compare(name, changed, golden, TOLERANCES) if not each.passed]
        assert [(each.variable, each.failed) for each in wrong] == [(variable, 1)]
