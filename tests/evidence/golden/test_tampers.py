"""Random changes of any dataset are seen: a number by 1e-9 of itself, NaN or its lack, deletion, marks."""

import numpy as np
import pytest

from evidence.golden import tampering
from planar_pushing.evidence.golden import check
from planar_pushing.evidence.golden.by_rule import check_dataset

pytestmark = pytest.mark.slow

#: Changes that are drawn.
COUNT = 120


@pytest.fixture(scope="module")
def datasets(smoke, smoke_marks, smoke_results):
    """Every dataset of a study, and what it must be."""
    results = check.Results(smoke_results)
    return [
        (f"{name}/{group}", results.dataset(name, group), expectation)
        for name, groups in check.expectations(smoke, smoke_marks, results)
        for group, expectation in groups().items()
        if expectation.structure.variables
    ]


def test_what_is_unchanged_passes(datasets):
    for name, dataset, expectation in datasets:
        checks = check_dataset(name, dataset, expectation)
        assert all(each.passed for each in checks), [each for each in checks if not each.passed]


def test_random_changes_are_seen(datasets):
    random = np.random.default_rng(13)
    for _ in range(COUNT):
        name, dataset, expectation = datasets[random.integers(len(datasets))]
        changed, what = tampering.tampered(dataset, random)
        checks = check_dataset(name, changed, expectation)
        assert not all(each.passed for each in checks), f"{name}: {what} is not seen"


@pytest.mark.parametrize("kind", tampering.KINDS)
def test_every_kind_of_change_is_named(datasets, kind):
    random = np.random.default_rng(5)
    name, dataset, expectation = next(each for each in datasets if each[0] == "contact_modes/")
    changed, what = kind(dataset, random)
    variable = what.partition(":")[0].partition(" ")[0]
    failed = [each for each in check_dataset(name, changed, expectation) if not each.passed]
    assert variable in {each.variable for each in failed}


def test_a_variable_without_a_rule_is_an_error(datasets):
    name, dataset, expectation = datasets[0]
    more = dataset.assign(more=dataset["force"])
    (failed,) = (each for each in check_dataset(name, more, expectation) if not each.passed)
    assert (failed.variable, failed.problem) == ("more", "is no variable of this dataset")
